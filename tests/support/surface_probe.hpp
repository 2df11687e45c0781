/// A triangulated surface and a point that is put anywhere to probe the potential of the surface.
#pragma once
#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

#include "supple/build/surfaces.hpp"
#include "supple/contact/surface_walk.hpp"
#include "supple/geometry/inside.hpp"

namespace supple::testing {

/// U(p) = sum of sign phi(distance) over what p meets, phi(d) = (sigma - d)^2/2 for d < sigma.
class SurfaceProbe {
 public:
  SurfaceProbe(const TriangleMesh& surface, double diameter) : mesh(surface), sigma(diameter) {
    topology_.facet = mesh.face;
    fans_.update(topology_, static_cast<int>(mesh.vertex.size()));
    facets_.resize(mesh.face.size());
    std::iota(facets_.begin(), facets_.end(), 0);
  }

  template <class Visit>
  smooth::MetParts meet(const Vec3& p, const Visit& visit) const {
    smooth::PatchInReach patch({mesh.vertex, topology_, fans_});
    return patch.meet(facets_, p, sigma, visit);
  }
  smooth::MetParts met(const Vec3& p) const {
    return meet(p, [](const auto&) {});
  }
  double energy(const Vec3& p) const {
    double u = 0;
    meet(p,
         [&](const auto& foot) { u += 0.5 * foot.sign * (sigma - foot.distance) * (sigma - foot.distance); });
    return u;
  }
  Vec3 force(const Vec3& p) const {
    Vec3 f{};
    meet(p, [&](const auto& foot) { f += foot.sign * (sigma - foot.distance) * foot.normal; });
    return f;
  }
  double distance(const Vec3& p) const {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& face : mesh.face) least = std::min(least, norm(closest(p, face).from));
    return least;
  }
  bool inside(const Vec3& p) const { return is_inside(p, mesh.vertex, mesh.face); }
  ClosestOnTriangle closest(const Vec3& p, const std::array<std::int32_t, 3>& face) const {
    const Vec3 x[3] = {mesh.vertex[face[0]], mesh.vertex[face[1]], mesh.vertex[face[2]]};
    return closest_on_triangle(p, x);
  }

  TriangleMesh mesh;  ///< its vertices may be moved
  const double sigma;

 private:
  Topology<3> topology_;
  SurfaceFans fans_;
  std::vector<std::int32_t> facets_;
};

}  // namespace supple::testing
