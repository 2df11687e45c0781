/// Maps of the contact potential of one vertex round a surface that is not convex, in planes through it:
/// figure 9.7 of [MacKeith 2025] in three dimensions, and how far energy and force jump. surface_maps FOLDER
/// writes FOLDER/surface_maps.png and prints the table of the README.
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "../potential_map.hpp"
#include "supple/build/surfaces.hpp"
#include "supple/contact/rough_contacts.hpp"
#include "supple/contact/smooth_surfaces.hpp"
#include "supple/core/random.hpp"
#include "supple/geometry/closest_point.hpp"
#include "supple/geometry/inside.hpp"

namespace {

using namespace supple;
using study::DrawnMap;
using study::MapWindow;

constexpr double sigma = 0.3;
constexpr double half_width = 1.65;  // of a map

enum Panel { rough, minimum_distance, smooth, faces, edges, corners };
constexpr int panels = 6;

/// Energy [k sigma^2] and force [k sigma] of a vertex.
struct Felt {
  double energy = 0;
  Vec3 force{};
};

/// A geodesic sphere of radius 1 with three ridges and three valleys round an axis, and a pit on the axis.
TriangleMesh particle() {
  TriangleMesh mesh = geodesic_icosahedron(162);
  for (Vec3& x : mesh.vertex) {
    x = (1 / norm(x)) * x;
    const double round = std::atan2(x[1], x[0]), across = std::hypot(x[0], x[1]);
    double r = 1 + 0.3 * std::cos(3 * round) * across * across;
    const double away = std::acos(x[2]) / 0.8;
    if (away < 1) r -= 0.55 * (1 - away * away) * (1 - away * away);
    x = r * x;
  }
  return mesh;
}

/// The vertex is a smooth sphere, which the potential is not halved for.
class Map {
 public:
  Map()
      : mesh_(particle()),
        rough_(std::make_shared<RoughContacts<3>>(Harmonic{1})),
        smooth_(std::make_shared<SmoothSurfaces>(Harmonic{1})) {
    system_.box.length = {20, 20, 20};
    system_.box.periodic = {false, false, false};
    add_surface(system_, mesh_, 0.5 * sigma, {}, 1, std::vector<double>(mesh_.face.size(), 1),
                std::vector<double>(hinges_of(mesh_).size(), 0));
    add_sphere_body(system_, {}, 0.5 * sigma);
  }
  const TriangleMesh& mesh() const { return mesh_; }
  bool inside(const Vec3& p) const { return is_inside(p, mesh_.vertex, mesh_.face); }
  double distance(const Vec3& p) const { return norm(nearest(p)); }

  Felt at(const Vec3& p, Panel panel) {
    if (panel == minimum_distance) {
      const Vec3 r = nearest(p);
      const double d = norm(r);
      return d < sigma ? reduced(0.5 * (sigma - d) * (sigma - d), (sigma - d) / d * r) : Felt{};
    }
    BodyContacts<3>& contacts = panel == rough ? static_cast<BodyContacts<3>&>(*rough_) : *smooth_;
    move_to(p, panel == rough ? rough_list_ : smooth_list_);
    Felt sum;
    for (const ContactRecord<3>& r : contacts.records(system_)) {
      if (panel >= faces && panel != (r.sites == 4 ? faces : r.sites == 3 ? edges : corners)) continue;
      const double factor = r.multiplicity;
      const Felt felt =
          reduced(factor * contacts.laws().of(r.species).energy(r.distance(), r.reach),
                  factor * contacts.laws().of(r.species).force(r.distance(), r.reach) * r.normal);
      sum.energy += felt.energy;
      sum.force += felt.force;
    }
    return sum;
  }
  int feature_violations(const Vec3& p) {
    move_to(p, smooth_list_);
    Evaluation<3> out;
    out.force.resize(system_.state.position.size());
    smooth_->evaluate(system_, Detail::forces, out);
    return smooth_->feature_violations();
  }

 private:
  static Felt reduced(double energy, const Vec3& force) {
    return {energy / (sigma * sigma), (1 / sigma) * force};
  }
  void move_to(const Vec3& p, NeighborList<3>& list) {
    system_.state.position.back() = p;
    list.update(system_);
  }
  Vec3 nearest(const Vec3& p) const {
    Vec3 least{1e9, 0, 0};
    for (const auto& [a, b, c] : mesh_.face) {
      const Vec3 x[3] = {mesh_.vertex[a], mesh_.vertex[b], mesh_.vertex[c]};
      const Vec3 from = closest_on_triangle(p, x).from;
      if (norm(from) < norm(least)) least = from;
    }
    return least;
  }

  TriangleMesh mesh_;
  System<3> system_;
  std::shared_ptr<RoughContacts<3>> rough_;
  std::shared_ptr<SmoothSurfaces> smooth_;
  NeighborList<3> rough_list_{default_skin, Meeting::sites}, smooth_list_{default_skin, Meeting::facets};
};

struct Jumps {
  double energy = 0, force = 0;
};

/// Along straight lines all through space, outside of the particle.
Jumps largest_jumps(Map& map, Panel panel) {
  RandomStream draw(1, Purpose::test);
  const auto energy = [&](const Vec3& a, const Vec3& b) {
    return std::abs(map.at(a, panel).energy - map.at(b, panel).energy);
  };
  const auto force = [&](const Vec3& a, const Vec3& b) {
    return norm(map.at(a, panel).force - map.at(b, panel).force);
  };
  Jumps largest;
  for (int line = 0; line < 60; ++line) {
    const auto point = [&] {
      return Vec3{draw.uniform(-1.3, 1.3), draw.uniform(-1.3, 1.3), draw.uniform(-1.3, 1.3)};
    };
    const Vec3 from = point(), to = point();
    const int steps = 100;
    for (int s = 0; s < steps; ++s) {
      const Vec3 a = from + (1.0 * s / steps) * (to - from), b = from + ((s + 1.0) / steps) * (to - from);
      const double step = norm(b - a);
      if (map.distance(a) < step || map.distance(a) > sigma + step || map.inside(a) || map.inside(b))
        continue;
      largest.energy = std::max(largest.energy, study::jump_between(a, b, energy));
      largest.force = std::max(largest.force, study::jump_between(a, b, force));
    }
  }
  return largest;
}

/// A plane in space, with coordinates of its own.
struct Plane {
  Vec3 origin, across, up;
  const char *across_name, *up_name;

  Vec3 in_space(const Vec2& p) const { return origin + p[0] * across + p[1] * up; }
  Vec2 within(const Vec3& x) const { return {dot(x - origin, across), dot(x - origin, up)}; }
  double height(const Vec3& x) const { return dot(x - origin, cross(across, up)); }
};

const Plane upright{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, "x/σ", "z/σ"};
const Plane level{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, "x/σ", "y/σ"};

struct Drawn {
  Panel panel;
  const Plane& plane;
  MapWindow window;
  std::string title;
};

/// Row by row, from where the row enters the particle to where it leaves it.
void draw_inside(const DrawnMap& on, const Map& map, const Plane& plane) {
  const double cell = on.size / study::map_cells;
  const auto inside = [&](int row, int column) {
    return column < study::map_cells && map.inside(plane.in_space(on.window.at(row, column)));
  };
  for (int row = 0; row < study::map_cells; ++row)
    for (int column = 0; column < study::map_cells; ++column) {
      const int begin = column;
      while (inside(row, column)) ++column;
      if (column == begin) continue;
      const double below = row + 1 < study::map_cells ? 1.5 : 1;
      on.canvas.rectangle(on.corner + cell * Point{1.0 * begin, 1.0 * row},
                          on.corner + cell * Point{1.0 * column, row + below}, {.fill = gray});
    }
}

/// Where the plane cuts the triangles.
void draw_section(const DrawnMap& on, const Map& map, const Plane& plane) {
  for (const auto& face : map.mesh().face) {
    std::vector<Point> cuts;
    for (int k = 0; k < 3; ++k) {
      const Vec3 &a = map.mesh().vertex[face[k]], &b = map.mesh().vertex[face[(k + 1) % 3]];
      const double ha = plane.height(a), hb = plane.height(b);
      if ((ha < 0) != (hb < 0)) cuts.push_back(on.place(plane.within(a + (ha / (ha - hb)) * (b - a))));
    }
    if (cuts.size() == 2) on.canvas.line(cuts[0], cuts[1], {});
  }
}

void draw_panel(const DrawnMap& on, const Map& map, const Drawn& drawn, const std::vector<double>& values,
                const ColorScale& scale) {
  on.draw_values(values, scale);
  draw_inside(on, map, drawn.plane);
  const double size = on.size;
  const std::array<Point, 4> square{on.corner, on.corner + Point{size, 0}, on.corner + Point{size, size},
                                    on.corner + Point{0, size}};
  on.canvas.clipped(square, ClipTo::inside, [&] { draw_section(on, map, drawn.plane); });
  on.draw_frame(drawn.title, {}, sigma, drawn.plane.across_name, drawn.plane.up_name);
}

void draw(Map& map, const std::string& path) {
  const MapWindow all{{0, 0}, half_width}, pit{{0, 0.72}, 0.45};
  const std::vector<Drawn> maps{{rough, upright, all, "(a) rough"},
                                {minimum_distance, upright, all, "(b) minimum distance"},
                                {smooth, upright, all, "(c) smooth = (d) + (e) + (f)"},
                                {faces, upright, all, "(d) faces"},
                                {edges, upright, all, "(e) edges: |U|"},
                                {corners, upright, all, "(f) corners: |U|"},
                                {smooth, level, all, "(c) across the middle"},
                                {minimum_distance, upright, pit, "(b) in the pit: lines have corners"},
                                {smooth, upright, pit, "(c) there: none has"}};
  std::vector<std::vector<double>> values;
  // What a vertex on a face has; (a) and the parts go higher.
  const ColorScale scale{0, 0.5};
  for (const Drawn& m : maps)
    values.push_back(study::sample_map(m.window, [&](const Vec2& p) {
      const Vec3 x = m.plane.in_space(p);
      return map.inside(x) ? NAN : std::abs(map.at(x, m.panel).energy);
    }));
  const double size = 150, across = 185, down = 195;
  Canvas canvas(path, 30 + 3 * across + 45, 3 * down + 15, 200);
  for (std::size_t k = 0; k < maps.size(); ++k)
    draw_panel({canvas,
                maps[k].window,
                {30 + static_cast<double>(k % 3) * across, 20 + static_cast<double>(k / 3) * down},
                size},
               map, maps[k], values[k], scale);
  draw_color_bar(canvas, {30 + 3 * across - 18, 45}, 400, scale, "U/(kσ²)", "");
  canvas.finish();
}

int run(const std::string& folder) {
  Map map;
  draw(map, folder + "/surface_maps.png");
  int outside = 0, violations = 0;
  double furthest = 0;
  constexpr double spacing = 0.06;
  for (double x = -half_width; x < half_width; x += spacing)
    for (double y = -half_width; y < half_width; y += spacing)
      for (double z = -half_width; z < half_width; z += spacing) {
        const Vec3 p{x, y, z};
        if (map.distance(p) >= sigma || map.inside(p)) continue;
        ++outside;
        const int here = map.feature_violations(p);
        violations += here;
        if (here == 0)
          furthest =
              std::max(furthest, std::abs(map.at(p, smooth).energy - map.at(p, minimum_distance).energy));
      }
  fmt::print("| panel | largest jump of U [kσ²] | largest jump of force [kσ] |\n|---|---|---|\n");
  const char* names[panels] = {"(a) rough", "(b) minimum distance", "(c) smooth", "(d) faces",
                               "(e) edges", "(f) corners"};
  for (int k = 0; k < panels; ++k) {
    const Jumps jumps = largest_jumps(map, static_cast<Panel>(k));
    fmt::print("| {} | {:.2g} | {:.2g} |\n", names[k], jumps.energy, jumps.force);
  }
  fmt::print("\nThe boundary within sigma is not one piece at {} of {} places within reach.\n", violations,
             outside);
  fmt::print("At the others (c) differs from (b) by {:.2g} kσ² at most.\n", furthest);
  return 0;
}

}  // namespace

int main(int count, char** words) {
  try {
    if (count == 2) return run(words[1]);
    fmt::print(stderr, "usage: surface_maps FOLDER\n");
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "surface_maps: {}\n", error.what());
    return 1;
  }
}
