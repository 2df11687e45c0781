#include "supple/compat/particleshear/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

#include "supple/experiment/initial_state.hpp"
#include "supple/io/text/number_text.hpp"

namespace supple {
namespace {

/// A double that is a float in the package, and one that is an int where it is whole.
std::string real(double x) { return python_float(x); }
std::string number(double x) { return python_number(x); }
std::string truth(bool x) { return x ? "True" : "False"; }

/// Everything the header needs, in the package's units: micrometre, mg, s.
struct Facts {
  explicit Facts(const RunFile& run) : c(run.resolved_case()), info(run.info()) {
    const Units units = particleshear_units();
    const auto constant = [&](const char* name, double unit = 1) {
      return run.value("constants", name) / unit;
    };
    mass = constant("mean_mass", units.mass);
    spring = constant("link_spring_constant", units.stiffness());
    tau = constant("time_constant");
    frequency = constant("frequency");
    time_step = constant("time_step");
    damping = constant("damping_factor");
    removed_links = run.find_value("constants", "removed_link_fraction").value_or(0);

    const auto material = [&](const char* name, double unit = 1) {
      return run.value(material_group, name) * unit;
    };
    const double stiffness = info.units.stiffness() / units.stiffness();
    const double viscosity = info.units.viscosity() / units.viscosity();
    k = material("k", stiffness);
    k_t = material("k_t", stiffness);
    nu = material("nu", viscosity);
    nu_t = material("nu_t", viscosity);
    mu = material("mu");
    ratio_central = material("permanent_ratio_central");
    ratio_tangential = material("permanent_ratio_tangential");
    to_length = info.units.length / units.length;
    to_mass = info.units.mass / units.mass;
  }
  std::string width() const { return number(info.box.length[0] * to_length); }
  std::string height() const { return number(info.box.length[1] * to_length); }
  /// A single Voronoi cell always spans the height.
  bool avoids_height_spanning() const {
    return c.particles.avoid_height_spanning_particles &&
           !(c.particles.cut == "voronoi" && c.particles.cut_lines <= 1);
  }

  Case c;
  RunInfo<2> info;
  double mass, spring, tau, frequency, time_step, damping, removed_links;
  double k, k_t, nu, nu_t, mu, ratio_central, ratio_tangential;
  double to_length, to_mass;
};

std::string title(const Facts& f) {
  const Particles& p = f.c.particles;
  const std::string kind =
      !p.permanent_links ? "Dermal filler control ensemble: No permanent links\n"
      : p.cut_lines <= 0
          ? "Dermal filler control ensemble: no cut lines \n"
          : fmt::format("Dermal filler Ensemble: \n\tCutting lines used to generate the particles{}\n",
                        p.cut_lines);
  return kind + fmt::format(
                    "\tN={} spheres, nominal packing density = {}\n"
                    "\tYoung modulus of the individual spheres = {} Pa \n"
                    "\tFriction coefficient = {}\n\n\n\n",
                    f.info.radius.size(), number(p.packing_fraction), number(f.c.material.young_modulus),
                    number(f.c.material.friction));
}

std::string function_call(const Facts& f, const std::string& folder) {
  const Material& m = f.c.material;
  const Particles& p = f.c.particles;
  const bool images = f.c.output.images > 0;
  const std::vector<std::pair<const char*, std::string>> arguments{
      {"root_folder", folder},
      {"do_permanent_links", truth(p.permanent_links)},
      {"cut_lines", std::to_string(p.cut_lines)},
      {"N", std::to_string(f.info.radius.size())},
      {"packing_fraction", number(p.packing_fraction)},
      {"bimodal_factor", number(p.bimodal_factor)},
      {"amplitude", number(f.c.shear.amplitude)},
      {"Young_modulus_spheres", number(m.young_modulus)},
      {"density", number(m.density)},
      {"mu", number(m.friction)},
      {"relative_viscosity", number(m.relative_viscosity)},
      {"relative_y_scale_force", "100000000.0"},  // of a plot; the package's default
      {"relative_frequency", number(f.c.shear.relative_frequency)},
      {"relative_transversal_link_strength", number(m.relative_transversal_link_strength)},
      {"central_repulsion_coefficient", number(m.central_repulsion_coefficient)},
      {"avoid_horizontal_angle_degree", number(p.avoid_horizontal_angle_degree)},
      {"avoid_height_spanning_particles", truth(p.avoid_height_spanning_particles)},
      {"interface_reenforcement_central", number(m.interface_reenforcement_central)},
      {"interface_reenforcement_tangential", number(m.interface_reenforcement_tangential)},
      {"keep_viscosity_coefficients_constant", truth(m.keep_viscosity_coefficients_constant)},
      {"cut_top_bottom", truth(p.cut_top_bottom)},
      {"doCutByTriangulation", truth(p.cut == "voronoi")},
      {"remove_link_fraction", number(p.remove_link_fraction)},
      {"edge_fuzziness", number(p.edge_fuzziness)},
      {"doDrawing", truth(images)},
  };
  std::string text = "Function call : \nSimulation_interlocking_rheology(";
  for (const auto& [name, value] : arguments)
    text += fmt::format("{}{}={}", text.back() == '(' ? "" : ",", name, value);
  const Shear& s = f.c.shear;
  return text +
         fmt::format(
             ")\n\ttheSimulation.baseline_pre_periods = {}\n\ttheSimulation.baseline_post_periods = {}\n"
             "\ttheSimulation.saveOutputImages = {}\n\ttheSimulation.imageFileType = {}\n"
             "\ttheSimulation.runSimulation(periods={}, cool_factor={})\n\n",
             number(s.pre_periods), number(s.post_periods), truth(images), f.c.output.image_format,
             number(s.periods), number(s.cool_factor));
}

std::string model_parameters(const Facts& f) {
  return fmt::format(
      "Oscillatory shear experiment\n\nModel parameters\n"
      "Width of simulation area size_x ={}micrometers\nHeight of simulation area size_y ={}micrometers\n"
      "Nominal packing fraction = {}\nYoung modulus spheres = {}Pa\nRelative density spheres = {}kg/m^3\n"
      "Characteristic time constant = {}s\nCharacteristic spring constant = {}mg/s^2\n"
      "Characteristic viscosity  = {}mg/s\n\n",
      f.width(), f.height(), number(f.c.particles.packing_fraction), number(f.c.material.young_modulus),
      number(f.c.material.density), real(f.tau), real(f.spring), real(f.spring * f.tau));
}

/// The package prints the largest radius, 0.8/1.2 of it in place of the smallest, and the mass of the first
/// disc.
std::string disc_information(const Facts& f) {
  const double largest = *std::max_element(f.info.radius.begin(), f.info.radius.end()) * f.to_length;
  return fmt::format(
      "Particle number = {}\nParticle information\n"
      "\tFrictional spheres under Lees-Edwards boundary conditions, organized in fixed particles, "
      "adjustment ofstrength between permament and temporary interfaces\n"
      "\tSpheres with, bimodal distribution, equal probability, \n"
      "\tr1={}r2={}\n\tidentical mass={}mg\n",
      f.info.radius.size(), real(largest * 0.8 / 1.2), real(largest), real(f.info.mass[0] * f.to_mass));
}

/// Links against free contacts; the characteristic spring is that of links, which re-enforcement leaves
/// alone. Of the two texts on viscosity and on height only the first of each is documented.
std::string link_parameters(const Facts& f) {
  const bool keep = f.c.material.keep_viscosity_coefficients_constant;
  return fmt::format(
      "Adjustment coefficient for central force in permanent links = {}[-], 0=no central force, 1=as in "
      "free interfaces; >1 re-enforcement of permanent over transient links\n"
      "\tk_permanent={}mg*s^(-2)\n"
      "Adjustment coefficient for tangential force in permanent links = {}[-], 0=no tangential force, 1=as "
      "in free interfaces; >1 re-enforcement of permanent over transient links\n"
      "\tk_t_permanent={}mg*s^(-2)\n"
      "Viscosity adjustment for permanent links:\n\tAdjustment: {}\n"
      "\tnu_permanent={}\n\tnu_t_permanent={}\n"
      "avoid_height_spanning_particles: Ensembles with full height spanning particles {}\n",
      real(f.ratio_central), real(f.k * f.ratio_central), real(f.ratio_tangential),
      real(f.k_t * f.ratio_tangential),
      keep ? "Keep viscosity (central and tangential) constant"
           : "Adjust viscosity (central and tangential) by same factor as the respective spring constant "
             "(k and k_t)",
      real(f.nu * (keep ? 1 : f.ratio_central)), real(f.nu_t * (keep ? 1 : f.ratio_tangential)),
      f.avoids_height_spanning() ? "discarded" : "accepted");
}

std::string ensemble_parameters(const Facts& f) {
  return fmt::format(
             "Ensemble parameters\nParticle mass m = {}mg\nCentral spring constant k = {}mg*s^(-2)\n"
             "Central viscosity constant nu = {}mg*s^(-1)\nLateral spring constant k_t = {}mg*s^(-2)\n"
             "Lateral viscosity constant nu_t = {}mg*s^(-1)\nFriction coefficient mu = {}\n"
             "Sample width = {}micrometers\nSample height = Gap height = {}micrometers\n",
             real(f.mass), real(f.k), real(f.nu), real(f.k_t), real(f.nu_t), number(f.mu), f.width(),
             f.height()) +
         disc_information(f) +
         fmt::format(
             "Nonlinear enhancement for repulsion near sphere center = {}[-], 0=no enhancement, 1=maximum "
             "enhancement; see CircleBasicElasticity.get_elastic_force\n",
             number(f.c.material.central_repulsion_coefficient)) +
         link_parameters(f) +
         fmt::format(
             "Actual fraction of randomly removed non-essential permanent bonds = {}[-]\n\n"
             "Edge fuzziness for creating interlocking = {}[-]\n\n\n",
             number(f.removed_links), number(f.c.particles.edge_fuzziness));
}

/// As in the package, the simulated time is that of the shear alone, and the third number of periods is the
/// first again.
std::string experiment_information(const Facts& f) {
  const Shear& s = f.c.shear;
  return fmt::format(
      "Rheology experiment information\nSimulated time = {}s\nTime step = {}s\nFrequency = {}Hz\n"
      "Strain amplitude = {}%\nDamping factor = {} [1 = no damping]\nPre-measurement periods = {} [-]\n"
      "Oscillatory shear periods = {} [-]\nPost-measurement periods = {} [-]\n\n\n",
      real(s.periods / f.frequency), real(f.time_step), real(f.frequency), real(s.amplitude * 100),
      real(f.damping), number(s.pre_periods), number(s.periods), number(s.pre_periods));
}

std::string summary(const RunFile& run) {
  const auto result = [&](const char* name) { return run.value("results", name); };
  const double in = result("in_phase_stress_internal"), out = result("out_of_phase_stress_internal");
  return fmt::format(
      "Output data\nSummary data\nIn phase stress = {}Pa\nOut of phase stress = {}Pa\nStress = {}Pa\n"
      "G'={}Pa\nG''={}Pa\nG'(by surface force)={}Pa\nG''(by surface force)={}Pa\n\n\n",
      real(in), real(out), real(std::sqrt(in * in + out * out)), real(result("storage_modulus_internal")),
      real(result("loss_modulus_internal")), real(result("storage_modulus_external")),
      real(result("loss_modulus_external")));
}

/// The package's names of the tensors, in the order of its text (Table S2-3).
constexpr std::pair<const char*, const char*> text_tensors[] = {
    {"stress_tensor_Love_Weber", "love_weber"},
    {"stress_tensor_peculiar_acceleration_otsuki", "otsuki"},
    {"stress_tensor_from_external_forces", "external"},
    {"stress_tensor_linear_acceleration", "linear_acceleration"},
    {"stress_tensor_unbalanced_linear_forces", "linear_acceleration"},
    {"stress_tensor_tangential_torque", "tangential_torque"},
    {"stress_tensor_internal_tangential_torque", "internal_torque"},
    {"stress_tensor_centrifugal", "centrifugal"},
    {"stress_tensor_overall", "overall"},
};

void write_tensors(const RunFile& run, NewFile& file) {
  std::string text =
      "index\tt\tstrain\tstrain_rate\tstress_measured_at_surface\tshear_stress_internal_stress-tensor";
  std::vector<std::vector<double>> columns;
  for (const char* name : {"strain", "strain_rate", "shear_stress_external", "shear_stress_internal"})
    columns.push_back(run.column("stress", name));
  for (const auto& [as, name] : text_tensors)
    for (const char* component : {"_00", "_01", "_10", "_11"}) {
      text += '\t' + (as + std::string(component));
      columns.push_back(run.column("stress", std::string(name) + component));
    }
  constexpr std::size_t strain_rate = 1;
  const std::vector<double> time = run.column("stress", "t");
  for (std::size_t row = 0; row < time.size(); ++row) {
    // The package starts from the int 0, and has a rate of int 0 at rest.
    text += '\n' + std::to_string(row) + '\t' + (row == 0 ? number(time[row]) : real(time[row]));
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const double x = columns[c][row];
      text += '\t';
      text += c == strain_rate && x == 0 ? "0" : real(x);
    }
    file.write(text);
    text.clear();
  }
  file.write(text);
}

}  // namespace

void export_published_text(const RunFile& run, const std::string& path, Existing existing) {
  const Facts facts(run);
  NewFile file(path, existing);
  const std::string folder = std::filesystem::path(path).parent_path().string();
  file.write(title(facts) + function_call(facts, folder.empty() ? "." : folder) + model_parameters(facts) +
             ensemble_parameters(facts) + experiment_information(facts) + summary(run) +
             "Detailed stress tensor data\n");
  const auto columns = run.columns("stress");
  const bool tensors =
      std::any_of(columns.begin(), columns.end(), [](const Column& c) { return c.name == "overall_00"; });
  if (tensors) write_tensors(run, file);
  else
    file.write(
        "\tNot saving detailed stress tensor data. If you wish to save this data, pass\n\t  "
        "saveStressTensorData=True");
  file.commit();
}

std::string published_text_path(const RunFile& run, const std::string& folder) {
  const Case c = run.resolved_case();
  const std::string kind = !c.particles.permanent_links ? "_uncrosslinked"
                           : c.particles.cut_lines <= 0 ? "_bulk"
                                                        : "";
  const auto rounded = [](double x, double digits) { return real(std::nearbyint(x * digits) / digits); };
  const std::string stem =
      fmt::format("{}/dermal_filler{}{}_f_{}_strain_{}_nr_", folder, kind, number(c.material.friction),
                  rounded(run.value("constants", "frequency"), 1e4), rounded(c.shear.amplitude, 1e5));
  for (int n = 1;; ++n)
    if (const std::string path = stem + std::to_string(n) + ".txt"; !std::filesystem::exists(path))
      return path;
}

}  // namespace supple
