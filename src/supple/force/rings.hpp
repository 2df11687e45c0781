/// Numbers of polygons laid out for vector instructions: what PolygonShape works on.
#pragma once
#include <algorithm>
#include <memory>
#include <vector>

#include "supple/force/lanes.hpp"
#include "supple/model/system.hpp"

namespace supple::rings {

using lanes::block;
using lanes::for_blocks;
using lanes::LaneSum;
using lanes::padded;

/// The numbers that a ring has for each vertex and the edge that leaves it, one row of numbers for each kind.
enum class Row {
  // The vector of the edge that leaves the vertex, and 1 over its length.
  edge_x,
  edge_y,
  per_length,
  bent,  ///< angle at the vertex beyond the rest angle
  part,  ///< terms of a sum
  // Forces of the edge on the vertex where it starts and on the one where it ends.
  start_x,
  start_y,
  end_x,
  end_y,
  // Copies of what is read, which only the last rings of a system need (place).
  rest_length,
  rest_angle,
  position,
  position_too,
  count
};

/// One ring. In every row the place [-1] repeats the last vertex and [n] the first one, so that no loop has
/// to close the ring. Place [-1] is also the last place of the row before: that row is written earlier, or in
/// the same loop.
struct Ring {
  int body, n, stride;
  double* numbers = nullptr;
  const Vec2* position = nullptr;  ///< this and the next two may be read to the end of the block
  const double *rest_length = nullptr, *rest_angle = nullptr;
  double pressure = 0;
  bool sharp = false;  ///< some corner is beyond least_blunt_cosine

  Ring(int b, int vertices) : body(b), n(vertices), stride(padded(n + 2)) {}
  double* operator[](Row row) const { return numbers + static_cast<int>(row) * stride; }
  int size() const { return static_cast<int>(Row::count) * stride; }
};

/// Rings that go through each pass together. Numbers that one pass stores must have left the store buffer of
/// the processor before the next pass reads them in other pieces; with one small ring at a time this wait is
/// half of all time.
struct Group {
  static constexpr int sites = 160;
  std::vector<Ring> rings;
  std::vector<double> numbers;

  /// Gives each ring memory for its rows, aligned, and pointers to what it reads.
  void place(const System<2>& system) {
    std::size_t size = 2 * block;
    for (const Ring& r : rings) size += static_cast<std::size_t>(r.size());
    if (numbers.size() < size) numbers.assign(size, 1.0);
    std::size_t space = (size - 1) * sizeof(double);
    void* at = numbers.data() + 1;
    auto* next = static_cast<double*>(std::align(block * sizeof(double), sizeof(double), at, space));
    for (Ring& r : rings) {
      r.numbers = next;
      next += r.size();
      point(system, r);
    }
  }

 private:
  /// Sets what a ring reads: the arrays of the system, or copies where they end less than a block after the
  /// ring.
  static void point(const System<2>& system, Ring& r) {
    const Topology<2>& t = system.topology;
    const auto reads = [&](const auto& values, std::int32_t begin, auto* copy) -> decltype(values.data()) {
      if (begin + padded(r.n) < static_cast<int>(values.size())) return values.data() + begin;
      std::copy_n(values.begin() + begin, std::min<std::size_t>(r.n, values.size() - begin), copy);
      return copy;
    };
    r.position = reads(system.state.position, t.begin[r.body], reinterpret_cast<Vec2*>(r[Row::position]));
    r.rest_length = reads(system.shape.rest_facet, t.facet_begin[r.body], r[Row::rest_length]);
    r.rest_angle = reads(system.shape.rest_hinge, t.hinge_begin[r.body], r[Row::rest_angle]);
  }
};

}  // namespace supple::rings
