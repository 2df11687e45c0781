#include "supple/draw/page/snapshot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "supple/core/error.hpp"
#include "supple/draw/canvas/color_scale.hpp"
#include "supple/draw/canvas/ticks.hpp"
#include "supple/draw/page/cell_page.hpp"
#include "supple/draw/page/legend.hpp"
#include "supple/draw/scene/colors_apart.hpp"
#include "supple/draw/scene/flat_discs.hpp"
#include "supple/draw/scene/layout.hpp"
#include "supple/draw/scene/polygon_outline.hpp"

namespace supple {

namespace {

constexpr Color wall_color = hex(0x999999);
constexpr double arc_step = 0.8;  // [pt]

/// What is filled of a body, at its positions, and the lines about it.
struct BodyShape {
  std::vector<Vec2> area;
  std::vector<std::vector<Vec2>> edge;
};

/// The parts of a disc's outline that bound its particle.
std::vector<std::vector<Vec2>> particle_edge(const FlatDisc& disc, std::int32_t body, const Scene& scene) {
  std::vector<std::vector<Vec2>> pieces;
  bool goes_on = false;
  for (std::size_t k = 0; k < disc.outline.size(); ++k) {
    const std::int32_t other = disc.across[k];
    const bool is_edge = other < 0 || scene.particle_of(other) != scene.particle_of(body);
    if (is_edge && !goes_on) pieces.push_back({disc.outline[k]});
    if (is_edge) pieces.back().push_back(disc.outline[(k + 1) % disc.outline.size()]);
    goes_on = is_edge;
  }
  return pieces;
}

std::vector<BodyShape> shapes_of(const Scene& scene, double step) {
  std::vector<BodyShape> shapes;
  const std::vector<FlatDisc> discs = flatten_discs(scene);
  for (std::int32_t b = 0; b < scene.bodies(); ++b) {
    BodyShape& shape = shapes.emplace_back();
    if (scene.is_disc(b)) {
      shape = {discs[b].outline, particle_edge(discs[b], b, scene)};
      continue;
    }
    const auto ring = scene.positions_of(b);
    shape.area.assign(ring.begin(), ring.end());
    if (scene.boundary == Boundary::rough) shape.edge = body_outline(ring, scene.radii_of(b), step);
  }
  return shapes;
}

/// Mean radius of circles about bodies, and of sites.
std::pair<double, double> mean_sizes(const Scene& scene) {
  double bodies = 0, sites = 0;
  for (std::int32_t b = 0; b < scene.bodies(); ++b) {
    const auto position = scene.positions_of(b);
    const auto radius = scene.radii_of(b);
    const Vec2 centre = scene.centre_of(b);
    double reach = 0;
    for (std::size_t i = 0; i < position.size(); ++i)
      reach = std::max(reach, norm(position[i] - centre) + radius[i]);
    bodies += reach / scene.bodies();
  }
  for (const double r : scene.radius) sites += r / scene.sites();
  return {bodies, sites};
}

class SnapshotPage {
 public:
  SnapshotPage(const std::string& path, const Scene& scene, const SnapshotOptions& options)
      : scene_(scene),
        options_(options),
        page_(path, scene.box, options.cell_size, options.strain_room, options.dots_per_inch, options.room),
        canvas_(page_.canvas()),
        bodies_(lay_out_bodies(scene, page_.rim() / page_.scale())),
        contacts_(lay_out_contacts(scene, page_.rim() / page_.scale())),
        shapes_(shapes_of(scene, arc_step / page_.scale())),
        body_of_site_(body_of_sites(scene)) {
    const auto points = [&, sizes = mean_sizes(scene)](double of_body, double of_site) {
      return std::min(of_body * sizes.first, of_site * sizes.second) * page_.scale();
    };
    outline_ = std::clamp(points(0.05, 0.15), 0.15, 0.9);
    hatching_ = std::max(points(0.25, 1), 1.0);
    lines_.widest = std::clamp(points(0.21, 0.55), 0.6, 5.0);
    lines_.full_force = options.full_force > 0 ? options.full_force : strongest_force(scene);
    choose_colors();
  }

  void draw() {
    draw_walls();
    page_.draw_matter([&](double whiteness, Lies skipped) { draw_matter(whiteness, skipped); });
    draw_cell_edge();
    page_.draw_title(title());
    page_.draw_scale_bar(scene_.units);
    draw_legend();
    canvas_.finish();
  }

 private:
  void choose_colors() {
    color_ = options_.color;
    if (!options_.scalar && color_.empty()) color_ = colors_apart(scene_);
    if (!options_.scalar) return;
    scale_ = scale_of(*options_.scalar);
    color_.clear();
    for (const double v : options_.scalar->value) color_.push_back(scale_.color(v));
  }

  std::vector<Point> on_page(const std::vector<Vec2>& points, const Vec2& shift) const {
    std::vector<Point> out;
    for (const Vec2& x : points) out.push_back(page_.on_page(x + shift));
    return out;
  }

  /// Draws bodies and contacts, faded to this share of white, without those that lie where nothing shows.
  void draw_matter(double whiteness, Lies skipped) {
    const auto shade = [&](Color c) { return mix(c, white, whiteness); };
    for (const DrawnBody& image : bodies_)
      if (image.lies != skipped) fill(image, whiteness);
    draw_bonds(whiteness, skipped);
    for (const DrawnBody& image : bodies_) {
      if (image.lies == skipped) continue;
      for (const std::vector<Vec2>& piece : shapes_[image.body].edge)
        canvas_.polyline(on_page(piece, image.shift), {shade(ink), outline_});
    }
    for (const DrawnBody& image : bodies_)
      if (image.lies != skipped && scene_.is_held(image.body))
        hatch(on_page(shapes_[image.body].area, image.shift), hatching_, {shade(ink), 0.6 * outline_});
    for (const DrawnBody& image : bodies_)
      if (image.lies != skipped) mark(image, shade(mark_color));
    for (const ContactStyle& style : contact_styles)
      for (const ContactImage& line : contacts_)
        if (line.lies != skipped && scene_.contacts[line.contact].state == style.state)
          draw_contact(line, shade(white), shade(style.color));
  }

  /// A disc as it is; of a polygon the ring, what is about its vertices and, thinly, the line between.
  void fill(const DrawnBody& image, double whiteness) {
    const Color own = color_[image.body], color = mix(own, white, whiteness);
    const std::vector<Point> ring = on_page(shapes_[image.body].area, image.shift);
    const Pen seam{mix(mix(own, black, 0.2), white, whiteness), 0.6 * outline_};
    if (scene_.is_disc(image.body)) return canvas_.polygon(ring, {color, seam});
    const auto radius = scene_.radii_of(image.body);
    if (scene_.boundary == Boundary::smooth) {  // lines with round corners cover all within the radius
      const double width = 2 * radius[0] * page_.scale();
      canvas_.polygon(ring, {{}, Pen{mix(ink, white, whiteness), width + outline_}});
      return canvas_.polygon(ring, {color, Pen{color, std::max(width - outline_, 0.0)}});
    }
    canvas_.polygon(ring, {color, {}});
    for (std::size_t k = 0; k < ring.size(); ++k)
      canvas_.circle(ring[k], radius[k] * page_.scale(), {color, {}});
    canvas_.polygon(ring, {{}, seam});
  }

  /// The springs inside bodies, thinly.
  void draw_bonds(double whiteness, Lies skipped) {
    if (scene_.bond.empty()) return;
    std::vector<std::vector<std::size_t>> of_body(static_cast<std::size_t>(scene_.bodies()));
    for (std::size_t k = 0; k < scene_.bond.size(); ++k)
      of_body[static_cast<std::size_t>(body_of_site_[scene_.bond[k][0]])].push_back(k);
    for (const DrawnBody& image : bodies_) {
      if (image.lies == skipped) continue;
      const Pen pen{mix(mix(color_[image.body], black, 0.35), white, whiteness), 0.4 * outline_};
      for (const std::size_t k : of_body[static_cast<std::size_t>(image.body)]) {
        const auto [i, j] = scene_.bond[k];
        canvas_.line(page_.on_page(scene_.position[i] + image.shift),
                     page_.on_page(scene_.position[j] + image.shift), pen);
      }
    }
  }

  /// Marked sites of a body, wide enough to be seen.
  void mark(const DrawnBody& image, Color color) {
    constexpr double least = 1.6;  // [pt]
    for (const std::int32_t i : options_.marked)
      if (body_of_site_[i] == image.body)
        canvas_.circle(page_.on_page(scene_.position[i] + image.shift),
                       std::max(least, scene_.radius[i] * page_.scale()), {color, {}});
  }

  /// Lines x + y = const in an outline, the same in all bodies.
  void hatch(const std::vector<Point>& outline, double spacing, const Pen& pen) {
    if (outline.empty()) return;
    const auto level = [&](const Point& p) { return (p[0] + p[1]) / spacing; };
    const auto [low, high] = std::ranges::minmax_element(outline, {}, level);
    for (double line = std::ceil(level(*low)); line < level(*high); ++line) {
      std::vector<Point> ends;
      for (std::size_t k = 0; k < outline.size(); ++k) {
        const Point a = outline[k], b = outline[(k + 1) % outline.size()];
        if ((level(a) < line) != (level(b) < line))
          ends.push_back(a + ((line - level(a)) / (level(b) - level(a))) * (b - a));
      }
      std::ranges::sort(ends, {}, [](const Point& p) { return p[0]; });
      for (std::size_t k = 0; k + 1 < ends.size(); k += 2) canvas_.line(ends[k], ends[k + 1], pen);
    }
  }

  /// Draws a contact. All but crosslinks within a particle stand out by a halo.
  void draw_contact(const ContactImage& line, Color halo, Color color) {
    const SceneContact& contact = scene_.contacts[line.contact];
    const Point from = page_.on_page(line.from), to = page_.on_page(line.to);
    const Pen pen = lines_.pen(color, contact.force * scene_.units.force(), contact.tension);
    const auto particle = [&](std::int32_t site) { return scene_.particle_of(body_of_site_[site]); };
    if (contact.state != ContactState::permanent || particle(contact.first) != particle(contact.second))
      canvas_.line(from, to, {halo, pen.width + 1.2 * outline_});
    canvas_.line(from, to, pen);
  }

  Walls walls() const {
    const bool sides = !scene_.box.periodic[flow], ends = !scene_.box.periodic[gradient];
    return scene_.walls.value_or(Walls{sides, sides, ends, ends});
  }
  void draw_walls() {
    const Walls solid = walls();
    const double band = 0.5 * page_.rim();
    const double left = solid.left ? band : 0, right = solid.right ? band : 0;
    const double top = solid.top ? band : 0, bottom = solid.bottom ? band : 0;
    const Point low{page_.corner()[3][0], page_.corner()[2][1]}, high = page_.corner()[1];  // y downward
    const auto wall = [&](bool wanted, Point a, Point b) {
      if (wanted) canvas_.rectangle(a, b, {wall_color, {}});
    };
    wall(solid.left, {low[0] - band, low[1] - top}, {low[0], high[1] + bottom});
    wall(solid.right, {high[0], low[1] - top}, {high[0] + band, high[1] + bottom});
    wall(solid.bottom, {low[0] - left, high[1]}, {high[0] + right, high[1] + band});
    wall(solid.top, {low[0] - left, low[1] - band}, {high[0] + right, low[1]});
  }

  /// Plates are thick; open sides, neither periodic nor solid, are dotted.
  void draw_cell_edge() {
    const Walls solid = walls();
    const std::array<Point, 4>& corner = page_.corner();
    const auto side = [&](int k, int direction, bool is_wall, Mobility plate = Mobility::free) {
      const bool is_plated = plate != Mobility::free && std::ranges::count(scene_.mobility, plate) > 0;
      const Pen line{ink, is_plated ? 3 : 0.8}, open{gray, 0.6, {2, 3}};
      canvas_.line(corner[k], corner[(k + 1) % 4], scene_.box.periodic[direction] || is_wall ? line : open);
    };
    side(0, gradient, solid.bottom, Mobility::lower_plate);
    side(1, flow, solid.right);
    side(2, gradient, solid.top, Mobility::upper_plate);
    side(3, flow, solid.left);
  }

  std::string title() const {
    if (!options_.title.empty()) return options_.title;
    return instant_title(scene_.units, scene_.time, scene_.box.strain, drawn_strain(scene_.box),
                         scene_.box.periodic[flow]);
  }

  void draw_legend() {
    Legend legend(canvas_, page_.legend_left(), page_.top());
    if (options_.scalar) {
      const double height = std::clamp(0.45 * scene_.box.length[gradient] * page_.scale(), 80.0, 160.0);
      legend.color_bar(*options_.scalar, scale_, height);
    } else {
      legend.particles(scene_);
    }
    legend.held(scene_, [&](const std::vector<Point>& ring) { hatch(ring, 3, {ink, 0.5}); });
    legend.contacts(scene_, lines_);
  }

  const Scene& scene_;
  const SnapshotOptions& options_;
  CellPage page_;
  Canvas& canvas_;
  std::vector<DrawnBody> bodies_;
  std::vector<ContactImage> contacts_;
  std::vector<BodyShape> shapes_;
  std::vector<std::int32_t> body_of_site_;
  std::vector<Color> color_;
  ColorScale scale_;
  ContactLines lines_;
  double outline_, hatching_;
};

}  // namespace

void check_colors(const std::string& path, std::size_t bodies, const std::optional<BodyScalar>& scalar,
                  const std::vector<Color>& color) {
  const std::string what = "cannot draw '" + path + "'";
  const std::size_t given = scalar ? scalar->value.size() : color.size();
  if (given != bodies && (scalar || given > 0))
    throw input_error(what, fmt::format("{} numbers or colours for {} bodies", given, bodies));
  if (scalar && scalar->range && !(scalar->range->first < scalar->range->second))
    throw input_error(what, "the range of its colours is empty");
}

ColorScale scale_of(const BodyScalar& scalar) {
  return scalar.range ? ColorScale{scalar.range->first, scalar.range->second} : scale_over(scalar.value);
}

void draw_snapshot(const std::string& path, const Scene& scene, const SnapshotOptions& options) {
  check_scene(scene, path);
  check_colors(path, static_cast<std::size_t>(scene.bodies()), options.scalar, options.color);
  for (const std::int32_t i : options.marked)
    if (i < 0 || i >= scene.sites())
      throw input_error("cannot draw '" + path + "'", fmt::format("marked site {} is not there", i));
  SnapshotPage(path, scene, options).draw();
}

}  // namespace supple
