/// A square of samples of a picture, and which shape is nearest at each.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/draw/solid/on_screen.hpp"

namespace supple {

/// Samples lie at x + 0.5, y + 0.5 for whole x and y. The square has `size` rows of `size` samples.
class SampleTile {
 public:
  explicit SampleTile(int size);

  /// Begins anew, with nothing, as the square whose first sample is (left, top).
  void move_to(int left, int top);

  /// Covers the samples in this triangle or sphere, border included, that nothing nearer has covered. The
  /// triangles on both sides of an edge leave no sample between them.
  void cover(const ScreenTriangle& t, std::int32_t shape);
  void cover(const ScreenSphere& s, std::int32_t shape);

  int left() const { return left_; }
  int top() const { return top_; }
  int size() const { return size_; }
  /// The shape that shows at column i of row j; -1: none.
  std::int32_t shape(int i, int j) const { return shape_[at(i, j)]; }
  float depth(int i, int j) const { return depth_[at(i, j)]; }

 private:
  std::size_t at(int i, int j) const { return static_cast<std::size_t>(j) * size_ + i; }
  /// The first and one past the last column (or row) from `low` to `high`, within the square.
  int first_at(double low, int origin) const;
  int end_at(double high, int origin) const;

  int left_ = 0, top_ = 0, size_;
  std::vector<float> depth_;
  std::vector<std::int32_t> shape_;
};

}  // namespace supple
