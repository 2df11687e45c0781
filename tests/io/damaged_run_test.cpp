/// Runs whose file is sound HDF5 but says what cannot be: sizes, indices, types and texts are not believed.
#include <ctime>

#include "supple/core/utf8.hpp"
#include "supple/io/export/csv.hpp"
#include "supple/io/export/trajectory.hpp"
#include "supple/io/run/run_file.hpp"
#include "supple/io/run/run_merge.hpp"
#include "supple/io/run/run_pictures.hpp"
#include "tests/io/continued_run.hpp"
#include "tests/io/damage.hpp"

namespace supple::testing {
namespace {

class DamagedRun : public ContinuedRun {
 protected:
  std::string damaged() const { return in_folder("damaged.h5"); }

  /// What `act` throws, where that is no error of Supple; and that it ends soon.
  template <class Act>
  void expect_an_error_or_none(const std::string& what, Act&& act) const {
    const std::clock_t start = std::clock();  // a busy machine takes longer
    try {
      act();
    } catch (const Error& e) {
      EXPECT_TRUE(is_utf8(e.what()));
    } catch (const std::exception& e) {
      ADD_FAILURE() << what << ": " << e.what();
    }
    EXPECT_LT(std::clock() - start, 5 * CLOCKS_PER_SEC) << what;
  }

  /// Everything that show reads.
  static void show(const RunFile& run) {
    std::string text = run.status() + run.version() + run.experiment() + run.physics() + run.case_text();
    run.resolved_case();
    run.info();
    for (const std::string& table : run.tables())
      for (const Column& column : run.columns(table))
        run.column(table, column.name), text += column.unit + column.meaning;
    for (const std::string& group : run.value_groups())
      for (const RunValue& value : run.values(group)) text += value.name.unit + value.name.meaning;
    for (const std::string& warning : run.warnings()) text += warning;
    for (std::int64_t k = 0; k < run.frames(); ++k) run.frame(k);
    EXPECT_TRUE(is_utf8(text));
  }

  void use_frames(const std::string& what) const {
    const std::string picture = in_folder("picture.svg");
    expect_an_error_or_none(what + ", picture", [&] { draw_frame(picture, RunFile(damaged()), 1); });
    expect_an_error_or_none(what + ", xyz",
                            [&] { export_xyz(RunFile(damaged()), in_folder("a.xyz"), Existing::replace); });
    expect_an_error_or_none(what + ", vtp", [&] {
      export_vtp(RunFile(damaged()), in_folder("a.pvd"), Existing::replace, Cells::triangles);
    });
    expect_an_error_or_none(what + ", contacts", [&] {
      export_contacts(RunFile(damaged()), in_folder("a.csv"), Existing::replace);
    });
  }

  void continue_run(const std::string& what, Case c) const {
    expect_an_error_or_none(what + ", continued", [&] {
      const InitialState state = read_state(damaged());
      MemoryRecorder recorder;
      run(adopt_state(c, &state), &state, recorder);
    });
  }

  /// Datasets with damages that mean something for them: each dataset with some, drawn, or with all of them
  /// where SUPPLE_ALL_DAMAGES is set (minutes).
  void damage_all(const std::string& name, const Case& further) const {
    const std::vector<std::string> datasets = datasets_of(in_folder(name));
    EXPECT_GT(datasets.size(), 60u);
    const bool all = std::getenv("SUPPLE_ALL_DAMAGES") != nullptr;
    std::uint64_t seed = 1;
    int tried = 0;
    for (const std::string& dataset : datasets)
      for (const Damage damage : all_damages) {
        seed = seed * 6364136223846793005u + 1442695040888963407u;
        if (!all && (seed >> 40) % 12 != 0) continue;
        std::filesystem::copy_file(in_folder(name), damaged(),
                                   std::filesystem::copy_options::overwrite_existing);
        if (!damage_dataset(damaged(), dataset, damage, seed >> 33)) continue;
        ++tried;
        const std::string what = dataset + ", damage " + std::to_string(static_cast<int>(damage));
        expect_an_error_or_none(what + ", show", [&] { show(RunFile(damaged())); });
        if (dataset.starts_with("tables"))
          expect_an_error_or_none(
              what + ", csv", [&] { export_csv(RunFile(damaged()), in_folder("a.csv"), Existing::replace); });
        if (dataset.starts_with("frames") || dataset.starts_with("discs") || dataset.starts_with("box"))
          use_frames(what);
        if (dataset.starts_with("final_state") || dataset.starts_with("protocol") ||
            dataset.starts_with("material"))
          continue_run(what, further);
        if (dataset.starts_with("tables") || dataset.starts_with("frames"))
          expect_an_error_or_none(what + ", merge", [&] {
            save_merged(RunFile(damaged()), "complete", in_folder("merged.h5"), Existing::replace);
          });
      }
    EXPECT_GT(tried, 60);
  }
};

TEST_F(DamagedRun, OfDiscsIsAnErrorOrReadAsFarAsItIsSound) {
  record("run.h5",
         case_of("experiment = \"dynamics\"\n[particles]\nN = 24\ncut_lines = 0\n[shear]\nrate = \"100\"\n"
                 "[time]\nsteps = 20\n[output]\nframes = 3\n"));
  damage_all("run.h5", case_of("experiment = \"dynamics\"\n[time]\nsteps = 2\n[output]\nframes = 1\n"));
}

TEST_F(DamagedRun, OfBodiesIsAnErrorOrReadAsFarAsItIsSound) {
  record("run.h5",
         case_of("experiment = \"jamming\"\n[bodies]\nN = 6\nvertices = 8\n[jamming]\npressure = 1e-3\n"
                 "packing_fraction = 0.6\nstep = 0.02\n"));
  damage_all("run.h5", case_of("experiment = \"dynamics\"\nphysics = \"deformable\"\n[time]\nsteps = 2\n"
                               "[output]\nframes = 1\n"));
}

}  // namespace
}  // namespace supple::testing
