/// Maps of the contact potential of one vertex round a particle that is not convex [MacKeith 2025,
/// figure 9.7], and how far its energy and force jump: contact_maps FOLDER writes FOLDER/contact_maps.png and
/// prints the table of the README.
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "../potential_map.hpp"
#include "supple/contact/rough_contacts.hpp"
#include "supple/contact/smooth_contacts.hpp"
#include "supple/core/error.hpp"
#include "supple/core/random.hpp"
#include "supple/force/force_field.hpp"
#include "supple/geometry/closest_point.hpp"
#include "supple/geometry/inside.hpp"
#include "supple/model/polygons.hpp"

namespace {

using namespace supple;
using study::DrawnMap;
using study::MapWindow;

constexpr double sigma = 0.4;
constexpr double half_width = 1.85;  // of a map
const Vec2 middle{10, 10};

enum Panel { rough, minimum_distance, smooth, edges, concave, convex };
constexpr int panels = 6;

/// Energy [k sigma^2] and force [k sigma] of a vertex.
struct Felt {
  double energy = 0;
  Vec2 force{};
};

std::vector<Vec2> particle() {
  std::vector<Vec2> ring;
  for (int k = 0; k < 12; ++k) {
    const double angle = 2 * std::numbers::pi * k / 12 + 0.2, r = 1 + 0.38 * std::cos(3 * angle - 0.9);
    ring.push_back(middle + r * Vec2{std::cos(angle), std::sin(angle)});
  }
  return ring;
}

/// The vertex is a smooth disc, which the potential is not halved for.
class Map {
 public:
  Map()
      : ring_(particle()),
        rough_(std::make_shared<RoughContacts<2>>(Harmonic{1})),
        smooth_(std::make_shared<SmoothContacts>(Harmonic{1})) {
    system_.box.length = {20, 20};
    system_.box.periodic = {false, false};
    const std::vector<double> rest(ring_.size(), 1);
    add_ring(system_, ring_, 0.5 * sigma, {}, 1, rest, rest);
    add_disc_body(system_, middle, 0.5 * sigma);
  }
  const std::vector<Vec2>& ring() const { return ring_; }
  bool inside(const Vec2& p) const { return is_inside(p, ring_); }
  double distance(const Vec2& p) const { return norm(nearest(p)); }

  Felt at(const Vec2& p, Panel panel) {
    if (panel == minimum_distance) {
      const Vec2 r = nearest(p);
      const double d = norm(r);
      return d < sigma ? reduced(0.5 * (sigma - d) * (sigma - d), (sigma - d) / d * r) : Felt{};
    }
    system_.state.position.back() = p;
    BodyContacts<2>& contacts = panel == rough ? static_cast<BodyContacts<2>&>(*rough_) : *smooth_;
    NeighborList<2>& list = panel == rough ? rough_list_ : smooth_list_;
    list.invalidate();
    list.update(system_);
    Felt sum;
    for (const ContactRecord<2>& r : contacts.records(system_)) {
      const Panel part = r.sites == 3 ? edges : r.multiplicity < 0 ? concave : convex;
      if (panel >= edges && panel != part) continue;
      const double factor = r.multiplicity;
      const Felt felt =
          reduced(factor * contacts.laws().of(r.species).energy(r.distance(), r.reach),
                  factor * contacts.laws().of(r.species).force(r.distance(), r.reach) * r.normal);
      sum.energy += felt.energy;
      sum.force += felt.force;
    }
    return sum;
  }
  int feature_violations(const Vec2& p) {
    at(p, smooth);
    Evaluation<2> out;
    out.force.resize(static_cast<std::size_t>(system_.state.size()));
    smooth_->evaluate(system_, Detail::forces, out);
    return smooth_->feature_violations();
  }

 private:
  static Felt reduced(double energy, const Vec2& force) {
    return {energy / (sigma * sigma), (1 / sigma) * force};
  }
  Vec2 nearest(const Vec2& p) const {
    Vec2 least{1e9, 0};
    for (std::size_t k = 0; k < ring_.size(); ++k) {
      const Vec2 from = closest_on_segment(p, ring_[k], ring_[(k + 1) % ring_.size()]).from;
      if (norm(from) < norm(least)) least = from;
    }
    return least;
  }

  std::vector<Vec2> ring_;
  System<2> system_;
  std::shared_ptr<RoughContacts<2>> rough_;
  std::shared_ptr<SmoothContacts> smooth_;
  NeighborList<2> rough_list_{default_skin, Meeting::sites}, smooth_list_{default_skin, Meeting::facets};
};

struct Jumps {
  double energy = 0, force = 0;
};

/// Along straight lines all over the map, outside of the particle.
Jumps largest_jumps(Map& map, Panel panel) {
  RandomStream draw(1, Purpose::test);
  const auto energy = [&](const Vec2& a, const Vec2& b) {
    return std::abs(map.at(a, panel).energy - map.at(b, panel).energy);
  };
  const auto force = [&](const Vec2& a, const Vec2& b) {
    return norm(map.at(a, panel).force - map.at(b, panel).force);
  };
  Jumps largest;
  for (int line = 0; line < 60; ++line) {
    const auto point = [&] {
      return middle + Vec2{draw.uniform(-half_width, half_width), draw.uniform(-half_width, half_width)};
    };
    const Vec2 from = point(), to = point();
    const int steps = 100;
    for (int s = 0; s < steps; ++s) {
      const Vec2 a = from + (1.0 * s / steps) * (to - from), b = from + ((s + 1.0) / steps) * (to - from);
      const double step = norm(b - a);
      if (map.inside(a) || map.inside(b) || map.distance(a) < step || map.distance(a) > sigma + step)
        continue;
      largest.energy = std::max(largest.energy, study::jump_between(a, b, energy));
      largest.force = std::max(largest.force, study::jump_between(a, b, force));
    }
  }
  return largest;
}

/// Energies on a map; not a number inside.
std::vector<double> energies(Map& map, Panel panel, const MapWindow& window) {
  return study::sample_map(
      window, [&](const Vec2& p) { return map.inside(p) ? NAN : std::abs(map.at(p, panel).energy); });
}

void draw_panel(const DrawnMap& on, const Map& map, const std::vector<double>& values,
                const ColorScale& scale, const std::string& title) {
  on.draw_values(values, scale);
  const double size = on.size;
  const std::array<Point, 4> square{on.corner, on.corner + Point{size, 0}, on.corner + Point{size, size},
                                    on.corner + Point{0, size}};
  on.canvas.clipped(square, ClipTo::inside, [&] {
    std::vector<Point> outline;
    for (const Vec2& p : map.ring()) outline.push_back(on.place(p));
    on.canvas.polygon(outline, {.fill = gray, .pen = Pen{}});
  });
  on.draw_frame(title, middle, sigma, "x/σ", "y/σ");
}

/// The corner with the sharpest concave angle.
Vec2 concave_corner(const std::vector<Vec2>& ring) {
  const std::size_t n = ring.size();
  std::size_t sharpest = 0;
  double least = 1;
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 in = ring[k] - ring[(k + n - 1) % n], out = ring[(k + 1) % n] - ring[k];
    const double turn = cross(in, out) / (norm(in) * norm(out));
    if (turn < least) least = turn, sharpest = k;
  }
  return ring[sharpest];
}

/// One potential in one part of the plane.
struct Drawn {
  Panel panel;
  MapWindow window;
  std::string title;
};

void draw(Map& map, const std::string& path) {
  const MapWindow all{middle, half_width};
  const Vec2 corner = concave_corner(map.ring());
  const MapWindow near{corner + sigma / norm(corner - middle) * 0.5 * (corner - middle), 0.75 * sigma};
  const std::vector<Drawn> maps{{rough, all, "(a) rough"},
                                {minimum_distance, all, "(b) minimum distance"},
                                {smooth, all, "(c) smooth = (d) + (e) + (f)"},
                                {edges, all, "(d) edges"},
                                {concave, all, "(e) concave corners: −U"},
                                {convex, all, "(f) convex corners"},
                                {rough, near, "(a) at a concave corner"},
                                {minimum_distance, near, "(b) there: each line has a corner"},
                                {smooth, near, "(c) there: none has"}};
  std::vector<std::vector<double>> values;
  ColorScale scale{0, 0};
  for (const Drawn& m : maps) {
    values.push_back(energies(map, m.panel, m.window));
    scale.high = std::max(scale.high, scale_over(values.back()).high);
  }
  const double size = 150, across = 185, down = 195;
  Canvas canvas(path, 30 + 3 * across + 45, 3 * down + 15, 200);
  for (std::size_t k = 0; k < maps.size(); ++k)
    draw_panel({canvas,
                maps[k].window,
                {30 + static_cast<double>(k % 3) * across, 20 + static_cast<double>(k / 3) * down},
                size},
               map, values[k], scale, maps[k].title);
  draw_color_bar(canvas, {30 + 3 * across - 18, 45}, 400, scale, "U/(kσ²)", "");
  canvas.finish();
}

int run(const std::string& folder) {
  Map map;
  draw(map, folder + "/contact_maps.png");
  int outside = 0, violations = 0;
  for (double x = -half_width; x < half_width; x += 0.02)
    for (double y = -half_width; y < half_width; y += 0.02) {
      const Vec2 p = middle + Vec2{x, y};
      if (map.inside(p) || map.distance(p) >= sigma) continue;
      ++outside;
      violations += map.feature_violations(p);
    }
  fmt::print("| panel | largest jump of U [kσ²] | largest jump of force [kσ] |\n|---|---|---|\n");
  const char* names[panels] = {"(a) rough", "(b) minimum distance", "(c) smooth",
                               "(d) edges", "(e) concave",          "(f) convex"};
  for (int k = 0; k < panels; ++k) {
    const Jumps jumps = largest_jumps(map, static_cast<Panel>(k));
    fmt::print("| {} | {:.2g} | {:.2g} |\n", names[k], jumps.energy, jumps.force);
  }
  fmt::print("\nThe boundary within sigma is not one arc at {} of {} places within reach.\n", violations,
             outside);
  return 0;
}

}  // namespace

int main(int count, char** words) {
  try {
    if (count == 2) return run(words[1]);
    fmt::print(stderr, "usage: contact_maps FOLDER\n");
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "contact_maps: {}\n", error.what());
    return 1;
  }
}
