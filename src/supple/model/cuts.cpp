#include "supple/model/cuts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "supple/core/random.hpp"

namespace supple {
namespace {

Vec2 random_point(const Box<2>& box, RandomStream& draw) {
  const double x = draw.uniform(), y = draw.uniform();
  return {x * box.length[0], y * box.length[1]};
}

void cut_if_linked(PairTable& pairs, std::int32_t row) {
  if (pairs.state[row] == ContactState::permanent) cut(pairs, row);
}

}  // namespace

double nearest_distance(const Box<2>& box, const Vec2& a, const Vec2& b) {
  const double width = box.length[flow], height = box.length[gradient];
  const auto distance_to_row = [&](double row) {
    Vec2 r = b - a + box.lattice().vector({0, row});
    if (box.periodic[flow]) r[flow] -= width * std::round(r[flow] / width);
    return norm(r);
  };
  if (!box.periodic[gradient]) return distance_to_row(0);

  const double level = -std::round((b[gradient] - a[gradient]) / height);
  double nearest = distance_to_row(level);
  // The row of images at a's level need not hold the nearest one, but images k rows away are no nearer than
  // (k - 1/2) height.
  for (int k = 1; (k - 0.5) * height < nearest; ++k)
    nearest = std::min({nearest, distance_to_row(level + k), distance_to_row(level - k)});
  return nearest;
}

std::vector<Vec2> random_particle_seeds(const Box<2>& box, int count, std::uint64_t seed, int attempt) {
  std::vector<Vec2> points;
  for (int p = 0; p < count; ++p) {
    RandomStream draw(seed, Purpose::particle_seed, stream_index(attempt, p));
    points.push_back(random_point(box, draw));
  }
  return points;
}

std::vector<std::int32_t> voronoi_cells(const System<2>& system, std::span<const Vec2> points,
                                        double fuzziness, std::uint64_t seed, int attempt) {
  std::vector<std::int32_t> cell;
  for (int i = 0; i < system.state.size(); ++i) {
    RandomStream draw(seed, Purpose::edge_fuzziness, stream_index(attempt, i));
    std::int32_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t p = 0; p < points.size(); ++p) {
      const double distance =
          nearest_distance(system.box, system.state.position[i], points[p]) + fuzziness * draw.uniform();
      if (distance < least) {
        least = distance;
        nearest = static_cast<std::int32_t>(p);
      }
    }
    cell.push_back(nearest);
  }
  return cell;
}

void cut_between_cells(PairTable& pairs, std::span<const TouchingPair> touching,
                       std::span<const std::int32_t> cell) {
  for (const TouchingPair& pair : touching)
    if (cell[pair.first] != cell[pair.second]) cut_if_linked(pairs, pair.row);
}

CutLine random_cut_line(const Box<2>& box, double avoid_horizontal, std::uint64_t seed, int attempt,
                        int line) {
  RandomStream draw(seed, Purpose::cut_line, stream_index(attempt, line));
  const Vec2 point = random_point(box, draw);
  // A line is horizontal where its normal is vertical. One draw from the allowed range has the same
  // distribution as draws that are repeated until one is allowed.
  const double steepest = std::numbers::pi / 2 - avoid_horizontal;
  const double angle = draw.uniform(-steepest, steepest);
  return {point, {std::cos(angle), std::sin(angle)}};
}

void cut_along_line(System<2>& system, std::span<const TouchingPair> touching, const CutLine& line) {
  for (const TouchingPair& pair : touching) {
    const double here = dot(line.normal, system.state.position[pair.first] - line.point);
    const double there = here + dot(line.normal, pair.separation);
    if (here * there <= 0) cut_if_linked(system.pairs, pair.row);
  }
}

void cut_along_plates(System<2>& system, std::span<const TouchingPair> touching) {
  for (const double y : {0.0, system.box.length[gradient]})
    cut_along_line(system, touching, {{0, y}, {0, 1}});
}

}  // namespace supple
