/// Numbers of a triangulated surface laid out for vector instructions: what SurfaceShape works on.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <vector>

#include "supple/force/lanes.hpp"
#include "supple/force/triangulation.hpp"
#include "supple/model/system.hpp"

namespace supple::surfaces {

/// The numbers that a triangle has, as rows in blocks of eight triangles: two of its edge vectors (the edge k
/// is opposite to its corner k), its normal, the cotangents of its angles, and twice its area.
namespace row {
inline constexpr int edge_1 = 0, edge_2 = 3, normal = 6, cotangent = 9, twice_area = 12, count = 13;
}

/// One surface, in the order of its Triangulation. Points have four numbers, so that one is one register; the
/// last is 0.
struct Surface {
  int body = 0;
  const Triangulation* mesh = nullptr;
  double* position = nullptr;      ///< points: the sites, seen from the first one
  double* triangle = nullptr;      ///< blocks of row::count rows
  double* facet_normal = nullptr;  ///< points: the normals once more
  double* edge_square = nullptr;   ///< of each corner, of the edge opposite to it
  double* moment = nullptr;        ///< of each hinge, over its length
  double* corner_force = nullptr;  ///< points: what each triangle does to its corners, and a zero behind them
  double* part = nullptr;          ///< terms of a sum over triangles or hinges
  const double *rest_area = nullptr, *rest_angle = nullptr;  ///< may be read to the end of the last block
  double pressure = 0;                                       ///< k_v (v - v0)

  /// Becomes the body b of the system: gets memory for its rows, aligned, its positions, and pointers to what
  /// it reads.
  void place(const System<3>& system, int b) {
    const Topology<3>& t = system.topology;
    body = b;
    mesh = &triangulation_of(t, b);
    const int facets = mesh->facet_blocks * lanes::block, hinges = mesh->hinge_blocks * lanes::block;
    double *area_copy = nullptr, *angle_copy = nullptr;
    const std::pair<double**, int> rows[] = {{&position, 4 * lanes::padded(mesh->sites)},
                                             {&triangle, row::count * facets},
                                             {&facet_normal, 4 * facets},
                                             {&edge_square, 3 * facets},
                                             {&moment, hinges},
                                             {&corner_force, 12 * facets + 4},
                                             {&part, std::max(facets, hinges)},
                                             {&area_copy, facets},
                                             {&angle_copy, hinges}};
    std::size_t size = lanes::block;
    for (const auto& [pointer, n] : rows) size += static_cast<std::size_t>(n);
    if (numbers_.size() < size) numbers_.assign(size, 0.0);
    std::size_t space = numbers_.size() * sizeof(double);
    void* at = numbers_.data();
    auto* next = static_cast<double*>(std::align(lanes::block * sizeof(double), sizeof(double), at, space));
    for (const auto& [pointer, n] : rows) *pointer = next, next += n;
    const Vec3 *const x = &system.state.position[t.begin[b]], origin = x[0];
    // Stored as they will be read, or the reads wait until the numbers have left the store buffer.
    for (int i = 0; i < mesh->sites; ++i)
      store_point(Point{x[i][0] - origin[0], x[i][1] - origin[1], x[i][2] - origin[2], 0}, position + 4 * i);
    store_point(Point{}, corner_force + mesh->no_corner());
    rest_area = whole_blocks(system.shape.rest_facet, t.facet_begin[b], facets, area_copy);
    rest_angle = whole_blocks(system.shape.rest_hinge, t.hinge_begin[b], hinges, angle_copy);
  }

 private:
  typedef double Point __attribute__((vector_size(4 * sizeof(double))));
  static void store_point(const Point& point, double* to) { std::memcpy(to, &point, sizeof point); }

  /// n numbers from `begin` on, or a copy of them where they end before.
  static const double* whole_blocks(const std::vector<double>& all, int begin, int n, double* copy) {
    const int there = static_cast<int>(all.size()) - begin;
    if (there >= n) return all.data() + begin;
    std::fill(std::copy_n(all.begin() + begin, there, copy), copy + n, 0.0);
    return copy;
  }

  std::vector<double> numbers_;
};

}  // namespace supple::surfaces
