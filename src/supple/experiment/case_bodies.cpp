/// The sections of a case that say what deformable particles are.
#include "supple/contact/laws/list.hpp"
#include "supple/experiment/case.hpp"

namespace supple {

namespace {

/// Those that [bodies] and [[species]] share.
template <class P>
Fields<P> fields_of_kind() {
  return {
      {"family",
       &P::family,
       "",
       "shape energy (Table 9.1); elastic solids: a network of springs, or elements round the centre "
       "(9.15); smooth discs (3D: spheres); rigid polygons (surfaces)",
       any_value,
       {"shell", "floppy", "droplet", "network", "elastic", "disc", "rough_disc", "sphere", "rough_sphere"}},
      {"N", &P::count, "", "number of particles", {1, 1e6}},
      {"vertices",
       &P::vertices,
       "",
       "vertices of a small particle; 3D: 12, 42, 162, 642, ... of a geodesic sphere, 42 unless given; of a "
       "network all nodes, 80 (3D: 400) unless given",
       {3, 1e5}},
      {"A0", &P::shape_parameter, "",
       "preferred p^2/(4 pi a) (3D: s^1.5/(6 sqrt(pi) v)); 0: of the regular polygon (geodesic sphere). "
       "Floppy: "
       "1.04 unless given",
       not_negative},
      {"A0_ratio", &P::shape_ratio, "",
       "the same over that of the regular polygon (geodesic sphere), N tan(pi/N)/pi: in place of A0",
       not_negative},
      {"diameter_ratio", &P::diameter_ratio, "",
       "vertex diameter sigma over preferred edge length; of a network in 3D 1.2 unless given", positive},
      {"k_v", &P::k_v, "", "stiffness of the volume, in 3D", not_negative, {}, Role::number},
      {"k_a",
       &P::k_a,
       "",
       "stiffness of the area; 3D: of triangles, droplet: 0.1 unless given",
       not_negative,
       {},
       Role::number},
      {"k_l", &P::k_l, "", "stiffness of edges; droplet: 0.1 unless given", not_negative, {}, Role::number},
      {"k_b",
       &P::k_b,
       "",
       "stiffness of corners (3D: of edges); floppy, droplet: 0 unless given",
       not_negative,
       {},
       Role::number},
      {"gamma",
       &P::gamma,
       "",
       "line (3D: surface) tension; droplet: 0.2 unless given",
       not_negative,
       {},
       Role::number},
      {"k_perimeter", &P::k_perimeter, "", "stiffness of the whole perimeter, beside that of its edges",
       not_negative},
      {"k_s",
       &P::k_s,
       "",
       "stiffness of the springs of a network, k of (k/2)(r - r0)^2; 2D: E is near 2 k/sqrt(3)",
       not_negative,
       {},
       Role::number},
      {"E",
       &P::young_modulus,
       "",
       "Young's modulus of an elastic particle; of a network, in place of k_s, if springs follow the strain",
       positive,
       {},
       Role::number},
      {"nu",
       &P::poisson_ratio,
       "",
       "Poisson's ratio of an elastic particle; 2D: of the sheet",
       {-1, 1, false, false},
       {},
       Role::number},
  };
}

/// In this order.
template <class P>
Fields<P> in_order(const Fields<P>& all, const std::vector<std::string_view>& names) {
  Fields<P> ordered;
  for (const std::string_view name : names)
    for (const Field<P>& f : all)
      if (f.name == name) ordered.push_back(f);
  return ordered;
}

}  // namespace

template <>
const Fields<Species>& fields() {
  static const Fields<Species> f = [] {
    Fields<Species> all = fields_of_kind<Species>();
    all.insert(all.begin(), {"name", &Species::name, "",
                             "by which [contact.A.B] calls it; empty: by its place, 1 for the first"});
    all.insert(all.begin() + 3,
               {"diameter", &Species::diameter, "",
                "of the disc (3D: sphere) with its preferred area, over that of area (volume) 1", positive});
    for (Field<Species>& field : all) {
      if (field.name == "vertices") field.meaning = "vertices of a particle";
      field.role = Role::sample;
    }
    return all;
  }();
  return f;
}

template <>
const Fields<Bodies>& fields() {
  using B = Bodies;
  static const Fields<B> more{
      {"dim",
       &B::dimensions,
       "",
       "dimensions: 2, polygons and discs; 3, triangulated surfaces and spheres",
       {2, 3}},
      {"vertex_rule",
       &B::vertex_rule,
       "",
       "large particles have as many vertices, or size_ratio times as many",
       any_value,
       {"equal", "scaled"}},
      {"size_ratio", &B::size_ratio, "", "large over small diameter", {1, 100}},
      {"large_fraction", &B::large_fraction, "", "share of large particles", fraction},
      {"A0_ratio_large", &B::shape_ratio_large, "", "A0_ratio of large particles; 0: as of small ones",
       not_negative},
      {"stiffness",
       &B::stiffness,
       "",
       "relative: (k/2)(l/l0 - 1)^2; absolute: (k/2)(l - l0)^2",
       any_value,
       {"relative", "absolute"},
       Role::number},
      {"discs", &B::discs, "", "smooth discs of the small area, added to the particles", {0, 1e6}},
      {"yield_strain",
       &B::yield_strain,
       "",
       "strain of lengths and areas, and radian of angles, beyond which preferred shapes flow",
       not_negative,
       {},
       Role::law},
      {"flow_time",
       &B::flow_time,
       "",
       "time in which they do; 0: they never flow",
       not_negative,
       {},
       Role::law},
  };
  static const Fields<B> f = [] {
    Fields<B> all = fields_of_kind<B>();
    all.insert(all.end(), more.begin(), more.end());
    all = in_order(all, {"dim",
                         "family",
                         "N",
                         "vertices",
                         "vertex_rule",
                         "size_ratio",
                         "large_fraction",
                         "A0",
                         "A0_ratio",
                         "A0_ratio_large",
                         "diameter_ratio",
                         "stiffness",
                         "k_v",
                         "k_a",
                         "k_l",
                         "k_b",
                         "gamma",
                         "k_perimeter",
                         "k_s",
                         "E",
                         "nu",
                         "discs",
                         "yield_strain",
                         "flow_time"});
    return with_role(Role::sample, all);
  }();
  return f;
}

template <>
const Fields<ContactOfBodies>& fields() {
  using T = ContactOfBodies;
  static const Fields<T> all{
      {"kind",
       &T::kind,
       "",
       "vertices as discs (9.3), or smooth boundaries (9.5, by inclusion-exclusion)",
       any_value,
       {"rough", "smooth"}},
      {"law", &T::law, "", "elastic law of contacts, of stiffness k_c", any_value, laws_of_bodies()},
      {"attraction_range",
       &T::attraction_range,
       "sigma",
       "beyond contact, of the law \"adhesive\"",
       {0, 1, true, false}},
      {"k_c",
       &T::k_c,
       "",
       "stiffness of contacts, relative or absolute as [bodies] stiffness says",
       positive,
       {},
       Role::number},
      {"k_p", &T::k_p, "k_c", "stiffness of walls over k_c", positive},
      {"floor_friction", &T::floor_friction, "", "Coulomb coefficient of the floor", not_negative},
      {"unsound",
       &T::unsound,
       "",
       "when a particle has got into another one: stop with the last good state, or mark it and go on",
       any_value,
       {"stop", "mark"},
       Role::run},
  };
  static const Fields<T> f = with_role(Role::law, all);
  return f;
}

template <>
const Fields<ContactOfSpecies>& fields() {
  using P = ContactOfSpecies;
  static const Fields<P> all{
      {"law", &P::law, "", "elastic law of contacts of A and B", any_value, laws_of_bodies()},
      {"attraction_range",
       &P::attraction_range,
       "sigma",
       "beyond contact, of the law \"adhesive\"",
       {0, 1, true, false}},
      {"k_c", &P::k_c, "", "stiffness of these contacts", positive},
      {"friction", &P::friction, "", "Coulomb coefficient mu of these contacts", not_negative},
      {"relative_viscosity", &P::relative_viscosity, "", "viscosity of these contacts, over sqrt(m k_c)",
       not_negative},
  };
  static const Fields<P> f = with_role(Role::exception, all);
  return f;
}

}  // namespace supple
