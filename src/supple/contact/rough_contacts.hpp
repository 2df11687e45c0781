/// Rough contacts: vertices are discs that repel those of other bodies.
#pragma once
#include "supple/contact/body_contacts.hpp"
#include "supple/contact/linked_touches.hpp"
#include "supple/contact/pushes.hpp"
#include "supple/contact/row_images.hpp"

namespace supple {

/// Vertices of different bodies act on each other at distances below sigma_ab = (sigma_a + sigma_b)/2, sigma
/// being their diameters, times the range of the law [MacKeith 2025, eq. 9.3-9.4]. Bodies of one site are
/// smooth discs. The bits are the same for any number of threads.
class RoughContacts final : public BodyContacts {
 public:
  using BodyContacts::BodyContacts;
  std::unique_ptr<BodyContacts> clone() const override { return std::make_unique<RoughContacts>(*this); }
  Meeting meeting() const override { return Meeting::sites; }
  void evaluate(const System<2>& system, Detail detail, Evaluation<2>& out) override;
  std::vector<ContactRecord<2>> records(const System<2>& system) override;

 private:
  struct Sum;
  /// The force on the second site of a row.
  struct Push {
    std::int32_t first, second;
    Vec2 force;
  };
  template <bool energies, bool links, class Laws, class Visit>
  void for_touching(const System<2>& system, const Laws& laws, int begin, int end, Sum& sum,
                    const Visit& visit) const;
  template <bool energies, bool links, class Laws>
  Sum add_all(const System<2>& system, const Laws& laws, Evaluation<2>& out);

  bool is_linked(const System<2>& system, int row) const;

  RowImages<2> images_;
  LinkedTouches linked_;
  std::vector<Vec2> shifts_;
  Pushes<Push> pushes_;  ///< with several threads
};

}  // namespace supple
