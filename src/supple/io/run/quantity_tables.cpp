#include "supple/io/run/quantity_tables.hpp"

#include <fmt/format.h>

#include "supple/io/run/run_layout.hpp"
#include "supple/model/quantities.hpp"

namespace supple {

namespace {

class Tables {
 public:
  void begin(const char* group, const char* what) {
    text_ += fmt::format("\n### {}\n\n{}\n\n| name | unit | meaning |\n|---|---|---|\n", group, what);
  }
  template <class Q>
  void row(const Q& quantity) {
    text_ += fmt::format("| `{}` | {} | {} |\n", quantity.name, quantity.unit.si, quantity.meaning);
  }
  template <class Struct>
  void rows_of() {
    for_each_quantity(static_cast<const Struct&>(Struct{}), [&](const auto& q, const auto&) { row(q); });
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace

std::string describe_quantities() {
  Tables t;
  t.begin("/discs", "The same in the whole run, of each site.");
  t.rows_of<RunInfo<2>>();
  t.begin("/box, /final_state/box", "The cell at the start, and at the end.");
  t.rows_of<Box<2>>();
  t.begin("/frames", "One of each frame, or of each site in each frame; contacts one after the other.");
  t.rows_of<Frame<2>>();
  t.row(first_contact);
  t.row(number_of_contacts);
  t.rows_of<ContactRow<2>>();
  t.begin("/frames/body, /frames/system",
          "Of each particle, and of the whole; tensors by component, as `stress_xy`.");
  for (const NamedNumber& number : numbers_in_frames) t.row(number);
  t.begin("/final_state", "What a run goes on from.");
  t.rows_of<System<2>>();
  t.row(meaning_of_species);
  t.begin("/final_state/sites", "Of each site.");
  t.rows_of<State<2>>();
  t.row(meaning_of_floor);
  t.begin("/final_state/topology", "Bodies of many sites.");
  t.rows_of<Topology<2>>();
  t.begin("/final_state/shape", "Preferred shapes; the columns of `stiffness` are the first four.");
  t.rows_of<ShapeStiffness>();
  t.rows_of<Shape>();
  t.begin("/final_state/solid", "Insides of elastic solids; the columns of `stiffness` are the first three.");
  t.rows_of<SolidStiffness>();
  t.rows_of<Solid<2>>();
  t.begin("/final_state/rigid", "Rigid particles.");
  t.rows_of<RigidBodies>();
  t.begin("/final_state/acceleration", "What brings velocities to the instant of the next forces.");
  t.rows_of<Acceleration<2>>();
  t.begin("/final_state/pairs", "Contacts and links of discs.");
  t.rows_of<PairTable>();
  t.row(meaning_of_history);
  t.row(meaning_of_images);
  t.begin("/final_state/touches", "What contacts of deformable particles remember.");
  t.rows_of<TouchKey>();
  t.rows_of<Touch>();
  t.begin("/final_state/links", "Links of deformable particles.");
  t.rows_of<Link>();
  t.begin("/final_state/evaluation", "Forces on each site, and the virial.");
  t.rows_of<Evaluation<2>>();
  t.begin("/final_state/evaluation/energy", "Energies, and power that is lost.");
  t.rows_of<EnergyParts>();
  return t.text();
}

}  // namespace supple
