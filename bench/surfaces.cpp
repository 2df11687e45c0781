#include "bench/surfaces.hpp"

#include <fmt/core.h>
#include <malloc.h>

#include "bench/time_per_vertex.hpp"
#include "supple/build/surfaces.hpp"
#include "supple/core/random.hpp"
#include "supple/experiment/jam.hpp"
#include "supple/experiment/random_surfaces.hpp"
#include "supple/force/shape_terms.hpp"
#include "supple/force/surface_shape.hpp"

namespace supple::bench {
namespace {

/// Geodesic spheres, a little out of shape.
System<3> surfaces(int bodies, int vertices, double bending) {
  System<3> system;
  RandomStream draw(1, Purpose::test);
  const TriangleMesh mesh = geodesic_icosahedron(vertices);
  for (int b = 0; b < bodies; ++b)
    add_surface(system, mesh, 1, {.area = 1, .length = 1, .bending = bending, .tension = 0.05});
  for (Vec3& x : system.state.position)
    for (int d = 0; d < 3; ++d) x[d] += 0.1 * mean_edge(mesh) * draw.uniform(-1, 1);
  return system;
}

/// Additions and multiplications of an evaluation, counted in the loops of force/surface_shape.cpp: of a
/// triangle, measured and pushed at its corners; what bending adds to that; of a hinge; and of a vertex,
/// where six corners meet. Bringing points into the lanes of registers and back is not among them.
constexpr double of_triangle = 65 + 47, of_bent_triangle = 12, of_hinge = 67, of_vertex = 21;

double operations_per_vertex(const System<3>& system) {
  const Topology<3>& t = system.topology;
  const auto triangles = static_cast<double>(t.facet.size()), hinges = static_cast<double>(t.hinge.size());
  double sum = of_triangle * triangles;
  if (system.shape.stiffness[0].hinge != 0) sum += of_bent_triangle * triangles + of_hinge * hinges;
  return of_vertex + sum / system.state.size();
}

/// 64 shells of 42 vertices, two sizes, jammed to 1e-5 k_v v0 with these contacts.
Packing<3> jammed_shells(const char* contact) {
  Case c;
  c.general.experiment = "jamming";
  c.contact.kind = contact;
  SurfaceSample sample{.count = 64};
  sample.shape.bending = 0.05;
  Packing<3> packing = packing_of(c, random_surfaces(sample));
  JamSpec wanted;
  wanted.search = JamSearch::pressure;
  wanted.pressure = 1e-5;
  jam(packing, wanted);
  return packing;
}

/// The same particles again and again, `times` along each direction.
System<3> repeated(const System<3>& s, int times) {
  System<3> all;
  all.box = s.box;
  all.box.length = times * s.box.length;
  const Topology<3>& t = s.topology;
  for (int copy = 0; copy < times * times * times; ++copy) {
    const Vec3 shift = s.box.lattice().vector(
        {1.0 * (copy % times), 1.0 * (copy / times % times), 1.0 * (copy / times / times)});
    for (int b = 0; b < t.body_count(s.state.size()); ++b) {
      TriangleMesh mesh = mesh_of(s, b);
      for (Vec3& x : mesh.vertex) x += shift;
      const auto part = [](const std::vector<double>& values, std::int32_t begin, std::int32_t end) {
        return std::vector<double>(values.begin() + begin, values.begin() + end);
      };
      add_surface(all, mesh, s.state.radius[t.body_begin(b)], s.shape.stiffness[b], s.shape.rest_volume[b],
                  part(s.shape.rest_facet, t.facet_begin[b], t.facet_begin[b + 1]),
                  part(s.shape.rest_hinge, t.hinge_begin[b], t.hinge_begin[b + 1]));
    }
  }
  return all;
}

template <class... Arrays>
double bytes_in(const Arrays&... arrays) {
  return (0.0 + ... + static_cast<double>(arrays.size() * sizeof(arrays[0])));
}

/// What a system and its evaluation hold [bytes].
struct Memory {
  double sites, meshes, rows, evaluation, allocated;

  Memory(const System<3>& s, const Evaluation<3>& out, double allocated_for_all)
      : allocated(allocated_for_all) {
    const State<3>& x = s.state;
    sites = bytes_in(x.position, x.velocity, x.mass, x.radius, x.angle, x.inertia, x.spin, x.mobility);
    const Topology<3>& t = s.topology;
    meshes = bytes_in(t.begin, t.facet_begin, t.hinge_begin, t.facet, t.hinge, s.shape.stiffness,
                      s.shape.rest_volume, s.shape.rest_facet, s.shape.rest_hinge);
    const PairTable& p = s.pairs;
    rows = bytes_in(p.begin, p.first, p.second, p.state, p.history, p.image);
    evaluation = bytes_in(out.force, out.torque);
  }
};

/// Bytes that this process has allocated and not given back.
double bytes_in_use() {
  const struct mallinfo2 now = mallinfo2();
  return static_cast<double>(now.uordblks + now.hblkhd);
}

void print_packed_surfaces() {
  fmt::print(
      "\nShells of 42 vertices at jamming, forces: CPU ns per vertex and evaluation (best of repeats), and "
      "bytes per vertex\n");
  fmt::print("  {:>8}  {:>8}  {:>6}  {:>6}  {:>6}  {:>6}  {:>6}  {:>6}  {:>9}\n", "contacts", "vertices",
             "shapes", "all", "sites", "meshes", "rows", "forces", "allocated");
  for (const char* contact : {"rough", "smooth"}) {
    const Packing<3> packing = jammed_shells(contact);
    for (const int times : {1, 2, 4, 7}) {
      const double before = bytes_in_use();
      System<3> s = repeated(packing.system, times);
      ForceField<3> field = *packing.field;
      field.invalidate();
      const SurfaceShape shape;
      Evaluation<3> out, shapes;
      field.evaluate(s, Detail::forces, out);
      const Memory memory(s, out, bytes_in_use() - before);
      shapes.force.resize(s.state.position.size());
      const auto [all, of_shapes] =
          time_per_vertex<2>(s.state.size(), {[&] { field.evaluate(s, Detail::forces, out); },
                                              [&] { shape.evaluate(s, Detail::forces, shapes); }});
      fmt::print("  {:>8}  {:>8}  {:>6.1f}  {:>6.1f}", contact, s.state.size(), of_shapes, all);
      for (const double bytes : {memory.sites, memory.meshes, memory.rows, memory.evaluation})
        fmt::print("  {:>6.0f}", bytes / s.state.size());
      fmt::print("  {:>9.0f}\n", memory.allocated / s.state.size());
    }
  }
  fmt::print(
      "  sites: System::state. meshes: topology and preferred shapes. rows: the pair table. forces: and "
      "torques.\n"
      "  allocated: all of these, the neighbour list, what contacts keep, and spare room.\n");
}

}  // namespace

void print_surfaces() {
  fmt::print("\nShape energy of triangulated surfaces: CPU ns per vertex and evaluation (best of repeats)\n");
  fmt::print("  {:>6}  {:>8}  {:>7}  {:>6}  {:>8}  {:>6}  {:>5}  {:>10}\n", "bodies", "vertices", "bending",
             "forces", "energies", "terms", "ratio", "arithmetic");
  for (const auto& [bodies, vertices] : {std::pair{224, 12}, {64, 42}, {16, 162}})
    for (const double bending : {0.1, 0.0}) {
      const System<3> s = surfaces(bodies, vertices, bending);
      const SurfaceShape shape;
      const TermSet<3> terms = shape_terms(s);
      Evaluation<3> out;
      out.force.resize(s.state.position.size());
      const auto [forces, energies] =
          time_per_vertex<2>(s.state.size(), {[&] { shape.evaluate(s, Detail::forces, out); },
                                              [&] { shape.evaluate(s, Detail::energies, out); }});
      double of_terms = 1e300;
      for (int turn = 0; turn < 20; ++turn) {
        const double start = cpu_seconds();
        terms.evaluate(s, Detail::forces, out);
        of_terms = std::min(of_terms, 1e9 * (cpu_seconds() - start) / s.state.size());
      }
      fmt::print("  {:>6}  {:>8}  {:>7}  {:>6.1f}  {:>8.1f}  {:>6.0f}  {:>5.0f}  {:>10.1f}\n", bodies,
                 vertices, bending, forces, energies, of_terms, of_terms / forces,
                 nanoseconds_of_operations(operations_per_vertex(s)));
    }
  fmt::print(
      "  energies: with energies and virial. terms: the same by the general terms (force/shape_terms.hpp), "
      "forces alone.\n"
      "  arithmetic: the additions and multiplications of the pass at the best rate of this machine.\n");
  print_packed_surfaces();
}

}  // namespace supple::bench
