#include "supple/experiment/between_plates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "supple/build/solid_bodies.hpp"
#include "supple/core/error.hpp"
#include "supple/experiment/body_motion.hpp"
#include "supple/model/bodies.hpp"
#include "supple/model/sanity.hpp"
#include "supple/observe/shape_measures.hpp"

namespace supple {

PlateCourse plate_course(const PlateCompression& plates) {
  PlateCourse course{{0}, static_cast<std::size_t>(plates.steps)};
  const double n = plates.steps;
  for (int k = 1; k <= plates.steps; ++k)
    course.compression.push_back(
        plates.spacing == "linear" ? plates.strain * k / n
        : k == plates.steps        ? plates.strain
                            : plates.first * std::pow(plates.strain / plates.first, (k - 1) / (n - 1)));
  if (plates.decompress)
    for (int k = plates.steps - 1; k >= 0; --k) course.compression.push_back(course.compression[k]);
  return course;
}

namespace {

template <int Dim>
constexpr int across = Dim - 1;  ///< the direction across the plates

/// An open cell about the particle with plates this far apart.
template <int Dim>
void set_gap(Packing<Dim>& packing, double width, double gap) {
  Box<Dim>& box = packing.system.box;
  box = {};
  for (int d = 0; d < Dim; ++d) {
    box.periodic[d] = false;
    box.length[d] = d == across<Dim> ? gap : width;
  }
  packing.cell = box;
  packing.field->invalidate();
}

/// Puts the middle of what the particle reaches over at `place`, in each direction.
template <int Dim>
void centre_body(System<Dim>& s, const Vec<Dim>& place) {
  Vec<Dim> move;
  for (int d = 0; d < Dim; ++d) {
    const BodyReach reach = reach_along(s, 0, d);
    move[d] = place[d] - 0.5 * (reach.low + reach.high);
  }
  move_body(s, 0, move);
  place_sites(s);
}

double turn_down(const Vec2& v) { return std::atan2(-v[0], -v[1]); }  // from v to (0, -1)
Vec3 turn_down(const Vec3& v) {
  const Vec3 down{0, 0, -1}, axis = cross(v, down);
  const double sine = norm(axis), cosine = dot(v, down);
  if (sine > 0) return (std::atan2(sine, cosine) / sine) * axis;
  return cosine < 0 ? Vec3{std::numbers::pi, 0, 0} : Vec3{};
}

Vec2 outward(const System<2>& s, const std::array<std::int32_t, 2>& edge) {
  const Vec2 along = s.state.position[edge[1]] - s.state.position[edge[0]];
  return -turned_left(along);
}
Vec3 outward(const System<3>& s, const std::array<std::int32_t, 3>& triangle) {
  const std::vector<Vec3>& x = s.state.position;
  return cross(x[triangle[1]] - x[triangle[0]], x[triangle[2]] - x[triangle[0]]);
}

/// Turns what the case wants there toward the lower plate. Discs and spheres have nothing to turn.
template <int Dim>
void orient(const std::string& wanted, System<Dim>& s) {
  if (wanted == "as_made" || s.topology.facet.empty()) return;
  const Vec<Dim> face = wanted == "flat" ? outward(s, s.topology.facet[0])
                                         : s.state.position[s.topology.body_begin(0)] - body_centre(s, 0);
  turn_body(s, 0, turn_down(face));
}

template <int Dim>
double mean_width(const System<Dim>& s) {
  double sum = 0;
  for (int d = 0; d < across<Dim>; ++d) sum += reach_along(s, 0, d).length();
  return sum / across<Dim>;
}

}  // namespace

template <int Dim>
void PlateState<Dim>::keep(Keeper& k) {
  k("diameter", diameter);
  k("volume", volume);
  k("width", width);
  k("shape", shape);
  k("before", before);
  k("gap_before", gap_before);
  k("step", step);
  k("work_down", work_down);
  k("work_up", work_up);
  k("force_before", force_before);
  k("evaluations", evaluations);
  k("minimisations", minimisations);
  k("last", last);
}

template <int Dim>
Packing<Dim> packing_between_plates(const Case& c, const InitialState* initial, const Making& making) {
  constexpr double sparse = 0.01;  // the cell where it is made has room for it, turned in any way
  Case alone = c;                  // without keys that say how many there are of what
  alone.species.clear();
  alone.bodies.discs = 0;
  alone.bodies.large_fraction = 0;
  alone.bodies.shape_ratio_large = 0;
  Packing<Dim> p = make_packing<Dim>(alone, initial, sparse, making);
  System<Dim>& s = p.system;
  if (const int bodies = s.topology.body_count(s.state.size()); bodies != 1)
    throw input_error(fmt::format("{} particles between the plates", bodies),
                      "plate_compression is about one of them",
                      initial ? "start from a state of one particle" : "set bodies.N = 1");
  put_at_rest(s);
  p.field->external() = {};
  WallLaw<Dim> plates = wall_law<Dim>(c);
  plates.floor_friction = 0;  // friction has no energy to minimise
  for (int d = 0; d < across<Dim>; ++d) plates.stands[d] = {false, false};
  p.field->set_walls(plates);
  const double room = 4 * outer_radius(s, 0);
  set_gap(p, room, room);
  centre_body(s, s.box.centre());
  require_sane(s, "this particle");
  return p;
}

template <int Dim>
void touch_plates(const Case& c, const InitialState* initial, Packing<Dim>& packing, PlateState<Dim>& state) {
  System<Dim>& s = packing.system;
  const double radius = *std::max_element(s.state.radius.begin(), s.state.radius.end());
  // A particle alone has no contact force: its own stiffness at the least compression is the scale.
  if (c.minimise.least_force == 0)
    packing.tolerance.least = force_by_pressure<Dim>(
        c.minimise.force_tolerance * c.plates.first * packing.pressure_unit, 2 * radius);
  state.last = relax(packing);
  require_converged(packing, state.last, "the particle alone");
  state.evaluations += state.last.evaluations;
  ++state.minimisations;
  if (!initial) orient(c.plates.orientation, s);
  state.diameter = reach_along(s, 0, across<Dim>).length();
  set_gap(packing, 2 * state.diameter, state.diameter);
  centre_body(s, s.box.centre());
  packing.field->invalidate();
  state.volume = measure_shapes(s).volume[0];
  state.width = mean_width(s);
  state.shape = s.state.position;
  state.gap_before = state.diameter;
  state.step = 0;
}

namespace {

template <int Dim>
double energy_of(Packing<Dim>& packing) {
  Evaluation<Dim> out;
  packing.field->evaluate(packing.system, Detail::energies, out);
  return out.energy.stored();
}

/// Where the minimisation starts.
template <int Dim>
void guess(Packing<Dim>& packing, PlateState<Dim>& state, double gap) {
  System<Dim>& s = packing.system;
  const double now = s.box.length[across<Dim>];
  const BodyDegrees<Dim> degrees(s);
  std::vector<double> x(static_cast<std::size_t>(degrees.size()));
  degrees.read(s, x);
  s.box.length[across<Dim>] = gap;
  packing.cell = s.box;
  // Sites of a body that deforms, and the centre of a rigid one.
  const auto height = [&](std::size_t k) { return k % Dim == across<Dim>; };
  const std::size_t heights = s.rigid.empty() ? x.size() : Dim;
  std::vector<double> evenly = x;
  for (std::size_t k = 0; k < heights; ++k)
    if (height(k)) evenly[k] *= gap / now;
  const bool leads = state.before.size() == x.size() && state.gap_before != now && s.rigid.empty();
  std::vector<double> onward = x;
  if (leads)
    for (std::size_t k = 0; k < x.size(); ++k)
      onward[k] += (gap - now) / (now - state.gap_before) * (x[k] - state.before[k]);
  degrees.write(evenly, s);
  packing.field->invalidate();
  if (leads) {
    const double even = energy_of(packing);
    degrees.write(onward, s);
    if (!(energy_of(packing) < even)) degrees.write(evenly, s);
  }
  state.before = std::move(x);
  state.gap_before = now;
}

template <int Dim>
double mean_plate_force(Packing<Dim>& packing) {
  Evaluation<Dim> out;
  packing.field->evaluate(packing.system, Detail::forces, out);
  return sum_plate_forces<Dim>(out.wall).mean();
}

}  // namespace

template <int Dim>
void move_plate(const Case& c, Packing<Dim>& packing, PlateState<Dim>& state, double gap) {
  constexpr int rounds = 8;
  guess(packing, state, gap);
  const double alone = packing.tolerance.least;
  // Where plates barely touch the particle, their force is lost in rounding.
  const double least = std::max(c.minimise.least_force, 1e-3 * alone);
  const auto wanted = [&] {
    const double mean = mean_plate_force(packing);
    return mean > 0 ? std::max(least, c.minimise.force_tolerance * mean) : alone;
  };
  double tolerance = wanted();
  for (int round = 0; round < rounds; ++round) {
    packing.tolerance.least = tolerance;
    state.last = relax(packing);
    state.evaluations += state.last.evaluations;
    // The mean force is known only in the equilibrium. Where positions allow no less the report says so.
    const double now = wanted();
    if (!state.last.converged || state.last.residual <= now || state.last.tolerance > tolerance) break;
    tolerance = 0.5 * now;
  }
  packing.tolerance.least = alone;
  ++state.minimisations;
  require_converged(packing, state.last,
                    fmt::format("the particle at compression {:.4g}", 1 - gap / state.diameter));
}

template <int Dim>
ForceUnit plate_force_unit(const Packing<Dim>& packing, double diameter) {
  const double section = std::pow(diameter, across<Dim>);
  const std::string power = Dim == 2 ? "D" : "D^2";
  if (const auto known = nominal_constants(packing.system, 0))
    return {known->young_modulus * section / (1 - known->poisson_ratio * known->poisson_ratio),
            "E " + power + "/(1-nu^2)"};
  return {packing.pressure_unit * section,
          packing.pressure_symbol.empty() ? power : packing.pressure_symbol + " " + power};
}

#define SUPPLE_BETWEEN(Dim)                                                                      \
  template void PlateState<Dim>::keep(Keeper&);                                                  \
  template Packing<Dim> packing_between_plates(const Case&, const InitialState*, const Making&); \
  template void touch_plates(const Case&, const InitialState*, Packing<Dim>&, PlateState<Dim>&); \
  template void move_plate(const Case&, Packing<Dim>&, PlateState<Dim>&, double);                \
  template ForceUnit plate_force_unit(const Packing<Dim>&, double);
SUPPLE_BETWEEN(2)
SUPPLE_BETWEEN(3)
#undef SUPPLE_BETWEEN

}  // namespace supple
