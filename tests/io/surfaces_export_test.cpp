/// Runs in three dimensions in the files of other programs. Where one is missing its test is skipped.
#include <gmock/gmock.h>
#include <sys/wait.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "supple/draw/scene/frame_scene.hpp"
#include "supple/geometry/mesh_measures.hpp"
#include "supple/io/export/csv.hpp"
#include "supple/io/export/trajectory.hpp"
#include "tests/io/count_of.hpp"
#include "tests/io/same_mesh.hpp"
#include "tests/io/surfaces_run.hpp"
#include "tests/io/temporary_folder.hpp"
#include "tests/paths.hpp"

namespace supple {
namespace {

using namespace testing;
using ::testing::HasSubstr;
using Json = nlohmann::json;

constexpr int sphere_site = 12, all_sites = 12 + 1 + 42, all_faces = 20 + 80;

class SurfacesExport : public TemporaryFolder {
 protected:
  const RunFile file = record_surfaces(in_folder("run.h5"));

  bool python_runs(const std::string& script) {
    const std::string line = "cd '" + folder() + "' && /usr/bin/python3 " + script + " >out.txt 2>err.txt";
    const int status = std::system(line.c_str());
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }
  Json answer_of(const std::string& script) {
    EXPECT_TRUE(python_runs(script)) << content_of(in_folder("err.txt"));
    return Json::parse(content_of(in_folder("out.txt")));
  }
  std::string error_of(const std::function<void()>& act) const {
    try {
      act();
    } catch (const Error& e) {
      return e.what();
    }
    return "";
  }
};

Vec3 vector_of(const Json& x) { return {x.at(0), x.at(1), x.at(2)}; }

void expect_same_bits(const Json& values, const std::vector<Vec3>& expected) {
  std::vector<Vec3> read;
  for (const Json& value : values) read.push_back(vector_of(value));
  expect_same({read, {}}, {expected, {}});
}

class SurfacesInVtk : public SurfacesExport {
 protected:
  void SetUp() override {
    if (!python_runs("-c 'import vtkmodules.vtkIOXML'"))
      GTEST_SKIP() << "VTK (python3-vtk9) is not installed";
    export_vtp(file, in_folder("a.pvd"));
  }
  Json frame_in_vtk(int k) {
    return answer_of(SUPPLE_SOURCE_DIR "/tests/io/read_vtp.py a_frames/frame000000" + std::to_string(k) +
                     ".vtp");
  }
};

/// Bodies that have left the cell stay where they are.
TEST_F(SurfacesInVtk, HaveTheSameVerticesFacesAndOrientation) {
  const RunInfo<3> info = file.info<3>();
  for (int k = 0; k < 2; ++k) {
    const Json mesh = frame_in_vtk(k);
    const Frame<3> frame = file.frame<3>(k);
    expect_same_bits(mesh["points"], frame.position);
    ASSERT_EQ(mesh["polygons"].size(), 1u + all_faces);
    EXPECT_EQ(mesh["others"], 1);
    EXPECT_EQ(mesh["polygons"][0], Json::array({sphere_site}));
    TriangleMesh read{frame.position, {}};
    for (int f = 1; f <= all_faces; ++f) {
      ASSERT_EQ(mesh["polygons"][f].size(), 3u);
      read.face.push_back(mesh["polygons"][f]);
    }
    EXPECT_EQ(read.face, info.facet);
    System<3> system = surfaces_and_sphere();
    EXPECT_NEAR(enclosed_volume(read),
                enclosed_volume(mesh_of(system, 0)) + enclosed_volume(mesh_of(system, 2)), 1e-12);
  }
}

TEST_F(SurfacesInVtk, HaveTheNumbersOfVerticesAndParticles) {
  const Json mesh = frame_in_vtk(1);
  const Frame<3> frame = file.frame<3>(1);
  const RunInfo<3> info = file.info<3>();
  const Json &points = mesh["of_points"], &cells = mesh["of_cells"];
  EXPECT_EQ(points.size(), 4u);
  expect_same_bits(points["velocity"]["values"], frame.velocity);
  expect_same_bits(points["force"]["values"], frame.force);
  for (int i = 0; i < all_sites; ++i) {
    EXPECT_EQ(points["site"]["values"][i][0], i);
    EXPECT_EQ(points["radius"]["values"][i][0].get<double>(), info.radius[i]);
  }
  ASSERT_EQ(cells.size(), 3 + frame.body.size());
  for (int c = 0; c <= all_faces; ++c) {
    const int body = c == 0 ? 1 : c <= 20 ? 0 : 2;  // the sphere is a vertex, and these come first
    EXPECT_EQ(cells["id"]["values"][c][0], body);
    EXPECT_EQ(cells["sites"]["values"][c][0], std::vector<int>({12, 1, 42})[body]);
    EXPECT_EQ(cells["radius"]["values"][c][0].get<double>(), info.radius[info.body_begin[body]]);
    for (const auto& [name, values] : frame.body)
      EXPECT_EQ(cells[name]["values"][c][0].get<double>(), values[body]) << name;
  }
}

TEST_F(SurfacesInVtk, HaveTimeCellAndNumbersOfAll) {
  const Json of_all = frame_in_vtk(1)["of_all"];
  EXPECT_EQ(of_all.size(), 5u);
  EXPECT_EQ(of_all["TimeValue"]["values"], Json::parse("[[0.25]]"));
  EXPECT_EQ(of_all["pressure"]["values"][0][0].get<double>(), 1.0 / 7 + 0.25);
  const double lean = (1 - 4.2 / 3) * 3;  // the least of the strains with this lattice
  const std::vector<Vec3> edges{{4.2, 0, 0}, {lean, 3, 0}, {0, 0, 3.3}};
  ASSERT_EQ(of_all["cell"]["values"].size(), 3u);
  for (int d = 0; d < 3; ++d)
    EXPECT_NEAR(norm(vector_of(of_all["cell"]["values"][d]) - edges[d]), 0, 1e-14) << d;
  EXPECT_NEAR(norm(vector_of(of_all["cell_origin"]["values"][0]) - Vec3{-0.5 * lean, 0, 0}), 0, 1e-14);
}

TEST_F(SurfacesExport, VtpIsACollectionOfTrianglesByTime) {
  export_vtp(file, in_folder("a.pvd"));
  const std::string pvd = content_of(in_folder("a.pvd"));
  EXPECT_EQ(count_of(pvd, "timestep=\"0\""), 1);
  EXPECT_EQ(count_of(pvd, "timestep=\"0.25\" group=\"\" part=\"0\" file=\"a_frames/frame0000001.vtp\""), 1);
  export_vtp(file, in_folder("b.pvd"), Existing::refuse, Cells::triangles);
  for (const char* name : {"/frame0000000.vtp", "/frame0000001.vtp"})
    EXPECT_EQ(content_of(in_folder("a_frames") + name), content_of(in_folder("b_frames") + name));
}

TEST_F(SurfacesExport, WhatIsOfThePlaneIsRefused) {
  const std::size_t before = files();
  EXPECT_THAT(error_of([&] { export_vtp(file, in_folder("a.pvd"), Existing::refuse, Cells::outlines); }),
              ::testing::AllOf(HasSubstr("no outlines"), HasSubstr("--cells triangles")));
  EXPECT_THAT(error_of([&] { export_trajectory(file, in_folder("a.csv")); }),
              HasSubstr("is a run in three dimensions"));
  EXPECT_EQ(files(), before);
}

TEST_F(SurfacesExport, ContactsHaveThreeComponentsOfForce) {
  export_contacts(file, in_folder("a.csv"));
  std::istringstream text(content_of(in_folder("a.csv")));
  std::string line;
  std::getline(text, line);
  EXPECT_EQ(line,
            "frame,t,first,second,state,elongation,normal_force,elastic_force,viscous_force,tangential_force,"
            "force_on_first_x,force_on_first_y,force_on_first_z");
  for (int k = 0; k < 2; ++k) {
    const Frame<3> frame = file.frame<3>(k);
    ASSERT_GT(frame.contacts.size(), 2u);
    for (const ContactRow<3>& c : frame.contacts) {
      ASSERT_TRUE(std::getline(text, line));
      std::vector<std::string> cell;
      std::istringstream row(line);
      for (std::string part; std::getline(row, part, ',');) cell.push_back(part);
      ASSERT_EQ(cell.size(), 13u);
      EXPECT_EQ(cell[0], std::to_string(k));
      EXPECT_EQ(std::stod(cell[1]), frame.time);
      EXPECT_EQ(cell[2] + " " + cell[3], std::to_string(c.first) + " " + std::to_string(c.second));
      EXPECT_EQ(std::stod(cell[6]), c.normal_force);
      for (int d = 0; d < 3; ++d) EXPECT_EQ(std::stod(cell[10 + d]), c.force[d]);
    }
  }
  EXPECT_FALSE(std::getline(text, line));
}

/// Positions stay where they are; the vectors of the lattice are rows.
TEST_F(SurfacesExport, AseReadsEverySite) {
  if (!python_runs("-c 'import ase.io'")) GTEST_SKIP() << "ASE (python3-ase) is not installed";
  export_xyz(file, in_folder("a.xyz"));
  const Json frames = answer_of(
      "-c \"import ase.io, json\n"
      "print(json.dumps([{'x': f.positions.tolist(), 'cell': f.cell.tolist(), 'pbc': f.pbc.tolist(),"
      " 'info': {k: float(v) for k, v in f.info.items() if k != 'Origin'},"
      " 'origin': list(map(float, f.info['Origin'])),"
      " 'type': [str(t) for t in f.arrays['type']],"
      " **{k: f.arrays[k].tolist() for k in ('velo', 'force', 'radius', 'id', 'molecule', 'stress_xz')}}"
      " for f in ase.io.read('a.xyz', ':')]))\"");
  ASSERT_EQ(frames.size(), 2u);
  const RunInfo<3> info = file.info<3>();
  for (int k = 0; k < 2; ++k) {
    const Json& read = frames[k];
    const Frame<3> frame = file.frame<3>(k);
    expect_same_bits(read["x"], frame.position);
    expect_same_bits(read["velo"], frame.velocity);
    expect_same_bits(read["force"], frame.force);
    EXPECT_EQ(read["radius"], Json(info.radius));
    EXPECT_EQ(read["molecule"], Json(info.particle));
    for (int i = 0; i < all_sites; ++i) {
      const int body = i < 12 ? 0 : i == 12 ? 1 : 2;
      EXPECT_EQ(read["id"][i], i);
      EXPECT_EQ(read["type"][i], std::vector<std::string>({"surface1", "sphere2", "surface3"})[body]);
      EXPECT_EQ(read["stress_xz"][i].get<double>(), frame.body.at("stress_xz")[body]);
    }
    EXPECT_EQ(read["pbc"], Json({true, true, true}));
    EXPECT_EQ(read["info"]["Time"].get<double>(), frame.time);
    EXPECT_EQ(read["info"]["pressure"].get<double>(), frame.numbers.at("pressure"));
    const double lean = frame.strain * frame.length[1] - 4.2;
    const Vec3 edges[] = {{4.2, 0, 0}, {lean, frame.length[1], 0}, {0, 0, 3.3}};
    for (int d = 0; d < 3; ++d) EXPECT_NEAR(norm(vector_of(read["cell"][d]) - edges[d]), 0, 1e-14) << k << d;
    EXPECT_NEAR(norm(vector_of(read["origin"]) - Vec3{-0.5 * lean, 0, 0}), 0, 1e-14);
  }
}

TEST_F(SurfacesExport, ArraysThatDoNotFitAreRefusedAndLeaveNoFile) {
  const auto message = [&](const std::function<void(BodyScene<3>&)>& change) {
    BodyScene<3> scene = body_scene_of(file.info<3>(), file.frame<3>(0));
    change(scene);
    return error_of([&] { write_vtp(in_folder("a.vtp"), scene); });
  };
  const std::size_t before = files();
  EXPECT_THAT(message([](auto& s) { s.facet[3][1] = all_sites; }), HasSubstr("a site that is not there"));
  EXPECT_THAT(message([](auto& s) { s.facet[3][1] = -1; }), HasSubstr("a site that is not there"));
  EXPECT_THAT(message([](auto& s) { s.facet[3][1] = 20; }), HasSubstr("joins bodies 0 and 2"));
  EXPECT_THAT(message([](auto& s) { s.facet.resize(20); }), HasSubstr("body 2 has no triangles"));
  EXPECT_THAT(message([](auto& s) { s.facet.push_back({12, 12, 12}); }), HasSubstr("body 1 is one site"));
  EXPECT_THAT(message([](auto& s) { s.begin = {0, 12, 15, all_sites}; }), HasSubstr("body 1 has 3 sites"));
  EXPECT_EQ(files(), before);
  EXPECT_EQ(message([](auto&) {}), "");
}

}  // namespace
}  // namespace supple
