#include "supple/experiment/surfaces_of_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "supple/core/error.hpp"
#include "supple/experiment/bodies_of_case.hpp"
#include "supple/experiment/random_centres.hpp"
#include "supple/observe/packing_fraction.hpp"
#include "supple/observe/soundness.hpp"

namespace supple {

namespace {

Outline outline_of(const Case& c) { return c.contact.kind == "smooth" ? Outline::smooth : Outline::rough; }

/// What one particle of the kind covers [length^3].
double covered_volume(const SurfaceKind& kind, Outline outline) {
  SurfaceKind one = kind;
  one.count = 1;
  Box<3> box;
  const double length = 4 * enclosing_radii({one})[0];
  box.length = {length, length, length};
  return packing_fraction(surfaces_about({one}, {box.centre()}, box, 1), outline).total * box.volume();
}

double widest(const std::vector<double>& radius) {
  return 2 * *std::max_element(radius.begin(), radius.end());
}

/// The place of each particle's species in the case; none without [[species]].
std::vector<std::int32_t> places_of(const Case& c) {
  std::vector<std::int32_t> places;
  for (std::size_t k = 0; k < c.species.size(); ++k)
    places.insert(places.end(), static_cast<std::size_t>(c.species[k].count), static_cast<std::int32_t>(k));
  return places;
}

}  // namespace

std::vector<SurfaceKind> surface_kinds(const Case& c) {
  std::vector<SurfaceKind> kinds;
  for (const Species& s : species_of(c))
    kinds.push_back({s.count, is_disc(s) ? 1 : s.vertices, s.diameter, s.diameter_ratio, shape_spec(c, s),
                     is_rigid(s) ? SurfaceMotion::rigid : SurfaceMotion::deforming,
                     is_solid(s) ? std::optional(solid_spec(s)) : std::nullopt});
  return kinds;
}

LooseSurfaces loose_surfaces(const Case& c, double packing_fraction_wanted) {
  const std::vector<SurfaceKind> kinds = surface_kinds(c);
  LooseSurfaces loose;
  int particles = 0;
  for (const SurfaceKind& kind : kinds) {
    loose.volume += kind.count * covered_volume(kind, outline_of(c));
    particles += kind.count;
  }
  const double length = std::cbrt(loose.volume / packing_fraction_wanted),
               wide = widest(enclosing_radii(kinds));
  loose.cell.length = {length, length, length};
  if (length < 2 * wide)
    throw input_error(
        fmt::format("{} particles at packing fraction {} in a periodic cell", particles,
                    packing_fraction_wanted),
        fmt::format(
            "the cell is {:.3g} wide and the largest particle {:.3g}: it would meet a neighbour on two "
            "sides",
            length, wide),
        "raise bodies.N");
  return loose;
}

System<3> surfaces_apart(const Case& c) {
  const std::vector<SurfaceKind> kinds = surface_kinds(c);
  const std::vector<double> radius = enclosing_radii(kinds);
  const auto side = static_cast<std::size_t>(std::ceil(std::cbrt(static_cast<double>(radius.size()))));
  const double pitch = 2 * widest(radius);
  Box<3> box;
  for (int d = 0; d < 3; ++d) box.length[d] = pitch * static_cast<double>(side);
  std::vector<Vec3> centre;
  for (std::size_t b = 0; b < radius.size(); ++b)
    centre.push_back({pitch * (static_cast<double>(b % side) + 0.5),
                      pitch * (static_cast<double>(b / side % side) + 0.5),
                      pitch * (static_cast<double>(b / side / side) + 0.5)});
  System<3> system = surfaces_about(kinds, centre, box, c.general.seed);
  system.species = places_of(c);
  return system;
}

System<3> random_surface_packing(const Case& c, double packing_fraction_wanted,
                                 const std::function<bool()>& stop_requested) {
  const LooseSurfaces loose = loose_surfaces(c, packing_fraction_wanted);
  const std::vector<SurfaceKind> kinds = surface_kinds(c);
  System<3> system = surfaces_about(
      kinds, random_centres(enclosing_radii(kinds), loose.cell, c.general.seed, stop_requested), loose.cell,
      c.general.seed);
  system.species = places_of(c);
  if (const Soundness s = look_at(system, outline_of(c));
      s.inside + s.crossing > 0 && c.contact.unsound == "stop")
    throw input_error(fmt::format("random particles at packing fraction {}", packing_fraction_wanted),
                      fmt::format("there is no room: {}", s.what()), "start at a lower one, and compress");
  return system;
}

}  // namespace supple
