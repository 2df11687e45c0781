#include "supple/solve/eigenvalue_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "supple/core/random.hpp"

namespace supple {
namespace {

using Dense = std::vector<std::vector<double>>;

struct Matrix {
  std::vector<MatrixEntry> entries;
  std::vector<OuterPart> parts;
  Dense dense;
};

/// `size` numbers, the first of them in parts of `width`; places have up to three entries, or none.
Matrix random_matrix(int size, int parts, int width, std::uint64_t seed) {
  RandomStream draw(seed, Purpose::test);
  Matrix m{
      {}, {}, Dense(static_cast<std::size_t>(size), std::vector<double>(static_cast<std::size_t>(size)))};
  for (int k = 0; k < 3 * size; ++k) {
    const int a = static_cast<int>(draw.below(static_cast<std::uint64_t>(size))),
              b = std::max(0, a - static_cast<int>(draw.below(6)));
    const double value = draw.uniform(-1, 1);
    m.entries.emplace_back(a, b, value);
    m.dense[a][b] += value;
    if (a != b) m.dense[b][a] += value;
  }
  for (int k = 1; k < size; ++k) {  // all are connected
    m.entries.emplace_back(k, k - 1, 0.01);
    m.dense[k][k - 1] += 0.01;
    m.dense[k - 1][k] += 0.01;
  }
  for (int p = 0; p < parts; ++p) {
    OuterPart part{draw.uniform(-1, 1), {}, {}};
    for (int k = p * width; k < (p + 1) * width; ++k) {
      part.index.push_back(k);
      part.slope.push_back(draw.uniform(-1, 1));
    }
    for (int a = 0; a < width; ++a)
      for (int b = 0; b < width; ++b)
        m.dense[part.index[a]][part.index[b]] += part.factor * part.slope[a] * part.slope[b];
    m.parts.push_back(std::move(part));
  }
  return m;
}

/// The formula on the whole matrix.
double bound_of(const Dense& m) {
  std::vector<double> x(m.size(), 1.0), y(m.size());
  double bound = 1e300;
  for (int iteration = 0; iteration < 30; ++iteration) {
    double ratio = 0;
    for (std::size_t a = 0; a < m.size(); ++a) {
      y[a] = 0;
      for (std::size_t b = 0; b < m.size(); ++b) y[a] += std::abs(m[a][b]) * x[b];
      ratio = std::max(ratio, y[a] / x[a]);
    }
    bound = std::min(bound, ratio);
    const double largest = *std::max_element(y.begin(), y.end());
    for (std::size_t a = 0; a < m.size(); ++a) x[a] = y[a] / largest + 1e-3;
  }
  return bound;
}

TEST(EigenvalueBound, PartsThatAreNotMultipliedOutCountAsIfTheyWere) {
  for (const auto& [size, parts, width] :
       {std::tuple{30, 0, 0}, {30, 1, 30}, {30, 3, 8}, {50, 5, 10}, {8, 2, 1}})
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const Matrix m = random_matrix(size, parts, width, seed);
      const double bound = bound_of(m.dense);
      EXPECT_NEAR(eigenvalue_bound(m.entries, m.parts, size), bound, 1e-12 * bound) << size << " " << parts;
    }
}

TEST(EigenvalueBound, OfMatricesThatNothingConnectsIsTheLargestOfThem) {
  Matrix both = random_matrix(40, 2, 8, 3);
  double largest = eigenvalue_bound(both.entries, both.parts, 40);
  for (const int first : {40, 70}) {
    const Matrix more = random_matrix(30, 1, 12, static_cast<std::uint64_t>(first));
    largest = std::max(largest, eigenvalue_bound(more.entries, more.parts, 30));
    for (const MatrixEntry& e : more.entries)
      both.entries.emplace_back(first + e.row(), first + e.col(), e.value());
    for (OuterPart part : more.parts) {
      for (std::int32_t& k : part.index) k += first;
      both.parts.push_back(part);
    }
  }
  EXPECT_EQ(eigenvalue_bound(both.entries, both.parts, 101), largest) << "number 100 is connected to nothing";
}

TEST(EigenvalueBound, OfPortionsOneAfterTheOtherIsTheLargestOfThem) {
  const Matrix portion[] = {random_matrix(40, 2, 8, 3), random_matrix(9, 1, 4, 5),
                            random_matrix(61, 3, 12, 4)};
  double largest = 0;
  for (const Matrix& m : portion)
    largest = std::max(largest, eigenvalue_bound(m.entries, m.parts, static_cast<int>(m.dense.size())));
  std::vector<int> order{0, 1, 2};
  do {
    EigenvalueBound bound;
    double least = 0;
    for (const int k : order) {
      const Matrix& m = portion[k];
      least = bound.of(m.entries, m.parts, static_cast<int>(m.dense.size()), least);
    }
    EXPECT_EQ(least, largest) << order[0] << order[1] << order[2];
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(EigenvalueBound, OfNothingIsZero) {
  EXPECT_EQ(eigenvalue_bound({}, {}, 0), 0);
  EXPECT_EQ(eigenvalue_bound({}, {}, 5), 0);
}

}  // namespace
}  // namespace supple
