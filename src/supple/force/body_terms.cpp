#include "supple/force/body_terms.hpp"

#include <fmt/format.h>

#include <tuple>

#include "supple/core/error.hpp"
#include "supple/energy/list.hpp"
#include "supple/force/body_block.hpp"

namespace supple {

namespace {

template <class Term>
typename Term::Param param_of(const double* number) {
  typename Term::Param p{};
  std::apply([&](const auto&... field) { ((p.*std::get<0>(field.member) = *number++), ...); }, Term::fields);
  return p;
}

/// visit(block) for the term of this name, on all bodies of the system.
template <int Dim, class Visit>
void visit_block(const System<Dim>& system, const BodyTermData& data, const Visit& visit) {
  bool found = false;
  const auto try_term = [&]<class Term>(Term) {
    if (Term::name != data.name) return;
    constexpr std::size_t width = std::tuple_size_v<decltype(Term::fields)>;
    if (data.width != width)
      throw input_error(fmt::format("{} with {} numbers a body", data.name, data.width),
                        fmt::format("it has {}", width));
    std::vector<typename Term::Param> params(
        system.topology.facet_begin.empty() ? 0 : system.topology.facet_begin.size() - 1);
    for (std::size_t b = 0; b < std::min(params.size(), data.bodies()); ++b)
      params[b] = param_of<Term>(&data.number[b * width]);
    visit(BodyBlock<Term, Dim>(std::move(params)));
    found = true;
  };
  std::apply([&](auto... term) { (try_term(term), ...); }, BodyTerms{});
  if (!found) throw input_error("there is no energy of bodies '" + data.name + "'");
}

}  // namespace

template <int Dim>
double BodyTermSet<Dim>::energy(const System<Dim>& system) const {
  double sum = 0;
  for (const BodyTermData& data : system.terms)
    visit_block(system, data, [&](const auto& block) { sum += block.energy(system); });
  return sum;
}

template <int Dim>
void BodyTermSet<Dim>::evaluate(const System<Dim>& system, Detail detail, Evaluation<Dim>& out) const {
  for (const BodyTermData& data : system.terms)
    visit_block(system, data, [&](const auto& block) { block.evaluate(system, detail, out); });
}

template <int Dim>
void BodyTermSet<Dim>::add_hessian(const System<Dim>& system, HessianBlocks<Dim>& blocks) const {
  for (const BodyTermData& data : system.terms)
    visit_block(system, data, [&](const auto& block) { block.add_hessian(system, blocks); });
}

template class BodyTermSet<2>;
template class BodyTermSet<3>;

}  // namespace supple
