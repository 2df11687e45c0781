/// Rough contacts: vertices are discs, or spheres, that repel those of other bodies.
#pragma once
#include "supple/contact/body_contacts.hpp"
#include "supple/contact/linked_touches.hpp"
#include "supple/contact/pushes.hpp"
#include "supple/contact/row_images.hpp"

namespace supple {

/// Vertices of different bodies act on each other at distances below sigma_ab = (sigma_a + sigma_b)/2, sigma
/// being their diameters, times the range of the law [MacKeith 2025, eq. 9.3-9.4]. Bodies of one site are
/// smooth discs or spheres. The bits are the same for any number of threads.
template <int Dim>
class RoughContacts final : public BodyContacts<Dim> {
 public:
  using BodyContacts<Dim>::BodyContacts;
  std::unique_ptr<BodyContacts<Dim>> clone() const override { return std::make_unique<RoughContacts>(*this); }
  Meeting meeting() const override { return Meeting::sites; }
  void evaluate(const System<Dim>& system, Detail detail, Evaluation<Dim>& out) override;
  std::vector<ContactRecord<Dim>> records(const System<Dim>& system) override;

 private:
  struct Sum;
  /// The force on the second site of a row.
  struct Push {
    std::int32_t first, second;
    Vec<Dim> force;
  };
  template <bool energies, bool links, class Laws, class Visit>
  void for_touching(const System<Dim>& system, const Laws& laws, int begin, int end, Sum& sum,
                    const Visit& visit) const;
  template <bool energies, bool links, class Laws>
  Sum add_all(const System<Dim>& system, const Laws& laws, Evaluation<Dim>& out);

  bool is_linked(const System<Dim>& system, int row) const;

  RowImages<Dim> images_;
  LinkedTouches<Dim> linked_;
  std::vector<Vec<Dim>> shifts_;
  Pushes<Push> pushes_;  ///< with several threads
};

}  // namespace supple
