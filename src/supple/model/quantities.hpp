/// What the numbers of a system are called, in which unit they are and what they say. Each is declared here
/// once: run files, states in other units and docs/quantities.md follow.
#pragma once
#include <tuple>
#include <type_traits>

#include "supple/model/evaluation.hpp"
#include "supple/model/frame.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// A member of `Struct`: a number, a vector, or an array of them.
template <class Struct, class Value>
struct Quantity {
  const char* name;  ///< in files
  Value Struct::*member;
  Unit unit;
  const char* meaning;
};
template <class Struct, class Value>
Quantity(const char*, Value Struct::*, Unit, const char*) -> Quantity<Struct, Value>;

/// The quantities of each struct, in the order of files.
template <class Struct>
inline constexpr auto quantities = std::tuple{};

/// visit(quantity, value) for each of them.
template <class Struct, class Visit>
void for_each_quantity(Struct& values, Visit&& visit) {
  static_assert(std::tuple_size_v<std::remove_const_t<decltype(quantities<std::remove_const_t<Struct>>)>> > 0,
                "its quantities are not listed here");
  std::apply([&](const auto&... quantity) { (visit(quantity, values.*(quantity.member)), ...); },
             quantities<std::remove_const_t<Struct>>);
}

inline constexpr const char* state_meaning = "0 open, 1 stick, 2 slip, 3 permanent";
inline constexpr const char* cells_meaning =
    "cells of the lattice to subtract from the difference of the positions";

template <int Dim>
inline constexpr auto quantities<Box<Dim>> =
    std::tuple{Quantity{"length", &Box<Dim>::length, unit::length, "of the cell along x, y, z"},
               Quantity{"periodic", &Box<Dim>::periodic, unit::none, "1: the cell repeats in this direction"},
               Quantity{"strain", &Box<Dim>::strain, unit::none, "accumulated shear strain"},
               Quantity{"strain_rate", &Box<Dim>::strain_rate, unit::rate, "shear rate"}};

template <int Dim>
inline constexpr auto quantities<State<Dim>> = std::tuple{
    Quantity{"position", &State<Dim>::position, unit::length, "of discs and vertices"},
    Quantity{"velocity", &State<Dim>::velocity, unit::speed, "half of lag before the positions"},
    Quantity{"mass", &State<Dim>::mass, unit::mass, "of discs and vertices"},
    Quantity{"radius", &State<Dim>::radius, unit::length, "of discs and of the discs on vertices"},
    Quantity{"angle", &State<Dim>::angle, unit::angle, "counter-clockwise"},
    Quantity{"inertia", &State<Dim>::inertia, unit::inertia, "moment of inertia of discs"},
    Quantity{"spin", &State<Dim>::spin, unit::spin, "counter-clockwise"},
    Quantity{"mobility", &State<Dim>::mobility, unit::none, "0 free, 1 lower plate, 2 upper plate, 3 fixed"}};

template <int Dim>
inline constexpr auto quantities<Topology<Dim>> = std::tuple{
    Quantity{"begin", &Topology<Dim>::begin, unit::none, "sites [begin[b], begin[b + 1]) form body b"},
    Quantity{"facet_begin", &Topology<Dim>::facet_begin, unit::none, "facets of body b, likewise"},
    Quantity{"hinge_begin", &Topology<Dim>::hinge_begin, unit::none, "hinges of body b, likewise"},
    Quantity{"facet", &Topology<Dim>::facet, unit::none, "sites of each edge or triangle"},
    Quantity{"hinge", &Topology<Dim>::hinge, unit::none, "sites of each corner, or of two triangles"}};

/// Columns of the array `stiffness` of Shape.
template <>
inline constexpr auto quantities<ShapeStiffness> =
    std::tuple{Quantity{"volume", &ShapeStiffness::volume, unit::area_stiffness, "k_a of (k_a/2)(a - a0)^2"},
               Quantity{"facet", &ShapeStiffness::facet, unit::stiffness, "k_l of (k_l/2)(l - l0)^2"},
               Quantity{"hinge", &ShapeStiffness::hinge, unit::energy, "k_b of (k_b/2)(theta - theta0)^2"},
               Quantity{"tension", &ShapeStiffness::tension, unit::force, "gamma of gamma l"}};

template <>
inline constexpr auto quantities<Shape> =
    std::tuple{Quantity{"rest_volume", &Shape::rest_volume, unit::area, "preferred area of each body"},
               Quantity{"rest_facet", &Shape::rest_facet, unit::length, "preferred length of each edge"},
               Quantity{"rest_hinge", &Shape::rest_hinge, unit::angle, "preferred angle of each corner"}};

/// Columns of the array `stiffness` of Solid.
template <>
inline constexpr auto quantities<SolidStiffness> =
    std::tuple{Quantity{"bond", &SolidStiffness::bond, unit::stiffness, "k of (k/2)(r - r0)^2"},
               Quantity{"lambda", &SolidStiffness::lambda, unit::stress, "of the strain energy (9.15)"},
               Quantity{"mu", &SolidStiffness::mu, unit::stress, "of the strain energy (9.15)"}};

template <int Dim>
inline constexpr auto quantities<Solid<Dim>> = std::tuple{
    Quantity{"bond_begin", &Solid<Dim>::bond_begin, unit::none,
             "bonds [bond_begin[b], bond_begin[b + 1]) are of body b"},
    Quantity{"element_begin", &Solid<Dim>::element_begin, unit::none, "elements of body b, likewise"},
    Quantity{"bond", &Solid<Dim>::bond, unit::none, "sites of each bond"},
    Quantity{"element", &Solid<Dim>::element, unit::none, "sites of each triangle (3D: tetrahedron)"},
    Quantity{"rest_bond", &Solid<Dim>::rest_bond, unit::length, "length of each bond without force"},
    Quantity{"rest_element", &Solid<Dim>::rest_element, unit::per_length,
             "inverse of the matrix of edges from the last site of each element, without stress"}};

template <int Dim>
inline constexpr auto quantities<RigidBodiesOf<Dim>> = std::tuple{
    Quantity{"body", &RigidBodiesOf<Dim>::body, unit::none, "which bodies are rigid, ascending"},
    Quantity{"centre", &RigidBodiesOf<Dim>::centre, unit::length, "centre of mass"},
    Quantity{"velocity", &RigidBodiesOf<Dim>::velocity, unit::speed, "of the centre of mass"},
    Quantity{"angle", &RigidBodiesOf<Dim>::angle, unit::angle, "since it became rigid, counter-clockwise"},
    Quantity{"spin", &RigidBodiesOf<Dim>::spin, unit::spin, "counter-clockwise"},
    Quantity{"mass", &RigidBodiesOf<Dim>::mass, unit::mass, "of all its sites"},
    Quantity{"inertia", &RigidBodiesOf<Dim>::inertia, unit::inertia,
             "of its sites as points, about the centre"},
    Quantity{"begin", &RigidBodiesOf<Dim>::begin, unit::none,
             "offsets [begin[r], begin[r + 1]) are of rigid body r"},
    Quantity{"offset", &RigidBodiesOf<Dim>::offset, unit::length,
             "from the centre to each site, at angle 0"}};

/// Without the memory of contacts, which has PairTable::width numbers a row, and images, which few have.
template <>
inline constexpr auto quantities<PairTable> = std::tuple{
    Quantity{"begin", &PairTable::begin, unit::none, "rows [begin[i], begin[i + 1]) are of first = i"},
    Quantity{"first", &PairTable::first, unit::none, "site; the smaller number"},
    Quantity{"second", &PairTable::second, unit::none, "site"},
    Quantity{"state", &PairTable::state, unit::none, state_meaning}};

template <>
inline constexpr auto quantities<TouchKey> =
    std::tuple{Quantity{"site", &TouchKey::site, unit::none, "vertex or disc that touches"},
               Quantity{"other", &TouchKey::other, unit::none, "what it touches"},
               Quantity{"on", &TouchKey::on, unit::none, "what other is the number of: 0 a site, 1 a body"},
               Quantity{"cells", &TouchKey::cells, unit::none, cells_meaning}};

template <>
inline constexpr auto quantities<Touch> =
    std::tuple{Quantity{"state", &Touch::state, unit::none, state_meaning},
               Quantity{"elongation", &Touch::elongation, unit::length, "of the tangential spring"}};

template <>
inline constexpr auto quantities<Link> =
    std::tuple{Quantity{"first", &Link::first, unit::none, "site; the smaller number"},
               Quantity{"second", &Link::second, unit::none, "site"},
               Quantity{"cells", &Link::cells, unit::none, cells_meaning},
               Quantity{"rest", &Link::rest, unit::length, "distance without force"},
               Quantity{"elongation", &Link::elongation, unit::length, "of the tangential spring"}};

template <int Dim>
inline constexpr auto quantities<Acceleration<Dim>> =
    std::tuple{Quantity{"site", &Acceleration<Dim>::site, unit::acceleration,
                        "of discs and vertices in the last step, beside that of the flow"},
               Quantity{"spin", &Acceleration<Dim>::spin, unit::turning, "of discs, likewise"},
               Quantity{"rigid", &Acceleration<Dim>::rigid, unit::acceleration, "of rigid bodies"},
               Quantity{"rigid_spin", &Acceleration<Dim>::rigid_spin, unit::turning, "of rigid bodies"}};

template <int Dim>
inline constexpr auto quantities<System<Dim>> =
    std::tuple{Quantity{"time", &System<Dim>::time, unit::time, "since the clock was last set to 0"},
               Quantity{"lag", &System<Dim>::lag, unit::time,
                        "velocities and spins are of half this time before the positions"},
               Quantity{"step", &System<Dim>::step, unit::none, "steps since the clock was last set to 0"}};

template <int Dim>
inline constexpr auto quantities<Evaluation<Dim>> =
    std::tuple{Quantity{"force", &Evaluation<Dim>::force, unit::force, "on each site"},
               Quantity{"torque", &Evaluation<Dim>::torque, unit::torque, "counter-clockwise"},
               Quantity{"virial", &Evaluation<Dim>::virial, unit::energy,
                        "static stress times volume, compression positive"}};

template <>
inline constexpr auto quantities<EnergyParts> = std::tuple{
    Quantity{"terms", &EnergyParts::terms, unit::energy, "stored in shapes"},
    Quantity{"elastic", &EnergyParts::elastic, unit::energy, "stored in contacts and links"},
    Quantity{"tangential", &EnergyParts::tangential, unit::energy, "stored in tangential springs"},
    Quantity{"wall", &EnergyParts::wall, unit::energy, "stored in walls and repulsive plates"},
    Quantity{"external", &EnergyParts::external, unit::energy, "stored in gravity and tethers"},
    Quantity{"viscous_power", &EnergyParts::viscous_power, unit::power, "lost in central dashpots"},
    Quantity{"tangential_viscous_power", &EnergyParts::tangential_viscous_power, unit::power,
             "lost in tangential dashpots"},
    Quantity{"sliding_power", &EnergyParts::sliding_power, unit::power, "lost by friction"}};

template <int Dim>
inline constexpr auto quantities<RunInfo<Dim>> = std::tuple{
    Quantity{"radius", &RunInfo<Dim>::radius, unit::length, "of discs and of the discs on vertices"},
    Quantity{"mass", &RunInfo<Dim>::mass, unit::mass, "of discs and vertices"},
    Quantity{"inertia", &RunInfo<Dim>::inertia, unit::inertia, "moment of inertia of discs"},
    Quantity{"particle", &RunInfo<Dim>::particle, unit::none,
             "of the site, from 0: the discs that links join, or the body of a vertex"}};

template <int Dim>
inline constexpr auto quantities<Frame<Dim>> = std::tuple{
    Quantity{"step", &Frame<Dim>::step, unit::none, "time step of the run"},
    Quantity{"time", &Frame<Dim>::time, unit::time, "of the frame"},
    Quantity{"strain", &Frame<Dim>::strain, unit::none, "accumulated shear strain"},
    Quantity{"strain_rate", &Frame<Dim>::strain_rate, unit::rate, "shear rate"},
    Quantity{"position", &Frame<Dim>::position, unit::length, "of discs and vertices"},
    Quantity{"velocity", &Frame<Dim>::velocity, unit::speed, "at the time of the frame"},
    Quantity{"force", &Frame<Dim>::force, unit::force, "on each site"},
    Quantity{"angle", &Frame<Dim>::angle, unit::angle, "counter-clockwise"},
    Quantity{"spin", &Frame<Dim>::spin, unit::spin, "counter-clockwise"},
    Quantity{"torque", &Frame<Dim>::torque, unit::torque, "counter-clockwise"},
    Quantity{"mobility", &Frame<Dim>::mobility, unit::none, "0 free, 1 lower plate, 2 upper plate, 3 fixed"},
    Quantity{"length", &Frame<Dim>::length, unit::length, "of the cell"}};

template <int Dim>
inline constexpr auto quantities<ContactRow<Dim>> = std::tuple{
    Quantity{"contact_first", &ContactRow<Dim>::first, unit::none, "site; the smaller number"},
    Quantity{"contact_second", &ContactRow<Dim>::second, unit::none, "site"},
    Quantity{"contact_state", &ContactRow<Dim>::state, unit::none, state_meaning},
    Quantity{"contact_elongation", &ContactRow<Dim>::elongation, unit::length,
             "of the tangential spring, along t = (-n_y, n_x), n from first to second"},
    Quantity{"contact_elongation_back", &ContactRow<Dim>::elongation_back, unit::length,
             "the published package's second one, as the second site sees it"},
    Quantity{"contact_normal_force", &ContactRow<Dim>::normal_force, unit::force,
             "elastic and viscous part; positive: pushes the two apart"},
    Quantity{"contact_elastic_force", &ContactRow<Dim>::elastic, unit::force,
             "part of the normal force by repulsion or link"},
    Quantity{"contact_viscous_force", &ContactRow<Dim>::viscous, unit::force,
             "part of the normal force by the dashpot"},
    Quantity{
        "contact_tangential_force", &ContactRow<Dim>::tangential_force, unit::force,
        "on contact_first along t = (-n_y, n_x), n from first to second; the opposite on contact_second"},
    Quantity{"contact_force", &ContactRow<Dim>::force, unit::force,
             "on contact_first; the opposite on contact_second"}};

/// What a file holds by name beside the members above.
struct NamedNumber {
  const char* name;
  Unit unit;
  const char* meaning;
};

inline constexpr NamedNumber meaning_of_history{"history", unit::length,
                                                "tangential elongation, once or as either disc sees it"},
    meaning_of_images{"image", unit::none,
                      "1: the row keeps its image, 0: the nearest; cells to subtract from second - first"},
    meaning_of_stiffness{"stiffness", unit::none, "of the shape energy of each body, columns as named"},
    meaning_of_inside{"stiffness", unit::none, "of the inside of each body, columns as named"},
    meaning_of_species{"species", unit::none, "of each body, from 0, as the case has them"},
    meaning_of_floor{"floor_contact", unit::length, "where a site sticks to the floor; nan: nowhere"},
    first_contact{"contact_begin", unit::none, "row of the first contact of the frame"},
    number_of_contacts{"contact_count", unit::none, "contacts of the frame"};

inline constexpr const char* tensor_meaning =
    "component of the stress tensor, compression positive: force along the first letter, line of action "
    "along "
    "the second";

/// Numbers of bodies and of the whole that frames hold; components of tensors by the name before "_xx".
inline constexpr NamedNumber numbers_in_frames[] = {
    {"pressure", unit::stress, "mean normal stress, compression positive (9.27)"},
    {"stress", unit::stress, tensor_meaning},
    {"contact_stress", unit::stress,
     "of contacts alone: component of the stress tensor, compression positive"},
    {"area", unit::area, "area that the body covers"},
    {"volume", unit::volume, "volume that the body covers, in 3D"},
    {"shape_parameter", unit::none, "p^2/(4 pi a); 3D: s^1.5/(6 sqrt(pi) v); 0 for discs and spheres"},
    {"contacts", unit::none, "bodies and walls that it touches"},
    {"rattler", unit::none, "1: held by too few contacts to bear pressure"},
    {"unsound", unit::none, "1: it has got into another one, crosses itself, or has too long edges"},
    {"packing_fraction", unit::none, "covered area over area of the cell; 3D: volumes"},
    {"uniaxial_strain", unit::none, "how far the upper wall has come down, over the first height"},
    {"sliding_x", unit::none,
     "how far to the right the upper particle is held, over the width of the lower one"},
    {"friction", unit::none, "mu_eff = F_t/F_n of two particles; 0 where nothing touches"},
    {"kinetic_energy", unit::energy, "energy of motion"},
    {"shape_energy", unit::energy, "energy of shapes"},
    {"contact_energy", unit::energy, "energy stored in contacts"},
    {"elastic_energy", unit::energy, "energy stored in contacts and links"},
    {"tangential_energy", unit::energy, "energy stored in tangential springs"},
    {"wall_energy", unit::energy, "energy stored in contacts with walls"},
    {"external_energy", unit::energy, "energy in gravity and tethers"}};

}  // namespace supple
