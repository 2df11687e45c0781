/// Bodies with an inside: spring networks, and elastic triangles or tetrahedra round a centre.
#pragma once
#include <cstdint>
#include <optional>

#include "supple/build/solids.hpp"
#include "supple/energy/elastic_constants.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// What fills a solid: a disordered network of springs, or elements that meet in its centre [MacKeith 2025,
/// section 9.3.4].
enum class Filling { network, elements };

/// A solid before its size is known.
struct SolidSpec {
  Filling filling = Filling::network;
  double spring = 1;  ///< of each bond of a network [energy/length^2]; 0: from Young's modulus
  /// Of elements; of a network without `spring` Young's modulus, which affine_modulus makes a spring.
  ElasticConstants material{1, 0.3};
};

/// The mesh of a solid of area (volume) 1 about the origin. `vertices` are the nodes of a network in all, or
/// the vertices of the regular polygon (the geodesic icosahedron) about the centre. Only networks depend on
/// the seed. Input errors of network_disc, network_ball, geodesic_icosahedron.
template <int Dim>
SolidMesh<Dim> solid_mesh(const SolidSpec& spec, int vertices, std::uint64_t seed);

/// The seed of the network of particle `body` of a sample: each is another one.
inline std::uint64_t network_seed(std::int64_t seed, int body) {
  return static_cast<std::uint64_t>(seed) ^ (static_cast<std::uint64_t>(body) << 32);
}

/// Adds this mesh as a body at rest, without stress. All nodes have mass 1 and the diameter `diameter_ratio`
/// times the mean length of an edge of the boundary. Its shape energy is 0. Input error where that is not
/// positive or an element has no area (volume).
template <int Dim>
void add_solid(System<Dim>& system, const SolidMesh<Dim>& mesh, double diameter_ratio, const SolidSpec& spec);

/// E and nu that body b is made of: those of its elements, or of a network of springs that follow a uniform
/// strain (affine_modulus). Nothing where it has no inside.
template <int Dim>
std::optional<ElasticConstants> nominal_constants(const System<Dim>& system, int b);

}  // namespace supple
