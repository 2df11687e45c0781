/// What reading and writing of packings share: the names in the layouts of polygons and of surfaces
/// (packing_file.hpp). For .cpp files only.
#pragma once
#include <string>
#include <vector>

#include "supple/experiment/initial_state.hpp"
#include "supple/io/state/json_node.hpp"
#include "supple/io/state/packing_file.hpp"
#include "supple/model/polygons.hpp"

namespace supple {

/// The deformable particles of so many dimensions, and how many numbers are a point.
template <int Dim>
inline constexpr auto shapes_of_packing = Dim == 2 ? "polygons" : "surfaces";
template <int Dim>
inline constexpr auto numbers_of_point = Dim == 2 ? "two" : "three";

/// visit(name, stiffness) for each stiffness of deformable particles, by the names that files give it.
template <int Dim, class Spec, class Visit>
void for_each_stiffness(Spec& spec, Visit&& visit) {
  visit(Dim == 2 ? "k_a" : "k_v", spec.area);
  visit(Dim == 2 ? "k_l" : "k_a", spec.length);
  visit("k_b", spec.bending);
  visit("gamma", spec.tension);
}

/// The keys of a file, and those of a particle.
template <int Dim>
std::vector<std::string> keys_of_packing();
template <int Dim>
std::vector<std::string> keys_of_particle();

/// Throws a file error where the object has a key that is not among these; of the keys of the other
/// dimension, which `other` lists, it says so.
template <int Dim>
void expect_keys(const JsonNode& node, const std::vector<std::string>& known,
                 const std::vector<std::string>& other);

/// A vector of Dim numbers.
template <int Dim>
Vec<Dim> read_vector(const JsonNode& node);

/// 0 or more.
double read_stiffness(const JsonNode& node);

/// The cell of a file: "box", "strain", "periodic".
template <int Dim>
Box<Dim> read_cell(const JsonNode& root);

/// The walls that stand where the cell is not periodic, and gravity.
template <int Dim>
Environment read_environment(const JsonNode& root, const Box<Dim>& cell);

/// What a particle of a file may leave to the file.
struct CommonOfParticles {
  ShapeSpec spec;
  std::vector<std::string> species;
  bool alone = false;  ///< the file is one particle, whose vertices meet no others and need no diameter
};

/// Adds a particle. A number NaN in System::floor_contact: the site sticks nowhere.
template <int Dim>
void read_particle(const JsonNode& particle, const CommonOfParticles& common, System<Dim>& system);

}  // namespace supple
