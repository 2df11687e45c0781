/// What tables and results say of a packing.
#include <algorithm>

#include "supple/experiment/packing_record.hpp"
#include "supple/solve/body_objective.hpp"

namespace supple {

namespace {

/// A component of the full stress.
template <int Dim>
Observables<PackingInstant<Dim>> stress_component(int i, int j, const std::string& symbol) {
  const std::string name = std::string("stress_") + "xyz"[i] + "xyz"[j];
  return {{{name, symbol, "full stress, compression positive"}, [i, j](const PackingInstant<Dim>& p) {
             const Mat<Dim> stress = p.stress();
             return i == j ? stress[i][i] : 0.5 * (stress[i][j] + stress[j][i]);
           }}};
}

}  // namespace

template <int Dim>
Observables<PackingInstant<Dim>> packing_observables(const std::string& symbol) {
  using P = PackingInstant<Dim>;
  Observables<P> all{
      {{"packing_fraction", "", packing_fraction_meaning<Dim>},
       [](const P& p) { return p.report.fraction.total; }},
      {{"pressure", symbol, "full virial pressure (9.26)"}, [](const P& p) { return pressure(p.stress()); }},
      {{"contact_pressure", symbol, "pressure by contacts alone"},
       [](const P& p) { return pressure(p.report.stresses.contact) / p.packing.pressure_unit; }}};
  for (int i = 0; i < Dim; ++i) all.add(stress_component<Dim>(i, i, symbol));
  for (int i = 0; i < Dim; ++i)
    for (int j = i + 1; j < Dim; ++j) all.add(stress_component<Dim>(i, j, symbol));
  all.add(
      {{{"energy", "", "potential energy"}, [](const P& p) { return p.report.evaluation.energy.stored(); }},
       {{"mean_contacts", "",
         "touching neighbours of a particle, each image of one counted, rattlers left out"},
        [](const P& p) { return p.report.numbers.mean(); }},
       {{"rattlers", "",
         "particles that can leave all of their contacts at once, removed until none is left"},
        [](const P& p) {
          return static_cast<double>(std::count(p.report.rattlers.begin(), p.report.rattlers.end(), 1));
        }},
       {{"residual", "", "largest net force on a vertex, or on a rigid particle"},
        [](const P& p) { return largest_net_force(p.packing.system, p.report.evaluation.force); }},
       {{"tolerance", "", "residual at which its minimisation was done"},
        [](const P& p) { return p.work.last.tolerance; }},
       {{"evaluations", "", "force evaluations so far"},
        [](const P& p) { return static_cast<double>(p.work.evaluations); }},
       {{"unsound", "", unsound_meaning},
        [](const P& p) { return static_cast<double>(p.report.soundness.bodies()); }}});
  return all;
}

template Observables<PackingInstant<2>> packing_observables<2>(const std::string&);
template Observables<PackingInstant<3>> packing_observables<3>(const std::string&);

}  // namespace supple
