/// The packing fraction of a small rough packing by formula and by Monte Carlo [MacKeith 2025, Table 9.2,
/// figure 9.12]: packing_fraction CASE OUT writes OUT/packing_fraction.png and prints the tables of the
/// README.
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "supple/draw/canvas/canvas.hpp"
#include "supple/experiment/jam.hpp"
#include "supple/io/text/case_file.hpp"
#include "supple/observe/packing_fraction.hpp"

namespace {

using namespace supple;
using std::numbers::pi;

constexpr int packings = 20;
constexpr std::int64_t points = 5'000'000;  // 1e8 in all
constexpr int published_points = 250'000;   // the standard error is then the 0.0008 of the chapter

/// The part of a cell that a panel shows, bodies and their images within it.
class Panel {
 public:
  Panel(Canvas& canvas, const Packing<2>& packing, Point corner, double size, const std::string& title)
      : canvas_(canvas),
        shapes_(body_shapes(packing.system, Outline::rough)),
        box_(packing.system.box),
        corner_(corner),
        scale_(size / box_.length[0]) {
    canvas_.text(corner_ + Point{0, -5}, title);
    frame_ = {corner, corner + Point{size, 0}, corner + Point{size, size}, corner + Point{0, size}};
  }

  /// draw(body, ring) for every image, its vertices on the page.
  template <class Draw>
  void for_each(const Draw& draw) const {
    canvas_.clipped(frame_, ClipTo::inside, [&] {
      for (const BodyImage& image : images_in({{0, 0}, box_.length}, shapes_, box_))
        draw(image.body, ring(image));
    });
  }
  /// draw(disc, radius, disc, radius) for every two vertices of neighbours in a ring, or of different bodies.
  template <class Draw>
  void for_each_pair(const Draw& draw) const {
    const std::vector<BodyImage> images = images_in({{0, 0}, box_.length}, shapes_, box_);
    canvas_.clipped(frame_, ClipTo::inside, [&] {
      for (std::size_t a = 0; a < images.size(); ++a) {
        const std::vector<Point> own = ring(images[a]);
        for (std::size_t i = 0; i < own.size(); ++i)
          draw(own[i], radius(images[a].body), own[(i + 1) % own.size()], radius(images[a].body));
        for (std::size_t b = 0; b < a; ++b)
          for (const Point& p : own)
            for (const Point& q : ring(images[b])) draw(p, radius(images[a].body), q, radius(images[b].body));
      }
    });
  }
  void finish() const { canvas_.polygon(frame_, {.pen = Pen{}}); }
  double radius(int body) const { return scale_ * shapes_[static_cast<std::size_t>(body)].radius[0]; }

 private:
  std::vector<Point> ring(const BodyImage& image) const {
    std::vector<Point> out;
    for (const Vec2& x : shapes_[static_cast<std::size_t>(image.body)].ring) {
      const Vec2 y = x + image.shift;
      out.push_back(corner_ + scale_ * Point{y[0], box_.length[1] - y[1]});
    }
    return out;
  }

  Canvas& canvas_;
  std::vector<BodyShape> shapes_;
  Box<2> box_;
  Point corner_;
  double scale_;
  std::vector<Point> frame_;
};

std::vector<Point> circle(const Point& centre, double radius) {
  std::vector<Point> out;
  for (int k = 0; k < 90; ++k)
    out.push_back(centre + radius * Point{std::cos(2 * pi * k / 90), std::sin(2 * pi * k / 90)});
  return out;
}

const Pen thin{gray, 0.5};

void draw(const Packing<2>& packing, const std::string& path) {
  const RoughSum sum = rough_sum(packing.system);
  const double size = 150, across = 165, down = 180;
  Canvas canvas(path, 3 * across + 5, 2 * down + 5, 200);
  int panels = 0;
  const auto panel = [&](const std::string& title) {
    const int k = panels++;
    return Panel(canvas, packing, {10 + (k % 3) * across, 18 + (k / 3) * down}, size, title);
  };
  const auto outlines = [&](const Panel& p) {
    p.for_each([&](int body, const std::vector<Point>& ring) {
      for (const Point& x : ring) canvas.circle(x, p.radius(body), {.pen = thin});
      canvas.polygon(ring, {.pen = thin});
    });
    p.finish();
  };
  const auto color = [](int body) {
    return line_palette[static_cast<std::size_t>(body) % line_palette.size()];
  };

  const Panel whole = panel(fmt::format("(a) covered: {:.4f}", sum.total));
  whole.for_each([&](int body, const std::vector<Point>& ring) {
    const Color fill = mix(color(body), white, 0.4);
    for (const Point& x : ring) canvas.circle(x, whole.radius(body), {.fill = fill});
    canvas.polygon(ring, {.fill = fill});
  });
  outlines(whole);

  const Panel polygons = panel(fmt::format("(b) polygons: +{:.4f}", sum.polygons));
  polygons.for_each(
      [&](int, const std::vector<Point>& ring) { canvas.polygon(ring, {.fill = line_palette[0]}); });
  outlines(polygons);

  const Panel vertices = panel(fmt::format("(c) vertices: +{:.4f}", sum.vertices));
  vertices.for_each([&](int body, const std::vector<Point>& ring) {
    for (const Point& x : ring)
      canvas.circle(x, vertices.radius(body), {.fill = mix(line_palette[1], white, 0.5)});
  });
  outlines(vertices);

  const Panel sectors = panel(fmt::format("(d) sectors: \u2212{:.4f}", sum.sectors));
  sectors.for_each([&](int body, const std::vector<Point>& ring) {
    canvas.clipped(ring, ClipTo::inside, [&] {
      for (const Point& x : ring)
        canvas.circle(x, sectors.radius(body), {.fill = mix(line_palette[2], white, 0.3)});
    });
  });
  outlines(sectors);

  const Panel pairs = panel(fmt::format("(e) pairs: \u2212{:.4f}", sum.pairs));
  pairs.for_each_pair([&](const Point& a, double r, const Point& b, double s) {
    if (norm(b - a) >= r + s) return;
    canvas.clipped(circle(a, r), ClipTo::inside, [&] { canvas.circle(b, s, {.fill = line_palette[3]}); });
  });
  // Of neighbours in a ring only the half outside of the polygon counts.
  pairs.for_each([&](int, const std::vector<Point>& ring) { canvas.polygon(ring, {.fill = white}); });
  outlines(pairs);

  const PackingFraction exact = packing_fraction(packing.system, packing.outline);
  const Panel shares = panel(fmt::format("(f) of each particle; all: {:.4f}", exact.total));
  shares.for_each([&](int body, const std::vector<Point>& ring) {
    for (const Point& x : ring) canvas.circle(x, shares.radius(body), {.fill = mix(color(body), white, 0.4)});
    canvas.polygon(ring, {.fill = mix(color(body), white, 0.4)});
  });
  shares.for_each([&](int body, const std::vector<Point>& ring) {
    Point middle{};
    for (const Point& x : ring) middle += (1.0 / static_cast<double>(ring.size())) * x;
    const double share = exact.volume[static_cast<std::size_t>(body)] / packing.system.box.volume();
    canvas.text(middle, fmt::format("{:.4f}", share), {.across = Across::centre, .down = Down::middle});
  });
  shares.finish();
  canvas.finish();
}

/// Probability that a chi-squared of 2 m degrees of freedom is larger.
double survival(double chi_squared, int m) {
  double term = std::exp(-0.5 * chi_squared), sum = 0;
  for (int k = 0; k < m; ++k) {
    sum += term;
    term *= 0.5 * chi_squared / (k + 1);
  }
  return sum;
}

int run(const std::string& path, const std::string& out) {
  Case c = read_case(path);
  fmt::print(
      "| seed | formula (9.18-9.22) | doubts | exact | Monte Carlo | difference / error "
      "|\n|---|---|---|---|---|---|\n");
  double right = 0, wrong = 0;
  for (int seed = 1; seed <= packings; ++seed) {
    c.general.seed = seed;
    Packing<2> packing = make_packing(c, nullptr, c.jamming.packing_fraction);
    jam(packing, jam_spec(c));
    const RoughSum sum = rough_sum(packing.system);
    const double exact = packing_fraction(packing.system, packing.outline).total;
    const MonteCarloFraction mc =
        monte_carlo_fraction(packing.system, packing.outline, points, static_cast<std::uint64_t>(seed));
    const double z = (sum.total - mc.value) / mc.error;
    right += z * z;
    wrong += std::pow((1.001 * sum.total - mc.value) / mc.error, 2);
    fmt::print("| {} | {:.6f} | {} | {:.6f} | {:.5f} ± {:.5f} | {:.2f} |\n", seed, sum.total, sum.doubts,
               exact, mc.value, mc.error, z);
    std::fflush(stdout);
    if (seed > 1) continue;
    const MonteCarloFraction few = monte_carlo_fraction(packing.system, packing.outline, published_points, 1);
    fmt::print("| 1, fewer points | {:.4f} | | | {:.4f} ± {:.4f} | |\n", sum.total, few.value, few.error);
    draw(packing, out + "/packing_fraction.png");
  }
  fmt::print("\nchi-squared {:.1f} of {}: p = {:.3f}; with a formula larger by 0.1 %: {:.0f}, p = {:.1e}\n",
             right, packings, survival(right, packings / 2), wrong, survival(wrong, packings / 2));
  return 0;
}

}  // namespace

int main(int count, char** words) {
  try {
    if (count == 3) return run(words[1], words[2]);
    fmt::print(stderr, "usage: packing_fraction CASE OUT\n");
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "packing_fraction: {}\n", error.what());
    return 1;
  }
}
