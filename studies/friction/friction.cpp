/// Figures 9.8 and 9.9 of MacKeith et al. (2025): the effective friction of two particles of which one slides
/// over the other. friction CASES OUT [SEEDS] takes CASES/shells.toml and CASES/floppy.toml, writes
/// OUT/friction_shells.png and OUT/friction_floppy.png, and prints the tables of the README.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "supple/core/error.hpp"
#include "supple/draw/chart/sliding_plot.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/io/text/case_file.hpp"

namespace {

using namespace supple;
using Keys = std::vector<std::string>;

Case case_of(const std::string& path, const Keys& keys) {
  Case c = read_case(path, keys);
  resolve_family(c);
  experiment_of(c).complete(c);
  check(c);
  return c;
}

Keys with(Keys keys, const Keys& more) {
  keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}

MemoryRecorder slide(const std::string& path, const Keys& keys) {
  MemoryRecorder r;
  run(case_of(path, keys), nullptr, r);
  return r;
}

double result(const MemoryRecorder& r, const char* name) { return r.get("results", name); }

SlidingCurve curve_of(const MemoryRecorder& r, const std::string& label) {
  const auto& table = r.tables.at("friction");
  SlidingCurve curve{label, table.column("x_over_width"), table.column("friction")};
  const std::vector<double> contacts = table.column("contacts");
  for (std::size_t k = 0; k < contacts.size(); ++k)
    if (contacts[k] == 0) curve.friction[k] = std::numeric_limits<double>::quiet_NaN();
  return curve;
}

SlidingRow row_of(const MemoryRecorder& r, Outline outline, const std::string& label) {
  std::vector<SlidingPicture> all;
  for (const Frame<2>& frame : r.frames) all.push_back(sliding_picture(r.info, frame));
  return {seven_of(all), outline, label};
}

const Keys narrow{"sliding.overlap=0.065"},
    wide{"bodies.diameter_ratio=1.8402295", "bodies.k_l=29.52992", "sliding.overlap=0.013"},
    smooth{"contact.kind=smooth", "sliding.overlap=0.114"};

/// Near the groove, in fine steps, at next to no overlap: what (9.13) is about.
MemoryRecorder slide_at_the_groove(const std::string& path, const Keys& shape) {
  return slide(path, with(shape, {"sliding.overlap=1e-4", "sliding.step=2e-4", "sliding.from=-0.004",
                                  "sliding.to=0.008"}));
}

void print_row(const std::string& what, double published, double ours) {
  fmt::print("| {} | {:.4g} | {:.4f} | {:+.4f} |\n", what, published, ours, ours - published);
}

void shells(const std::string& path, const std::string& out) {
  fmt::print("| shells | published | ours | difference |\n|---|---|---|---|\n");
  const MemoryRecorder a = slide(path, narrow), b = slide(path, wide), c = slide(path, smooth);
  print_row("rough, C = 1.3066: bound (9.13)", 0.577, result(a, "friction_bound"));
  print_row("rough, C = 0.71: bound (9.13)", 0.283, result(b, "friction_bound"));
  print_row("rough, C = 1.3066: maximum at overlap 0.0001 sigma, steps of 0.0002 D", 0.577,
            result(slide_at_the_groove(path, {}), "friction_max"));
  print_row("rough, C = 0.71: the same", 0.283,
            result(slide_at_the_groove(path, {wide.begin(), wide.begin() + 2}), "friction_max"));
  print_row("(a) rough, C = 1.3066: maximum at overlap 0.065 sigma", 0.537, result(a, "friction_max"));
  print_row("(b) rough, C = 0.71: maximum at overlap 0.013 sigma", 0.261, result(b, "friction_max"));
  print_row("(c) smooth, C = 1.3066: maximum at overlap 0.114 sigma", 0.190, result(c, "friction_max"));
  print_row("(c) its place, x/D", 0.1, result(c, "friction_max_x"));

  fmt::print(
      "\n| largest step of mu_eff from place to place | dx = 0.016 D | 0.004 D | 0.001 D "
      "|\n|---|---|---|---|\n");
  const auto jumps = [&](const char* name, const Keys& keys) {
    fmt::print("| {} |", name);
    for (const char* step : {"0.016", "0.004", "0.001"})
      fmt::print(" {:.4f} |",
                 result(slide(path, with(keys, {fmt::format("sliding.step={}", step)})), "friction_jump"));
    fmt::print("\n");
  };
  jumps("rough, C = 1.3066, overlap 0.0005 sigma", {"sliding.overlap=5e-4"});
  jumps("smooth, overlap 0.114 sigma", smooth);

  SlidingPlot plot;
  plot.curves = {curve_of(a, "(a) rough, C = 1.3066"), curve_of(b, "(b) rough, C = 0.71"),
                 curve_of(c, "(c) smooth, C = 1.3066")};
  plot.bounds = {result(a, "friction_bound"), result(b, "friction_bound")};
  plot.rows = {row_of(a, Outline::rough, "(a)"), row_of(b, Outline::rough, "(b)"),
               row_of(c, Outline::smooth, "(c)")};
  plot.star = Vec2{result(c, "friction_max_x"), result(c, "friction_max")};
  plot.height = 560;
  draw_sliding_plot(out + "/friction_shells.png", plot);
}

/// Of the pairs of one kind that were started from many shapes.
struct Ensemble {
  std::vector<double> largest;    ///< mu_eff
  std::vector<double> magnitude;  ///< |mu_eff|
  int apart = 0, failed = 0;

  static double quantile(std::vector<double> v, double share) {
    if (v.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::sort(v.begin(), v.end());
    const double at = share * static_cast<double>(v.size() - 1);
    const auto k = static_cast<std::size_t>(at);
    return v[k] + (at - static_cast<double>(k)) * (v[std::min(k + 1, v.size() - 1)] - v[k]);
  }
};

Ensemble ensemble_of(const std::string& path, const Keys& keys, int seeds) {
  Ensemble all;
  for (int seed = 1; seed <= seeds; ++seed) try {
      const MemoryRecorder r = slide(path, with(keys, {fmt::format("seed={}", seed), "output.frames=1"}));
      if (result(r, "places_in_contact") == 0) {
        ++all.apart;
        continue;
      }
      const double most = result(r, "friction_max");
      all.largest.push_back(most);
      all.magnitude.push_back(std::max(most, -result(r, "friction_min")));
    } catch (const Error& e) {
      if (e.kind() != ErrorKind::numerics) throw;
      ++all.failed;
      fmt::print(stderr, "seed {}: {}\n", seed, e.what());
    }
  return all;
}

struct Floppy {
  const char *name, *key;
};
constexpr Floppy floppy_kinds[] = {
    {"A_min", "bodies.A0_ratio=1"}, {"1.15", "bodies.A0=1.15"}, {"1.30", "bodies.A0=1.3"}};

void floppy(const std::string& path, const std::string& out, int seeds) {
  fmt::print(
      "\n| overlap | A0 | contacts | pairs that push | mu_eff: median (quartiles) of the maxima | median of "
      "max abs(mu_eff) |\n"
      "|---|---|---|---|---|---|\n");
  for (const char* overlap : {"0.065", "1.5", "2.1"})
    for (const Floppy& kind : floppy_kinds)
      for (const char* contact : {"rough", "smooth"}) {
        const Ensemble e = ensemble_of(
            path,
            {kind.key, fmt::format("contact.kind={}", contact), fmt::format("sliding.overlap={}", overlap)},
            seeds);
        fmt::print("| {} sigma | {} | {} | {} of {} |", overlap, kind.name, contact, e.largest.size(), seeds);
        if (e.largest.empty()) fmt::print(" | |\n");
        else
          fmt::print(" {:.3f} ({:.3f} to {:.3f}) | {:.3f} |\n", Ensemble::quantile(e.largest, 0.5),
                     Ensemble::quantile(e.largest, 0.25), Ensemble::quantile(e.largest, 0.75),
                     Ensemble::quantile(e.magnitude, 0.5));
        std::fflush(stdout);
      }
  for (const char* contact : {"rough", "smooth"}) {
    const Outline outline = contact == std::string("rough") ? Outline::rough : Outline::smooth;
    SlidingPlot plot;
    for (const Floppy& kind : floppy_kinds) {
      const bool is_round = kind.name == std::string("A_min");
      const std::string overlap = is_round ? (outline == Outline::rough ? "0.065" : "0.114") : "1.5";
      const MemoryRecorder r = slide(
          path, {kind.key, fmt::format("contact.kind={}", contact), "seed=3", "sliding.overlap=" + overlap});
      plot.curves.push_back(curve_of(r, fmt::format("A0 = {}, overlap {}", kind.name, overlap)));
      if (!is_round) plot.rows.push_back(row_of(r, outline, fmt::format("A0 = {}", kind.name)));
    }
    if (outline == Outline::rough) plot.bounds = {0.57735};
    plot.height = 480;
    draw_sliding_plot(fmt::format("{}/friction_floppy_{}.png", out, contact), plot);
  }
}

}  // namespace

int main(int count, char** words) {
  try {
    if (count == 3 || count == 4) {
      const std::string cases = words[1], out = words[2];
      shells(cases + "/shells.toml", out);
      floppy(cases + "/floppy.toml", out, count == 4 ? std::atoi(words[3]) : 20);
      return 0;
    }
    fmt::print(stderr, "usage: friction CASES OUT [SEEDS]\n");
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "friction: {}\n", error.what());
    return 1;
  }
}
