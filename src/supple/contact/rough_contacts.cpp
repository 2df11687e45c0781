#include "supple/contact/rough_contacts.hpp"

#include <cmath>

#include "supple/contact/coincident.hpp"

namespace supple {

template <int Dim>
struct RoughContacts<Dim>::Sum {
  double energy = 0;
  Mat<Dim> virial;
  Sum& operator+=(const Sum& b) {
    energy += b.energy;
    virial += b.virial;
    return *this;
  }
};

/// visit(push) for each row of [begin, end) that touches, in order.
template <int Dim>
template <bool energies, bool links, class Laws, class Visit>
void RoughContacts<Dim>::for_touching(const System<Dim>& system, const Laws& laws_here, int begin, int end,
                                      Sum& sum, const Visit& visit) const {
  const std::int32_t *first = system.pairs.first.data(), *second = system.pairs.second.data(),
                     *image = images_.index().data();
  const Vec<Dim>*position = system.state.position.data(), *shifts = shifts_.data();
  const double* radius = system.state.radius.data();
  for (int row = begin; row < end; ++row) {
    const std::int32_t i = first[row], j = second[row];
    const Vec<Dim> shift = shifts[image[row]];
    Vec<Dim> r;
    for (int d = 0; d < Dim; ++d) r[d] = position[j][d] - position[i][d] - shift[d];
    const double sigma = radius[i] + radius[j], square = dot(r, r);
    const auto& law_here = laws_here.of(i, j);
    const double square_range = law_here.range() * law_here.range();
    // Measured: a batch that need not guess whether rows touch gains nothing, as gathering it costs as much.
    if (!(square < square_range * (sigma * sigma))) continue;
    if constexpr (links)
      if (is_linked(system, row)) continue;
    double distance = std::sqrt(square), per_distance = 1 / distance;
    if (distance == 0) r = arbitrary_direction<Dim>(i, j), per_distance = 1;
    const Vec<Dim> push = (law_here.force(distance, sigma) * per_distance) * r;
    visit(Push{i, j, push});
    if constexpr (energies) {
      sum.energy += law_here.energy(distance, sigma);
      if (distance > 0) sum.virial.add_outer(1, push, r);
    }
  }
}

template <int Dim>
template <bool energies, bool links, class Laws>
typename RoughContacts<Dim>::Sum RoughContacts<Dim>::add_all(const System<Dim>& system, const Laws& laws,
                                                             Evaluation<Dim>& out) {
  const PairTable& pairs = system.pairs;
  const int sites = system.state.size();
  const bool serial = runs_in_place(sites);
  if (!serial) pushes_.begin(chunk_count(sites), sites);
  const auto add = [force = out.force.data()](const Push& push, const auto& here) {
    if (here(push.first)) force[push.first] -= push.force;
    if (here(push.second)) force[push.second] += push.force;
  };
  constexpr auto everywhere = [](std::int32_t) { return true; };
  const Sum total = sum_chunks<Sum>(sites, [&](std::int64_t begin, std::int64_t end) {
    Sum sum;
    const auto scatter = [&](const Push& push) { add(push, everywhere); };
    if (serial) {
      for_touching<energies, links>(system, laws, pairs.begin[begin], pairs.begin[end], sum, scatter);
      return sum;
    }
    const auto keep = [&](const Push& push) {
      pushes_.keep(begin / chunk_size, push, std::array{push.first, push.second});
    };
    for_touching<energies, links>(system, laws, pairs.begin[begin], pairs.begin[end], sum, keep);
    return sum;
  });
  if (!serial) pushes_.add(add);
  return total;
}

template <int Dim>
bool RoughContacts<Dim>::is_linked(const System<Dim>& system, int row) const {
  return linked_.contains(touch_key(system.pairs.second[row], TouchOn::site, system.pairs.first[row],
                                    images_.cells()[images_.index()[row]]));
}

template <int Dim>
void RoughContacts<Dim>::evaluate(const System<Dim>& system, Detail detail, Evaluation<Dim>& out) {
  images_.update(system);
  linked_.update(system, this->meeting());
  shifts_ = images_.shifts(system.box);
  if (!this->laws().is_uniform()) this->update_species(system);
  this->visit_laws([&](const auto laws_here) {
    if (detail == Detail::forces) {
      if (linked_.empty()) add_all<false, false>(system, laws_here, out);
      else add_all<false, true>(system, laws_here, out);
      return;
    }
    const Sum sum = linked_.empty() ? add_all<true, false>(system, laws_here, out)
                                    : add_all<true, true>(system, laws_here, out);
    out.energy.elastic += sum.energy;
    out.virial += sum.virial;
  });
}

template <int Dim>
std::vector<ContactRecord<Dim>> RoughContacts<Dim>::records(const System<Dim>& system) {
  images_.update(system);
  linked_.update(system, this->meeting());
  this->update_species(system);
  const std::vector<Vec<Dim>>& shifts = images_.shifts(system.box);
  const State<Dim>& state = system.state;
  std::vector<ContactRecord<Dim>> records;
  for (int row = 0; row < system.pairs.size(); ++row) {
    const std::int32_t i = system.pairs.first[row], j = system.pairs.second[row];
    const Vec<Dim> r = state.position[j] - state.position[i] - shifts[images_.index()[row]];
    const double sigma = state.radius[i] + state.radius[j], distance = norm(r);
    if (!(distance < this->law_of(i, j).range() * sigma) || is_linked(system, row)) continue;
    ContactRecord<Dim> record;
    record.normal = distance > 0 ? (1 / distance) * r : arbitrary_direction<Dim>(i, j);
    record.branch = r;
    record.reach = sigma;
    record.gap = distance - sigma;
    record.species = this->species_of(i, j);
    record.row = row;
    record.set_cells(images_.cells()[images_.index()[row]]);
    record.add(i, -1);
    record.add(j, +1);
    records.push_back(record);
  }
  return records;
}

template class RoughContacts<2>;
template class RoughContacts<3>;

}  // namespace supple
