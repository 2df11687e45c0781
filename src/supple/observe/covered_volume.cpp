// Every body has its own volume, and loses what it shares: of a point that n bodies cover, it keeps 1/n. What
// it loses is the sum over the others of the integral of 1/n over what the two have in common, because 1 -
// 1/n is n - 1 times 1/n. So each integral is over one body or over one overlap, exact where there is a
// closed form.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "supple/core/parallel.hpp"
#include "supple/core/require.hpp"
#include "supple/geometry/disc_overlap.hpp"
#include "supple/geometry/facet.hpp"
#include "supple/geometry/hinge.hpp"
#include "supple/observe/body_chords.hpp"
#include "supple/observe/line_integral.hpp"
#include "supple/observe/packing_fraction.hpp"

namespace supple {
namespace {

using std::numbers::pi;
using Image = ImageOf<3>;

double total_length(const std::vector<Interval>& chords) {
  double length = 0;
  for (const Interval& i : chords) length += i.high - i.low;
  return length;
}

/// Volume of everything within `radius` of a convex polyhedron, V + S r + M r^2 + 4 pi r^3/3, with M half
/// the sum over edges of length times turning angle [Steiner 1840]. Nothing where it may not be convex: a
/// closed surface of the Euler number of one sphere whose edges all turn outward is the boundary of a convex
/// body [Tietze 1928].
std::optional<double> steiner_volume(const BodySurface& body) {
  constexpr double straight = -1e-9;
  const double r = body.radius[0];
  if (body.size() - static_cast<int>(body.hinge.size()) + static_cast<int>(body.face.size()) != 2)
    return std::nullopt;
  double surface = 0, curvature = 0;
  for (const auto& hinge : body.hinge) {
    const auto [a, b, c, d] = body.corners(hinge);
    const Vec3 x[4] = {a, b, c, d};
    const double turn = hinge_angle(x);
    if (!(turn >= straight)) return std::nullopt;
    curvature += 0.5 * turn * norm(b - a);
  }
  for (const auto& face : body.face) {
    const auto [a, b, c] = body.corners(face);
    const Vec3 x[3] = {a, b, c};
    surface += facet_measure(x);
  }
  return body.polyhedron() + r * (surface + r * (curvature + r * (4 * pi / 3)));
}

/// The volume of a body alone, where a closed form holds.
std::optional<double> exact_volume(const BodySurface& body, Outline outline) {
  const double r = body.radius[0];
  if (body.is_sphere()) return 4 * pi / 3 * r * r * r;
  if (outline == Outline::smooth) return steiner_volume(body);
  const bool bare = std::all_of(body.radius.begin(), body.radius.end(), [](double x) { return x == 0; });
  return bare ? std::optional(body.polyhedron()) : std::nullopt;
}

/// What two bodies may have in common, with the copies of others that may cover it too.
struct Meeting {
  int body;
  Image other;
  std::vector<Image> third;
  BoundsOf<3> bounds;  ///< of both
};

/// How far a body reaches along a direction of length 1 [length]: its vertices with their spheres.
double reach_along(const BodySurface& shape, const Vec3& direction) {
  double reach = -std::numeric_limits<double>::infinity();
  for (int k = 0; k < shape.size(); ++k)
    reach = std::max(reach, dot(direction, shape.vertex[k]) + shape.radius[k]);
  return reach;
}

/// Whether a plane across the line of their middles parts a body from a displaced one.
bool parted(const BodySurface& a, const BodySurface& b, const Vec3& shift) {
  const auto middle = [](const BodySurface& s) { return 0.5 * (s.bounds.low + s.bounds.high); };
  const Vec3 along = middle(b) + shift - middle(a);
  const double length = norm(along);
  if (!(length > 0)) return false;
  const Vec3 direction = (1 / length) * along;
  return reach_along(a, direction) < dot(direction, shift) - reach_along(b, -direction);
}

/// Every overlap of two bodies once, also of a body with its own image.
std::vector<Meeting> find_meetings(const std::vector<BodySurface>& shapes, const Box<3>& box) {
  const ImageSearch search(shapes, box);
  std::vector<Meeting> meetings;
  std::vector<Image> near;
  for (int body = 0; body < static_cast<int>(shapes.size()); ++body) {
    search.find(body, near);
    for (const Image& other : near) {
      const double* shift = other.shift.e;
      const bool backward = std::lexicographical_compare(shift, shift + 3, Vec3{}.e, Vec3{}.e + 3);
      if (other.body < body || (other.body == body && backward)) continue;
      if (parted(shapes[body], shapes[other.body], other.shift)) continue;
      Meeting m{body, other, {}, common_part(shapes[body].bounds, other.bounds)};
      for (const Image& third : near)
        if (&third != &other && third.bounds.meets(m.bounds)) m.third.push_back(third);
      meetings.push_back(std::move(m));
    }
  }
  return meetings;
}

class Volumes {
 public:
  Volumes(const std::vector<BodySurface>& shapes, Outline outline) : shapes_(shapes) {
    chords_.reserve(shapes.size());
    for (const BodySurface& shape : shapes) chords_.emplace_back(shape, outline);
  }

  /// Volume of a body alone, by lines.
  LineIntegral alone(int body, double error, const VolumeAccuracy& a, RandomStream& draw) const {
    std::vector<Interval> own;
    const auto length = [&](const LineAlongZ& line) {
      chords_[body].find(line, own);
      return total_length(own);
    };
    return integrate_over_lines(base_of(shapes_[body].bounds), error, a.most_lines, draw, length);
  }

  /// The integral of 1/n over what two bodies have in common.
  LineIntegral shared(const Meeting& m, double error, const VolumeAccuracy& a, RandomStream& draw) const {
    std::vector<Interval> own, other, both, scratch;
    const auto share = [&](const LineAlongZ& line) {
      chords_[m.body].find(line, own);
      if (own.empty()) return 0.0;
      find(m.other, line, other);
      intersect(own, other, both);
      if (both.empty()) return 0.0;
      return shared_length(m, line, both, scratch);
    };
    return integrate_over_lines(base_of(m.bounds), error, a.most_lines, draw, share);
  }

  /// The same in closed form: half of the lens of two spheres of which no third one covers any.
  std::optional<double> exact_share(const Meeting& m) const {
    const BodySurface &a = shapes_[m.body], &b = shapes_[m.other.body];
    if (!a.is_sphere() || !b.is_sphere()) return std::nullopt;
    const Vec3 x = a.vertex[0], y = b.vertex[0] + m.other.shift;
    const double r = a.radius[0], s = b.radius[0], lens = sphere_overlap(r, s, norm(y - x));
    for (const Image& third : m.third) {
      if (lens == 0) return 0;
      const BodySurface& c = shapes_[third.body];
      if (!c.is_sphere()) return std::nullopt;
      const Vec3 z = c.vertex[0] + third.shift;
      const double t = c.radius[0];
      if (norm(z - x) < r + t && norm(z - y) < s + t && spheres_have_common_point({x, y, z}, {r, s, t}))
        return std::nullopt;
    }
    return 0.5 * lens;
  }

 private:
  static Bounds base_of(const BoundsOf<3>& b) { return {{b.low[0], b.low[1]}, {b.high[0], b.high[1]}}; }

  void find(const Image& image, const LineAlongZ& line, std::vector<Interval>& chords) const {
    chords_[image.body].find(line - Vec2{image.shift[0], image.shift[1]}, chords);
    for (Interval& i : chords) i = {i.low + image.shift[2], i.high + image.shift[2]};
  }

  /// The length of `both`, each point over the number of bodies that cover it.
  double shared_length(const Meeting& m, const LineAlongZ& line, const std::vector<Interval>& both,
                       std::vector<Interval>& scratch) const {
    std::vector<Interval> more;  // of all third bodies
    for (const Image& third : m.third) {
      if (!(third.bounds.low[0] <= line[0] && line[0] <= third.bounds.high[0])) continue;
      if (!(third.bounds.low[1] <= line[1] && line[1] <= third.bounds.high[1])) continue;
      find(third, line, scratch);
      more.insert(more.end(), scratch.begin(), scratch.end());
    }
    if (more.empty()) return 0.5 * total_length(both);
    double sum = 0;
    std::vector<double> cuts;
    for (const Interval& i : both) {
      cuts = {i.low, i.high};
      for (const Interval& c : more)
        for (const double z : {c.low, c.high})
          if (i.low < z && z < i.high) cuts.push_back(z);
      std::sort(cuts.begin(), cuts.end());
      for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
        const double middle = 0.5 * (cuts[k] + cuts[k + 1]);
        const auto covers = [&](const Interval& c) { return c.low < middle && middle < c.high; };
        const auto others = std::count_if(more.begin(), more.end(), covers);
        sum += (cuts[k + 1] - cuts[k]) / static_cast<double>(2 + others);
      }
    }
    return sum;
  }

  const std::vector<BodySurface>& shapes_;
  std::vector<BodyChords> chords_;
};

/// The errors that integrals may have so that the whole has the error that is wanted: half of its square for
/// bodies alone, for each in proportion to its volume, half for overlaps, each of which counts twice.
struct ErrorBudget {
  double per_volume, of_share;

  ErrorBudget(double wanted, const std::vector<double>& volume, std::size_t shares) {
    double sum = 0, squares = 0;
    for (const double v : volume) {
      sum += v;
      squares += v * v;
    }
    per_volume = std::sqrt(0.5 / squares) * wanted * sum;
    of_share = std::sqrt(0.5 / static_cast<double>(std::max<std::size_t>(1, shares))) * 0.5 * wanted * sum;
  }
};

}  // namespace

PackingFraction packing_fraction(const System<3>& system, Outline outline, const VolumeAccuracy& accuracy) {
  require(accuracy.relative_error > 0, "relative_error", accuracy.relative_error, "positive");
  require(accuracy.most_lines > 0, "most_lines", static_cast<double>(accuracy.most_lines), "at least 1");
  const std::vector<BodySurface> shapes = body_shapes(system, outline);
  const std::vector<Meeting> meetings = find_meetings(shapes, system.box);
  const Volumes volumes(shapes, outline);
  const std::size_t bodies = shapes.size();

  std::vector<double> about(bodies);
  for (std::size_t b = 0; b < bodies; ++b)
    about[b] = shapes[b].is_sphere() ? *exact_volume(shapes[b], outline) : shapes[b].polyhedron();
  const ErrorBudget budget(accuracy.relative_error, about, meetings.size());

  std::vector<LineIntegral> integrals(bodies + meetings.size());
  for_parts(static_cast<std::int64_t>(integrals.size()), [&](std::int64_t k) {
    RandomStream draw(accuracy.seed, Purpose::line_lattice, static_cast<std::uint64_t>(k));
    LineIntegral& integral = integrals[k];
    if (static_cast<std::size_t>(k) < bodies) {
      const auto exact = exact_volume(shapes[k], outline);
      integral = exact ? LineIntegral{*exact, 0}
                       : volumes.alone(static_cast<int>(k), budget.per_volume * about[k], accuracy, draw);
    } else {
      const Meeting& m = meetings[static_cast<std::size_t>(k) - bodies];
      const auto exact = volumes.exact_share(m);
      integral = exact ? LineIntegral{*exact, 0} : volumes.shared(m, budget.of_share, accuracy, draw);
    }
  });

  PackingFraction out;
  out.volume.resize(bodies);
  out.volume_error.resize(bodies);  // squares, until the end
  double square = 0;
  for (std::size_t k = 0; k < integrals.size(); ++k) {
    const auto [value, error] = integrals[k];
    if (k < bodies) {
      out.volume[k] += value;
      out.volume_error[k] += error * error;
      square += error * error;
      continue;
    }
    const Meeting& m = meetings[k - bodies];
    const double times = m.body == m.other.body ? 2 : 1;  // of a body and its images on both sides
    for (const int b : {m.body, m.other.body}) {
      out.volume[b] -= value;
      out.volume_error[b] += times * error * error;
    }
    square += 4 * error * error;
  }
  for (const double v : out.volume) out.total += v;
  for (double& e : out.volume_error) e = std::sqrt(e);
  out.total /= system.box.volume();
  out.error = std::sqrt(square) / system.box.volume();
  return out;
}

}  // namespace supple
