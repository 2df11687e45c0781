#include "supple/experiment/given_packing.hpp"

#include <algorithm>

#include "supple/model/polygons.hpp"

namespace supple {

namespace {

/// Preferred area and edges of a body.
struct Preferred {
  double area, length;  ///< of an edge, in the mean
  int edges;
};
Preferred preferred(const System<2>& system, std::size_t b) {
  const int first = system.topology.facet_begin[b], end = system.topology.facet_begin[b + 1];
  double perimeter = 0;
  for (int f = first; f < end; ++f) perimeter += system.shape.rest_facet[f];
  return {system.shape.rest_volume[b], perimeter / (end - first), end - first};
}

/// Whether a body is deformable; discs and rigid bodies are not.
bool is_soft(const ShapeStiffness& k) { return k.volume > 0 || k.facet > 0 || k.hinge > 0 || k.tension > 0; }

/// Sets the stiffnesses that the user did not give to `k`, in the kind of the case (absolute or relative).
void adopt_stiffness(Case& c, const ShapeStiffness& k, const Preferred& p) {
  const bool relative = c.bodies.stiffness == "relative";
  const auto adopt = [&](const char* key, double& of_case, double absolute, double scale) {
    if (!c.is_given(key)) of_case = relative ? absolute * scale : absolute;
  };
  adopt("bodies.k_a", c.bodies.k_a, k.volume, p.area * p.area);
  adopt("bodies.k_l", c.bodies.k_l, k.facet, p.length * p.length);
  adopt("bodies.k_b", c.bodies.k_b, k.hinge, 1);
  adopt("bodies.gamma", c.bodies.gamma, k.tension, p.edges * p.length);
}

}  // namespace

void adopt_stiffness(Case& c, const System<2>& system) {
  const auto& all = system.shape.stiffness;
  const auto soft = std::find_if(all.begin(), all.end(), is_soft);
  if (soft != all.end())
    adopt_stiffness(c, *soft, preferred(system, static_cast<std::size_t>(soft - all.begin())));
}

void give_stiffness(const Case& c, System<2>& system) {
  const Bodies& b = c.bodies;
  const StiffnessKind kind = b.stiffness == "relative" ? StiffnessKind::relative : StiffnessKind::absolute;
  for (std::size_t body = 0; body < system.shape.stiffness.size(); ++body) {
    ShapeStiffness& k = system.shape.stiffness[body];
    if (!is_soft(k)) continue;
    const Preferred p = preferred(system, body);
    const ShapeStiffness given =
        absolute_stiffness({b.k_a, b.k_l, b.k_b, b.gamma, kind}, p.area, p.length, p.edges);
    if (c.is_given("bodies.k_a")) k.volume = given.volume;
    if (c.is_given("bodies.k_l")) k.facet = given.facet;
    if (c.is_given("bodies.k_b")) k.hinge = given.hinge;
    if (c.is_given("bodies.gamma")) k.tension = given.tension;
  }
}

}  // namespace supple
