/// Files of Supple in the programs of others. Where one is missing its test is skipped and says so.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "supple/draw/scene/frame_scene.hpp"
#include "supple/io/run/run_file.hpp"
#include "tests/app/command.hpp"

namespace supple {
namespace {

using Json = nlohmann::json;

class OtherPrograms : public CommandTest {
 protected:
  /// Output and exit code of a shell command in the test's folder.
  Outcome shell(const std::string& line) {
    const std::string out = path("out.txt").string(), err = path("err.txt").string();
    const int status = std::system(
        ("cd '" + path("").string() + "' && (" + line + ") >'" + out + "' 2>'" + err + "'").c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(out), read_text(err)};
  }
  bool answers(const std::string& line) { return shell(line).code == 0; }

  void make_gel() {
    write_small_case("gel.toml");
    ASSERT_EQ(supple("run gel.toml").code, 0);
  }
  void make_jam() {
    write("jam.toml",
          "experiment = \"jamming\"\n[bodies]\nN = 8\nvertices = 10\n[jamming]\npressure = 1e-3\n"
          "packing_fraction = 0.6\nstep = 0.02\n[output]\nplot = false\nsnapshot = false\n");
    ASSERT_EQ(supple("run jam.toml").code, 0);
  }
  RunFile run(const std::string& name) { return RunFile(path(name).string()); }
};

#define SKIP_WITHOUT(program, test) \
  if (!answers(test)) GTEST_SKIP() << program " is not installed"

TEST_F(OtherPrograms, AseReadsExtendedXyz) {
  SKIP_WITHOUT("ASE (python3-ase)", "/usr/bin/python3 -c 'import ase.io'");
  make_gel();
  make_jam();
  for (const std::string name : {"gel", "jam"}) {
    ASSERT_EQ(supple("export " + name + ".h5 --to xyz").code, 0);
    const Outcome read = shell(
        "/usr/bin/python3 -c \"import ase.io, json\n"
        "frames = ase.io.read('" +
        name +
        ".xyz', ':')\n"
        "print(json.dumps([[len(f), f.positions[0].tolist(), f.arrays['velo'][0].tolist(),"
        " float(f.cell[0][0]), float(f.arrays['radius'][0]), float(f.info['Time'])] for f in frames]))\"");
    ASSERT_EQ(read.code, 0) << read.err;
    const Json frames = Json::parse(read.out);
    const RunFile file = run(name + ".h5");
    const RunInfo<2> info = file.info();
    ASSERT_EQ(static_cast<std::int64_t>(frames.size()), file.frames());
    for (std::int64_t k = 0; k < file.frames(); ++k) {
      const Frame<2> frame = file.frame(k);
      const Scene scene = scene_of(info, frame);
      const Vec2 x = frame.position[0] + placement_shifts(scene, Placement::in_cell)[0];
      const Json& f = frames[static_cast<std::size_t>(k)];
      EXPECT_EQ(f[0], info.radius.size());
      for (int d = 0; d < 2; ++d) {
        EXPECT_NEAR(f[1][static_cast<std::size_t>(d)].get<double>(), x[d], 1e-12 * info.box.length[0]) << k;
        EXPECT_EQ(f[2][static_cast<std::size_t>(d)].get<double>(), frame.velocity[0][d]);
      }
      EXPECT_EQ(f[3].get<double>(), frame.length[0]);
      EXPECT_EQ(f[4].get<double>(), info.radius[0]);
      EXPECT_EQ(f[5].get<double>(), frame.time);
    }
  }
}

/// The area of a polygon from its corners.
TEST_F(OtherPrograms, VtkReadsEveryFrameWithItsTimeAndAreas) {
  SKIP_WITHOUT("VTK (python3-vtk9)", "/usr/bin/python3 -c 'import vtkmodules.vtkIOXML'");
  make_jam();
  ASSERT_EQ(supple("export jam.h5 --to vtp --cells triangles").code, 0);
  const RunFile file = run("jam.h5");
  const Frame<2> frame = file.frame(0);
  const Outcome read =
      shell("/usr/bin/python3 " SUPPLE_SOURCE_DIR "/tests/io/read_vtp.py jam_frames/frame0000000.vtp");
  ASSERT_EQ(read.code, 0) << read.err;
  const Json mesh = Json::parse(read.out);
  std::vector<double> area(frame.body.at("area").size());
  const Json& ids = mesh["of_cells"]["id"]["values"];
  for (std::size_t c = 0; c < mesh["polygons"].size(); ++c) {
    const Json& cell = mesh["polygons"][c];
    const auto x = [&](std::size_t k, std::size_t d) {
      return mesh["points"][cell[k].get<std::size_t>()][d].get<double>();
    };
    area[ids[c][0].get<std::size_t>()] +=
        0.5 * std::abs((x(1, 0) - x(0, 0)) * (x(2, 1) - x(0, 1)) - (x(1, 1) - x(0, 1)) * (x(2, 0) - x(0, 0)));
  }
  for (std::size_t b = 0; b < area.size(); ++b)  // arcs have corners 11.25 degrees apart: 0.6 % less
    EXPECT_NEAR(area[b], frame.body.at("area")[b], 6e-3 * area[b]) << "particle " << b;
  EXPECT_EQ(mesh["of_all"]["TimeValue"]["values"][0][0].get<double>(), frame.time);
}

TEST_F(OtherPrograms, VtkJsReadsFrames) {
  const std::string from =
      std::getenv("SUPPLE_NODE_MODULES") ? std::getenv("SUPPLE_NODE_MODULES") : SUPPLE_SOURCE_DIR;
  const std::string find = "node -e \"require('module').createRequire('" + from +
                           "/').resolve('@kitware/vtk.js/IO/XML/XMLPolyDataReader.js')\"";
  SKIP_WITHOUT("vtk.js (npm install @kitware/vtk.js; SUPPLE_NODE_MODULES names the folder)", find);
  make_gel();
  make_jam();
  for (const std::string name : {"gel", "jam"}) {
    const RunFile file = run(name + ".h5");
    for (const std::string cells : {"polygons", "outlines", "triangles"}) {
      const Outcome made = supple("export " + name + ".h5 --to vtp --force --cells " + cells);
      ASSERT_EQ(made.code, 0) << made.err;
      const Outcome read = shell("node " SUPPLE_SOURCE_DIR "/tests/io/read_vtp.mjs '" + from + "' " + name +
                                 "_frames/frame0000000.vtp");
      ASSERT_EQ(read.code, 0) << read.err;
      const Json mesh = Json::parse(read.out);
      const std::size_t bodies =
          name == "gel" ? file.info().radius.size() : file.info().body_begin.size() - 1;
      EXPECT_GT(mesh["points"].get<std::size_t>(), bodies);
      if (cells != "triangles") {
        EXPECT_EQ(mesh["polygons"].get<std::size_t>(), bodies) << name << ' ' << cells;
      }
      if (name == "jam" && cells == "outlines") {
        EXPECT_EQ(mesh["area"].get<std::vector<double>>(), file.frame(0).body.at("area"));
      }
    }
  }
}

TEST_F(OtherPrograms, OctaveReadsTablesResultsAndTexts) {
  SKIP_WITHOUT("Octave", "octave-cli --version");
  make_gel();
  const Outcome read = shell(
      "octave-cli --quiet --no-init-file --eval \""
      "f = load('gel.h5'); printf('%.17g %d %.17g %.17g %s\\n', f.tables.stress.t(end), "
      "numel(f.tables.stress.t), f.results.storage_modulus_virial, f.frames.position(2, 1, 1), "
      "class(f.final_state.time))\"");
  ASSERT_EQ(read.code, 0) << read.err;
  const RunFile file = run("gel.h5");
  double time = 0, modulus = 0, y = 0;
  int rows = 0;
  char kind[32] = "";
  ASSERT_EQ(std::sscanf(read.out.c_str(), "%lf %d %lf %lf %31s", &time, &rows, &modulus, &y, kind), 5)
      << read.out;
  EXPECT_EQ(time, file.column("stress", "t").back());
  EXPECT_EQ(rows, file.rows("stress"));
  EXPECT_EQ(modulus, file.value("results", "storage_modulus_virial"));
  EXPECT_EQ(y, file.frame(0).position[0][1]);
  EXPECT_STREQ(kind, "double");
}

TEST_F(OtherPrograms, RReadsEveryArray) {
  SKIP_WITHOUT("R with hdf5r", "Rscript -e 'library(hdf5r)'");
  make_gel();
  write("read.R",
        "suppressMessages(library(hdf5r))\n"
        "f <- H5File$new('gel.h5', 'r')\n"
        "sets <- f$ls(recursive = TRUE)\n"
        "sets <- sets$name[sets$obj_type == 'H5I_DATASET']\n"
        "for (s in sets) { d <- f[[s]]; if (prod(d$dims) > 0 || length(d$dims) == 0) d$read() }\n"
        "cat(length(sets), sprintf('%.17g', sum(f[['tables/stress/t']][])), h5attr(f, 'status'), '\\n')\n");
  const Outcome read = shell("Rscript read.R");
  ASSERT_EQ(read.code, 0) << read.err;
  int sets = 0;
  double sum = 0;
  char status[32] = "";
  ASSERT_EQ(std::sscanf(read.out.c_str(), "%d %lf %31s", &sets, &sum, status), 3) << read.out;
  double expected = 0;
  for (const double t : run("gel.h5").column("stress", "t")) expected += t;
  EXPECT_NEAR(sum, expected, 1e-12 * expected);
  EXPECT_GT(sets, 60);
  EXPECT_STREQ(status, "complete");
}

TEST_F(OtherPrograms, H5repackMakesTheSameRun) {
  SKIP_WITHOUT("h5repack (hdf5-tools)", "h5repack --version");
  make_gel();
  make_jam();
  for (const std::string name : {"gel", "jam"})
    for (const std::string filter : {"-f GZIP=9", "-f NONE", "-l CONTI"}) {
      const Outcome packed = shell("rm -f packed.h5 && h5repack " + filter + " " + name + ".h5 packed.h5");
      EXPECT_EQ(packed.code, 0) << name << ' ' << filter << '\n' << packed.err;
      EXPECT_EQ(shell("h5diff " + name + ".h5 packed.h5").code, 0) << name << ' ' << filter;
      const Outcome was = supple("show --json " + name + ".h5"), is = supple("show --json packed.h5");
      EXPECT_EQ(is.code, 0) << is.err;
      EXPECT_EQ(Json::parse(was.out)["results"], Json::parse(is.out)["results"]);
    }
}

/// Octave and R cannot know that pandas' default parser changes last bits: numpy's does not.
TEST_F(OtherPrograms, NumpyReadsTheTableWithItsUnits) {
  SKIP_WITHOUT("numpy", "/usr/bin/python3 -c 'import numpy'");
  make_gel();
  ASSERT_EQ(supple("export gel.h5 --to csv").code, 0);
  const Outcome read = shell(
      "/usr/bin/python3 -c \"import numpy as np\n"
      "t = np.genfromtxt('gel.csv', delimiter=',', names=True)\n"
      "print(repr(float(t['t_s'][-1])), repr(float(t['shear_stress_virial_Pa'][-2])))\"");
  ASSERT_EQ(read.code, 0) << read.err;
  double time = 0, stress = 0;
  ASSERT_EQ(std::sscanf(read.out.c_str(), "%lf %lf", &time, &stress), 2);
  const std::vector<double> all = run("gel.h5").column("stress", "shear_stress_virial");
  EXPECT_EQ(time, run("gel.h5").column("stress", "t").back());
  EXPECT_EQ(stress, all[all.size() - 2]);
}

}  // namespace
}  // namespace supple
