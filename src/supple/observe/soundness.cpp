#include "supple/observe/soundness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "supple/geometry/simplex.hpp"
#include "supple/observe/polygon_look.hpp"
#include "supple/observe/surface_look.hpp"

namespace supple {

namespace {

template <int Dim>
using LookOf = std::conditional_t<Dim == 2, PolygonLook, SurfaceLook>;

/// Marks bodies with a coordinate that is not finite, or so large that differences have no digits left.
template <int Dim>
Soundness find_not_finite(const System<Dim>& system) {
  Soundness out;
  const int bodies = system.topology.body_count(system.state.size());
  out.unsound.resize(static_cast<std::size_t>(bodies));
  for (int b = 0; b < bodies; ++b)
    for (int i = system.topology.body_begin(b); i < system.topology.body_end(b) && !out.unsound[b]; ++i)
      for (const double x : system.state.position[i].e) out.unsound[b] |= !(std::abs(x) < 1e100);
  out.not_finite = out.bodies();
  return out;
}

/// The diameter of the smallest vertex.
template <int Dim>
double narrowest_vertex(const State<Dim>& state) {
  double least = std::numeric_limits<double>::infinity();
  for (const double r : state.radius) least = std::min(least, 2 * r);
  return least;
}

template <int Dim>
bool has_inverted_element(const System<Dim>& system, int b) {
  const Solid<Dim>& solid = system.solid;
  for (std::int32_t k = solid.element_begin[b]; k < solid.element_begin[b + 1]; ++k) {
    Vec<Dim> corner[Dim + 1];
    for (int a = 0; a <= Dim; ++a) corner[a] = system.state.position[solid.element[k][a]];
    if (!(simplex_volume(corner) > 0)) return true;
  }
  return false;
}

template <int Dim>
void find_inverted(const System<Dim>& system, Soundness& out) {
  for (int b = 0; b < system.solid.bodies(); ++b)
    if (has_inverted_element(system, b)) {
      ++out.inverted;
      out.unsound[b] = 1;
    }
}

template <int Dim>
Soundness look_at_all(const System<Dim>& system, Outline outline) {
  Soundness wrong = find_not_finite(system);
  if (wrong.not_finite > 0) return wrong;
  const std::vector<ShapeOf<Dim>> shapes = lay_out_bodies(system);
  const ImageSearch search(shapes, system.box);
  const double narrowest = narrowest_vertex(system.state);
  LookOf<Dim> look(shapes.size(), shapes, outline);
  std::vector<ImageOf<Dim>> near;
  for (int b = 0; b < static_cast<int>(shapes.size()); ++b) {
    look.alone(b, shapes[b], narrowest);
    search.find(b, near);
    for (const ImageOf<Dim>& image : near)
      if (image.body >= b) look.together(b, image);
  }
  Soundness found = look.result();
  find_inverted(system, found);
  return found;
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
  say(inverted, "has folded over inside", "have folded over inside");
  say(inside, "is inside another one, or a vertex of it is",
      "are inside another one, or vertices of them are");
  say(crossing, "crosses another one", "cross another one");
  say(open, "has an edge or a triangle so large that a vertex of another one fits through",
      "have edges or triangles so large that a vertex of another one fits through");
  return text;
}

Soundness look_at(const System<2>& system, Outline outline) { return look_at_all(system, outline); }
Soundness look_at(const System<3>& system, Outline outline) { return look_at_all(system, outline); }

Soundness look_at_each(const System<2>& system, Outline outline) {
  Soundness wrong = find_not_finite(system);
  if (wrong.not_finite > 0) return wrong;
  const State<2>& state = system.state;
  const Topology<2>& t = system.topology;
  const double narrowest = narrowest_vertex(state);
  const std::vector<BodyShape> none;
  PolygonLook look(wrong.unsound.size(), none, outline);
  BodyShape shape;
  for (int b = 0; b < static_cast<int>(wrong.unsound.size()); ++b) {
    if (t.body_size(b) == 1) continue;
    const int begin = t.body_begin(b), end = begin + t.boundary_size(b);
    shape.ring.assign(state.position.begin() + begin, state.position.begin() + end);
    shape.radius.assign(state.radius.begin() + begin, state.radius.begin() + end);
    look.alone(b, shape, narrowest);
  }
  Soundness found = look.result();
  find_inverted(system, found);
  return found;
}

Soundness look_at_each(const System<3>& system, Outline outline) {
  Soundness wrong = find_not_finite(system);
  if (wrong.not_finite > 0) return wrong;
  const std::vector<BodySurface> shapes = lay_out_bodies(system);
  const double narrowest = narrowest_vertex(system.state);
  SurfaceLook look(shapes.size(), shapes, outline);
  for (int b = 0; b < static_cast<int>(shapes.size()); ++b) look.alone(b, shapes[b], narrowest);
  Soundness found = look.result();
  find_inverted(system, found);
  return found;
}

}  // namespace supple
