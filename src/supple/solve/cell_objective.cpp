#include "supple/solve/cell_objective.hpp"

#include <algorithm>
#include <cmath>

namespace supple {

template <int Dim>
CellObjective<Dim>::CellObjective(System<Dim>& system, ForceField<Dim>& field,
                                  const ForceTolerance& tolerance, CellFreedom freedom, double pressure,
                                  double shear_stress)
    : system_(system),
      field_(field),
      bodies_(system, field, tolerance),
      freedom_(freedom),
      pressure_(pressure),
      shear_stress_(shear_stress),
      start_(system.box),
      at_(static_cast<std::size_t>(bodies_.size())) {
  const std::vector<std::int32_t>& sites = bodies_.degrees().sites();
  const std::vector<std::int32_t> body = bodies_of_sites(system.topology, system.state.size());
  for (std::size_t i = 0; i < sites.size(); ++i) {
    if (i > 0 && body[sites[i]] == body[sites[i - 1]]) ++groups_.back().count;
    else groups_.push_back({Dim * i, 1});
  }
  for (std::size_t k = Dim * sites.size(); k < at_.size(); k += rigid_numbers<Dim>) groups_.push_back({k, 1});
}

template <int Dim>
std::vector<double> CellObjective<Dim>::coordinates() const {
  std::vector<double> x = bodies_.coordinates();
  x.resize(static_cast<std::size_t>(size()), 0.0);
  return x;
}

namespace {

template <int Dim>
Vec<Dim> vector_at(const double* numbers) {
  Vec<Dim> v;
  for (int d = 0; d < Dim; ++d) v[d] = numbers[d];
  return v;
}

/// Mean of `count` vectors.
template <int Dim>
Vec<Dim> mean(const double* vectors, int count) {
  Vec<Dim> sum{};
  for (int k = 0; k < count; ++k) sum += vector_at<Dim>(vectors + Dim * k);
  return (1.0 / count) * sum;
}

}  // namespace

/// Sets the cell of these numbers, and the numbers of the bodies in it: their centres c go to growth (c +
/// shear c_y e_x).
template <int Dim>
void CellObjective<Dim>::strain_cell(std::span<const double> x) {
  std::size_t next = static_cast<std::size_t>(bodies_.size());
  growth_ = freedom_.size ? std::exp(x[next++] / start_.length[0]) : 1;
  shear_ = freedom_.shear ? x[next] / start_.length[0] : 0;
  system_.box.length = growth_ * start_.length;
  system_.box.strain = start_.strain + shear_;
  std::copy(x.begin(), x.begin() + bodies_.size(), at_.begin());
  for (const Group& group : groups_) {
    const Vec<Dim> c = mean<Dim>(&x[group.first], group.count);
    Vec<Dim> move = (growth_ - 1) * c;
    move[flow] = growth_ * (c[flow] + shear_ * c[gradient]) - c[flow];
    for (std::size_t k = group.first; k < group.first + Dim * group.count; k += Dim)
      for (int d = 0; d < Dim; ++d) at_[k + d] += move[d];
  }
}

template <int Dim>
double CellObjective<Dim>::evaluate(std::span<const double> x, std::span<double> slope) {
  strain_cell(x);
  const double energy = bodies_.evaluate(at_, slope.first(at_.size()));
  // The virial belongs to sites that all move with the strain; here bodies keep their shapes, so the part of
  // the sites' motion relative to their centres is taken out.
  Mat<Dim> virial = bodies_.evaluation().virial;
  for (const Group& group : groups_) {
    const Vec<Dim> c = mean<Dim>(&x[group.first], group.count);
    for (std::size_t k = group.first; k < group.first + Dim * group.count && group.count > 1; k += Dim)
      virial.add_outer(1, vector_at<Dim>(&slope[k]), vector_at<Dim>(&x[k]) - c);
    const Vec<Dim> s = mean<Dim>(&slope[group.first], group.count);
    Vec<Dim> change = (growth_ - 1) * s;
    change[gradient] = growth_ * (s[gradient] + shear_ * s[flow]) - s[gradient];
    for (std::size_t k = group.first; k < group.first + Dim * group.count; k += Dim)
      for (int d = 0; d < Dim; ++d) slope[k + d] += change[d];
  }
  const double area = system_.box.volume(), start = start_.volume();
  std::size_t next = at_.size();
  if (freedom_.size) {
    double by_size = Dim * pressure_ * area;
    for (int d = 0; d < Dim; ++d) by_size -= virial[d][d];
    slope[next++] = by_size / start_.length[0];
  }
  if (freedom_.shear) slope[next] = (-virial[flow][gradient] - shear_stress_ * start) / start_.length[0];
  return energy + pressure_ * (area - start) - shear_stress_ * start * shear_;
}

template <int Dim>
double CellObjective<Dim>::residual(std::span<const double> x, std::span<const double> slope) {
  double most = bodies_.residual(at_, slope.first(at_.size()));
  // The slopes by size and strain sum over the whole cell; per vertex along its rim they compare with net
  // forces.
  const double share = 1 / std::sqrt(static_cast<double>(std::max(1, system_.state.size())));
  for (std::size_t k = at_.size(); k < slope.size(); ++k) most = std::max(most, share * std::abs(slope[k]));
  return most;
}

template <int Dim>
void CellObjective<Dim>::assemble(std::span<const double> x, HessianKind kind, SparseMatrix& lower) {
  strain_cell(x);
  SparseMatrix inner;
  if (kind == HessianKind::exact) bodies_.hessian(at_, inner);
  else bodies_.preconditioner(at_, inner);
  std::vector<MatrixEntry> entries;
  for (int c = 0; c < inner.size; ++c)
    for (int k = inner.begin[c]; k < inner.begin[c + 1]; ++k)
      entries.emplace_back(inner.row[k], c, inner.value[k]);
  std::vector<double> moved(x.begin(), x.end()), above(x.size()), below(x.size());
  const double step = 1e-6 * start_.length[0];
  for (int row = bodies_.size(); row < size(); ++row) {
    const auto k = static_cast<std::size_t>(row);
    moved[k] = x[k] + step;
    evaluate(moved, above);
    moved[k] = x[k] - step;
    evaluate(moved, below);
    moved[k] = x[k];
    for (int column = 0; column <= row; ++column)
      entries.emplace_back(
          row, column,
          (above[static_cast<std::size_t>(column)] - below[static_cast<std::size_t>(column)]) / (2 * step));
  }
  sum_entries(size(), entries, lower);
  strain_cell(x);
}

template class CellObjective<2>;
template class CellObjective<3>;

}  // namespace supple
