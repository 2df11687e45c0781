/// What a vertex meets of the boundary of another body: the parts that act, and where they are nearest. The
/// geometry of SmoothContacts, whose comment has the formula.
#pragma once
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "supple/contact/coincident.hpp"
#include "supple/contact/corner.hpp"
#include "supple/contact/edge_candidates.hpp"

namespace supple::smooth {

/// Which parts of a candidate act on the site, and which say that the site may be inside.
template <class Flag>
struct Parts {
  Flag faces_edge, behind_edge;  ///< within sigma of the edge, on its outer or inner side
  Flag convex_corner;            ///< in front of it: counts +1
  Flag concave_corner;           ///< over both of its edges: counts -1
  Flag behind_corner;  ///< within sigma of a concave corner, which is nearer than its edges from inside

  Flag act() const { return faces_edge | convex_corner | concave_corner; }
  Flag behind() const { return behind_edge | behind_corner; }
  int corner() const { return convex_corner - concave_corner; }
};

template <class S, class Flag>
[[gnu::always_inline]] inline Parts<Flag> parts_of(const CornerPlace<S, Flag>& at, const S& reach) {
  const S limit = reach * reach;
  const Flag near_edge = at.over_edge & (at.height * at.height < limit * at.square);
  const Flag near_corner = dot(at.to, at.to) < limit, outer = at.height >= 0.0;
  const Flag over_both = near_corner & at.over_start & at.over_last;
  const Flag in_front = near_corner & !at.over_start & !at.over_last;
  return {Flag(near_edge & outer), Flag(near_edge & !outer), Flag(in_front & at.convex),
          Flag(over_both & !at.convex), Flag(in_front & !at.convex)};
}

enum class Part { edge, corner };

/// The nearest point of an edge or a corner: signed distance from it, its gradient by the site's position,
/// and where on the edge.
struct Foot {
  double distance;
  Vec2 normal;
  double along = 0;
};

/// The choice is made by data, not by branches.
inline Foot foot_on(const CornerPlace<double, bool>& at, const EdgeCandidate& c, Part part) {
  const bool edge = part == Part::edge;
  const double square = dot(at.to, at.to), per_square = 1 / (edge ? at.square : square);
  if (!edge & (square == 0)) return {0, arbitrary_direction<2>(c.site, c.start)};
  const double per_length = std::sqrt(per_square);
  const Vec2 across{edge ? at.edge[1] : at.to[0], edge ? -at.edge[0] : at.to[1]};
  return {(edge ? at.height : square) * per_length,
          {per_length * across[0], per_length * across[1]},
          edge ? at.along * per_square : 0};
}

/// What candidates are compared with.
struct Scene {
  const System<2>& system;
  const std::vector<EdgeCandidate>& candidates;
  const std::vector<Vec2>& shifts;
  double range;  ///< of the law that reaches farthest, over sigma

  Vec2 vertex(std::int32_t k) const { return system.state.position[k]; }
  Vec2 point(const EdgeCandidate& c) const { return vertex(c.site) + shifts[c.image]; }
  CornerPlace<double, bool> place(const EdgeCandidate& c) const {
    return place_at_corner(point(c), vertex(c.before), vertex(c.start), vertex(c.end));
  }
  double sigma(const EdgeCandidate& c) const {
    return system.state.radius[c.site] + system.state.radius[c.start];
  }
  /// Beyond it nothing acts.
  double limit(const EdgeCandidate& c) const { return range * sigma(c); }
};

/// The nearest part of the boundary, if the site is behind it. Then the site is inside: from outside, another
/// part of the boundary would be nearer.
struct Inside {
  const EdgeCandidate* candidate = nullptr;  ///< null: not inside
  Part part = Part::edge;
  Foot touch{};
};

inline Inside find_inside(const Scene& scene, std::int32_t begin, std::int32_t end) {
  Inside nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::int32_t k = begin; k < end; ++k) {
    const EdgeCandidate& c = scene.candidates[k];
    const auto at = scene.place(c);
    if (at.over_edge && at.height * at.height < least * at.square) {
      least = at.height * at.height / at.square;
      nearest = {at.height < 0 ? &c : nullptr, Part::edge, foot_on(at, c, Part::edge)};
    }
    if (!at.over_start && !at.over_last && dot(at.to, at.to) < least) {
      least = dot(at.to, at.to);
      const Foot touch = foot_on(at, c, Part::corner);
      nearest = {at.convex ? nullptr : &c, Part::corner, {-touch.distance, -touch.normal}};
    }
  }
  return nearest;
}

/// visit(candidate, part, touch, sigma, sign) for each part that acts, in order; close(arcs) behind the last
/// one of each group that met something: the Euler number of what is within sigma.
template <class Laws, class Visit, class Close>
inline void walk(const Scene& scene, const Laws& laws, const std::vector<std::int32_t>& selected,
                 const std::vector<std::int32_t>& group_begin, const Visit& visit, const Close& close) {
  const EdgeCandidate* last = nullptr;
  int arcs = 0;
  bool met = false, behind = false;
  const auto close_group = [&] {
    Inside inside;
    if (behind) inside = find_inside(scene, group_begin[last->group], group_begin[last->group + 1]);
    if (inside.candidate) {
      visit(*inside.candidate, inside.part, inside.touch, scene.sigma(*inside.candidate), 1);
      ++arcs, met = true;
    }
    if (met) close(arcs);
  };
  for (const std::int32_t k : selected) {
    const EdgeCandidate& c = scene.candidates[k];
    if (last && c.group != last->group) {
      close_group();
      arcs = 0, met = behind = false;
    }
    last = &c;
    const auto at = scene.place(c);
    const double sigma = scene.sigma(c);
    const auto parts = parts_of(at, laws.of(c.site, c.start).range() * sigma);
    if (parts.act()) {
      const Part first = parts.faces_edge ? Part::edge : Part::corner;
      visit(c, first, foot_on(at, c, first), sigma, parts.faces_edge ? 1 : parts.corner());
      met = true;
    }
    if (parts.faces_edge && parts.corner() != 0)
      visit(c, Part::corner, foot_on(at, c, Part::corner), sigma, parts.corner());
    arcs += parts.faces_edge + parts.corner();
    behind |= parts.behind();
  }
  if (last) close_group();
}

}  // namespace supple::smooth
