/// The sections of a case that say what is done with deformable particles.
#include "supple/experiment/case.hpp"

namespace supple {

template <>
const Fields<Minimisation>& fields() {
  using M = Minimisation;
  static const Fields<M> f{
      {"method",
       &M::method,
       "",
       "FIRE, then second order; or one of them alone",
       any_value,
       {"auto", "fire", "newton"}},
      {"force_tolerance", &M::force_tolerance, "mean contact force",
       "largest net force on a vertex in equilibrium", positive},
      {"least_force", &M::least_force, "",
       "net force that is equilibrium whatever touches; 0: from the wanted pressure", not_negative},
      {"max_evaluations", &M::max_evaluations, "", "force evaluations before a minimisation gives up",
       at_least_one},
  };
  return f;
}

template <>
const Fields<Jamming>& fields() {
  using J = Jamming;
  static const Fields<J> f{
      {"packing_fraction",
       &J::packing_fraction,
       "",
       "where the search starts, at random positions",
       {0, 0.8, true, false},
       {},
       Role::sample},
      {"step",
       &J::step,
       "",
       "largest relative step of the packing fraction where particles push each other; up to 0.02 while none "
       "does "
       "(chapter: never)",
       {0, 0.1, true, false}},
      {"pressure", &J::pressure, "k_a a0", "P_t of the jammed packing; k_c for discs and rigid particles",
       positive},
      {"window", &J::window, "", "done when 1 < P/P_t < 1 + window", positive},
      {"search",
       &J::search,
       "",
       "minima of the enthalpy, at first at a high pressure and with soft contacts (a packing that is given "
       "goes on by the root search); the chapter's halving of steps; or a root search along the packing "
       "fraction that ends in the same window",
       any_value,
       {"pressure", "root", "chapter"}},
      {"pressure_kind",
       &J::pressure_kind,
       "",
       "which pressure P is: the full virial (9.26), or of contacts alone",
       any_value,
       {"full", "contact"}},
  };
  return f;
}

template <>
const Fields<Compression>& fields() {
  using C = Compression;
  static const Fields<C> f{
      {"highest_pressure", &C::highest_pressure, "k_a a0",
       "last pressure of the list that starts at jamming.pressure", positive},
      {"per_decade", &C::per_decade, "", "pressures per decade, spaced logarithmically", at_least_one},
      {"decompress", &C::decompress, "", "also go back through the list"},
  };
  return f;
}

template <>
const Fields<Uniaxial>& fields() {
  using U = Uniaxial;
  static const Fields<U> f{
      {"strain", &U::strain, "", "how far the upper wall comes down, over the height", {0, 0.9, true, false}},
      {"step", &U::step, "", "strain between two minimisations", {0, 0.1, true, false}},
      {"packing_fraction",
       &U::packing_fraction,
       "",
       "of the area between the walls at random positions",
       {0, 0.95, true, false},
       {},
       Role::sample},
      {"pressure",
       &U::pressure,
       "k_a a0",
       "to which all walls squeeze the particles before the compression; 0: they do not. k_c for discs and "
       "rigid "
       "particles",
       not_negative,
       {},
       Role::sample},
      {"aspect_ratio",
       &U::aspect_ratio,
       "",
       "height over width of the box before the compression",
       positive,
       {},
       Role::sample},
  };
  return f;
}

template <>
const Fields<PlateCompression>& fields() {
  using P = PlateCompression;
  static const Fields<P> f{
      {"strain",
       &P::strain,
       "",
       "largest compression: how much nearer the plates come, over their distance at first touch",
       {0, 0.9, true, false}},
      {"steps",
       &P::steps,
       "",
       "of the upper plate on its way down, each with a minimisation",
       {1, 1e6, false, false}},
      {"spacing",
       &P::spacing,
       "",
       "of the compressions: logarithmic from plates.first on, or linear",
       any_value,
       {"logarithmic", "linear"}},
      {"first", &P::first, "", "least compression of logarithmic steps", {0, 0.9, true, false}},
      {"decompress", &P::decompress, "", "also move the plate up again through the same compressions"},
      {"orientation",
       &P::orientation,
       "",
       "what of the particle faces the lower plate: its first edge (3D: triangle), its first vertex, or what "
       "does as it is made, turned at random by the seed; a state stays as it is",
       any_value,
       {"flat", "corner", "as_made"}},
      {"fit_from", &P::fit_from, "",
       "least compression of the fitted exponent; 0: where five vertices touch each plate, or a decade below "
       "plates.fit_to where that is less",
       not_negative},
      {"fit_to", &P::fit_to, "", "largest compression of the fitted exponent; 0: plates.strain",
       not_negative},
      {"window",
       &P::window,
       "decades",
       "of compression over which each local exponent is fitted",
       {0.05, 5, false, false}},
  };
  return f;
}

template <>
const Fields<Slump>& fields() {
  using S = Slump;
  static const Fields<S> f{
      {"gravity", &S::gravity, "", "acceleration downward; a vertex has mass 1", positive, {}, Role::law},
      {"width", &S::width, "mean particle diameter", "of the box in which the heap settles", at_least_one},
      {"drop_spacing", &S::drop_spacing, "largest particle diameter",
       "between the particles before they fall", at_least_one},
      {"settle_time", &S::settle_time, "sqrt(1/gravity)",
       "before the right wall is taken away, at most: less if all comes to rest", positive},
      {"spread_time", &S::spread_time, "sqrt(1/gravity)", "after it, at most", positive},
      {"rest", &S::rest, "", "kinetic energy of a heap at rest, over that of a fall of all by one diameter",
       positive},
  };
  return f;
}

template <>
const Fields<Sliding>& fields() {
  using S = Sliding;
  static const Fields<S> f{
      {"overlap", &S::overlap, "sigma",
       "how far below the height at which the upper particle would first touch the lower one at x = 0, in "
       "the "
       "shapes that they start with: rough, its lowest vertex both vertices of the groove; smooth, the flat "
       "edge"},
      {"centre_distance", &S::centre_distance, "R",
       "height of the upper centre over the lower one at the start, over the radius of the circle through "
       "the vertices of the lower, regular one; 0: from overlap",
       not_negative},
      {"from", &S::from, "D",
       "x where the upper particle starts, over the width of the lower one; from = to = 0: before the first "
       "contact"},
      {"to", &S::to, "D", "x where it ends; from = to = 0: after the last contact"},
      {"step", &S::step, "D", "between two relaxations", {0, 1, true, false}},
      {"path",
       &S::path,
       "",
       "from left to right, from right to left, or there and back again",
       any_value,
       {"forward", "backward", "cyclic"}},
      {"cycles", &S::cycles, "", "how often there and back again", {1, 1e4}},
      {"relaxation",
       &S::relaxation,
       "",
       "after each step: minimisation of the energy, or motion with drag until it has died down",
       any_value,
       {"minimise", "dynamics"}},
      {"rest", &S::rest, "k_c sigma^2", "kinetic energy below which motion has died down", positive},
      {"most_steps", &S::most_steps, "", "time steps of one relaxation before it gives up", at_least_one},
      {"noise", &S::noise, "sigma",
       "largest displacement of the vertices, each for itself, along x and along y, before the particles "
       "relax alone into the shapes that they start with",
       not_negative},
      {"least_force", &S::least_force, "k_c sigma",
       "results leave places out where the force between the two is smaller: floppy particles make way until "
       "hardly any is left",
       not_negative},
      {"tether_stiffness", &S::tether_stiffness, "k_c", "stiffness of the springs that hold vertices",
       positive},
  };
  return f;
}

template <>
const Fields<Motion>& fields() {
  using M = Motion;
  static const Fields<M> f{
      {"damping",
       &M::damping,
       "1/time",
       "drag -m damping v on every vertex; slump: sqrt(gravity) unless given; friction: sqrt(k_c/m)",
       not_negative,
       {},
       Role::law},
      {"kinetic_energy", &M::kinetic_energy, "", "mean kinetic energy of a vertex at the start",
       not_negative},
  };
  return f;
}

}  // namespace supple
