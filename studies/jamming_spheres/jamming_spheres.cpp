/// Onset and contact number of packings of smooth spheres: jamming_spheres [PACKINGS [SPHERES]] prints them,
/// jamming_spheres --check fails, too, if those of 30 packings of 128 are not the published ones.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/experiment/jam.hpp"
#include "supple/experiment/random_surfaces.hpp"
#include "supple/observe/rattlers.hpp"

namespace supple {
namespace {

struct Jammed {
  double packing_fraction, contacts, rattlers, pressure;
  bool isostatic;
  long evaluations;
};

Jammed jam_spheres(int spheres, int seed) {
  Case c;
  c.general.experiment = "jamming";
  SurfaceSample sample{.count = spheres, .vertices = 1};
  sample.seed = seed;
  sample.packing_fraction = 0.3;
  Packing<3> packing = packing_of(c, random_surfaces(sample));
  JamSpec wanted;
  wanted.search = JamSearch::pressure;
  const JamProgress<3> end = jam(packing, wanted);

  const System<3>& s = packing.system;
  BodyContacts<3>& law = *packing.field->bodies();
  const auto contacts = site_contacts(s, law.records(s), law.laws());
  const std::vector<std::uint8_t> rattlers = find_rattlers(s, contacts);
  const ContactNumbers numbers = count_contacts(contact_network(s, contacts), rattlers);
  double volume = 0;  // of the spheres: the onset is where they do not overlap yet
  for (const double r : s.state.radius) volume += 4 * std::numbers::pi / 3 * r * r * r;
  return {volume / s.box.volume(),
          numbers.mean(),
          static_cast<double>(std::count(rattlers.begin(), rattlers.end(), 1)),
          end.state.pressure,
          count_constraints(s, contacts, rattlers).excess() == 0,
          end.evaluations};
}

double mean_of(const std::vector<Jammed>& all, double Jammed::*number) {
  double sum = 0;
  for (const Jammed& j : all) sum += j.*number;
  return sum / static_cast<double>(all.size());
}

/// Mean, with its standard error, of one number of all packings.
std::string show_mean(const std::vector<Jammed>& all, double Jammed::*number, int digits) {
  const double n = static_cast<double>(all.size()), mean = mean_of(all, number);
  double square = 0;
  for (const Jammed& j : all) square += (j.*number - mean) * (j.*number - mean);
  return fmt::format("{:.{}f} ± {:.{}f}", mean, digits, std::sqrt(square / (n - 1) / n), digits);
}

/// Prints the table, and returns whether its numbers are the published ones.
bool run(int packings, int spheres) {
  std::vector<Jammed> all;
  for (int seed = 1; seed <= packings; ++seed) {
    all.push_back(jam_spheres(spheres, seed));
    fmt::print(stderr, "\r{} of {}", seed, packings);
  }
  const auto isostatic = std::count_if(all.begin(), all.end(), [](const Jammed& j) { return j.isostatic; });
  const double backbone = spheres - mean_of(all, &Jammed::rattlers), expected = 6 - 6 / backbone;
  fmt::print("\n| | published | ours |\n|---|---|---|\n");
  fmt::print("| packing fraction, rattlers counted | 0.64 ± 0.01 | {} |\n",
             show_mean(all, &Jammed::packing_fraction, 4));
  fmt::print("| contacts of a sphere of the backbone | 6 - 6/N = {:.3f} | {} |\n", expected,
             show_mean(all, &Jammed::contacts, 3));
  fmt::print("| rattlers of {} | | {} |\n", spheres, show_mean(all, &Jammed::rattlers, 1));
  fmt::print("| just rigid: 3 N - 2 contacts | | {} of {} |\n", isostatic, all.size());
  return std::abs(mean_of(all, &Jammed::packing_fraction) - 0.64) < 0.01 &&
         std::abs(mean_of(all, &Jammed::contacts) / expected - 1) < 0.01;
}

}  // namespace
}  // namespace supple

int main(int count, char** words) {
  try {
    if (count > 1 && std::string(words[1]) == "--check") return supple::run(30, 128) ? 0 : 1;
    supple::run(count > 1 ? std::stoi(words[1]) : 30, count > 2 ? std::stoi(words[2]) : 128);
  } catch (const supple::Error& e) {
    fmt::print(stderr, "{}\n", e.what());
    return e.exit_code();
  } catch (const std::exception&) {
    fmt::print(stderr, "usage: jamming_spheres [PACKINGS [SPHERES]] | --check\n");
    return 2;
  }
  return 0;
}
