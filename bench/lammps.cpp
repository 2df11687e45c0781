#include "bench/lammps.hpp"

#include <fmt/os.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <numeric>

#include "supple/core/error.hpp"

namespace supple::bench {
namespace {

void write_discs(const std::string& path, const System<2>& system) {
  const State<2>& s = system.state;
  auto file = fmt::output_file(path);
  file.print("Dense discs\n\n{} atoms\n1 atom types\n\n", s.size());
  file.print("0 {:.17g} xlo xhi\n0 {:.17g} ylo yhi\n-0.5 0.5 zlo zhi\n\nAtoms\n\n", system.box.length[0],
             system.box.length[1]);
  // Density of a sphere of this mass: `fix nve/sphere disc` takes mass as it is and the moment of inertia of
  // a disc.
  for (int i = 0; i < s.size(); ++i) {
    const double diameter = 2 * s.radius[i], volume = std::numbers::pi / 6 * diameter * diameter * diameter;
    file.print("{} 1 {:.17g} {:.17g} {:.17g} {:.17g} 0\n", i + 1, diameter, s.mass[i] / volume,
               s.position[i][0], s.position[i][1]);
  }
  file.print("\nVelocities\n\n");
  for (int i = 0; i < s.size(); ++i)
    file.print("{} {:.17g} {:.17g} 0 0 0 {:.17g}\n", i + 1, s.velocity[i][0], s.velocity[i][1], s.spin[i]);
}

/// The number behind the first `label` in the text; 0 where there is none.
double number_after(const std::string& text, const std::string& label) {
  const auto at = text.find(label);
  return at == std::string::npos ? 0 : std::strtod(text.c_str() + at + label.size(), nullptr);
}

/// The number at the start of the first line that holds `label`.
double number_before(const std::string& text, const std::string& label) {
  const auto at = text.find(label);
  return at == std::string::npos ? 0 : std::strtod(text.c_str() + text.rfind('\n', at) + 1, nullptr);
}

std::string output_of(const std::string& command) {
  FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  char part[4096];
  while (pipe && std::fgets(part, sizeof part, pipe)) text += part;
  if (!pipe || pclose(pipe) != 0)
    throw file_error("'" + command + "' failed", text,
                     "see whether LAMMPS is installed: scripts/deps --bench");
  return text;
}

}  // namespace

void write_lammps_case(const std::string& folder, const System<2>& system, const DiscLaw& law,
                       double time_step) {
  write_discs(folder + "/discs.data", system);
  const State<2>& s = system.state;
  // Its damping is per effective mass of the pair; this is the one of the mean mass.
  const double effective = 0.5 * std::accumulate(s.mass.begin(), s.mass.end(), 0.0) / s.size();
  auto file = fmt::output_file(folder + "/in.discs");
  file.print("units lj\ndimension 2\natom_style sphere\nboundary p p p\nnewton off\ncomm_modify vel yes\n");
  file.print("read_data {}/discs.data\n", folder);
  file.print("neighbor ${{skin}} bin\nneigh_modify every 1 delay 0 check yes\n");
  file.print("pair_style gran/hooke/history {} {} {} {} {} 1\npair_coeff * *\n", law.contact.k,
             law.contact.k_t, law.contact.eta / effective, law.contact.eta_t / effective, law.friction);
  file.print("timestep {}\nfix motion all nve/sphere disc\nfix plane all enforce2d\n", time_step);
  file.print("thermo 100000000\nrun ${{steps}}\n");
  // What it ends with; after the run, so that it costs no time.
  const double mean_mass = std::accumulate(s.mass.begin(), s.mass.end(), 0.0) / s.size();
  file.print("compute touching all contact/atom\ncompute contacts all reduce ave c_touching\n");
  file.print("variable speed equal sqrt(ke/{:.17g})\nvariable contacts equal c_contacts\n", mean_mass);
  file.print("thermo_style custom step ke c_contacts\nthermo_modify norm yes\nrun 0 post no\n");
  file.print("print \"rms speed ${{speed}}\"\nprint \"contacts ${{contacts}}\"\n");
}

LammpsRun run_lammps(const std::string& folder, int steps, double skin) {
  const std::string text = output_of(
      fmt::format("OMP_NUM_THREADS=1 lmp -in {0}/in.discs -log {0}/log -var steps {1} -var skin {2} 2>&1",
                  folder, steps, skin));
  const double share = std::min(1.0, 0.01 * number_before(text, "% CPU use"));
  return {share * number_after(text, "Loop time of"),
          static_cast<long>(number_after(text, "Neighbor list builds =")), number_after(text, "\nrms speed"),
          number_after(text, "\ncontacts")};
}

bool lammps_found() { return std::system("command -v lmp >/dev/null 2>&1") == 0; }

}  // namespace supple::bench
