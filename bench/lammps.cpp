#include "bench/lammps.hpp"

#include <fmt/os.h>

#include <algorithm>
#include <array>
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
  file.print("0 {:.17g} xlo xhi\n0 {:.17g} ylo yhi\n-0.5 0.5 zlo zhi\n\nAtoms\n\n", system.box.length[0], system.box.length[1]);
  // Density of a sphere of this mass: `fix nve/sphere disc` takes mass as it is and the moment of inertia of a disc.
  for (int i = 0; i < s.size(); ++i) {
    const double diameter = 2 * s.radius[i], volume = std::numbers::pi / 6 * diameter * diameter * diameter;
    file.print("{} 1 {:.17g} {:.17g} {:.17g} {:.17g} 0\n", i + 1, diameter, s.mass[i] / volume, s.position[i][0], s.position[i][1]);
  }
  file.print("\nVelocities\n\n");
  for (int i = 0; i < s.size(); ++i)
    file.print("{} {:.17g} {:.17g} 0 0 0 {:.17g}\n", i + 1, s.velocity[i][0], s.velocity[i][1], s.spin[i]);
}

/// Numbers after `label` in the text; zeros where it is not there.
template <std::size_t n>
std::array<double, n> numbers_after(const std::string& text, const std::string& label) {
  std::array<double, n> found{};
  const auto at = text.rfind(label);
  if (at == std::string::npos) return found;
  const char* next = text.c_str() + at + label.size();
  for (double& x : found) {
    char* end = nullptr;
    x = std::strtod(next, &end);
    next = end;
  }
  return found;
}

std::string output_of(const std::string& command) {
  FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  std::array<char, 4096> part;
  while (pipe && std::fgets(part.data(), part.size(), pipe)) text += part.data();
  if (!pipe || pclose(pipe) != 0) throw file_error("'" + command + "' failed", text, "see whether LAMMPS is installed: scripts/deps --bench");
  return text;
}

}  // namespace

void write_lammps_case(const std::string& folder, const System<2>& system, const DiscLaw& law, double time_step) {
  write_discs(folder + "/discs.data", system);
  const State<2>& s = system.state;
  // Its damping is per effective mass of the pair; this is the one of the mean mass.
  const double effective = 0.5 * std::accumulate(s.mass.begin(), s.mass.end(), 0.0) / s.size();
  auto file = fmt::output_file(folder + "/in.discs");
  file.print("units lj\ndimension 2\natom_style sphere\nboundary p p p\nnewton off\ncomm_modify vel yes\n");
  file.print("read_data {}/discs.data\n", folder);
  file.print("neighbor ${{skin}} bin\nneigh_modify every 1 delay 0 check yes\n");
  file.print("pair_style gran/hooke/history {} {} {} {} {} 1\npair_coeff * *\n", law.contact.k, law.contact.k_t,
             law.contact.eta / effective, law.contact.eta_t / effective, law.friction);
  file.print("timestep {}\nfix motion all nve/sphere disc\nfix plane all enforce2d\n", time_step);
  file.print("compute contact all contact/atom\ncompute contacts all reduce ave c_contact\n");
  file.print("variable speed equal sqrt(ke*2/{})\n", std::accumulate(s.mass.begin(), s.mass.end(), 0.0) / s.size() * 2);
  file.print("thermo_modify norm yes\nthermo 100000000\nrun ${{steps}}\n");
  file.print("variable touching equal c_contacts\nrun 0 post no\n");
  file.print("print \"rms speed ${{speed}}\"\nprint \"contacts ${{touching}}\"\n");
}

LammpsRun run_lammps(const std::string& folder, int steps, double skin) {
  const std::string text = output_of(fmt::format(
      "OMP_NUM_THREADS=1 lmp -in {0}/in.discs -log {0}/log -var steps {1} -var skin {2} 2>&1", folder, steps, skin));
  LammpsRun run;
  run.seconds = numbers_after<1>(text, "Loop time of")[0];
  run.seconds *= 0.01 * std::min(100.0, numbers_after<1>(text, "\n\n")[0]);
  run.builds = static_cast<long>(numbers_after<1>(text, "Neighbor list builds =")[0]);
  run.speed = numbers_after<1>(text, "rms speed")[0];
  run.contacts = numbers_after<1>(text, "\ncontacts")[0];
  return run;
}

bool lammps_found() { return std::system("command -v lmp >/dev/null 2>&1") == 0; }

}  // namespace supple::bench
