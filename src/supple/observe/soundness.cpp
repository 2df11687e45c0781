#include "supple/observe/soundness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "supple/geometry/inside.hpp"
#include "supple/geometry/polygon.hpp"
#include "supple/geometry/self_crossing.hpp"
#include "supple/observe/body_images.hpp"

namespace supple {

namespace {

/// Whether the open segments a b and c d cross. Those that only touch do not.
bool cross_each_other(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const Vec2 first = b - a, second = d - c;
  return cross(first, c - a) * cross(first, d - a) < 0 && cross(second, a - c) * cross(second, b - c) < 0;
}

Bounds bounds_of_edge(const BodyShape& shape, int k, const Vec2& shift) {
  Bounds bounds{shape.ring[k] + shift, shape.ring[k] + shift};
  bounds.include({shape.ring[shape.next(k)] + shift, shape.ring[shape.next(k)] + shift});
  return bounds;
}

/// An edge of a ring, displaced, with its bounds.
struct Edge {
  Vec2 from, to;
  Bounds bounds;
  int number;
};

/// The edges of a displaced body that meet a region, from left to right.
void edges_in(const BodyShape& shape, const Vec2& shift, const Bounds& region, std::vector<Edge>& edges) {
  edges.clear();
  for (int k = 0; k < shape.size(); ++k)
    if (const Bounds bounds = bounds_of_edge(shape, k, shift); bounds.meets(region))
      edges.push_back({shape.ring[k] + shift, shape.ring[shape.next(k)] + shift, bounds, k});
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return a.bounds.low[0] < b.bounds.low[0]; });
}

/// Bounds of a ring, without the discs at its vertices.
Bounds bounds_of_ring(const BodyShape& shape) {
  Bounds bounds{shape.ring[0], shape.ring[0]};
  for (const Vec2& x : shape.ring) bounds.include({x, x});
  return bounds;
}

class Look {
 public:
  /// At this many bodies, and at these shapes for those that are to be looked at together.
  Look(std::size_t bodies, const std::vector<BodyShape>& shapes, Outline outline)
      : shapes_(shapes), outline_(outline) {
    for (const BodyShape& shape : shapes) rings_.push_back(bounds_of_ring(shape));
    inside_.resize(bodies);
    crossing_.resize(bodies);
    out_.unsound.resize(bodies);
  }

  void alone(int b, const BodyShape& shape, double narrowest) {
    if (shape.is_disc()) return;
    count(b, out_.turned_over, !(polygon_area(shape.ring) > 0));
    count(b, out_.self_crossing, find_self_crossing(shape.ring).has_value());
    if (outline_ == Outline::smooth) return;
    bool open = false;
    for (int k = 0; k < shape.size(); ++k) {
      const double length = norm(shape.ring[shape.next(k)] - shape.ring[k]);
      const double discs = shape.radius[k] + shape.radius[shape.next(k)];
      if (discs > 0) out_.longest_edge = std::max(out_.longest_edge, length / discs);
      open = open || length >= discs + narrowest;
    }
    count(b, out_.open, open);
  }

  /// Body a, and the copy of another one, or of itself.
  void together(int a, const BodyImage& image) {
    const BodyShape &first = shapes_[a], &second = shapes_[image.body];
    if (first.is_disc() && second.is_disc()) return discs(a, image);
    const Bounds other = rings_[image.body].shifted(image.shift);
    if (!rings_[a].meets(other)) return;
    const Bounds region = common_part(rings_[a], other);
    if (has_site_inside(first, {}, second, image.shift, region)) inside_[a] = 1;
    if (has_site_inside(second, image.shift, first, {}, region)) inside_[image.body] = 1;
    if (first.is_disc() || second.is_disc() || !boundaries_cross(first, second, image.shift, region)) return;
    crossing_[a] = crossing_[image.body] = 1;
  }

  Soundness result() {
    for (int b = 0; b < static_cast<int>(inside_.size()); ++b) {
      count(b, out_.inside, inside_[b]);
      count(b, out_.crossing, crossing_[b]);
    }
    return std::move(out_);
  }

 private:
  void count(int body, int& number, bool wrong) {
    if (!wrong) return;
    ++number;
    out_.unsound[body] = 1;
  }

  void discs(int a, const BodyImage& image) {
    const double r = shapes_[a].radius[0], other = shapes_[image.body].radius[0];
    const double distance = norm(shapes_[image.body].ring[0] + image.shift - shapes_[a].ring[0]);
    if (distance < std::abs(r - other)) inside_[r < other ? a : image.body] = 1;
  }

  /// Whether a vertex of one body lies in the polygon of the other.
  bool has_site_inside(const BodyShape& one, const Vec2& shift, const BodyShape& other,
                       const Vec2& other_shift, const Bounds& region) const {
    if (other.is_disc()) return false;
    return std::any_of(one.ring.begin(), one.ring.end(), [&](const Vec2& site) {
      const Vec2 x = site + shift;
      return region.holds(x) && is_inside(x - other_shift, other.ring);
    });
  }

  bool boundaries_cross(const BodyShape& first, const BodyShape& second, const Vec2& shift,
                        const Bounds& region) {
    edges_in(first, {}, region, first_);
    edges_in(second, shift, region, second_);
    for (const Edge& a : first_)
      for (const Edge& b : second_) {
        if (b.bounds.low[0] > a.bounds.high[0]) break;
        if (a.bounds.meets(b.bounds) && cross_each_other(a.from, a.to, b.from, b.to)) return true;
      }
    return false;
  }

  const std::vector<BodyShape>& shapes_;
  Outline outline_;
  std::vector<Bounds> rings_;
  std::vector<std::uint8_t> inside_, crossing_;
  std::vector<Edge> first_, second_;
  Soundness out_;
};

/// Marks bodies with a coordinate that is not finite, or so large that differences have no digits left.
Soundness find_not_finite(const System<2>& system) {
  Soundness out;
  const int bodies = system.topology.body_count(system.state.size());
  out.unsound.resize(static_cast<std::size_t>(bodies));
  for (int b = 0; b < bodies; ++b)
    for (int i = system.topology.body_begin(b); i < system.topology.body_end(b) && !out.unsound[b]; ++i) {
      const Vec2& x = system.state.position[i];
      out.unsound[b] = !(std::abs(x[0]) < 1e100 && std::abs(x[1]) < 1e100);
    }
  out.not_finite = out.bodies();
  return out;
}

/// The diameter of the smallest vertex.
double narrowest_disc(const State<2>& state) {
  double least = std::numeric_limits<double>::infinity();
  for (const double r : state.radius) least = std::min(least, 2 * r);
  return least;
}

}  // namespace

int Soundness::bodies() const { return std::accumulate(unsound.begin(), unsound.end(), 0); }

std::string Soundness::what() const {
  std::string text;
  const auto say = [&](int number, const char* one, const char* many) {
    if (number == 0) return;
    if (text.empty())
      text =
          fmt::format("{} {} {}", number, number == 1 ? "particle" : "particles", number == 1 ? one : many);
    else text += fmt::format(", {} {}", number, number == 1 ? one : many);
  };
  say(not_finite, "has a position that is no number", "have positions that are no numbers");
  say(turned_over, "has turned inside out", "have turned inside out");
  say(self_crossing, "crosses itself", "cross themselves");
  say(inside, "is inside another one, or a vertex of it is",
      "are inside another one, or vertices of them are");
  say(crossing, "crosses another one", "cross another one");
  say(open, "has an edge so long that a vertex of another one fits between its ends",
      "have edges so long that a vertex of another one fits between their ends");
  return text;
}

Soundness look_at(const System<2>& system, Outline outline) {
  Soundness wrong = find_not_finite(system);
  if (wrong.not_finite > 0) return wrong;
  const std::vector<BodyShape> shapes = lay_out_bodies(system);
  const ImageSearch search(shapes, system.box);
  const double narrowest = narrowest_disc(system.state);
  Look look(shapes.size(), shapes, outline);
  std::vector<BodyImage> near;
  for (int b = 0; b < static_cast<int>(shapes.size()); ++b) {
    look.alone(b, shapes[b], narrowest);
    search.find(b, near);
    for (const BodyImage& image : near)
      if (image.body >= b) look.together(b, image);
  }
  return look.result();
}

Soundness look_at_each(const System<2>& system, Outline outline) {
  Soundness wrong = find_not_finite(system);
  if (wrong.not_finite > 0) return wrong;
  const State<2>& state = system.state;
  const Topology<2>& t = system.topology;
  const double narrowest = narrowest_disc(state);
  const std::vector<BodyShape> none;
  Look look(wrong.unsound.size(), none, outline);
  BodyShape shape;
  for (int b = 0; b < static_cast<int>(wrong.unsound.size()); ++b) {
    if (t.body_size(b) == 1) continue;
    shape.ring.assign(state.position.begin() + t.body_begin(b), state.position.begin() + t.body_end(b));
    shape.radius.assign(state.radius.begin() + t.body_begin(b), state.radius.begin() + t.body_end(b));
    look.alone(b, shape, narrowest);
  }
  return look.result();
}

}  // namespace supple
