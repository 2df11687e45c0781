#include "supple/contact/rough_contacts.hpp"

#include <cmath>

#include "supple/contact/coincident.hpp"
#include "supple/core/parallel.hpp"

namespace supple {

struct RoughContacts::Sum {
  double energy = 0;
  Mat2 virial;
  Sum& operator+=(const Sum& b) {
    energy += b.energy;
    virial += b.virial;
    return *this;
  }
};

template <bool energies>
void RoughContacts::add_rows(const System<2>& system, int begin, int end, const std::vector<Vec2>& shifts, Evaluation<2>& out,
                             Sum& sum) {
  const std::int32_t *first = system.pairs.first.data(), *second = system.pairs.second.data(), *image = images_.index().data();
  const Vec2* position = system.state.position.data();
  const double* radius = system.state.radius.data();
  Vec2* force = out.force.data();
  const Harmonic law_here = law();
  for (int row = begin; row < end; ++row) {
    const std::int32_t i = first[row], j = second[row];
    const Vec2 shift = shifts[image[row]];
    Vec2 r{position[j][0] - position[i][0] - shift[0], position[j][1] - position[i][1] - shift[1]};
    const double sigma = radius[i] + radius[j], square = dot(r, r);
    if (!(square < sigma * sigma)) continue;
    double distance = std::sqrt(square), per_distance = 1 / distance;
    if (distance == 0) r = arbitrary_direction<2>(i, j), per_distance = 1;
    const Vec2 push = (law_here.force(distance, sigma) * per_distance) * r;  // on the second
    force[i] -= push;
    force[j] += push;
    if constexpr (energies) {
      sum.energy += law_here.energy(distance, sigma);
      if (distance > 0) sum.virial.add_outer(1, push, r);
    }
  }
}

void RoughContacts::evaluate(const System<2>& system, Detail detail, Evaluation<2>& out) {
  images_.update(system);
  const std::vector<Vec2>& shifts = images_.shifts(system.box);
  Sum sum;
  if (detail == Detail::forces) return add_rows<false>(system, 0, system.pairs.size(), shifts, out, sum);
  add_rows<true>(system, 0, system.pairs.size(), shifts, out, sum);
  out.energy.elastic += sum.energy;
  out.virial += sum.virial;
}

std::vector<ContactRecord<2>> RoughContacts::records(const System<2>& system) {
  images_.update(system);
  const std::vector<Vec2>& shifts = images_.shifts(system.box);
  const State<2>& state = system.state;
  std::vector<ContactRecord<2>> records;
  for (int row = 0; row < system.pairs.size(); ++row) {
    const std::int32_t i = system.pairs.first[row], j = system.pairs.second[row];
    const Vec2 r = state.position[j] - state.position[i] - shifts[images_.index()[row]];
    const double sigma = state.radius[i] + state.radius[j], distance = norm(r);
    if (!(distance < sigma)) continue;
    ContactRecord<2> record;
    record.normal = distance > 0 ? (1 / distance) * r : arbitrary_direction<2>(i, j);
    record.branch = r;
    record.reach = sigma;
    record.gap = distance - sigma;
    record.row = row;
    record.crosses = images_.index()[row] != 0;
    record.add(i, -1);
    record.add(j, +1);
    records.push_back(record);
  }
  return records;
}

}  // namespace supple
