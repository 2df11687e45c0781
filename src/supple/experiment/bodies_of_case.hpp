/// The deformable particles that a case describes: how many and how large, and samples of them.
#pragma once
#include <array>
#include <cstdint>
#include <functional>

#include "supple/experiment/case.hpp"
#include "supple/model/system.hpp"
#include "supple/observe/packing_fraction.hpp"

namespace supple {

/// Numbers of particles and vertices. Particles come first, small before large, then the extra discs.
struct BodySizes {
  explicit BodySizes(const Bodies& b);

  int bodies() const { return particles + discs; }
  /// Vertices and discs of all particles: up to 1e11 for keys in their ranges.
  std::int64_t sites() const;
  bool is_large(int body) const { return body >= particles - large && body < particles; }
  /// Preferred area; 1 for small particles and extra discs.
  double area(int body) const { return is_large(body) ? ratio * ratio : 1; }
  /// Particles of one kind are drawn alike: small, large, extra discs.
  int kind(int body) const { return body >= particles ? 2 : is_large(body) ? 1 : 0; }
  static constexpr int kinds = 3;
  /// Number of vertices; 1 for a disc.
  int vertices(int body) const {
    return body >= particles ? 1 : is_large(body) ? vertices_large : vertices_small;
  }

  int particles, discs, large;
  double ratio;
  int vertices_small, vertices_large;
};

/// The shape of a cell: height over width, periodic or between walls. Its lengths follow from the packing
/// fraction.
struct Enclosure {
  double aspect_ratio = 1;
  std::array<bool, 2> periodic{true, true};
};

/// Sizes of the particles, and the cell that they are for.
struct LooseBodies {
  std::vector<double> radius;  ///< of the circle round each particle
  double area = 0;             ///< that all particles cover when apart
  Box<2> cell;
};

/// Which particles are measured: each one, or only one of each kind, where the case draws nothing for single
/// particles; results are the same to rounding.
enum class Measured { each, kinds };

/// Everything about a random packing except where its particles are. Input error where the largest does not
/// fit into the cell.
LooseBodies loose_bodies(const Case& c, double packing_fraction, const Enclosure& enclosure = {},
                         Measured measured = Measured::each);

/// The particles in a square array, far apart.
System<2> particles_apart(const Case& c);

/// The particles at random positions in the cell, moved apart as far as can be. Input error where there is no
/// room; `interrupted` where asked to stop.
System<2> random_packing(const Case& c, double packing_fraction, const Enclosure& enclosure = {},
                         const std::function<bool()>& stop_requested = {});

}  // namespace supple
