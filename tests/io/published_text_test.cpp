#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <regex>

#include "supple/compat/particleshear/text.hpp"
#include "supple/experiment/initial_state.hpp"
#include "supple/io/run/file_recorder.hpp"
#include "tests/io/sample_run.hpp"
#include "tests/io/temporary_folder.hpp"
#include "tests/package/reference.hpp"

namespace supple {
namespace {

using namespace supple::testing;
using ::testing::HasSubstr;

/// A text written by the published package (the header and the first 130 rows).
const std::string& sample() {
  static const std::string text = read_gzip(reference_path("sample_output.txt.gz"));
  return text;
}

/// The number that follows `label` in the sample.
double sample_number(const std::string& label) {
  const std::size_t at = sample().find(label);
  if (at == std::string::npos) throw std::runtime_error("no '" + label + "' in the sample");
  return std::stod(sample().substr(at + label.size()));
}

/// The number in SI whose conversion by `unit` gives exactly the sample's.
double in_si(double x, double unit) {
  double si = x * unit;
  while (si / unit < x) si = std::nextafter(si, INFINITY);
  while (si / unit > x) si = std::nextafter(si, -INFINITY);
  return si;
}

Case sample_call() {
  Case c;
  c.general.physics = "particleshear-1.0.2";
  c.particles.cut_lines = 3;
  c.particles.discs = 16;
  c.material.density = 50;
  c.shear.relative_frequency = 0.5;
  c.shear.pre_periods = c.shear.periods = c.shear.post_periods = 1;
  c.output.image_format = "jpg";
  return c;
}

const std::map<std::string, std::string>& table_names() {
  static const std::map<std::string, std::string> names{
      {"t", "t"},
      {"strain", "strain"},
      {"strain_rate", "strain_rate"},
      {"stress_measured_at_surface", "shear_stress_external"},
      {"shear_stress_internal_stress-tensor", "shear_stress_internal"},
      {"stress_tensor_Love_Weber", "love_weber"},
      {"stress_tensor_peculiar_acceleration_otsuki", "otsuki"},
      {"stress_tensor_from_external_forces", "external"},
      {"stress_tensor_linear_acceleration", "linear_acceleration"},
      {"stress_tensor_tangential_torque", "tangential_torque"},
      {"stress_tensor_internal_tangential_torque", "internal_torque"},
      {"stress_tensor_centrifugal", "centrifugal"},
      {"stress_tensor_overall", "overall"}};
  return names;
}

void record_table(Recorder& to) {
  std::stringstream text(sample().substr(sample().find("index\t")));
  std::string line;
  std::getline(text, line);
  std::vector<Column> columns;
  std::vector<bool> taken;
  for (const std::string& name : split(line, '\t')) {
    const bool component = std::regex_search(name, std::regex("_[01][01]$"));
    const std::string end = component ? name.substr(name.size() - 3) : "";
    const auto at = table_names().find(name.substr(0, name.size() - end.size()));
    taken.push_back(at != table_names().end());
    if (taken.back()) columns.push_back({at->second + end, "", ""});
  }
  to.declare("stress", columns);
  while (std::getline(text, line)) {
    const auto cells = split(line, '\t');
    std::vector<double> row;
    for (std::size_t k = 0; k < cells.size(); ++k)
      if (taken[k]) row.push_back(std::stod(cells[k]));
    to.append("stress", row);
  }
}

/// A run with the numbers of the sample.
void record_sample_text(Recorder& to) {
  RunInfo<2> info;
  info.units = particleshear_units();
  info.box.length = {500, 500};
  info.radius.assign(16, 60);
  info.radius[3] = sample_number("r2=");
  info.mass.assign(16, sample_number("identical mass="));
  info.inertia.assign(16, 1);
  info.particle.assign(16, 0);
  to.begin(info);
  const auto value = [&](const char* group, const char* name, double x) {
    to.value(group, {name, "", ""}, x);
  };
  value("constants", "mean_mass", in_si(sample_number("Particle mass m = "), 1e-6));
  value("constants", "link_spring_constant", in_si(sample_number("Characteristic spring constant = "), 1e-6));
  value("constants", "time_constant", sample_number("Characteristic time constant = "));
  value("constants", "frequency", sample_number("Frequency = "));
  value("constants", "time_step", sample_number("Time step = "));
  value("constants", "damping_factor", sample_number("Damping factor = "));
  value(material_group, "k", sample_number("Central spring constant k = "));
  value(material_group, "nu", sample_number("Central viscosity constant nu = "));
  value(material_group, "k_t", sample_number("Lateral spring constant k_t = "));
  value(material_group, "nu_t", sample_number("Lateral viscosity constant nu_t = "));
  value(material_group, "mu", 0.01);
  value(material_group, "permanent_ratio_central", 1);
  value(material_group, "permanent_ratio_tangential", 1);
  value("results", "in_phase_stress_internal", sample_number("In phase stress = "));
  value("results", "out_of_phase_stress_internal", sample_number("Out of phase stress = "));
  value("results", "storage_modulus_internal", sample_number("\nG'="));
  value("results", "loss_modulus_internal", sample_number("\nG''="));
  value("results", "storage_modulus_external", sample_number("G'(by surface force)="));
  value("results", "loss_modulus_external", sample_number("G''(by surface force)="));
}

class PublishedText : public TemporaryFolder {
 protected:
  /// The text of a run of `c`, the folder in it replaced by that of the sample.
  std::string text_of(const Case& c, bool table = true) const {
    FileRecorder to(in_folder("run.h5"), c, "");
    record_sample_text(to);
    if (table) record_table(to);
    else to.declare("stress", {{"t", "", ""}});
    to.finish("complete");
    export_published_text(RunFile(in_folder("run.h5")), in_folder("run.txt"));
    std::string text = content_of(in_folder("run.txt"));
    const std::string folder = "root_folder=" + in_folder("");
    const std::size_t at = text.find(folder.substr(0, folder.size() - 1));
    return at == std::string::npos ? text : text.replace(at, folder.size() - 1, "root_folder=out");
  }
};

TEST_F(PublishedText, TheSampleByteForByte) {
  const std::string text = text_of(sample_call());
  const auto lines = split(text, '\n'), expected = split(sample(), '\n');
  ASSERT_EQ(lines.size(), expected.size());
  for (std::size_t k = 0; k < lines.size(); ++k) ASSERT_EQ(lines[k], expected[k]) << "line " << k + 1;
  EXPECT_EQ(text, sample());
}

TEST_F(PublishedText, ControlsHaveTheirOwnTitles) {
  Case c = sample_call();
  c.particles.permanent_links = false;
  EXPECT_THAT(text_of(c),
              ::testing::StartsWith("Dermal filler control ensemble: No permanent links\n\tN=16 spheres"));
}

TEST_F(PublishedText, BulkControl) {
  Case c = sample_call();
  c.particles.cut_lines = 0;
  EXPECT_THAT(text_of(c),
              ::testing::StartsWith("Dermal filler control ensemble: no cut lines \n\tN=16 spheres"));
}

TEST_F(PublishedText, WithoutTensorsItSaysSo) {
  EXPECT_THAT(
      text_of(sample_call(), false),
      ::testing::EndsWith(
          "Detailed stress tensor data\n\tNot saving detailed stress tensor data. If you wish to save "
          "this data, pass\n\t  saveStressTensorData=True"));
}

TEST_F(PublishedText, ARunWithoutResultsIsAnError) {
  FileRecorder to(in_folder("run.h5"), sample_call(), "");
  record_sample(to, 3, 2);
  to.finish("interrupted");
  EXPECT_THAT(
      file_error_of([&] { export_published_text(RunFile(in_folder("run.h5")), in_folder("run.txt")); }),
      HasSubstr("has no number"));
  EXPECT_FALSE(std::filesystem::exists(in_folder("run.txt")));
}

TEST_F(PublishedText, FilesAreNamedAsByThePackage) {
  FileRecorder to(in_folder("run.h5"), sample_call(), "");
  record_sample_text(to);
  to.finish("complete");
  const RunFile run(in_folder("run.h5"));
  const std::string first = in_folder("dermal_filler0.01_f_25888.3455_strain_0.2_nr_1.txt");
  EXPECT_EQ(published_text_path(run, in_folder("").substr(0, in_folder("").size() - 1)), first);
  write_content(first, "");
  EXPECT_THAT(published_text_path(run, in_folder(".")), ::testing::EndsWith("_nr_2.txt"));
}

}  // namespace
}  // namespace supple
