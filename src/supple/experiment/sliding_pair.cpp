#include "supple/experiment/sliding_pair.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "supple/core/error.hpp"
#include "supple/core/random.hpp"
#include "supple/core/whole_number.hpp"
#include "supple/experiment/body_motion.hpp"
#include "supple/experiment/packing_record.hpp"
#include "supple/experiment/sound_states.hpp"
#include "supple/geometry/polygon.hpp"
#include "supple/model/bodies.hpp"
#include "supple/observe/pair_friction.hpp"

namespace supple {

namespace {

using std::numbers::pi;
enum { lower, upper };  // the two bodies

int vertices_of(const System<2>& s, int b) {
  return s.topology.facet_begin[b + 1] - s.topology.facet_begin[b];
}

/// The vertex k of a body, in the order of its boundary; any whole number.
std::int32_t vertex(const System<2>& s, int b, int k) {
  const int n = vertices_of(s, b);
  return s.topology.facet[s.topology.facet_begin[b] + ((k % n) + n) % n][0];
}

std::vector<Vec2> ring_of(const System<2>& s, int b) {
  std::vector<Vec2> ring;
  for (int k = 0; k < vertices_of(s, b); ++k) ring.push_back(s.state.position[vertex(s, b, k)]);
  return ring;
}

double vertex_radius(const System<2>& s, int b) { return s.state.radius[vertex(s, b, 0)]; }

/// The vertices that are held: of the edge (of an even number `count`, the two at its ends) or about the
/// vertex (of an odd one, it and its neighbours) opposite to the side that meets the other particle. Vertex 0
/// of the lower particle is the left end of the edge that looks up, that of the upper one looks down.
std::vector<std::int32_t> held_vertices(const System<2>& s, int b) {
  const int n = vertices_of(s, b);
  const bool about_vertex = (n % 2 == 0) == (b == upper);
  if (about_vertex) {
    const int middle = b == upper ? n / 2 : (n - 1) / 2;
    return {vertex(s, b, middle - 1), vertex(s, b, middle), vertex(s, b, middle + 1)};
  }
  const int left = b == upper ? (n + 1) / 2 : n / 2 - 1;
  return {vertex(s, b, left), vertex(s, b, b == upper ? left - 1 : left + 1)};
}

/// Turns a body about its centre so that vertex 0 lies in this direction [radian].
void turn_to(System<2>& s, int b, double direction) {
  const Vec2 centre = body_centre(s, b), arm = s.state.position[vertex(s, b, 0)] - centre;
  const double turn = direction - std::atan2(arm[1], arm[0]);
  if (const int r = rigid_index(s, b); r >= 0) {
    s.rigid.angle[r] += turn;
    return place_sites(s, r);
  }
  const double c = std::cos(turn), sine = std::sin(turn);
  for (int i = s.topology.body_begin(b); i < s.topology.body_end(b); ++i) {
    const Vec2 o = s.state.position[i] - centre;
    s.state.position[i] = centre + Vec2{c * o[0] - sine * o[1], sine * o[0] + c * o[1]};
  }
}

void put_centre(System<2>& s, int b, const Vec2& at) {
  move_body(s, b, at - body_centre(s, b));
  place_sites(s);
}

/// Displaces the vertices of bodies that can change their shape, each by another amount.
void shake(System<2>& s, double largest, std::int64_t seed) {
  if (!(largest > 0)) return;
  for_sites_apart(s, [&](int i) {
    RandomStream draw(static_cast<std::uint64_t>(seed), Purpose::body_position,
                      static_cast<std::uint64_t>(i));
    const double x = draw.uniform(-largest, largest), y = draw.uniform(-largest, largest);
    s.state.position[i] += Vec2{x, y};
  });
}

/// Radius of the circle through the vertices of a regular particle of the preferred area, or of a rigid one.
double regular_radius(const System<2>& s, int b) {
  const int n = vertices_of(s, b);
  const double preferred = s.shape.empty() ? 0 : s.shape.rest_volume[b];
  const double area = preferred > 0 ? preferred : polygon_area(ring_of(s, b));
  return std::sqrt(2 * area / (n * std::sin(2 * pi / n)));
}

double width_of(const System<2>& s, int b) {
  double low = s.state.position[vertex(s, b, 0)][0], high = low;
  for (const Vec2& x : ring_of(s, b)) low = std::min(low, x[0]), high = std::max(high, x[0]);
  return high - low + 2 * vertex_radius(s, b);
}

/// The x by which the place of a particle is told: of its middle spring, or the mean.
double mark(const System<2>& s, const std::vector<std::int32_t>& sites) {
  if (sites.size() % 2 == 1) return s.state.position[sites[sites.size() / 2]][0];
  double sum = 0;
  for (const std::int32_t i : sites) sum += s.state.position[i][0] / static_cast<double>(sites.size());
  return sum;
}

std::vector<Tether<2>> tethers_at(const System<2>& s, const std::vector<std::int32_t>& sites, double k) {
  std::vector<Tether<2>> tethers;
  for (const std::int32_t i : sites) tethers.push_back({i, s.state.position[i], k});
  return tethers;
}

/// The two far apart, turned, in the shapes that they take alone.
Packing<2> lone_particles(const Case& c) {
  Packing<2> p = make_packing<2>(c, nullptr, 1e-3, set_apart);
  System<2>& s = p.system;
  put_at_rest(s);
  double largest = 0;
  for (const int b : {lower, upper}) largest = std::max(largest, outer_radius(s, b));
  s.box = {};
  s.box.periodic = {false, false};
  s.box.length = {10 * largest, 20 * largest};
  turn_to(s, lower, pi / 2 + pi / vertices_of(s, lower));
  turn_to(s, upper, -pi / 2);
  put_centre(s, lower, {5 * largest, 5 * largest});
  put_centre(s, upper, {5 * largest, 15 * largest});
  shake(s, c.sliding.noise * (vertex_radius(s, lower) + vertex_radius(s, upper)), c.general.seed);
  WallLaw<2> none = wall_law<2>(c);
  none.stands = {{{false, false}, {false, false}}};
  p.field->set_walls(none);
  p.field->invalidate();
  LastGood<2> good(p);
  require_converged(p, relax(p), "a particle alone");
  good.look();
  return p;
}

/// Where the way of the upper particle begins, how long it is, and how often it is gone.
SlidingPath path_of(const Case& c, const SlidingPair& pair, double reach) {
  const Sliding& wanted = c.sliding;
  SlidingPath path;
  path.step = wanted.step * pair.width;
  const std::string to_do = "raise sliding.step, or bring sliding.from and sliding.to nearer to each other";
  if (wanted.from == 0 && wanted.to == 0) {
    if (!(pair.rise < reach))
      throw input_error(fmt::format("the upper particle passes {:.4g} above the lower one", pair.rise),
                        fmt::format("they reach {:.4g} together: they never touch", reach),
                        "raise sliding.overlap, or lower sliding.centre_distance");
    const double far = std::sqrt(reach * reach - pair.rise * pair.rise) / path.step;
    path.first = -static_cast<double>(whole_number(std::ceil(far) + 1, "steps of the pair", to_do, 1e8));
    path.length = static_cast<std::int64_t>(-2 * path.first);
  } else {
    path.first = wanted.from / wanted.step;
    path.length = std::max<std::int64_t>(
        1, whole_number((wanted.to - wanted.from) / wanted.step, "steps of the pair", to_do, 1e8));
  }
  path.starts_right = wanted.path == "backward";
  if (wanted.path == "cyclic") path.legs = 2 * wanted.cycles;
  return path;
}

/// The net force that is equilibrium where hardly anything touches, unless the case gives it: a share of the
/// least force that counts, or what the last digits of the positions make of the springs.
double least_net_force(const Case& c, const SlidingPair& pair, double spring) {
  if (c.minimise.least_force > 0) return c.minimise.least_force;
  const Vec2 length = pair.packing.system.box.length;
  const double last_digit = std::numeric_limits<double>::epsilon() * std::max(length[0], length[1]);
  return std::max(c.minimise.force_tolerance * pair.least_force, 4 * spring * last_digit);
}

double vertical_distance(const System<2>& s) { return body_centre(s, upper)[1] - body_centre(s, lower)[1]; }

/// Sets touch and rise, of the particles at the same height with x_bm = 0.
void set_heights(const Case& c, SlidingPair& pair) {
  const System<2>& s = pair.packing.system;
  const std::vector<Vec2> below = ring_of(s, lower), above = ring_of(s, upper);
  const auto touch =
      first_touch({below, vertex_radius(s, lower)}, {above, vertex_radius(s, upper)}, pair.packing.outline);
  const bool is_open = pair.packing.outline == Outline::rough && !pair.bound;
  if (!touch || is_open)
    throw input_error("the upper particle never touches the lower one at x = 0",
                      "its vertices pass between those of the lower one",
                      "raise bodies.diameter_ratio, or set contact.kind = \"smooth\"");
  pair.touch = *touch + vertical_distance(s);
  pair.rise = c.sliding.centre_distance > 0 ? c.sliding.centre_distance * pair.radius
                                            : pair.touch - c.sliding.overlap * pair.sigma;
  if (!(pair.rise > 0))
    throw input_error(fmt::format("sliding.overlap = {}", c.sliding.overlap),
                      "the upper particle would be below the lower one", "lower it");
}

/// The lower and the upper particle in a box that all of the path fits into.
void put_in_place(SlidingPair& pair, const std::vector<std::int32_t>& of_lower) {
  System<2>& s = pair.packing.system;
  const double ends[] = {0, pair.path.step * pair.path.first,
                         pair.path.step * (pair.path.first + static_cast<double>(pair.path.length))};
  const auto [left, right] = std::minmax({ends[0], ends[1], ends[2]});
  const double low = outer_radius(s, lower) + pair.sigma, high = outer_radius(s, upper) + pair.sigma,
               margin = std::max(low, high);
  s.box.length = {right - left + 2 * margin, low + pair.rise + high};
  const Vec2 move{margin - left - mark(s, of_lower), low - body_centre(s, lower)[1]};
  for (const int b : {lower, upper}) move_body(s, b, move);
  move_body(s, upper, {0, pair.rise - vertical_distance(s)});
  place_sites(s);
}

}  // namespace

std::vector<Tether<2>> SlidingPair::tethers(std::int64_t place) const {
  std::vector<Tether<2>> all = held;
  for (Tether<2> t : moved) {
    t.anchor[0] += path.x(place);
    all.push_back(t);
  }
  return all;
}

SlidingPair make_sliding_pair(const Case& c) {
  SlidingPair pair;
  pair.packing = lone_particles(c);
  Packing<2>& p = pair.packing;
  System<2>& s = p.system;
  const double reach = vertex_radius(s, lower) + vertex_radius(s, upper);
  pair.sigma = reach;
  const ContactLaws& laws = p.field->bodies()->laws();
  const BodyLaw& law = s.species.empty() ? laws.common() : laws.of(s.species[lower], s.species[upper]);
  pair.spring = law.spring(reach);
  pair.least_force = c.sliding.least_force * pair.spring * pair.sigma;
  pair.width = width_of(s, lower);
  pair.radius = regular_radius(s, lower);
  if (p.outline == Outline::rough)
    pair.bound = rough_friction_bound(
        0.5 * norm(s.state.position[vertex(s, lower, 0)] - s.state.position[vertex(s, lower, -1)]), reach);

  const std::vector<std::int32_t> of_lower = held_vertices(s, lower), of_upper = held_vertices(s, upper);
  move_body(s, upper, {mark(s, of_lower) - mark(s, of_upper), -vertical_distance(s)});
  place_sites(s);
  set_heights(c, pair);
  const double farthest = outer_radius(s, lower) + outer_radius(s, upper) + (law.range() - 1) * reach;
  pair.path = path_of(c, pair, farthest);
  put_in_place(pair, of_lower);
  const double k = c.sliding.tether_stiffness * pair.spring;
  p.tolerance.least = least_net_force(c, pair, k);
  pair.held = tethers_at(s, of_lower, k);
  pair.moved = tethers_at(s, of_upper, k);
  move_body(s, upper, {pair.path.x(0), 0});
  place_sites(s);
  put_at_rest(s);
  p.cell = s.box;
  p.relaxed.reset();
  p.field->invalidate();
  return pair;
}

std::vector<Derived> derived_pair(const SlidingPair& pair) {
  const System<2>& s = pair.packing.system;
  std::vector<Derived> all = derived_packing(pair.packing);
  const auto add = [&](const char* name, const char* unit, const char* meaning, double value) {
    all.push_back({{name, unit, meaning}, value});
  };
  std::erase_if(all, [](const Derived& d) { return d.name.name == "start_fraction"; });
  add("width", "", "D: widest horizontal distance of two vertices of the lower particle, and sigma",
      pair.width);
  add("sigma", "", "mean diameter of the vertices", pair.sigma);
  add("radius_ratio", "", "C = R/sigma, R of the circle through the vertices of the lower, regular particle",
      pair.radius / pair.sigma);
  add("touch_distance", "R", "vertical distance of the centres at which they first touch at x = 0",
      pair.touch / pair.radius);
  add("centre_distance", "R", "vertical distance of the centres at the start", pair.rise / pair.radius);
  add("overlap", "sigma", "first of these less second", (pair.touch - pair.rise) / pair.sigma);
  add("step", "", "of the upper particle between two relaxations", pair.path.step);
  add("relaxations", "", "places of the upper particle, each with a relaxation",
      static_cast<double>(pair.path.places()));
  if (pair.bound) add("friction_bound", "", "largest mu_eff of rigid rough particles (9.13)", *pair.bound);
  add("tether_ratio", "k_c", "stiffness of the springs that hold vertices",
      pair.moved.front().stiffness / pair.spring);
  if (s.shape.empty()) return all;
  const ShapeStiffness& k = s.shape.stiffness[lower];
  const double a0 = s.shape.rest_volume[lower];
  add("k_l_ratio", "k_c", "stiffness of the edges of the lower particle", k.facet / pair.spring);
  add("k_b_ratio", "k_c sigma^2", "stiffness of its corners", pair.in_contact_energies(k.hinge));
  add("k_a_ratio", "k_c sigma^2", "k_a a0^2 of it", pair.in_contact_energies(k.volume * a0 * a0));
  return all;
}

}  // namespace supple
