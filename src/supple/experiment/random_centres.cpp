#include "supple/experiment/random_centres.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "supple/contact/rough_contacts.hpp"
#include "supple/core/error.hpp"
#include "supple/core/random.hpp"
#include "supple/force/force_field.hpp"
#include "supple/model/add_sites.hpp"
#include "supple/solve/body_objective.hpp"
#include "supple/solve/minimise.hpp"

namespace supple {

namespace {

constexpr double much_wider = 12;
constexpr int most_draws = 1000;  // where hardly any place is free

/// Discs (3D: spheres) of which a point must not be in any.
template <int Dim>
class TakenPlaces {
 public:
  /// None of them has a radius above `widest`.
  TakenPlaces(const Box<Dim>& box, double widest) : box_(box) {
    int places = 1;
    for (int d = 0; d < Dim; ++d) {
      cells_[d] = static_cast<int>(std::clamp(std::floor(box.length[d] / widest), 1.0, most_cells));
      places *= cells_[d];
    }
    at_.resize(static_cast<std::size_t>(places));
  }
  /// A disc in the cell. It goes into all places of the grid that it can reach.
  void add(const Vec<Dim>& centre, double radius) {
    const Place middle = place_of(centre);
    int neighbours = 1;
    for (int d = 0; d < Dim; ++d) neighbours *= 3;
    for (int n = 0; n < neighbours; ++n) {
      Place p = middle;
      for (int d = 0, rest = n; d < Dim; ++d, rest /= 3)
        p[d] = (middle[d] + rest % 3 - 1 + cells_[d]) % cells_[d];
      at_[index(p)].push_back({centre, radius});
    }
  }
  bool hold(const Vec<Dim>& x) const {
    const std::vector<Disc>& near = at_[index(place_of(x))];
    return std::any_of(near.begin(), near.end(), [&](const Disc& disc) {
      return norm(box_.displacement(disc.centre, x)) < disc.radius;
    });
  }

 private:
  using Place = std::array<int, Dim>;
  static constexpr double most_cells = Dim == 2 ? 1000 : 100;  // along a direction
  struct Disc {
    Vec<Dim> centre;
    double radius;
  };
  Place place_of(const Vec<Dim>& x) const {
    Place place{};
    for (int d = 0; d < Dim; ++d)
      place[d] = std::clamp(static_cast<int>(x[d] / box_.length[d] * cells_[d]), 0, cells_[d] - 1);
    return place;
  }
  std::size_t index(const Place& p) const {
    int at = 0;
    for (int d = Dim - 1; d >= 0; --d) at = p[d] + cells_[d] * at;
    return static_cast<std::size_t>(at);
  }

  Box<Dim> box_;
  Place cells_{};
  std::vector<std::vector<Disc>> at_;
};

template <int Dim>
std::vector<Vec<Dim>> move_apart(const std::vector<double>& radius, const std::vector<Vec<Dim>>& centre,
                                 const Box<Dim>& box, const StopRequest& stop_requested) {
  System<Dim> discs;
  discs.box = box;
  for (std::size_t k = 0; k < radius.size(); ++k) add_round_body(discs, centre[k], 1.02 * radius[k]);
  ForceField<Dim> field(RoughContacts<Dim>(Harmonic{1, true}));
  field.set_walls({.repulsion = Harmonic{4, true}});
  BodyObjective<Dim> objective(discs, field, {1e-3, 1e-8});
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
template <int Dim>
class Draw {
 public:
  Draw(const Box<Dim>& box, std::int64_t seed, std::size_t body)
      : length_(box.length), stream_(static_cast<std::uint64_t>(seed), Purpose::body_position, body) {}
  Vec<Dim> next() {
    Vec<Dim> x;
    for (int d = 0; d < Dim; ++d) x[d] = stream_.uniform(0, length_[d]);
    return x;
  }

 private:
  Vec<Dim> length_;
  RandomStream stream_;
};

/// The wide ones apart from each other, and the others where none of these is.
template <int Dim>
void place_wide_first(const std::vector<double>& radius, const Box<Dim>& box, std::int64_t seed,
                      const StopRequest& stop_requested, std::vector<Vec<Dim>>& centre) {
  const double widest = *std::max_element(radius.begin(), radius.end());
  std::vector<std::size_t> wide, narrow;
  for (std::size_t k = 0; k < radius.size(); ++k)
    (much_wider * radius[k] < widest ? narrow : wide).push_back(k);
  if (narrow.empty()) return;
  std::vector<double> radius_of_wide;
  std::vector<Vec<Dim>> centre_of_wide;
  for (const std::size_t k : wide) radius_of_wide.push_back(radius[k]), centre_of_wide.push_back(centre[k]);
  centre_of_wide = move_apart(radius_of_wide, centre_of_wide, box, stop_requested);
  TakenPlaces<Dim> taken(box, widest);
  for (std::size_t w = 0; w < wide.size(); ++w) {
    box.lattice().wrap(centre_of_wide[w]);
    centre[wide[w]] = centre_of_wide[w];
    taken.add(centre_of_wide[w], radius_of_wide[w]);
  }
  for (const std::size_t k : narrow) {
    Draw<Dim> draw(box, seed, k);
    for (int tries = 0; tries < most_draws; ++tries)
      if (centre[k] = draw.next(); !taken.hold(centre[k])) break;
  }
}

}  // namespace

template <int Dim>
std::vector<Vec<Dim>> random_centres(const std::vector<double>& radius, const Box<Dim>& box,
                                     std::int64_t seed, const std::function<bool()>& stop_requested) {
  std::vector<Vec<Dim>> centre;
  for (std::size_t k = 0; k < radius.size(); ++k) centre.push_back(Draw<Dim>(box, seed, k).next());
  place_wide_first(radius, box, seed, stop_requested, centre);
  return move_apart(radius, centre, box, stop_requested);
}

template std::vector<Vec2> random_centres(const std::vector<double>&, const Box<2>&, std::int64_t,
                                          const std::function<bool()>&);
template std::vector<Vec3> random_centres(const std::vector<double>&, const Box<3>&, std::int64_t,
                                          const std::function<bool()>&);

}  // namespace supple
