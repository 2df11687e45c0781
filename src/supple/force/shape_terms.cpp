#include "supple/force/shape_terms.hpp"

#include "supple/energy/list.hpp"
#include "supple/force/body_block.hpp"

namespace supple {

namespace {

/// Adds Term on the stencils [begin[b], begin[b+1]) of every body whose stiffness is not zero.
template <class Term, int Dim, class Stencil, class MakeParam>
void add_stencils(const System<Dim>& system, const std::vector<std::int32_t>& begin,
                  const std::vector<Stencil>& all, double ShapeStiffness::*stiffness, const MakeParam& param,
                  TermSet<Dim>& terms) {
  std::vector<Stencil> stencils;
  std::vector<typename Term::Param> params;
  for (std::size_t b = 0; b < system.shape.stiffness.size(); ++b) {
    const double k = system.shape.stiffness[b].*stiffness;
    if (k == 0) continue;
    for (std::int32_t s = begin[b]; s < begin[b + 1]; ++s) {
      stencils.push_back(all[s]);
      params.push_back(param(k, s));
    }
  }
  if (!stencils.empty()) terms.add(Term{}, std::move(stencils), std::move(params));
}

}  // namespace

template <int Dim>
TermSet<Dim> shape_terms(const System<Dim>& system) {
  TermSet<Dim> terms;
  const Shape& shape = system.shape;
  if (shape.empty()) return terms;
  std::vector<EnclosedVolume::Param> volume;
  for (std::size_t b = 0; b < shape.stiffness.size(); ++b)
    volume.push_back({shape.stiffness[b].volume, shape.rest_volume[b]});
  terms.add(std::make_shared<BodyBlock<EnclosedVolume, Dim>>(std::move(volume)));

  const Topology<Dim>& t = system.topology;
  using Stretch = typename FacetStretch<Dim>::Param;
  using Bend = typename HingeBend<Dim>::Param;
  using Tension = typename FacetTension<Dim>::Param;
  add_stencils<FacetStretch<Dim>>(
      system, t.facet_begin, t.facet, &ShapeStiffness::facet,
      [&](double k, int s) {
        return Stretch{k, shape.rest_facet[s]};
      },
      terms);
  add_stencils<HingeBend<Dim>>(
      system, t.hinge_begin, t.hinge, &ShapeStiffness::hinge,
      [&](double k, int s) {
        return Bend{k, shape.rest_hinge[s]};
      },
      terms);
  add_stencils<FacetTension<Dim>>(
      system, t.facet_begin, t.facet, &ShapeStiffness::tension, [](double k, int) { return Tension{k}; },
      terms);
  return terms;
}

template TermSet<2> shape_terms(const System<2>&);
template TermSet<3> shape_terms(const System<3>&);

}  // namespace supple
