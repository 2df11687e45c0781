#include "supple/experiment/random_centres.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "supple/contact/rough_contacts.hpp"
#include "supple/core/error.hpp"
#include "supple/core/random.hpp"
#include "supple/force/force_field.hpp"
#include "supple/model/polygons.hpp"
#include "supple/solve/body_objective.hpp"
#include "supple/solve/minimise.hpp"

namespace supple {

namespace {

constexpr double much_wider = 12;
constexpr int most_draws = 1000;  // where hardly any place is free

/// Discs of which a point must not be in any.
class TakenPlaces {
 public:
  /// None of them has a radius above `widest`.
  TakenPlaces(const Box<2>& box, double widest) : box_(box) {
    for (int d = 0; d < 2; ++d)
      cells_[d] = static_cast<int>(std::clamp(std::floor(box.length[d] / widest), 1.0, 1000.0));
    at_.resize(static_cast<std::size_t>(cells_[0] * cells_[1]));
  }
  /// A disc in the cell. It goes into all places of the grid that it can reach.
  void add(const Vec2& centre, double radius) {
    const std::array<int, 2> middle = place_of(centre);
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j) {
        const int x = middle[0] + i, y = middle[1] + j;
        at_[index((x + cells_[0]) % cells_[0], (y + cells_[1]) % cells_[1])].push_back({centre, radius});
      }
  }
  bool hold(const Vec2& x) const {
    const std::array<int, 2> p = place_of(x);
    const std::vector<Disc>& near = at_[index(p[0], p[1])];
    return std::any_of(near.begin(), near.end(), [&](const Disc& disc) {
      return norm(box_.displacement(disc.centre, x)) < disc.radius;
    });
  }

 private:
  struct Disc {
    Vec2 centre;
    double radius;
  };
  std::array<int, 2> place_of(const Vec2& x) const {
    std::array<int, 2> place{};
    for (int d = 0; d < 2; ++d)
      place[d] = std::clamp(static_cast<int>(x[d] / box_.length[d] * cells_[d]), 0, cells_[d] - 1);
    return place;
  }
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(x + cells_[0] * y); }

  Box<2> box_;
  std::array<int, 2> cells_{};
  std::vector<std::vector<Disc>> at_;
};

std::vector<Vec2> move_apart(const std::vector<double>& radius, const std::vector<Vec2>& centre,
                             const Box<2>& box, const StopRequest& stop_requested) {
  System<2> discs;
  discs.box = box;
  for (std::size_t k = 0; k < radius.size(); ++k) add_disc_body(discs, centre[k], 1.02 * radius[k]);
  ForceField<2> field(RoughContacts<2>(Harmonic{1, true}));
  field.set_walls({.repulsion = Harmonic{4, true}});
  BodyObjective<2> objective(discs, field, {1e-3, 1e-8});
  std::vector<double> x = objective.coordinates();
  MinimiseSpec spec;
  spec.method = Minimiser::fire;
  spec.max_evaluations = 20000;
  spec.stop_requested = stop_requested;
  if (minimise(objective, x, spec).ending == Ending::interrupted)
    throw Error(ErrorKind::interrupted, "interrupted while particles found their places");
  return discs.state.position;
}

/// Where each particle is drawn, one place after the other.
class Draw {
 public:
  Draw(const Box<2>& box, std::int64_t seed, std::size_t body)
      : length_(box.length), stream_(static_cast<std::uint64_t>(seed), Purpose::body_position, body) {}
  Vec2 next() {
    const double x = stream_.uniform(0, length_[0]);
    return {x, stream_.uniform(0, length_[1])};
  }

 private:
  Vec2 length_;
  RandomStream stream_;
};

/// The wide ones apart from each other, and the others where none of these is.
void place_wide_first(const std::vector<double>& radius, const Box<2>& box, std::int64_t seed,
                      const StopRequest& stop_requested, std::vector<Vec2>& centre) {
  const double widest = *std::max_element(radius.begin(), radius.end());
  std::vector<std::size_t> wide, narrow;
  for (std::size_t k = 0; k < radius.size(); ++k)
    (much_wider * radius[k] < widest ? narrow : wide).push_back(k);
  if (narrow.empty()) return;
  std::vector<double> radius_of_wide;
  std::vector<Vec2> centre_of_wide;
  for (const std::size_t k : wide) radius_of_wide.push_back(radius[k]), centre_of_wide.push_back(centre[k]);
  centre_of_wide = move_apart(radius_of_wide, centre_of_wide, box, stop_requested);
  TakenPlaces taken(box, widest);
  for (std::size_t w = 0; w < wide.size(); ++w) {
    box.lattice().wrap(centre_of_wide[w]);
    centre[wide[w]] = centre_of_wide[w];
    taken.add(centre_of_wide[w], radius_of_wide[w]);
  }
  for (const std::size_t k : narrow) {
    Draw draw(box, seed, k);
    for (int tries = 0; tries < most_draws; ++tries)
      if (centre[k] = draw.next(); !taken.hold(centre[k])) break;
  }
}

}  // namespace

std::vector<Vec2> random_centres(const std::vector<double>& radius, const Box<2>& box, std::int64_t seed,
                                 const std::function<bool()>& stop_requested) {
  std::vector<Vec2> centre;
  for (std::size_t k = 0; k < radius.size(); ++k) centre.push_back(Draw(box, seed, k).next());
  place_wide_first(radius, box, seed, stop_requested, centre);
  return move_apart(radius, centre, box, stop_requested);
}

}  // namespace supple
