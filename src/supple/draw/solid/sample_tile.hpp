/// A square of samples of a picture, and which shape is nearest at each.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "supple/draw/solid/on_screen.hpp"

namespace supple {

/// Samples lie at x + 0.5, y + 0.5 for whole x and y. The square has `size` rows of `size` samples.
class SampleTile {
 public:
  explicit SampleTile(int size);

  /// Begins anew, with nothing, as the square whose first sample is (left, top). Only what lies within `cuts`
  /// will show.
  void move_to(int left, int top, std::span<const ScreenCut> cuts);

  /// Covers the samples in this triangle or sphere that nothing nearer has covered. A sample on the edge of
  /// two triangles is in one of them.
  void cover(const ScreenTriangle& t, std::int32_t shape);
  void cover(const ScreenSphere& s, std::int32_t shape);
  /// Where something is cut: covers, by `shape`, the samples that begin within the body whose triangles and
  /// spheres were covered since the last call. Its surface must be closed.
  void cover_cut(std::int32_t shape);

  int left() const { return left_; }
  int top() const { return top_; }
  int size() const { return size_; }
  /// The shape that shows at column i of row j; -1: none.
  std::int32_t shape(int i, int j) const { return shape_[at(i, j)]; }
  float depth(int i, int j) const { return depth_[at(i, j)]; }
  /// The place in `cuts` of the side by which a sample begins.
  int side(int i, int j) const { return side_[at(i, j)]; }

 private:
  std::size_t at(int i, int j) const { return static_cast<std::size_t>(j) * size_ + i; }
  /// The first column (or row) whose samples lie at `place` or beyond, within the square. It is one past the
  /// last of those before `place`.
  int first_at(double place, int origin) const;
  void touch(int first_row, int end_row);
  void cut_row(const ScreenCut& cut, std::int32_t side, int j);
  void cover(int first, int j, int count, int sees, std::int32_t shape);
  bool is_cut() const { return !near_.empty(); }

  int left_ = 0, top_ = 0, size_;
  std::vector<float> depth_;
  std::vector<std::int32_t> shape_;
  std::vector<float> row_;  // depths of a surface in a row
  // Where something is cut: where the ray of each sample enters and leaves the cell, by which side; how often
  // it is inside the present body where it enters; rows that this body has touched.
  std::vector<float> near_, far_;
  std::vector<std::int32_t> side_, inside_;
  int first_row_ = 0, end_row_ = 0;
};

}  // namespace supple
