#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "supple/core/error.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/packing_record.hpp"
#include "supple/model/bodies.hpp"

namespace supple {

namespace {

/// The packing in a box of four walls, of the wanted aspect ratio and packing fraction.
Packing boxed_packing(const Case& c, const InitialState* initial) {
  // Walls keep vertices, not their discs' centres, out: the particles start in a smaller periodic cell, then the walls are put round it.
  Packing p = make_packing(c, initial, c.uniaxial.packing_fraction);
  System<2>& s = p.system;
  const double stretch = std::sqrt(c.uniaxial.aspect_ratio);
  for (int b = 0; b < s.topology.body_count(s.state.size()); ++b) {
    const Vec2 centre = body_centre(s, b);
    Vec2 inside = centre, still{};
    s.box.wrap(inside, still);
    move_body(s, b, Vec2{inside[0] / stretch, inside[1] * stretch} - centre);
  }
  s.box.length = {s.box.length[0] / stretch, s.box.length[1] * stretch};
  s.box.periodic = {false, false};
  p.field->set_walls(wall_law(c));
  p.field->invalidate();
  return p;
}

double force_on_upper_wall(const System<2>& s, const Evaluation<2>& evaluation) {
  double sum = 0;
  for (const SiteForce<2>& w : evaluation.wall)
    if (s.state.position[w.site][gradient] > 0.5 * s.box.length[gradient]) sum -= w.force[gradient];
  return sum;
}

std::vector<double> uniaxial_row(const Packing& packing, const PackingReport& r, const JamProgress& work, double strain) {
  std::vector<double> row = packing_row(packing, r, work);
  row.insert(row.begin(), strain);
  double overlap = 0, shape = 0;
  for (const ContactRecord<2>& record : r.records) overlap -= record.gap / record.reach / static_cast<double>(r.records.size());
  for (const double a : r.shapes.shape_parameter) shape += a / static_cast<double>(r.shapes.shape_parameter.size());
  const double pairs = static_cast<double>(r.network.pairs.size()), sites = static_cast<double>(r.contacts.size());
  for (const double x : {force_on_upper_wall(packing.system, r.evaluation), sites, pairs > 0 ? sites / pairs : 0, overlap, shape})
    row.push_back(x);
  return row;
}

/// Lowers the upper wall to `height`; what is below moves with the strain, bodies as wholes.
void lower_wall(System<2>& s, double height) {
  scale_cell(s, {1, height / s.box.length[gradient]});
  s.box.length[gradient] = height;
}

}  // namespace

std::vector<Derived> derive_uniaxial_compression(const Case& c, const InitialState* initial) {
  std::vector<Derived> all = derived_packing(boxed_packing(c, initial));
  all.push_back({{"minimisations", "", "steps of the wall, each with a minimisation"}, std::ceil(c.uniaxial.strain / c.uniaxial.step)});
  return all;
}

void run_uniaxial_compression(const Case& c, const InitialState* initial, Recorder& recorder) {
  Packing packing = boxed_packing(c, initial);
  begin_packing(packing, derive_uniaxial_compression(c, initial), recorder);
  std::vector<Column> columns = packing_columns(packing);
  columns.insert(columns.begin(), {"strain", "", "how far the upper wall has come down, over the first height"});
  columns.push_back({"wall_force", "", "force on the upper wall"});
  columns.push_back({"vertex_contacts", "", "vertices that touch another particle"});
  columns.push_back({"contact_length", "", "vertices in contact per pair of particles that touch: 2 at a point, more on a facet"});
  columns.push_back({"mean_overlap", "diameter", "mean overlap of vertices or discs over the distance at which they touch"});
  columns.push_back({"mean_shape_parameter", "", "mean p^2/(4 pi a)"});
  recorder.declare("packing", columns);
  const double height = packing.system.box.length[gradient];
  const auto steps = std::max<std::int64_t>(1, std::llround(c.uniaxial.strain / c.uniaxial.step));
  const std::int64_t every = std::max<std::int64_t>(1, steps / c.output.frames);
  JamProgress work;
  for (std::int64_t k = 0; k <= steps; ++k) {
    const double strain = c.uniaxial.strain * static_cast<double>(k) / static_cast<double>(steps);
    lower_wall(packing.system, height * (1 - strain));
    work.last = relax(packing);
    work.state = observe(packing);
    ++work.minimisations;
    work.evaluations += work.last.evaluations;
    work.unconverged += !work.last.converged;
    packing.system.time = strain;
    const PackingReport report = report_packing(packing);
    recorder.append("packing", uniaxial_row(packing, report, work, strain));
    if (k % every == 0 && k < steps) recorder.frame(packing_frame(packing, report));
    recorder.progress(fmt::format("strain {:.3f}", strain), k, steps);
    if (!recorder.stop_requested()) continue;
    hand_over(packing, recorder);
    throw Error(ErrorKind::interrupted, fmt::format("interrupted at strain {:.4f}", strain));
  }
  record_packing(packing, work, recorder);
}

}  // namespace supple
