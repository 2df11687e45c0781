/// Rough contacts: vertices are discs that repel those of other bodies.
#pragma once
#include "supple/contact/body_contacts.hpp"
#include "supple/contact/row_images.hpp"

namespace supple {

/// Vertex on vertex [MacKeith 2025, eq. 9.3-9.4], r < sigma_ab = (sigma_a + sigma_b)/2. Bodies of one site are smooth discs.
class RoughContacts final : public BodyContacts {
 public:
  using BodyContacts::BodyContacts;
  Meeting meeting() const override { return Meeting::sites; }
  void evaluate(const System<2>& system, Detail detail, Evaluation<2>& out) override;
  std::vector<ContactRecord<2>> records(const System<2>& system) override;

 private:
  struct Sum;
  template <bool energies>
  void add_rows(const System<2>& system, int begin, int end, const std::vector<Vec2>& shifts, Evaluation<2>& out, Sum& sum);

  RowImages<2> images_;
};

}  // namespace supple
