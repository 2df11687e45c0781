/// Packings of the particles that a case makes or names.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "supple/core/error.hpp"
#include "supple/experiment/bodies_of_case.hpp"
#include "supple/experiment/given_packing.hpp"
#include "supple/experiment/packing.hpp"
#include "supple/experiment/surfaces_of_case.hpp"
#include "supple/model/body_flow.hpp"
#include "supple/model/rigid.hpp"

namespace supple {

namespace {

template <int Dim>
void check_initial(const Case& c, const InitialState* initial, const Making& making) {
  if (!initial) return;
  const System<Dim>& given = system_of<Dim>(*initial);
  if (given.topology.begin.empty())
    throw input_error("the state to start from holds no bodies", "its discs are of the microgel model",
                      "start from a run of deformable particles, or from [bodies]");
  if (!given.links.empty() && making.flow == Flow::stopped)
    throw input_error("the state to start from holds crosslinked particles",
                      fmt::format("{} would leave their links out", c.general.experiment),
                      "shear them, or start from particles without links");
  const std::vector<std::int32_t>& species = given.species;
  if (!c.pairs.empty() && species.empty())
    throw input_error("the particles to start from are of no species",
                      fmt::format("[{}] is about contacts of some of them", pair_section(c.pairs.front())),
                      "start from a run of [[species]], or leave that section away");
  if (const auto kinds = species.empty() ? 0 : *std::max_element(species.begin(), species.end()) + 1;
      !c.species.empty() && kinds > static_cast<std::int32_t>(c.species.size()))
    throw input_error(fmt::format("the particles to start from are of {} species", kinds),
                      fmt::format("the case has {}", c.species.size()), "leave [[species]] away");
}

template <int Dim>
bool is_enclosed(const System<Dim>& system) {
  return std::ranges::none_of(system.box.periodic, std::identity());
}
template <int Dim>
bool is_periodic(const System<Dim>& system) {
  return std::ranges::all_of(system.box.periodic, std::identity());
}

/// What acts on particles of a state from outside: walls where its cell is not periodic, and gravity.
template <int Dim>
void surround(const Case& c, const Environment& environment, Packing<Dim>& p) {
  p.field->external().gravity = environment.gravity_in<Dim>();
  if (is_periodic(p.system)) return;
  WallLaw<Dim> walls = wall_law<Dim>(c);
  walls.stands = environment.stands_in<Dim>();
  p.field->set_walls(walls);
}

/// The particles of a state with the stiffnesses of the case.
template <int Dim>
System<Dim> given_system(const Case& c, const InitialState& initial, Flow flow) {
  System<Dim> system = system_of<Dim>(initial);
  if (flow == Flow::stopped) {
    set_strain_rate(system, 0);
    leave_plates(system);
    system.lag = 0;  // velocities of its end begin this one
    place_sites(system);
    system.touches = {};  // only contacts that rub remember
  }
  give_stiffness(c, system);
  return system;
}

/// The particles that the case makes.
Packing<2> made_packing(const Case& c, double packing_fraction_wanted, const Enclosure& enclosure,
                        const Making& making) {
  if (making.places == Places::random)
    return packing_of(c, random_packing(c, packing_fraction_wanted, enclosure, making.stop_requested));
  System<2> apart = particles_apart(c);
  const LooseBodies loose = loose_bodies(c, packing_fraction_wanted, enclosure, &apart);
  Packing<2> p = packing_of(c, std::move(apart), Places::apart);
  p.cell = loose.cell;
  p.covered_area = loose.area;
  return p;
}

Packing<3> made_packing_in_3d(const Case& c, double packing_fraction_wanted, const Making& making) {
  if (making.places == Places::random)
    return packing_of(c, random_surface_packing(c, packing_fraction_wanted, making.stop_requested));
  const LooseSurfaces loose = loose_surfaces(c, packing_fraction_wanted);
  Packing<3> p = packing_of(c, surfaces_apart(c), Places::apart);
  p.cell = loose.cell;
  p.covered_area = loose.volume;
  return p;
}

}  // namespace

template <int Dim>
Packing<Dim> make_packing(const Case& c, const InitialState* initial, double packing_fraction_wanted,
                          const Making& making) {
  check_initial<Dim>(c, initial, making);
  if (!initial) {
    if constexpr (Dim == 2) return made_packing(c, packing_fraction_wanted, {}, making);
    else return made_packing_in_3d(c, packing_fraction_wanted, making);
  }
  Packing<Dim> p = packing_of(c, given_system<Dim>(c, *initial, making.flow));
  surround(c, initial->environment, p);
  return p;
}

Packing<2> make_boxed_packing(const Case& c, const InitialState* initial, double packing_fraction_wanted,
                              double aspect_ratio, const Making& making) {
  if (initial && !is_enclosed(system_of<2>(*initial)))
    throw input_error("the state to start from is periodic",
                      fmt::format("{} needs a box of walls", c.general.experiment),
                      "start from a run between walls, or from [bodies]");
  if (initial && !(initial->environment.is_closed() && initial->environment.gravity == Vec3{}))
    throw input_error(
        "the state to start from lies under gravity, or without some of the walls",
        fmt::format("{} is about particles between four walls, without weight", c.general.experiment),
        "start from a run of it, or from [bodies]");
  check_initial<2>(c, initial, making);
  Packing<2> p = initial ? packing_of(c, given_system<2>(c, *initial, making.flow))
                         : made_packing(c, packing_fraction_wanted, {aspect_ratio, {false, false}}, making);
  WallLaw<2> walls = wall_law<2>(c);
  walls.floor_friction = 0;  // friction has no energy to minimise
  p.field->set_walls(walls);
  return p;
}

template <int Dim>
Packing<Dim> make_periodic_packing(const Case& c, const InitialState* initial, const Making& making) {
  if (initial && !is_periodic(system_of<Dim>(*initial)))
    throw input_error("the state to start from lies between walls",
                      fmt::format("{} needs a periodic cell", c.general.experiment),
                      "start from a periodic packing");
  return make_packing<Dim>(c, initial, c.jamming.packing_fraction, making);
}

template Packing<2> make_packing(const Case&, const InitialState*, double, const Making&);
template Packing<3> make_packing(const Case&, const InitialState*, double, const Making&);
template Packing<2> make_periodic_packing(const Case&, const InitialState*, const Making&);
template Packing<3> make_periodic_packing(const Case&, const InitialState*, const Making&);

}  // namespace supple
