/// Figure 9.4 of MacKeith et al. (2025): soft discs and deformable particles of the same bulk modulus,
/// squeezed by 20 %. uniaxial_compression CASE OUT [SEEDS] writes OUT/uniaxial_compression.png and prints the
/// table of the README.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>

#include "../panel.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/jam.hpp"
#include "supple/io/text/case_file.hpp"
#include "supple/model/bodies.hpp"

namespace {

using namespace supple;
using study::Panel;

/// Discs of this stiffness at the pressure of the deformable particles: k_c (pi/4) is the spring of two small
/// ones.
Case disc_case(Case c, double k_c) {
  const double unit = k_c * std::numbers::pi / 4;
  c.bodies.family = "disc";
  c.contact.kind = "rough";
  c.contact.k_c = k_c;
  c.uniaxial.pressure /= unit;
  return c;
}

/// -V dP/dV of a box that all walls squeeze, in units of k_a a0 of the deformable particles (which is 1). The
/// squeeze is small: a rearrangement within it would be taken for elasticity.
double bulk_modulus(const Case& c) {
  Packing<2> p = make_boxed_packing(c, nullptr, c.uniaxial.packing_fraction, c.uniaxial.aspect_ratio);
  JamSpec spec;
  spec.pressure = c.uniaxial.pressure;
  spec.step = 5e-3;
  const double before = jam(p, spec).state.pressure, shrink = 1e-4;
  scale_cell(p.system, {1 - shrink, 1 - shrink});
  p.field->invalidate();
  relax(p);
  return p.pressure_unit * (observe(p).pressure - before) / (2 * shrink);
}

/// The stiffness of discs with the bulk modulus of the deformable particles at the same pressure. Each
/// stiffness has a packing, and so a modulus, of its own: the best of a dozen.
double matching_stiffness(const Case& deformable, double wanted) {
  double k_c = 1, best = 1, least = std::numeric_limits<double>::infinity();
  for (int turn = 0; turn < 12 && least > 0.01; ++turn) {
    const double ratio = std::clamp(wanted / bulk_modulus(disc_case(deformable, k_c)), 0.5, 2.0);
    if (std::abs(std::log(ratio)) < least) least = std::abs(std::log(ratio)), best = k_c;
    k_c *= ratio;
  }
  return best;
}

struct Squeezed {
  MemoryRecorder run;
  double unit() const { return run.get("constants", "pressure_unit"); }
  double at(const std::string& column, bool end) const {
    const std::vector<double> values = run.tables.at("packing").column(column);
    return end ? values.back() : values.front();
  }
};

Squeezed squeeze(const Case& c) {
  Squeezed s;
  supple::run(c, nullptr, s.run);
  for (const std::string& warning : s.run.warnings) fmt::print(stderr, "{}: {}\n", c.bodies.family, warning);
  return s;
}

void draw(const Squeezed& discs, const Squeezed& deformable, const std::string& path) {
  constexpr double size = 200, gap = 30, above = 22;
  Canvas canvas(path, 2 * size + gap + 24, 2 * (size + above + 16), 250);
  const auto panel = [&](const Squeezed& s, Outline outline, const Frame<2>& frame, double scale,
                         Point corner, const std::string& title) {
    const Panel p{canvas, s.run.info, frame, outline, corner, scale};
    p.draw_particles();
    for (const auto side : {Panel::Side::left, Panel::Side::right, Panel::Side::bottom, Panel::Side::top})
      p.draw_wall(side);
    canvas.text(corner + Point{-5, -p.height() - 9}, title);
  };
  const auto row = [&](const Squeezed& s, Outline outline, double floor, const char* letter,
                       const char* name) {
    const double scale = size / s.run.frames.front().length[1];
    panel(s, outline, s.run.frames.front(), scale, {10, floor},
          fmt::format("({}) {}, P = {:.2g}", letter, name, s.unit() * s.at("pressure", false)));
    panel(s, outline, s.run.frames.back(), scale, {10 + size + gap, floor},
          fmt::format("20 %: P = {:.2g}", s.unit() * s.at("pressure", true)));
  };
  row(discs, Outline::rough, size + above, "a", "soft discs");
  row(deformable, Outline::smooth, 2 * (size + above) + 12, "b", "deformable");
  canvas.finish();
}

constexpr const char* columns[] = {"overlap_area",     "mean_overlap",  "contact_length",
                                   "packing_fraction", "mean_contacts", "mean_shape_parameter"};

void print(const char* name, int seed, const Squeezed& s) {
  for (const bool end : {false, true}) {
    fmt::print("| {} | {} | {} | {:.4f} |", name, seed, end ? "20 %" : "0", s.unit() * s.at("pressure", end));
    for (const char* column : columns) fmt::print(" {:.4f} |", s.at(column, end));
    fmt::print("\n");
  }
  std::fflush(stdout);
}

int run(const std::string& path, const std::string& out, int seeds) {
  Case c = read_case(path);
  resolve_family(c);
  fmt::print("| particles | seed | strain | pressure |");
  for (const char* column : columns) fmt::print(" {} |", column);
  fmt::print("\n|---|---|---|---|---|---|---|---|---|---|\n");
  std::string moduli;
  for (int seed = 1; seed <= seeds; ++seed) {
    c.general.seed = seed;
    const double modulus = bulk_modulus(c), k_c = matching_stiffness(c, modulus);
    const Case softer = disc_case(c, k_c);
    const Squeezed discs = squeeze(softer), deformable = squeeze(c);
    print("discs", seed, discs);
    print("deformable", seed, deformable);
    moduli += fmt::format("* seed {}: bulk modulus {:.4f}; of discs with k_c = {:.4f}: {:.4f}\n", seed,
                          modulus, k_c, bulk_modulus(softer));
    if (seed == 1) draw(discs, deformable, out + "/uniaxial_compression.png");
  }
  fmt::print("\n{}", moduli);
  return 0;
}

}  // namespace

int main(int count, char** words) {
  try {
    if (count == 3 || count == 4) return run(words[1], words[2], count == 4 ? std::atoi(words[3]) : 3);
    fmt::print(stderr, "usage: uniaxial_compression CASE OUT [SEEDS]\n");
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "uniaxial_compression: {}\n", error.what());
    return 1;
  }
}
