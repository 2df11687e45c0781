/// Packings of particles that adhere: nothing on the way takes pressures, energies or forces for positive.
#include <gtest/gtest.h>

#include "supple/experiment/adopt_state.hpp"
#include "supple/experiment/held_keys.hpp"
#include "supple/experiment/jam.hpp"
#include "supple/experiment/packing_record.hpp"
#include "supple/model/bodies.hpp"

namespace supple {
namespace {

Case sticky(const char* kind, const char* search) {
  Case c;
  c.general.experiment = "jamming";
  c.bodies.count = 10;
  c.bodies.vertices = 10;
  c.contact.kind = kind;
  c.contact.law = "adhesive";
  c.contact.attraction_range = 0.2;
  c.jamming.pressure = 1e-4;
  c.jamming.search = search;
  resolve_family(c);
  return c;
}

/// They bear a pressure long before particles that only push jam (0.84), and pull at each other there.
TEST(AdhesivePacking, BearsItsPressureFarBelowThePackingOfParticlesThatPush) {
  for (const char* kind : {"rough", "smooth"})
    for (const char* search : {"root", "pressure"}) {
      SCOPED_TRACE(std::string(kind) + ", " + search);
      const Case c = sticky(kind, search);
      Packing<2> packing = make_packing(c, nullptr, c.jamming.packing_fraction);
      const JamProgress<2> end = jam(packing, jam_spec(c));
      EXPECT_TRUE(end.last.converged);
      EXPECT_GT(end.state.pressure, 1e-4);
      EXPECT_LT(end.state.pressure, 1.01e-4);
      EXPECT_LT(covered_fraction(packing), 0.7);
      EXPECT_LT(end.state.energy, 0);
      const PackingReport<2> report = report_packing(packing);
      int pulling = 0;
      for (const SiteContact<2>& contact : report.contacts) pulling += contact.normal_force() < 0;
      EXPECT_GT(pulling, 5);
      EXPECT_GT(report.numbers.mean(), 1.5);
    }
}

/// Drawn out as far as its contacts let it, a packing is under tension.
TEST(AdhesivePacking, HoldsTogetherUnderTension) {
  const Case c = sticky("rough", "pressure");
  Packing<2> packing = make_packing(c, nullptr, c.jamming.packing_fraction);
  jam(packing, jam_spec(c));
  scale_cell(packing.system, {1.02, 1.02});
  packing.field->invalidate();
  EXPECT_TRUE(relax(packing).converged);
  const PackingState<2> state = observe(packing);
  EXPECT_LT(state.pressure, -1e-4);
  EXPECT_LT(state.energy, 0);
}

TEST(AdhesivePacking, ItsLawStaysWithTheState) {
  const Case c = sticky("rough", "pressure");
  InitialState state;
  state.system = make_packing(c, nullptr, 0.1).system;
  state.units = reduced_units();
  state.keys = held_keys(c);
  Case next;
  next.general.experiment = "compression";
  next.initial.state = "sticky.h5";
  const Case adopted = adopt_state(next, &state);
  EXPECT_EQ(adopted.contact.law, "adhesive");
  EXPECT_EQ(adopted.contact.attraction_range, 0.2);
}

}  // namespace
}  // namespace supple
