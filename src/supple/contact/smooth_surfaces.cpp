#include "supple/contact/smooth_surfaces.hpp"

#include <algorithm>

#include "supple/contact/round_bodies.hpp"
#include "supple/contact/surface_walk.hpp"

namespace supple {

using namespace smooth;

struct SmoothSurfaces::Sum {
  double energy = 0;
  Mat<3> virial;
};

void SmoothSurfaces::update(const System<3>& system) {
  candidates_.update(system, range());
  linked_.update(system, meeting());
  if (!linked_.empty()) body_ = bodies_of_sites(system.topology, system.state.size());
}

bool SmoothSurfaces::is_linked(const FacetGroup& group) const {
  return linked_.contains(touch_key(group.site, TouchOn::body, group.body, -candidates_.cells(group.image)));
}

template <class Laws, class Visit, class Close>
void SmoothSurfaces::walk_groups(const System<3>& system, const Laws& laws, const std::vector<Vec3>& shifts,
                                 std::int64_t begin, std::int64_t end, const Visit& visit,
                                 const Close& close) const {
  const State<3>& state = system.state;
  PatchInReach patch({state.position, system.topology, candidates_.fans()});
  for (std::int64_t g = begin; g < end; ++g) {
    const FacetGroup& group = candidates_.groups()[static_cast<std::size_t>(g)];
    if (!linked_.empty() && is_linked(group)) continue;
    const std::int32_t other = system.topology.body_begin(group.body);
    const double sigma = state.radius[group.site] + state.radius[other];
    const MetParts met =
        patch.meet(candidates_.facets(group), state.position[group.site] + shifts[group.image],
                   laws.of(group.site, other).range() * sigma,
                   [&](const SurfaceFoot& foot) { visit(group, foot, sigma); });
    if (met.parts > 0) close(met);
  }
}

template <class Laws, class Meet>
void SmoothSurfaces::walk_spheres(const System<3>& system, const Laws& laws, const std::vector<Vec3>& shifts,
                                  std::int64_t begin, std::int64_t end, const Meet& meet) const {
  const auto rows = std::span(candidates_.round_rows())
                        .subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(end - begin));
  walk_round_bodies(system, laws, rows, candidates_.images(), shifts, linked_, body_, meet);
}

template <bool energies, class Laws>
void SmoothSurfaces::add_all(const System<3>& system, const Laws& laws, Evaluation<3>& out, Sum& sum) {
  const auto push_off = [&](std::int32_t site, std::int32_t other, double distance, const Vec3& normal,
                            double sigma, double factor) {
    const auto& law_here = laws.of(site, other);
    Push push{site, 1, {other, site, site}, {1, 0, 0}, {}, distance, 0, normal};
    push.force = (factor * law_here.force(distance, sigma)) * normal;
    if constexpr (energies) push.energy = factor * law_here.energy(distance, sigma);
    return push;
  };
  const auto add = [force = out.force.data()](const Push& push, const auto& here) {
    if (here(push.site)) force[push.site] += push.force;
    for (std::size_t k = 0; k < static_cast<std::size_t>(push.corners); ++k)
      if (here(push.corner[k])) force[push.corner[k]] -= push.weight[k] * push.force;
  };
  const auto book = [&sum](const Push& push) {
    if constexpr (!energies) return;
    sum.energy += push.energy;
    sum.virial.add_outer(push.distance, push.force, push.normal);
  };
  // Each calls visit(push), in the order of rows, and of groups.
  const std::vector<Vec3>& between_spheres = candidates_.images().shifts(system.box);
  const auto visit_spheres = [&](std::int64_t begin, std::int64_t end, const auto& visit) {
    walk_spheres(system, laws, between_spheres, begin, end,
                 [&](std::int32_t, std::int32_t i, std::int32_t j, double distance, const Vec3& normal,
                     double sigma) { visit(push_off(j, i, distance, normal, sigma, 1)); });
  };
  const std::vector<Vec3>& shifts = candidates_.shifts(system.box);
  const auto visit_groups = [&](std::int64_t begin, std::int64_t end, int& violations, const auto& visit) {
    walk_groups(
        system, laws, shifts, begin, end,
        [&](const FacetGroup& group, const SurfaceFoot& foot, double sigma) {
          Push push =
              push_off(group.site, foot.site[0], foot.distance, foot.normal, sigma, foot.sign * group.scale);
          push.corners = foot.sites;
          for (std::size_t k = 0; k < static_cast<std::size_t>(foot.sites); ++k)
            push.corner[k] = foot.site[k], push.weight[k] = foot.weight[k];
          visit(push);
        },
        [&](const MetParts& met) { violations += met.euler != 1; });
  };

  const auto spheres = static_cast<std::int64_t>(candidates_.round_rows().size()),
             groups = static_cast<std::int64_t>(candidates_.groups().size());
  if (runs_in_place(std::max(spheres, groups))) {
    const auto meet = [&](const Push& push) {
      add(push, [](std::int32_t) { return true; });
      book(push);
    };
    visit_spheres(0, spheres, meet);
    visit_groups(0, groups, violations_, meet);
    return;
  }
  const std::int64_t first_of_groups = chunk_count(spheres), chunks = first_of_groups + chunk_count(groups);
  pushes_.begin(chunks, system.state.size());
  std::vector<std::vector<Push>> in_order(energies ? static_cast<std::size_t>(chunks) : 0);
  const auto keep_in = [&](std::int64_t chunk) {
    return [&, chunk](const Push& push) {
      pushes_.keep(chunk, push, std::array{push.site, push.corner[0], push.corner[1], push.corner[2]});
      if constexpr (energies) in_order[static_cast<std::size_t>(chunk)].push_back(push);
    };
  };
  for_chunks(spheres, [&](std::int64_t c, std::int64_t begin, std::int64_t end) {
    visit_spheres(begin, end, keep_in(c));
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

void SmoothSurfaces::evaluate(const System<3>& system, Detail detail, Evaluation<3>& out) {
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

std::vector<ContactRecord<3>> SmoothSurfaces::records(const System<3>& system) {
  update(system);
  update_species(system);
  const EachPair laws{*this};
  std::vector<ContactRecord<3>> records;
  std::int32_t touches = 0;
  const auto begin = [&](std::int32_t site, std::int32_t other, double distance, const Vec3& normal,
                         double sigma, double factor, const Vec3& cells) -> ContactRecord<3>& {
    ContactRecord<3>& record = records.emplace_back();
    record.normal = normal;
    record.branch = distance * normal;
    record.reach = sigma;
    record.gap = distance - sigma;
    record.multiplicity = factor;
    record.species = species_of(site, other);
    record.set_cells(cells);
    record.touch = touches;
    return record;
  };
  walk_spheres(system, laws, candidates_.images().shifts(system.box), 0,
               static_cast<std::int64_t>(candidates_.round_rows().size()),
               [&](std::int32_t row, std::int32_t i, std::int32_t j, double distance, const Vec3& normal,
                   double sigma) {
                 const RowImages<3>& images = candidates_.images();
                 ContactRecord<3>& record =
                     begin(i, j, distance, normal, sigma, 1, images.cells()[images.index()[row]]);
                 record.row = row;
                 record.add(i, -1);
                 record.add(j, +1);
                 ++touches;
               });
  walk_groups(
      system, laws, candidates_.shifts(system.box), 0, static_cast<std::int64_t>(candidates_.groups().size()),
      [&](const FacetGroup& group, const SurfaceFoot& foot, double sigma) {
        ContactRecord<3>& record = begin(group.site, foot.site[0], foot.distance, foot.normal, sigma,
                                         foot.sign * group.scale, -candidates_.cells(group.image));
        record.add(group.site, 1);
        for (std::size_t k = 0; k < static_cast<std::size_t>(foot.sites); ++k)
          record.add(foot.site[k], -foot.weight[k]);
      },
      [&](const MetParts&) { ++touches; });
  return records;
}

}  // namespace supple
