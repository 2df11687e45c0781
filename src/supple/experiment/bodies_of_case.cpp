#include "supple/experiment/bodies_of_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/core/parallel.hpp"
#include "supple/core/random.hpp"
#include "supple/experiment/random_centres.hpp"
#include "supple/model/bodies.hpp"
#include "supple/model/polygons.hpp"
#include "supple/model/sanity.hpp"
#include "supple/observe/packing_fraction.hpp"
#include "supple/observe/soundness.hpp"

namespace supple {

namespace {

using std::numbers::pi;

bool has_polygons(const Bodies& b) { return b.family != "disc"; }

Outline outline_of(const Case& c) { return c.contact.kind == "smooth" ? Outline::smooth : Outline::rough; }

/// p^2/(4 pi a) that a particle of n vertices prefers; 0: of the regular polygon.
double preferred_shape_parameter(const Bodies& b, int n, bool large) {
  if (b.family == "rough_disc") return 0;
  const double ratio = large && b.shape_ratio_large > 0 ? b.shape_ratio_large : b.shape_ratio;
  return ratio > 0 ? ratio * least_shape_parameter(n) : b.shape_parameter;
}

ShapeSpec shape_spec(const Bodies& b, int n, bool large) {
  return {b.k_a,
          b.k_l,
          b.k_b,
          b.gamma,
          b.stiffness == "relative" ? StiffnessKind::relative : StiffnessKind::absolute,
          preferred_shape_parameter(b, n, large)};
}

/// With edges too long for it the regular polygon is a saddle: it would stay one to rounding. A small push
/// lets it buckle, another one each particle.
bool buckles(const Bodies& b, const BodySizes& sizes, int body) {
  const int n = sizes.vertices(body);
  return n > 1 && b.family != "rough_disc" &&
         preferred_shape_parameter(b, n, sizes.is_large(body)) > least_shape_parameter(n) * (1 + 1e-9);
}

/// Adds the particle `body` of the case about a centre.
void add_particle(const Case& c, const BodySizes& sizes, int body, const Vec2& centre, System<2>& system) {
  const Bodies& b = c.bodies;
  const double area = sizes.area(body);
  const int n = sizes.vertices(body);
  if (n == 1) return add_disc_body(system, centre, std::sqrt(area / pi));
  RandomStream draw(static_cast<std::uint64_t>(c.general.seed), Purpose::body_angle,
                    static_cast<std::uint64_t>(body));
  const ShapeSpec shape = shape_spec(b, n, sizes.is_large(body));
  const int index = system.topology.body_count(system.state.size());
  add_polygon(system, centre, area, n, draw.uniform(0, 2 * pi), b.diameter_ratio, shape);
  if (b.family == "rough_disc") return make_rigid(system, index);
  if (!buckles(b, sizes, body)) return;
  for (int i = system.topology.begin[index]; i < system.topology.begin[index + 1]; ++i)
    system.state.position[i] += 0.01 * draw.uniform(-1, 1) * (system.state.position[i] - centre);
}

/// The widest particle of the case: the first or the last one that is no extra disc, or an extra disc.
double widest_particle(const Case& c, const BodySizes& sizes) {
  double widest = 0;
  for (const int body : {0, sizes.particles - 1, sizes.bodies() - 1}) {
    System<2> alone;
    add_particle(c, sizes, body, {}, alone);
    const double width = 2 * outer_radius(alone, 0);
    alone.box.length = {width, width};
    require_sane(alone, "these particles");
    widest = std::max(widest, width);
  }
  return widest;
}

struct LooseBody {
  double area = 0, radius = 0;
};

/// One particle with nothing else as far as `apart` of it.
LooseBody measure_alone(const Case& c, const BodySizes& sizes, int body, const Vec2& centre, double apart) {
  System<2> alone;
  add_particle(c, sizes, body, centre, alone);
  alone.box.length = {apart, apart};
  return {packing_fraction(alone, outline_of(c)).area[0], outer_radius(alone, 0)};
}

/// Those that the case does not draw, one of each kind.
std::array<std::optional<LooseBody>, BodySizes::kinds> measure_kinds(const Case& c, const BodySizes& sizes,
                                                                     double apart) {
  std::array<std::optional<LooseBody>, BodySizes::kinds> found;
  for (const int body : {0, sizes.particles - 1, sizes.bodies() - 1})
    if (auto& of_kind = found[static_cast<std::size_t>(sizes.kind(body))];
        !of_kind && !buckles(c.bodies, sizes, body))
      of_kind = measure_alone(c, sizes, body, {}, apart);
  return found;
}

}  // namespace

BodySizes::BodySizes(const Bodies& b)
    : particles(b.count),
      discs(has_polygons(b) ? b.discs : 0),
      large(static_cast<int>(std::lround(b.large_fraction * b.count))),
      ratio(b.size_ratio),
      vertices_small(has_polygons(b) ? b.vertices : 1),
      vertices_large(has_polygons(b) && b.vertex_rule == "scaled"
                         ? static_cast<int>(std::lround(b.size_ratio * b.vertices))
                         : vertices_small) {}

std::int64_t BodySizes::sites() const {
  return std::int64_t{particles - large} * vertices_small + std::int64_t{large} * vertices_large + discs;
}

LooseBodies loose_bodies(const Case& c, double packing_fraction_wanted, const Enclosure& enclosure,
                         Measured measured) {
  const BodySizes sizes(c.bodies);
  const int bodies = sizes.bodies();
  LooseBodies loose;
  const double pitch = std::max(1e2, 1.1 * widest_particle(c, sizes));
  const double apart = std::max(1e4, 2 * pitch) * bodies;
  std::vector<double> area(static_cast<std::size_t>(bodies));
  loose.radius.resize(area.size());
  std::array<std::optional<LooseBody>, BodySizes::kinds> kinds;
  if (measured == Measured::kinds) kinds = measure_kinds(c, sizes, apart);
  for_chunks(bodies, [&](std::int64_t, std::int64_t begin, std::int64_t end) {
    for (auto b = static_cast<int>(begin); b < end; ++b) {
      const auto& known = kinds[static_cast<std::size_t>(sizes.kind(b))];
      // Every packing follows, to the last bit, from areas there.
      const LooseBody body = known ? *known : measure_alone(c, sizes, b, {pitch * b, 0}, apart);
      area[b] = body.area;
      loose.radius[b] = body.radius;
    }
  });
  for (const double a : area) loose.area += a;
  Box<2>& cell = loose.cell;
  cell.periodic = enclosure.periodic;
  const double width = std::sqrt(loose.area / packing_fraction_wanted / enclosure.aspect_ratio);
  cell.length = {width, enclosure.aspect_ratio * width};
  const double widest = 2 * *std::max_element(loose.radius.begin(), loose.radius.end());
  const double least = cell.periodic[0] ? 2 * widest : widest;
  const double shorter = std::min(cell.length[0], cell.length[1]);
  if (shorter < least)
    throw input_error(
        fmt::format("{} particles at packing fraction {} in a {} cell", bodies, packing_fraction_wanted,
                    cell.periodic[0] ? "periodic" : "walled"),
        fmt::format("the cell is {:.3g} wide and the largest particle {:.3g}: it {}", shorter, widest,
                    cell.periodic[0] ? "would meet a neighbour on two sides" : "does not fit in"),
        "raise bodies.N");
  return loose;
}

System<2> particles_apart(const Case& c) {
  const BodySizes sizes(c.bodies);
  const double pitch = 2 * widest_particle(c, sizes);
  const auto side = static_cast<int>(std::ceil(std::sqrt(sizes.bodies())));
  System<2> system;
  system.box.length = {pitch * side, pitch * side};
  for (int b = 0; b < sizes.bodies(); ++b)
    add_particle(c, sizes, b, {pitch * (b % side + 0.5), pitch * (b / side + 0.5)}, system);
  return system;
}

System<2> random_packing(const Case& c, double packing_fraction_wanted, const Enclosure& enclosure,
                         const std::function<bool()>& stop_requested) {
  const LooseBodies loose = loose_bodies(c, packing_fraction_wanted, enclosure);
  const std::vector<Vec2> centre = random_centres(loose.radius, loose.cell, c.general.seed, stop_requested);
  const BodySizes sizes(c.bodies);
  System<2> system;
  system.box = loose.cell;
  for (int b = 0; b < sizes.bodies(); ++b) add_particle(c, sizes, b, centre[b], system);
  if (const Soundness s = look_at(system, outline_of(c));
      s.inside + s.crossing > 0 && c.contact.unsound == "stop")
    throw input_error(fmt::format("random particles at packing fraction {}", packing_fraction_wanted),
                      fmt::format("there is no room, of {} particles: {}", sizes.bodies(), s.what()),
                      "start at a lower one, and compress");
  return system;
}

}  // namespace supple
