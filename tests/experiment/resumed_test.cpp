/// Runs that are killed at safe points and go on: every number is that of a run that was left alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "supple/experiment/experiments.hpp"
#include "supple/io/text/case_file.hpp"
#include "tests/io/same_frame.hpp"

namespace supple {
namespace {

struct Killed {};

/// Dies at every n-th safe point with what it has recorded, and goes on from there.
template <int Dim>
class Mortal : public MemoryRecorderOf<Dim> {
 public:
  explicit Mortal(long every) : every_(every) {}

  void safe_point(const Keep& keep, const char*, std::int64_t) override {
    ++seen;
    if (every_ <= 0 || ++since_ < every_) return;
    since_ = 0;
    Kept kept;
    Keeper keeper = Keeper::saving(kept);
    keep(keeper);
    kept_ = std::move(kept);
    throw Killed{};
  }
  const Kept* resumed() const override { return kept_ ? &*kept_ : nullptr; }

  /// Runs the case to its end, however often it dies; returns how often.
  int live(const Case& c) {
    for (int deaths = 0;; ++deaths) try {
        run(c, nullptr, *this);
        return deaths;
      } catch (const Killed&) {
      }
  }
  long seen = 0;

 private:
  long every_, since_ = 0;
  std::optional<Kept> kept_;
};

template <int Dim>
std::map<std::string, double> last_values(const MemoryRecorderOf<Dim>& recorder) {
  std::map<std::string, double> last;
  for (const auto& [group, values] : recorder.values)
    for (const auto& value : values)
      if (value.name.name != "cpu_time") last[group + "/" + value.name.name] = value.value;
  return last;
}

template <int Dim>
void expect_same_runs(const MemoryRecorderOf<Dim>& a, const MemoryRecorderOf<Dim>& b) {
  ASSERT_EQ(a.tables.size(), b.tables.size());
  for (const auto& [name, table] : a.tables) {
    const auto& rows = b.tables.at(name).rows;
    ASSERT_EQ(table.rows.size(), rows.size()) << name;
    for (std::size_t k = 0; k < rows.size(); ++k)
      for (std::size_t column = 0; column < table.columns.size(); ++column)
        ASSERT_EQ(table.rows[k].at(column), rows[k].at(column))
            << name << ", row " << k << ", " << table.columns[column].name;
  }
  ASSERT_EQ(a.frames.size(), b.frames.size());
  for (std::size_t k = 0; k < a.frames.size(); ++k) testing::expect_same(a.frames[k], b.frames[k]);
  const auto first = last_values(a), second = last_values(b);
  ASSERT_EQ(first.size(), second.size());
  for (const auto& [name, value] : first)
    EXPECT_TRUE(testing::same_bits(std::vector{value}, std::vector{second.at(name)})) << name;
  System<Dim> last = a.last_system, other = b.last_system;
  drop_open(last.pairs, last.state.size());
  drop_open(other.pairs, other.state.size());
  testing::expect_same(last, other);
  EXPECT_EQ(a.warnings, b.warnings);
}

struct Named {
  std::string name, text;
};
void PrintTo(const Named& one, std::ostream* to) { *to << one.name; }

const std::string discs = R"(
[particles]
N = 45
cut_lines = 4
[shear]
relative_frequency = 0.2
pre_periods = 0.5
periods = 1.5
post_periods = 0.25
[output]
frames = 7
)";
const std::string shells = R"(
[bodies]
N = 6
vertices = 8
[jamming]
packing_fraction = 0.4
step = 0.01
pressure = 1e-3
)";

const std::string loose = R"(
[jamming]
packing_fraction = 0.05
pressure = 1e-3
)";

const Named cases[] = {
    {"oscillation", "experiment = \"oscillatory_shear\"\n" + discs + "energies = true\n"},
    {"oscillation_of_the_package",
     "experiment = \"oscillatory_shear\"\nphysics = \"particleshear-1.0.2\"\n" + discs},
    {"preparation", "experiment = \"preparation\"\n[particles]\nN = 45\nremove_link_fraction = 0.1\n"},
    {"dynamics_of_discs",
     "experiment = \"dynamics\"\n[particles]\nN = 45\n[shear]\nrate = \"100*cos(300*t)\"\n[time]\nsteps = "
     "300\n[output]\nframes = 4\nenergies = true\n"},
    {"oscillation_of_shells", "experiment = \"oscillatory_shear\"\nphysics = \"deformable\"\n" + shells +
                                  "[material]\nfriction = 0.3\nrelative_viscosity = 0.1\n[box]\nplates = "
                                  "\"capture\"\n[shear]\namplitude = 0.1\npre_periods = 0.25\nperiods = "
                                  "1.25\npost_periods = 0\nrelative_frequency = 0.1\n"},
    {"dynamics_of_shells",
     "experiment = \"dynamics\"\nphysics = \"deformable\"\n"
     "[bodies]\nN = 12\nvertices = 8\n[jamming]\npacking_fraction = 0.7\n"
     "[motion]\nkinetic_energy = 1e-4\n[time]\nsteps = 300\n[output]\nframes = 5\n"},
    {"sheared_rigid_polygons",
     "experiment = \"dynamics\"\nphysics = \"deformable\"\n[bodies]\nfamily = \"rough_disc\"\nN = "
     "16\nvertices "
     "= 8\n[jamming]\npacking_fraction = 0.8\n[shear]\nrate = \"0.01\"\n[material]\nfriction = "
     "0.3\n[time]\nsteps = 200\n"},
    {"jam_by_root", "experiment = \"jamming\"\n" + shells + "search = \"root\"\n"},
    {"jam_by_chapter", "experiment = \"jamming\"\n" + shells + "search = \"chapter\"\n"},
    {"jam_by_pressure", "experiment = \"jamming\"\n" + shells + "search = \"pressure\"\n"},
    {"jam_of_smooth_droplets", "experiment = \"jamming\"\n" + shells +
                                   "search = \"pressure\"\n[contact]\nkind = \"smooth\"\nk_c = "
                                   "10\n[minimise]\nmethod = \"fire\"\n"},
    {"compression", "experiment = \"compression\"\n" + shells +
                        "[compression]\nhighest_pressure = 1e-2\nper_decade = 2\ndecompress = true\n"},
    {"jam_in_3d", "experiment = \"jamming\"\n[bodies]\ndim = 3\nN = 4\nvertices = 12\n" + loose},
    {"jam_of_rigid_surfaces",
     "experiment = \"jamming\"\n[bodies]\ndim = 3\nN = 4\nvertices = "
     "12\nfamily = \"rough_sphere\"\n" +
         loose},
    {"compression_in_3d", "experiment = \"compression\"\n[bodies]\ndim = 3\nN = 16\nfamily = \"sphere\"\n" +
                              loose + "[compression]\nhighest_pressure = 1e-2\nper_decade = 2\n"},
    {"jam_of_solids",
     "experiment = \"jamming\"\n[[species]]\nfamily = \"network\"\nN = 4\nvertices = 30\n[[species]]\nfamily "
     "= \"elastic\"\nN = 4\nvertices = 10\n" +
         loose},
    {"uniaxial_compression",
     "experiment = \"uniaxial_compression\"\n[bodies]\nN = 6\nvertices = "
     "8\n[uniaxial]\nstrain = 0.1\nstep = 0.01\npressure = 1e-3\n"},
    {"plate_compression",
     "experiment = \"plate_compression\"\n[bodies]\nvertices = 12\n[plates]\nstrain = 0.1\nsteps = "
     "8\n[output]\nframes = 5\n"},
    {"plate_compression_in_3d",
     "experiment = \"plate_compression\"\n[bodies]\ndim = 3\nvertices = 12\nfamily = "
     "\"droplet\"\n[plates]\nfirst = 1e-3\nsteps = 6\n"},
    {"slump",
     "experiment = \"slump\"\n[bodies]\nN = 6\nvertices = 8\n[slump]\nsettle_time = 15\nspread_time "
     "= 12\n"},
    {"friction",
     "experiment = \"friction\"\n[bodies]\nfamily = \"floppy\"\nvertices = 8\nA0 = 1.15\n[sliding]\noverlap "
     "= "
     "1.5\nstep = 0.05\npath = \"cyclic\"\nnoise = 0.1\n[output]\nframes = 6\n"},
    {"friction_by_damped_motion",
     "experiment = \"friction\"\n[bodies]\nvertices = 8\n[sliding]\nfrom = -0.03\nto = 0.05\nrelaxation = "
     "\"dynamics\"\nrest = 1e-12\n[output]\nframes = 3\n"},
};

/// Calls `test` with Dim, as Dimensions<Dim>.
template <int Dim>
struct Dimensions {};
template <class Test>
void in_its_dimensions(const Case& c, Test&& test) {
  if (c.bodies.dimensions == 2) test(Dimensions<2>{});
  else test(Dimensions<3>{});
}

class Resumed : public ::testing::TestWithParam<Named> {
 protected:
  Case make_case() const {
    Case c = read_case_text(GetParam().text, "case.toml");
    resolve_family(c);
    experiment_of(c).complete(c);
    return c;
  }
};

TEST_P(Resumed, GoesOnBitForBitHoweverOftenItDies) {
  const Case c = make_case();
  in_its_dimensions(c, [&]<int Dim>(Dimensions<Dim>) {
    Mortal<Dim> whole(0);
    ASSERT_EQ(whole.live(c), 0);
    ASSERT_GT(whole.seen, 8);
    for (const long every : {whole.seen / 7, 2 * whole.seen / 3}) {
      Mortal<Dim> mortal(every);
      // It passes the safe point where it died once more.
      EXPECT_EQ(mortal.live(c), 1 + (whole.seen - every) / (every - 1));
      expect_same_runs<Dim>(whole, mortal);
    }
  });
}

TEST_P(Resumed, GoesOnWithAnotherNumberOfThreads) {
  const Case c = make_case();
  in_its_dimensions(c, [&]<int Dim>(Dimensions<Dim>) {
    Mortal<Dim> whole(0);
    whole.live(c);
    Mortal<Dim> mortal(whole.seen / 2);
    try {
      run(c, nullptr, mortal);
    } catch (const Killed&) {
    }
    Case wider = c;
    wider.general.threads = 2;
    mortal.live(wider);
    expect_same_runs<Dim>(whole, mortal);
  });
}

INSTANTIATE_TEST_SUITE_P(Experiments, Resumed, ::testing::ValuesIn(cases),
                         [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace supple
