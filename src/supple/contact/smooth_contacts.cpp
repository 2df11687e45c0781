#include "supple/contact/smooth_contacts.hpp"

#include <cmath>
#include <limits>

#include "supple/contact/coincident.hpp"
#include "supple/contact/corner.hpp"

namespace supple {

namespace {

/// The parts of one candidate that act, and those that say that the site may be inside.
struct Parts {
  bool faces_edge, behind_edge;  ///< within sigma of the edge, on its outer or inner side
  int corner;  ///< factor of the corner: 1 in front of a convex one, -1 over both edges of a concave one, or
               ///< 0
  bool behind_corner;  ///< within sigma of a concave corner, which is nearer than its edges from inside
};

inline Parts parts_of(const CornerPlace& at, double sigma) {
  const double limit = sigma * sigma;
  const bool near_edge = at.over_edge & (at.height * at.height < limit * at.square),
             near_corner = dot(at.to, at.to) < limit;
  const bool in_front = at.beyond_edge & at.beyond_last, over_both = !at.beyond_edge & !at.beyond_last;
  return {near_edge && at.height >= 0, near_edge && at.height < 0,
          near_corner * ((in_front & at.convex) - (over_both & !at.convex)),
          near_corner && in_front && !at.convex};
}

/// Signed distance from an edge or a corner, its gradient by the site's position, and where on the edge.
struct Touch {
  double distance;
  Vec2 normal;
  double along = 0;
};

inline Touch touch_edge(const CornerPlace& at) {
  const double per_square = 1 / at.square, per_length = std::sqrt(per_square);
  return {at.height * per_length, {per_length * at.edge[1], -per_length * at.edge[0]}, at.along * per_square};
}

Touch touch_corner(const CornerPlace& at, const EdgeCandidate& c) {
  const double distance = norm(at.to);
  return {distance, distance > 0 ? (1 / distance) * at.to : arbitrary_direction<2>(c.site, c.start)};
}

/// What a group of candidates looks at.
struct Scene {
  const System<2>& system;
  const std::vector<EdgeCandidate>& candidates;
  const std::vector<Vec2>& shifts;

  CornerPlace place(std::int32_t k) const {
    const EdgeCandidate& c = candidates[k];
    const std::vector<Vec2>& x = system.state.position;
    return place_at_corner(x[c.site] + shifts[c.image], x[c.before], x[c.start], x[c.end]);
  }
  double sigma(std::int32_t k) const {
    return system.state.radius[candidates[k].site] + system.state.radius[candidates[k].start];
  }
};

/// Nearest part of the boundary, if the site sees its inner side: a site is inside where it is behind what is
/// nearest to it, because from outside something of the boundary would lie between.
struct Inside {
  std::int32_t candidate = -1;  ///< -1: not inside
  bool on_edge = false;
  Touch touch{};
};

Inside find_inside(const Scene& scene, std::int32_t begin, std::int32_t end) {
  Inside nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::int32_t k = begin; k < end; ++k) {
    const CornerPlace at = scene.place(k);
    if (at.over_edge && at.height * at.height < least * at.square) {
      least = at.height * at.height / at.square;
      nearest = {at.height < 0 ? k : -1, true, touch_edge(at)};
    }
    if (at.beyond_edge && at.beyond_last && dot(at.to, at.to) < least) {
      least = dot(at.to, at.to);
      const double depth = std::sqrt(least);
      nearest = {at.convex ? -1 : k, false, {-depth, (-1 / depth) * at.to}};
    }
  }
  return nearest;
}

/// What a walk over a group found beside the parts that act.
struct GroupSummary {
  int arcs = 0;      ///< Euler number of what is within sigma: 1 for a simple arc
  bool met = false;  ///< whether anything is
  bool inside = false;
  bool violates() const { return met && arcs != 1; }
};

/// edge(candidate, touch, sigma) and corner(candidate, touch, sigma, sign) for each part of a group that
/// acts, in order.
template <class Edge, class Corner>
inline GroupSummary walk_group(const Scene& scene, std::int32_t begin, std::int32_t end, const Edge& edge,
                               const Corner& corner) {
  GroupSummary summary;
  bool behind = false;
  for (std::int32_t k = begin; k < end; ++k) {
    const EdgeCandidate& c = scene.candidates[k];
    const CornerPlace at = scene.place(k);
    const double sigma = scene.sigma(k);
    const Parts parts = parts_of(at, sigma);
    if (parts.faces_edge) edge(c, touch_edge(at), sigma);
    if (parts.corner != 0) corner(c, touch_corner(at, c), sigma, parts.corner);
    summary.arcs += parts.faces_edge + parts.corner;
    summary.met |= parts.faces_edge | (parts.corner != 0);
    behind |= parts.behind_edge | parts.behind_corner;
  }
  if (!behind) return summary;
  const Inside found = find_inside(scene, begin, end);
  if (found.candidate < 0) return summary;
  const EdgeCandidate& c = scene.candidates[found.candidate];
  if (found.on_edge) edge(c, found.touch, scene.sigma(found.candidate));
  else corner(c, found.touch, scene.sigma(found.candidate), 1);
  ++summary.arcs;
  summary.met = summary.inside = true;
  return summary;
}

/// meet(row, i, j, r, distance, sigma) for each pair of discs that touch; r from i to j.
template <class Meet>
void walk_discs(const System<2>& system, EdgeCandidates& candidates, const Meet& meet) {
  const State<2>& state = system.state;
  const std::vector<Vec2>& shifts = candidates.images().shifts(system.box);
  for (const std::int32_t row : candidates.disc_rows()) {
    const std::int32_t i = system.pairs.first[row], j = system.pairs.second[row];
    const Vec2 r = state.position[j] - state.position[i] - shifts[candidates.images().index()[row]];
    const double sigma = state.radius[i] + state.radius[j], distance = norm(r);
    if (distance < sigma)
      meet(row, i, j, Touch{distance, distance > 0 ? (1 / distance) * r : arbitrary_direction<2>(i, j)},
           sigma);
  }
}

}  // namespace

struct SmoothContacts::Sum {
  double energy = 0;
  Mat2 virial;
};

template <bool energies>
void SmoothContacts::add_all(const System<2>& system, Evaluation<2>& out, Sum& sum) {
  const Harmonic law_here = law();
  Vec2* force = out.force.data();
  const auto push_off = [&](std::int32_t site, const Touch& touch, double sigma, double factor) {
    const Vec2 push = (factor * law_here.force(touch.distance, sigma)) * touch.normal;
    force[site] += push;
    if constexpr (energies) {
      sum.energy += factor * law_here.energy(touch.distance, sigma);
      sum.virial.add_outer(touch.distance, push, touch.normal);
    }
    return push;
  };
  walk_discs(system, candidates_,
             [&](std::int32_t, std::int32_t i, std::int32_t j, const Touch& touch, double sigma) {
               force[i] -= push_off(j, touch, sigma, 1);
             });
  const Scene scene{system, candidates_.all(), candidates_.shifts(system.box)};
  const auto edge = [&](const EdgeCandidate& c, const Touch& touch, double sigma) {
    const Vec2 push = push_off(c.site, touch, sigma, c.scale);
    force[c.start] -= (1 - touch.along) * push;
    force[c.end] -= touch.along * push;
  };
  const auto corner = [&](const EdgeCandidate& c, const Touch& touch, double sigma, int sign) {
    force[c.start] -= push_off(c.site, touch, sigma, sign * c.scale);
  };
  const std::vector<std::int32_t>& group = candidates_.group_begin();
  for (std::size_t g = 0; g + 1 < group.size(); ++g) {
    const GroupSummary summary = walk_group(scene, group[g], group[g + 1], edge, corner);
    violations_ += summary.violates();
    const std::int32_t site = scene.candidates[group[g]].site;
    if (summary.inside && (inside_.empty() || inside_.back() != site)) inside_.push_back(site);
  }
}

void SmoothContacts::evaluate(const System<2>& system, Detail detail, Evaluation<2>& out) {
  candidates_.update(system);
  inside_.clear();
  violations_ = 0;
  Sum sum;
  if (detail == Detail::forces) return add_all<false>(system, out, sum);
  add_all<true>(system, out, sum);
  out.energy.elastic += sum.energy;
  out.virial += sum.virial;
}

std::vector<ContactRecord<2>> SmoothContacts::records(const System<2>& system) {
  candidates_.update(system);
  std::vector<ContactRecord<2>> records;
  std::int32_t touches = 0;
  const auto begin = [&](const Touch& touch, double sigma, double factor, bool crosses) -> ContactRecord<2>& {
    ContactRecord<2>& record = records.emplace_back();
    record.normal = touch.normal;
    record.branch = touch.distance * touch.normal;
    record.reach = sigma;
    record.gap = touch.distance - sigma;
    record.multiplicity = factor;
    record.crosses = crosses;
    record.touch = touches;
    return record;
  };
  walk_discs(system, candidates_,
             [&](std::int32_t row, std::int32_t i, std::int32_t j, const Touch& touch, double sigma) {
               ContactRecord<2>& record = begin(touch, sigma, 1, candidates_.images().index()[row] != 0);
               record.row = row;
               record.add(i, -1);
               record.add(j, +1);
               ++touches;
             });
  const Scene scene{system, candidates_.all(), candidates_.shifts(system.box)};
  const auto crosses = [&](const EdgeCandidate& c) { return !candidates_.is_home(c.image); };
  const auto edge = [&](const EdgeCandidate& c, const Touch& touch, double sigma) {
    ContactRecord<2>& record = begin(touch, sigma, c.scale, crosses(c));
    record.add(c.site, 1);
    record.add(c.start, -(1 - touch.along));
    record.add(c.end, -touch.along);
  };
  const auto corner = [&](const EdgeCandidate& c, const Touch& touch, double sigma, int sign) {
    ContactRecord<2>& record = begin(touch, sigma, sign * c.scale, crosses(c));
    record.add(c.site, 1);
    record.add(c.start, -1);
  };
  const std::vector<std::int32_t>& group = candidates_.group_begin();
  for (std::size_t g = 0; g + 1 < group.size(); ++g)
    touches += walk_group(scene, group[g], group[g + 1], edge, corner).met;
  return records;
}

}  // namespace supple
