#include "supple/contact/smooth_contacts.hpp"

#include <cmath>
#include <limits>

#include "supple/contact/coincident.hpp"
#include "supple/contact/corner.hpp"

namespace supple {

namespace {

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

/// Four numbers side by side, in one register where there is one.
typedef double Four __attribute__((vector_size(32)));

inline VecOf<Four, 2> side_by_side(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return {Four{a[0], b[0], c[0], d[0]}, Four{a[1], b[1], c[1], d[1]}};
}

/// Lists the few candidates that matter now, so that the loop over them has no branches that cannot be
/// predicted. Four are looked at in one go, by the same operations as one, which saves a third of the time.
void select(const Scene& scene, std::vector<std::int32_t>& selected) {
  const std::size_t n = scene.candidates.size();
  selected.resize(n);
  std::size_t count = 0, k = 0;
  for (; k + 4 <= n; k += 4) {
    const EdgeCandidate* c = &scene.candidates[k];
    const auto vertices = [&](std::int32_t EdgeCandidate::*of) {
      return side_by_side(scene.vertex(c[0].*of), scene.vertex(c[1].*of), scene.vertex(c[2].*of),
                          scene.vertex(c[3].*of));
    };
    const auto at = place_at_corner(
        side_by_side(scene.point(c[0]), scene.point(c[1]), scene.point(c[2]), scene.point(c[3])),
        vertices(&EdgeCandidate::before), vertices(&EdgeCandidate::start), vertices(&EdgeCandidate::end));
    const Four limit{scene.limit(c[0]), scene.limit(c[1]), scene.limit(c[2]), scene.limit(c[3])};
    const auto parts = parts_of(at, limit);
    const auto matter = parts.act() | parts.behind();
    for (std::size_t lane = 0; lane < 4; ++lane) {
      selected[count] = static_cast<std::int32_t>(k + lane);
      count -= static_cast<std::size_t>(matter[lane]);  // true is -1 here
    }
  }
  for (; k < n; ++k) {
    const auto parts = parts_of(scene.place(scene.candidates[k]), scene.limit(scene.candidates[k]));
    selected[count] = static_cast<std::int32_t>(k);
    count += parts.act() | parts.behind();
  }
  selected.resize(count);
}

/// The nearest part of the boundary, if the site is behind it. Then the site is inside: from outside, another
/// part of the boundary would be nearer.
struct Inside {
  const EdgeCandidate* candidate = nullptr;  ///< null: not inside
  Part part = Part::edge;
  Foot touch{};
};

Inside find_inside(const Scene& scene, std::int32_t begin, std::int32_t end) {
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

}  // namespace

struct SmoothContacts::Sum {
  double energy = 0;
  Mat2 virial;
};

/// meet(row, i, j, r, distance, sigma) for each pair of discs that touch; r from i to j.
template <class Laws, class Meet>
void SmoothContacts::walk_discs(const System<2>& system, const Laws& laws, const Meet& meet) {
  const State<2>& state = system.state;
  const std::vector<Vec2>& shifts = candidates_.images().shifts(system.box);
  for (const std::int32_t row : candidates_.disc_rows()) {
    const std::int32_t i = system.pairs.first[row], j = system.pairs.second[row];
    const Vec2 r = state.position[j] - state.position[i] - shifts[candidates_.images().index()[row]];
    const double sigma = state.radius[i] + state.radius[j], distance = norm(r);
    if (!(distance < laws.of(i, j).range() * sigma)) continue;
    if (!linked_.empty() &&
        linked_.contains(touch_key(j, TouchOn::body, body_[i], candidates_.cells_of_row(row))))
      continue;
    meet(row, i, j, Foot{distance, distance > 0 ? (1 / distance) * r : arbitrary_direction<2>(i, j)}, sigma);
  }
}

/// Selects the candidates that matter now, without the contacts of linked pairs.
void SmoothContacts::select_acting(const System<2>& system) {
  select({system, candidates_.all(), candidates_.shifts(system.box), range()}, selected_);
  if (linked_.empty()) return;
  std::erase_if(selected_, [&](std::int32_t k) {
    const EdgeCandidate& c = candidates_.all()[k];
    return linked_.contains(touch_key(c.site, TouchOn::body, body_[c.start], -candidates_.cells(c.image)));
  });
}

void SmoothContacts::update(const System<2>& system) {
  candidates_.update(system, range());
  linked_.update(system, meeting());
  if (!linked_.empty()) body_ = bodies_of_sites(system.topology, system.state.size());
}

template <bool energies, class Laws>
void SmoothContacts::add_all(const System<2>& system, const Laws& given, Evaluation<2>& out, Sum& sum) {
  const Laws laws = given;  // its numbers stay in registers: 2 % of the time
  Vec2* force = out.force.data();
  const auto push_off = [&](std::int32_t site, std::int32_t other, const Foot& touch, double sigma,
                            double factor) {
    const auto& law_here = laws.of(site, other);
    const Vec2 push = (factor * law_here.force(touch.distance, sigma)) * touch.normal;
    force[site] += push;
    if constexpr (energies) {
      sum.energy += factor * law_here.energy(touch.distance, sigma);
      sum.virial.add_outer(touch.distance, push, touch.normal);
    }
    return push;
  };
  walk_discs(system, laws,
             [&](std::int32_t, std::int32_t i, std::int32_t j, const Foot& touch, double sigma) {
               force[i] -= push_off(j, i, touch, sigma, 1);
             });
  select_acting(system);
  const Scene scene{system, candidates_.all(), candidates_.shifts(system.box), range()};
  walk(
      scene, laws, selected_, candidates_.group_begin(),
      [&](const EdgeCandidate& c, Part, const Foot& touch, double sigma, int sign) {
        const Vec2 push = push_off(c.site, c.start, touch, sigma, sign * c.scale),
                   at_end = touch.along * push;
        force[c.start] -= push - at_end;
        force[c.end] -= at_end;
      },
      [&](int arcs) { violations_ += arcs != 1; });
}

void SmoothContacts::evaluate(const System<2>& system, Detail detail, Evaluation<2>& out) {
  update(system);
  if (!laws().is_uniform()) update_species(system);
  violations_ = 0;
  Sum sum;
  visit_laws([&](const auto laws_here) {
    if (detail == Detail::forces) add_all<false>(system, laws_here, out, sum);
    else add_all<true>(system, laws_here, out, sum);
  });
  if (detail == Detail::forces) return;
  out.energy.elastic += sum.energy;
  out.virial += sum.virial;
}

std::vector<ContactRecord<2>> SmoothContacts::records(const System<2>& system) {
  update(system);
  update_species(system);
  const EachPair laws{*this};
  std::vector<ContactRecord<2>> records;
  std::int32_t touches = 0;
  const auto begin = [&](const Foot& touch, double sigma, double factor,
                         const Vec2& cells) -> ContactRecord<2>& {
    ContactRecord<2>& record = records.emplace_back();
    record.normal = touch.normal;
    record.branch = touch.distance * touch.normal;
    record.reach = sigma;
    record.gap = touch.distance - sigma;
    record.multiplicity = factor;
    record.set_cells(cells);
    record.touch = touches;
    return record;
  };
  walk_discs(system, laws,
             [&](std::int32_t row, std::int32_t i, std::int32_t j, const Foot& touch, double sigma) {
               ContactRecord<2>& record = begin(touch, sigma, 1, candidates_.cells_of_row(row));
               record.species = species_of(i, j);
               record.row = row;
               record.add(i, -1);
               record.add(j, +1);
               ++touches;
             });
  select_acting(system);
  const Scene scene{system, candidates_.all(), candidates_.shifts(system.box), range()};
  walk(
      scene, laws, selected_, candidates_.group_begin(),
      [&](const EdgeCandidate& c, Part part, const Foot& touch, double sigma, int sign) {
        ContactRecord<2>& record = begin(touch, sigma, sign * c.scale, -candidates_.cells(c.image));
        record.species = species_of(c.site, c.start);
        record.add(c.site, 1);
        record.add(c.start, -(1 - touch.along));
        if (part == Part::edge) record.add(c.end, -touch.along);
      },
      [&](int) { ++touches; });
  return records;
}

}  // namespace supple
