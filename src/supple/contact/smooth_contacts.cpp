#include "supple/contact/smooth_contacts.hpp"

#include <algorithm>

#include "supple/contact/round_bodies.hpp"
#include "supple/contact/smooth_walk.hpp"

namespace supple {

using namespace smooth;

namespace {

/// Four numbers side by side, in one register where there is one.
typedef double Four __attribute__((vector_size(32)));

VecOf<Four, 2> side_by_side(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return {Four{a[0], b[0], c[0], d[0]}, Four{a[1], b[1], c[1], d[1]}};
}

/// Lists the few candidates in [begin, end) that matter now, so that the loop over them has no branches that
/// cannot be predicted. Four are looked at in one go, by the same operations as one, which saves a third of
/// the time.
void select(const Scene& scene, std::int32_t begin, std::int32_t end, std::vector<std::int32_t>& selected) {
  const auto n = static_cast<std::size_t>(end);
  auto k = static_cast<std::size_t>(begin);
  selected.resize(n - k);
  std::size_t count = 0;
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

}  // namespace

struct SmoothContacts::Sum {
  double energy = 0;
  Mat2 virial;
};

/// meet(row, i, j, touch, sigma) for each pair of discs that touch, among disc rows [begin, end).
template <class Laws, class Meet>
void SmoothContacts::walk_discs(const System<2>& system, const Laws& laws, const std::vector<Vec2>& shifts,
                                std::int64_t begin, std::int64_t end, const Meet& meet) const {
  const auto rows = std::span(candidates_.disc_rows())
                        .subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(end - begin));
  walk_round_bodies(system, laws, rows, candidates_.images(), shifts, linked_, body_,
                    [&](std::int32_t row, std::int32_t i, std::int32_t j, double distance, const Vec2& normal,
                        double sigma) {
                      meet(row, i, j, Foot{distance, normal}, sigma);
                    });
}

void SmoothContacts::leave_out_linked(std::vector<std::int32_t>& selected) const {
  if (linked_.empty()) return;
  std::erase_if(selected, [&](std::int32_t k) {
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
  const auto push_off = [&](std::int32_t site, std::int32_t start, std::int32_t end, const Foot& touch,
                            double sigma, double factor) {
    const auto& law_here = laws.of(site, start);
    const Vec2 push = (factor * law_here.force(touch.distance, sigma)) * touch.normal;
    return Push{site,
                start,
                end,
                push,
                touch.along * push,
                touch.distance,
                energies ? factor * law_here.energy(touch.distance, sigma) : 0,
                touch.normal};
  };
  const auto add = [force = out.force.data()](const Push& push, const auto& here) {
    if (here(push.site)) force[push.site] += push.force;
    if (here(push.start)) force[push.start] -= push.force - push.at_end;
    if (here(push.end)) force[push.end] -= push.at_end;
  };
  const auto book = [&sum](const Push& push) {
    if constexpr (!energies) return;
    sum.energy += push.energy;
    sum.virial.add_outer(push.distance, push.force, push.normal);
  };
  // Each calls visit(push), in the order of rows, and of candidates.
  const std::vector<Vec2>& between_discs = candidates_.images().shifts(system.box);
  const auto visit_discs = [&](std::int64_t begin, std::int64_t end, const auto& visit) {
    walk_discs(system, laws, between_discs, begin, end,
               [&](std::int32_t, std::int32_t i, std::int32_t j, const Foot& touch, double sigma) {
                 visit(push_off(j, i, i, touch, sigma, 1));
               });
  };
  const Scene scene{system, candidates_.all(), candidates_.shifts(system.box), range()};
  const std::vector<std::int32_t>& group_begin = candidates_.group_begin();
  const auto visit_groups = [&](std::int64_t begin, std::int64_t end, int& violations, const auto& visit) {
    static thread_local std::vector<std::int32_t> selected;
    select(scene, group_begin[static_cast<std::size_t>(begin)], group_begin[static_cast<std::size_t>(end)],
           selected);
    leave_out_linked(selected);
    walk(
        scene, laws, selected, group_begin,
        [&](const EdgeCandidate& c, Part, const Foot& touch, double sigma, int sign) {
          visit(push_off(c.site, c.start, c.end, touch, sigma, sign * c.scale));
        },
        [&](int arcs) { violations += arcs != 1; });
  };

  const auto discs = static_cast<std::int64_t>(candidates_.disc_rows().size()),
             groups = static_cast<std::int64_t>(group_begin.size()) - 1;
  if (runs_in_place(std::max(discs, groups))) {
    const auto meet = [&](const Push& push) {
      add(push, [](std::int32_t) { return true; });
      book(push);
    };
    visit_discs(0, discs, meet);
    visit_groups(0, groups, violations_, meet);
    return;
  }
  const std::int64_t first_of_groups = chunk_count(discs), chunks = first_of_groups + chunk_count(groups);
  pushes_.begin(chunks, system.state.size());
  std::vector<std::vector<Push>> in_order(energies ? static_cast<std::size_t>(chunks) : 0);
  const auto keep_in = [&](std::int64_t chunk) {
    return [&, chunk](const Push& push) {
      pushes_.keep(chunk, push, std::array{push.site, push.start, push.end});
      if constexpr (energies) in_order[static_cast<std::size_t>(chunk)].push_back(push);
    };
  };
  for_chunks(discs, [&](std::int64_t c, std::int64_t begin, std::int64_t end) {
    visit_discs(begin, end, keep_in(c));
  });
  violations_ += sum_chunks<int>(groups, [&](std::int64_t begin, std::int64_t end) {
    int violations = 0;
    visit_groups(begin, end, violations, keep_in(first_of_groups + begin / chunk_size));
    return violations;
  });
  pushes_.add(add);
  for (const std::vector<Push>& of_chunk : in_order)
    for (const Push& push : of_chunk) book(push);
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
  walk_discs(system, laws, candidates_.images().shifts(system.box), 0,
             static_cast<std::int64_t>(candidates_.disc_rows().size()),
             [&](std::int32_t row, std::int32_t i, std::int32_t j, const Foot& touch, double sigma) {
               ContactRecord<2>& record = begin(touch, sigma, 1, candidates_.cells_of_row(row));
               record.species = species_of(i, j);
               record.row = row;
               record.add(i, -1);
               record.add(j, +1);
               ++touches;
             });
  const Scene scene{system, candidates_.all(), candidates_.shifts(system.box), range()};
  std::vector<std::int32_t> selected;
  select(scene, 0, candidates_.group_begin().back(), selected);
  leave_out_linked(selected);
  walk(
      scene, laws, selected, candidates_.group_begin(),
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
