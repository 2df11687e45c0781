#include "supple/experiment/case.hpp"

#include "supple/contact/laws/list.hpp"
#include "supple/experiment/experiments.hpp"

namespace supple {

namespace {

/// Names that live as long as the program.
std::vector<std::string_view> lasting(const std::vector<std::string>& names) {
  return {names.begin(), names.end()};
}

}  // namespace

namespace {
constexpr Range at_least_zero = not_negative;
}

template <>
const Fields<General>& fields() {
  static const std::vector<std::string> experiments_there = experiment_names(),
                                        physics_there = physics_names();
  static const Fields<General> f{
      {"experiment", &General::experiment, "", "what to run", any_value, lasting(experiments_there)},
      {"physics", &General::physics, "",
       "microgel discs as documented, or as the published package computes them; or deformable particles",
       any_value, lasting(physics_there), Role::law},
      {"seed", &General::seed, "", "key of all random numbers", at_least_zero},
      {"threads", &General::threads, "", "threads; results do not depend on it", {1, 1024}},
  };
  return f;
}

template <>
const Fields<Material>& fields() {
  using M = Material;
  static const Fields<M> all{
      {"young_modulus", &M::young_modulus, "Pa", "Young modulus of the discs; k = (pi/8) E (S1-8)", positive},
      {"density", &M::density, "kg/m^3", "density of the discs", positive, {}, Role::sample},
      {"friction", &M::friction, "", "Coulomb coefficient mu of contacts", not_negative},
      {"relative_viscosity", &M::relative_viscosity, "", "viscosity over sqrt(m k) (S1-9)", not_negative},
      {"relative_transversal_link_strength", &M::relative_transversal_link_strength, "",
       "tangential over central stiffness, k_t/k", not_negative},
      {"elastic_law", &M::elastic_law, "", "elastic law of contacts of discs", any_value, laws_of_discs()},
      {"elastic_expression", &M::elastic_expression, "N/m",
       "repulsion as an expression of d, d0, k, c (law \"expression\")"},
      {"central_repulsion_coefficient", &M::central_repulsion_coefficient, "",
       "c: 1 divergent (S1-5b), 0 linear (S1-5a)", fraction},
      {"plateau_begin", &M::plateau_begin, "d0", "inner end of the plateau", {0, 1, true, true}},
      {"plateau_end", &M::plateau_end, "d0", "outer end of the plateau", {0, 1, true, false}},
      {"plateau_slope", &M::plateau_slope, "", "slope of the plateau", {0, 1, true, false}},
      {"attraction_range",
       &M::attraction_range,
       "d0",
       "beyond contact, of the law \"adhesive\"",
       {0, 1, true, false}},
      {"tensile_law",
       &M::tensile_law,
       "",
       "attraction of stretched links: k |delta|; stiffening; or saturating, as in the package",
       any_value,
       {"linear", "exponential", "saturating"}},
      {"tensile_range", &M::tensile_range, "d0", "range of the exponential tensile law", positive},
      {"interface_reenforcement_central", &M::interface_reenforcement_central, "",
       "contact over link stiffness, central", positive},
      {"interface_reenforcement_tangential", &M::interface_reenforcement_tangential, "",
       "contact over link stiffness, tangential", positive},
      {"keep_viscosity_coefficients_constant", &M::keep_viscosity_coefficients_constant, "",
       "leave viscosities alone where stiffness is re-enforced"},
      {"slip",
       &M::slip,
       "",
       "tangential spring in slip: held at the Coulomb limit, frozen, or reset",
       any_value,
       {"clamp", "freeze", "reset"}},
      {"lever_arm",
       &M::lever_arm,
       "",
       "arms of the tangential speed: shares of the distance, or the radii",
       any_value,
       {"distance", "radius"}},
  };
  static const Fields<M> f = with_role(Role::law, all);
  return f;
}

template <>
const Fields<Particles>& fields() {
  using P = Particles;
  static const Fields<P> all{
      {"N", &P::discs, "", "number of discs", {1, 1e7}},
      {"packing_fraction",
       &P::packing_fraction,
       "",
       "area of all discs over area of the cell (S1-14)",
       {0, 5, true, false}},
      {"bimodal_factor", &P::bimodal_factor, "", "large over small radius", {1, 100}},
      {"permanent_links", &P::permanent_links, "", "crosslink touching discs into particles"},
      {"cut",
       &P::cut,
       "",
       "how the crosslinked scaffold is cut into particles",
       any_value,
       {"voronoi", "lines"}},
      {"cut_lines", &P::cut_lines, "", "Voronoi points, or lines; 0 or 1 point: bulk scaffold", {0, 1e6}},
      {"edge_fuzziness", &P::edge_fuzziness, "largest radius", "roughness of the Voronoi edges",
       not_negative},
      {"avoid_horizontal_angle_degree",
       &P::avoid_horizontal_angle_degree,
       "degree",
       "lines nearer to horizontal are drawn again",
       {0, 90, false, true}},
      {"avoid_height_spanning_particles", &P::avoid_height_spanning_particles, "",
       "cut again while a particle is taller than 0.9 of the cell"},
      {"max_cut_tries", &P::max_cut_tries, "", "cuts tried before giving up", at_least_one},
      {"cut_top_bottom", &P::cut_top_bottom, "", "also cut along the two plates (wall slip)"},
      {"remove_link_fraction",
       &P::remove_link_fraction,
       "",
       "fraction of links removed at random; particles stay connected",
       {0, 1, false, true}},
  };
  static const Fields<P> f = with_role(Role::sample, all);
  return f;
}

template <>
const Fields<Cell>& fields() {
  static const Fields<Cell> all{
      {"width", &Cell::width, "m", "length along the flow", positive, {}, Role::sample},
      {"height", &Cell::height, "m", "gap between the plates", positive, {}, Role::sample},
      {"boundary",
       &Cell::boundary,
       "",
       "Lees-Edwards; periodic without shear; or none, with discs fixed at the edge",
       any_value,
       {"lees_edwards", "periodic", "fixed"}},
      {"plates",
       &Cell::plates,
       "",
       "discs at a plate join it; are only repelled by it; or there are no plates. Vertices and rigid "
       "particles "
       "join it; none unless given",
       any_value,
       {"capture", "repulsive", "none"}},
  };
  static const Fields<Cell> f = with_role(Role::law, all);
  return f;
}

template <>
const Fields<Shear>& fields() {
  using S = Shear;
  static const Fields<S> f{
      {"amplitude", &S::amplitude, "", "strain amplitude A; 0.2 is 20 %", {0, 10, true, false}},
      {"relative_frequency", &S::relative_frequency, "1/tau", "frequency times tau = sqrt(m/k)", positive},
      {"periods", &S::periods, "", "periods of shear", positive},
      {"pre_periods", &S::pre_periods, "", "periods of rest before", not_negative},
      {"post_periods", &S::post_periods, "", "periods of rest after", not_negative},
      {"cool_factor",
       &S::cool_factor,
       "",
       "factor per period on velocity relative to the flow, and on spin",
       {0, 1, true, false},
       {},
       Role::law},
      {"rate", &S::rate, "1/s", "shear rate as an expression of t [s] (dynamics)"},
  };
  return f;
}

template <>
const Fields<Stepping>& fields() {
  static const Fields<Stepping> f{
      {"step", &Stepping::time_step, "s", "time step; 0: from the stability criterion", not_negative},
      {"step_factor", &Stepping::step_factor, "", "multiplies the chosen step", positive},
      {"steps", &Stepping::steps, "", "number of steps (dynamics)", {0, 1e12}},
  };
  return f;
}

template <>
const Fields<Preparation>& fields() {
  using P = Preparation;
  static const Fields<P> all{
      {"stress_tolerance", &P::stress_tolerance, "",
       "relax until the stress fluctuates by less than this share of E/100, whatever is done to the sample",
       positive},
      {"max_time", &P::max_time, "tau", "give up when one relaxation takes longer; tau = sqrt(m/k)",
       positive},
  };
  static const Fields<P> f = with_role(Role::sample, all);
  return f;
}

template <>
const Fields<Initial>& fields() {
  static const Fields<Initial> f{
      {"state", &Initial::state, "", "file to start from: a run of Supple, or the reference's JSON"},
      {"packing", &Initial::packing, "", "packing of deformable particles to start from: a JSON file"},
      {"keep_time", &Initial::keep_time, "",
       "go on from the state's time and step (dynamics); else t starts at 0"},
  };
  return f;
}

template <>
const Fields<Output>& fields() {
  static const Fields<Output> f{
      {"file", &Output::file, "", "the run; empty: name of the case with .h5"},
      {"tensors", &Output::tensors, "", "keep every tensor at every step (discs of microgels)"},
      {"energies", &Output::energies, "",
       "keep energies, work and losses by channel at every step (discs of microgels)"},
      {"frames", &Output::frames, "",
       "evenly spaced frames of the protocol; dynamics keeps every step unless this is given", at_least_one},
      {"images", &Output::images, "", "evenly spaced images of the protocol", not_negative},
      {"image_format",
       &Output::image_format,
       "",
       "format of the images",
       any_value,
       {"png", "jpg", "svg", "pdf", "ps"}},
      {"plot", &Output::plot, "", "also draw the figure of the experiment, beside the run"},
      {"relative_y_scale_force", &Output::relative_y_scale_force, "Young modulus",
       "where the plot's stress axis ends (discs of microgels); 0: what the data need", not_negative},
      {"snapshot", &Output::snapshot, "", "also draw the cell at the end, beside the run"},
      {"text", &Output::text, "", "also write the published text format (oscillatory_shear)"},
  };
  return f;
}

}  // namespace supple
