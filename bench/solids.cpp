#include "bench/solids.hpp"

#include <fmt/core.h>

#include "bench/time_per_vertex.hpp"
#include "supple/build/solid_bodies.hpp"
#include "supple/force/solid_terms.hpp"

namespace supple::bench {
namespace {

/// Additions and multiplications for the forces in dimension d, and divisions and roots, counted in the
/// gradients of energy/bond_stretch and energy/element_strain and where they are added to the sites.
constexpr double of_spring(int d) { return 6.0 * d + 3; }
constexpr int divisions_of_spring = 2;
constexpr double of_element(int d) {
  const double edges = d * d, product = d * d * (2 * d - 1), products = 0.5 * d * (d + 1) * (2 * d - 1);
  const double volume = d == 2 ? 3 : 14, normal = d * (d + 4.0) + 2 * d * d,
               shear = d * (d - 1) * (2 * d + 0.5);
  return edges + product + products + volume + normal + shear + product + 2.0 * d * d + (d + 1) * d;
}
constexpr int divisions_of_element = 1;

template <int Dim>
struct Row {
  const char* name;
  SolidSpec spec;
  int vertices;
};

template <int Dim>
void print_row(const Row<Dim>& row) {
  System<Dim> system;
  add_solid(system, solid_mesh<Dim>(row.spec, row.vertices, 1), 1, row.spec);
  for (Vec<Dim>& x : system.state.position) x[0] *= 1.01;
  const Solid<Dim>& solid = system.solid;
  const bool network = row.spec.filling == Filling::network;
  const double parts = static_cast<double>(network ? solid.bond.size() : solid.element.size());
  Evaluation<Dim> out;
  out.force.resize(system.state.position.size());
  const SolidTerms<Dim> terms;
  const auto [forces, energies] =
      time_per_vertex<2>(static_cast<int>(parts), {[&] { terms.evaluate(system, Detail::forces, out); },
                                                   [&] { terms.evaluate(system, Detail::energies, out); }});
  const double arithmetic =
      network ? nanoseconds_of_operations(of_spring(Dim)) + nanoseconds_of_divisions(divisions_of_spring)
              : nanoseconds_of_operations(of_element(Dim)) + nanoseconds_of_divisions(divisions_of_element);
  // The lists once, and each site read and its force read and written once.
  const double bytes = (network ? sizeof(solid.bond[0]) + sizeof(double)
                                : sizeof(solid.element[0]) + sizeof(solid.rest_element[0])) +
                       3 * sizeof(Vec<Dim>) * system.state.size() / parts;
  const double memory = bytes / bytes_per_nanosecond(static_cast<std::size_t>(parts * bytes));
  fmt::print("  {:<22}  {:>8}  {:>6.1f}  {:>8.1f}  {:>10.1f}  {:>6.1f}\n", row.name, parts, forces, energies,
             arithmetic, memory);
}

}  // namespace

void print_solids() {
  const SolidSpec network, elements{Filling::elements, 0, {1, 0.3}};
  fmt::print(
      "\nInside of elastic solids: CPU ns per spring, triangle or tetrahedron and evaluation (best of "
      "repeats)\n");
  fmt::print("  {:<22}  {:>8}  {:>6}  {:>8}  {:>10}  {:>6}\n", "", "of them", "forces", "energies",
             "arithmetic", "memory");
  print_row<2>({"springs of a disc", network, 1100});
  print_row<3>({"springs of a ball", network, 3765});
  print_row<2>({"triangles", elements, 1000});
  print_row<3>({"tetrahedra", elements, 162});
  print_row<3>({"tetrahedra", elements, 2562});
  fmt::print(
      "  energies: with energies and virial. arithmetic: additions, multiplications, divisions and roots at "
      "the "
      "best\n  rate of this machine, in vectors. memory: the lists, and each site once, at the speed of a "
      "copy of "
      "that size.\n");
}

}  // namespace supple::bench
