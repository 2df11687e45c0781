/// A case: every parameter of a run, with its default. Names are the keys of the TOML file; units and
/// meanings stand with the fields (case.cpp, case_bodies.cpp). Values are in SI, those of deformable
/// particles in their units.
#pragma once
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "supple/core/field.hpp"

namespace supple {

struct General {
  std::string experiment = "oscillatory_shear";
  std::string physics = "documented";
  std::int64_t seed = 1;
  int threads = 1;
};

struct Material {
  double young_modulus = 8000, density = 1000, friction = 0.01;
  double relative_viscosity = 0.1, relative_transversal_link_strength = 1;
  std::string elastic_law = "divergent", tensile_law = "linear";
  std::string elastic_expression;
  double central_repulsion_coefficient = 1;
  double plateau_begin = 0.3, plateau_end = 0.8, plateau_slope = 0.1;
  double tensile_range = 0.2;
  double attraction_range = 0.1;
  double interface_reenforcement_central = 1, interface_reenforcement_tangential = 1;
  bool keep_viscosity_coefficients_constant = false;
  std::string slip = "clamp", lever_arm = "distance";
};

struct Particles {
  int discs = 150;
  double packing_fraction = 1.5, bimodal_factor = 1.4;
  bool permanent_links = true;
  std::string cut = "voronoi";
  int cut_lines = 5;
  double edge_fuzziness = 0, avoid_horizontal_angle_degree = 15;
  bool avoid_height_spanning_particles = true, cut_top_bottom = false;
  int max_cut_tries = 1000;
  double remove_link_fraction = 0;
};

struct Cell {
  double width = 500e-6, height = 500e-6;
  std::string boundary = "lees_edwards", plates = "capture";
};

struct Shear {
  double amplitude = 0.2, relative_frequency = 0.025;
  double periods = 9;
  double pre_periods = 2, post_periods = 1;
  double cool_factor = 0.5;
  std::string rate = "0";
};

struct Stepping {
  double time_step = 0;    ///< 0: a share of the stability limit
  double step_factor = 1;  ///< multiplies the chosen step
  std::int64_t steps = 0;  ///< `dynamics` only
};

struct Preparation {
  double stress_tolerance = 0.1, max_time = 800;
};

struct Initial {
  std::string state;    ///< path of a state (Supple's run file or the reference's JSON); empty: random discs
  std::string packing;  ///< path of a packing of polygons (JSON); empty: made from [bodies]
  bool keep_time = false;  ///< time goes on from that of the state; else it starts at 0
};

/// What a deformable particle is made of.
struct ParticleKind {
  std::string family = "shell";
  int count = 64, vertices = 20;
  double shape_parameter = 0;  ///< 0: of the regular polygon
  double shape_ratio = 0;      ///< over that of the regular polygon; 0: not given
  double diameter_ratio = 1;
  /// Defaults of the family "shell"; see resolve_family. In 3D k_v is of the volume and k_a of triangles.
  double k_v = 1, k_a = 1, k_l = 1, k_b = 0.05, gamma = 0;
  double k_perimeter = 0;
  /// Of solids: spring, Young's modulus and Poisson's ratio. k_s = 0: from Young's modulus.
  double k_s = 1, young_modulus = 1, poisson_ratio = 0.3;
};

/// Deformable particles of one kind and two sizes, in units in which the preferred area (3D: volume) of a
/// small one is 1; and what holds for particles of any kind.
struct Bodies : ParticleKind {
  int dimensions = 2;
  std::string vertex_rule = "equal";
  double size_ratio = 1.4, large_fraction = 0.5;
  double shape_ratio_large = 0;  ///< 0: as of small ones
  std::string stiffness = "relative";
  int discs = 0;
  double yield_strain = 0, flow_time = 0;
};

/// One of several kinds in a sample, in place of [bodies].
struct Species : ParticleKind {
  double diameter = 1;  ///< of the disc with its preferred area, over that of area 1
  std::string name;     ///< empty: its place, from 1
};

struct ContactOfBodies {
  std::string kind = "rough", law = "linear";
  double attraction_range = 0.1;
  double k_c = 1, k_p = 4, floor_friction = 0.1;
  std::string unsound = "stop";  ///< what happens when particles get into each other
};

/// Contacts of the particles of two species. What the user does not give is as in [contact] and [material]
/// (pairs_of).
struct ContactOfSpecies {
  std::string first, second;  ///< names of the species, in the order of the alphabet
  std::string law = ContactOfBodies().law;
  double attraction_range = ContactOfBodies().attraction_range, k_c = ContactOfBodies().k_c;
  double friction = Material().friction, relative_viscosity = Material().relative_viscosity;
};

struct Minimisation {
  std::string method = "auto";
  double force_tolerance = 1e-6, least_force = 0;
  std::int64_t max_evaluations = 1000000;
};

struct Jamming {
  double packing_fraction = 1e-3, step = 1e-3;
  double pressure = 1e-7, window = 0.01;
  std::string search = "pressure", pressure_kind = "full";
};

struct Compression {
  double highest_pressure = 1e-2;
  int per_decade = 4;
  bool decompress = true;
};

struct Uniaxial {
  double strain = 0.2, step = 0.002, packing_fraction = 0.6, pressure = 1e-3, aspect_ratio = 1;
};

struct PlateCompression {
  double strain = 0.1, first = 1e-4;
  int steps = 60;
  std::string spacing = "logarithmic", orientation = "flat";
  bool decompress = true;
  double fit_from = 0, fit_to = 0, window = 0.5;
};

struct Slump {
  double gravity = 2e-4, width = 10, drop_spacing = 1.05;
  double settle_time = 150, spread_time = 500, rest = 1e-8;  ///< times in sqrt(1/gravity)
};

/// Two particles, one of which slides over the other.
struct Sliding {
  double overlap = 0.05, centre_distance = 0;  ///< centre_distance [R]; 0: from overlap [sigma]
  double from = 0, to = 0, step = 0.016;       ///< [D]; from = to = 0: from before to after all contacts
  std::string path = "forward", relaxation = "minimise";
  int cycles = 1;
  double noise = 0, tether_stiffness = 100;  ///< [sigma], [k_c]
  double least_force = 1e-6;                 ///< [k_c sigma]
  double rest = 1e-20;                       ///< [k_c sigma^2]
  std::int64_t most_steps = 2'000'000;
};

struct Motion {
  double damping = 0, kinetic_energy = 0;  ///< damping of `slump` and `friction`: see their rows
};

struct Output {
  std::string file;       ///< empty: <case name>.h5 beside the current folder
  bool tensors = true;    ///< every tensor at every step
  bool energies = false;  ///< the energy balance by channel at every step
  int frames =
      49;  ///< evenly spaced over the protocol, a quarter of a period by default; dynamics: every step
  int images = 0;  ///< evenly spaced images over the protocol
  std::string image_format = "png";
  bool plot = true;                   ///< also draw strain and stress against time
  double relative_y_scale_force = 0;  ///< end of the plot's stress axis; 0: what the data need
  bool snapshot = true;               ///< also draw the cell at the end
  bool text = false;                  ///< also write the published text format
};

/// A whole case. `given` names the keys ("section.key", or "seed" above any section) that the user set;
/// others have their defaults, which give way to what a state says. `origin` is the file that the case came
/// from, for errors and relative paths.
struct Case {
  General general;
  Material material;
  Particles particles;
  Cell box;
  Shear shear;
  Stepping time;
  Preparation preparation;
  Bodies bodies;
  std::vector<Species> species;  ///< empty: those of `bodies`
  ContactOfBodies contact;
  std::vector<ContactOfSpecies> pairs;  ///< in the order of their names; most have none
  Minimisation minimise;
  Jamming jamming;
  Compression compression;
  Uniaxial uniaxial;
  PlateCompression plates;
  Slump slump;
  Sliding sliding;
  Motion motion;
  Initial initial;
  Output output;
  std::set<std::string> given;
  std::string origin;

  bool is_given(const std::string& key) const { return given.count(key) > 0; }
};

template <class P>
const Fields<P>& fields();
template <>
const Fields<General>& fields();
template <>
const Fields<Material>& fields();
template <>
const Fields<Particles>& fields();
template <>
const Fields<Cell>& fields();
template <>
const Fields<Shear>& fields();
template <>
const Fields<Stepping>& fields();
template <>
const Fields<Preparation>& fields();
template <>
const Fields<Bodies>& fields();
template <>
const Fields<Species>& fields();
template <>
const Fields<ContactOfBodies>& fields();
template <>
const Fields<ContactOfSpecies>& fields();
template <>
const Fields<Minimisation>& fields();
template <>
const Fields<Jamming>& fields();
template <>
const Fields<Compression>& fields();
template <>
const Fields<Uniaxial>& fields();
template <>
const Fields<PlateCompression>& fields();
template <>
const Fields<Slump>& fields();
template <>
const Fields<Sliding>& fields();
template <>
const Fields<Motion>& fields();
template <>
const Fields<Initial>& fields();
template <>
const Fields<Output>& fields();

/// Name of the section [[species]] of this place in keys: "species.1" of the first.
std::string species_section(std::size_t index);
/// By what [contact.A.B] calls it: its name, or else its place, "1" of the first.
std::string name_of_species(const Case& c, std::size_t index);
/// Name of the section [contact.A.B] in keys.
std::string pair_section(const ContactOfSpecies& pair);
/// The contacts of two species in the case, new ones where it has none of them. The order does not matter.
ContactOfSpecies& contact_between(Case& c, std::string first, std::string second);
/// What a section is of: "species" of "species.2", "contact.A.B" of any pair, others as they are.
std::string kind_of_section(std::string_view section);
/// The section of a key, without its dot: "bodies" of "bodies.N", "species.1" of "species.1.N", "" of "seed".
inline std::string_view section_of(std::string_view key) {
  const auto dot = key.rfind('.');
  return dot == key.npos ? std::string_view() : key.substr(0, dot);
}
/// A case with one of every section.
Case every_section();

/// visit(section, struct) for each section in the order of the file; `general` holds the keys above any
/// section.
template <class AnyCase, class Visit>
void for_each_section(AnyCase& c, Visit&& visit) {
  visit("", c.general);
  visit("material", c.material);
  visit("particles", c.particles);
  visit("box", c.box);
  visit("shear", c.shear);
  visit("time", c.time);
  visit("preparation", c.preparation);
  visit("bodies", c.bodies);
  for (std::size_t k = 0; k < c.species.size(); ++k) visit(species_section(k), c.species[k]);
  visit("contact", c.contact);
  for (auto& pair : c.pairs) visit(pair_section(pair), pair);
  visit("minimise", c.minimise);
  visit("jamming", c.jamming);
  visit("compression", c.compression);
  visit("uniaxial", c.uniaxial);
  visit("plates", c.plates);
  visit("slump", c.slump);
  visit("sliding", c.sliding);
  visit("motion", c.motion);
  visit("initial", c.initial);
  visit("output", c.output);
}

/// visit("section.key", field, struct) for every parameter.
template <class AnyCase, class Visit>
void for_each_key(AnyCase& c, Visit&& visit) {
  for_each_section(c, [&](const std::string& section, auto& values) {
    for (const auto& field : fields<std::decay_t<decltype(values)>>())
      visit((section.empty() ? "" : section + ".") + std::string(field.name), field, values);
  });
}

/// The sections of which the case's experiment uses a key, in the order of the file.
std::vector<std::string> sections_of(const Case& c);

/// What is not given and follows from what is: the physics from the experiment, the stiffnesses from the
/// family [MacKeith 2025, Table 9.1]. What follows from the experiment: Experiment::complete.
void resolve_family(Case& c);

/// Checks what one key cannot know of others (a packing that cannot be reached, a plateau that ends before it
/// begins, ...). Throws one input error with a line for each problem. Ranges of single keys are checked where
/// the case is read.
void check(const Case& c);

/// Warnings of what is allowed but was probably not meant: keys without effect, protocols that cannot be
/// evaluated.
std::vector<std::string> find_doubts(const Case& c);

}  // namespace supple
