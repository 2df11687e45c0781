/// The deformable particles that a case describes: how many and how large, and samples of them.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "supple/build/solid_bodies.hpp"
#include "supple/experiment/case.hpp"
#include "supple/model/polygons.hpp"
#include "supple/model/system.hpp"
#include "supple/observe/packing_fraction.hpp"

namespace supple {

/// The kinds of particles of a case, in the order of its bodies: those of [[species]]; or of [bodies] the
/// small ones, the large ones and the extra discs, as far as there are any.
std::vector<Species> species_of(const Case& c);

bool is_disc(const ParticleKind& kind);
/// Whether it is a polygon or surface that moves as one piece.
bool is_rigid(const ParticleKind& kind);
/// Whether it has an inside, of springs or elastic elements.
bool is_solid(const ParticleKind& kind);
/// Whether it has a shape energy (Table 9.1): none of the others do.
bool is_soft(const ParticleKind& kind);
/// What a solid is filled with.
SolidSpec solid_spec(const ParticleKind& kind);
/// The least shape parameter that a particle of so many vertices can have: of the regular polygon, or of the
/// geodesic sphere; 1 where there is none of so many.
double least_shape_parameter(const Case& c, const ParticleKind& kind);
/// What the kind prefers; 0: the least.
double preferred_shape_parameter(const Case& c, const ParticleKind& kind);
/// Its shape energy, before its size is known: in 3D k_v and k_a stand for area and length.
ShapeSpec shape_spec(const Case& c, const ParticleKind& kind);
/// Any of the species.
bool has_polygons(const Case& c);
bool has_soft(const Case& c);

/// "shell"; with [[species]] all of them: "32 shell, 16 disc".
std::string families_of(const Case& c);

/// Particles, and vertices and discs of all of them: up to 1e11 for keys in their ranges.
struct SampleSize {
  std::int64_t bodies = 0, sites = 0;
};
SampleSize sample_size(const Case& c);

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

/// The particles in a square array, far apart.
System<2> particles_apart(const Case& c);

/// Everything about a random packing except where its particles are. Each of them is measured alone; if they
/// are given set apart, the same follows, to rounding, in a time that check has: from one of each kind where
/// the case draws nothing for single particles, and from what it has drawn. Input error where the largest
/// does not fit into the cell.
LooseBodies loose_bodies(const Case& c, double packing_fraction, const Enclosure& enclosure = {},
                         const System<2>* set_apart = nullptr);

/// The particles at random positions in the cell, moved apart as far as can be. Input error where there is no
/// room; `interrupted` where asked to stop.
System<2> random_packing(const Case& c, double packing_fraction, const Enclosure& enclosure = {},
                         const std::function<bool()>& stop_requested = {});

}  // namespace supple
