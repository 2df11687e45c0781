/// Every key of a case does something, or it is refused.
#include "supple/experiment/used_keys.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "supple/core/error.hpp"
#include "supple/experiment/experiments.hpp"
#include "tests/experiment/error_of.hpp"

namespace supple {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// A small case of each experiment, of each kind of matter and physics that it is about.
std::vector<Case> every_kind() {
  std::vector<Case> kinds;
  for (const Experiment& e : experiments()) {
    Case c;
    c.general.experiment = e.name;
    c.particles.discs = 12;
    c.particles.cut_lines = 0;
    c.shear.relative_frequency = 0.5;
    c.shear.pre_periods = c.shear.post_periods = 0;
    c.shear.periods = 1;
    c.bodies.count = 10;
    c.bodies.vertices = 6;
    c.bodies.size_ratio = 1.2;
    c.jamming.packing_fraction = 0.5;
    c.jamming.step = 0.05;
    c.jamming.pressure = 1e-2;
    c.jamming.window = 0.5;
    c.compression.highest_pressure = 3e-2;
    c.compression.per_decade = 1;
    c.uniaxial.packing_fraction = 0.3;
    c.uniaxial.pressure = 1e-3;
    c.uniaxial.strain = c.uniaxial.step = 0.01;
    c.slump.settle_time = c.slump.spread_time = 1;
    c.slump.width = 4;
    if (e.name == "dynamics") c.time.steps = 20;
    if (e.name == "friction") c.bodies.count = 2;
    if (e.name == "plate_compression") c.bodies.count = 1;
    c.general.physics = e.matter->physics;
    resolve_family(c);
    kinds.push_back(c);
  }
  return kinds;
}

std::string name_of(const Case& c) { return c.general.experiment + ", " + c.general.physics; }

/// Another value of the key, not its default, that is valid by itself; and the key as given.
void change(Case& c, const std::string& wanted) {
  for_each_key(c, [&](const std::string& key, const auto& field, auto& section) {
    if (key != wanted) return;
    std::visit(
        [&](auto member) {
          auto& value = section.*member;
          using Value = std::decay_t<decltype(value)>;
          if constexpr (std::is_same_v<Value, std::string>) {
            if (key == "shear.rate") value = "1e4";
            else if (field.choices.empty()) value = "other";
            else value = field.choices[field.choices[0] == value ? 1 : 0];
          } else if constexpr (std::is_same_v<Value, bool>) {
            value = !value;
          } else if constexpr (std::is_integral_v<Value>) {
            value += key == "bodies.dim" ? 1 : 2;
          } else {
            const double before = value;
            for (const double other : {0.5 * before, 2 * before, key == "time.step" ? 1e-7 : 0.01})
              if (field.range.contains(other) && other != before) {
                value = other;
                break;
              }
          }
        },
        field.member);
  });
  c.given.insert(wanted);
}

std::vector<std::string> all_keys() {
  std::vector<std::string> keys;
  const Case defaults;
  for_each_key(defaults, [&](const std::string& key, const auto&, const auto&) { keys.push_back(key); });
  return keys;
}

/// Everything that a run computes, or how it failed. Not what it hands on without using it: the group
/// "protocol".
std::string outcome(const Case& c) {
  try {
    std::string text;
    for (const Derived& d : derive(c, nullptr)) text += fmt::format("{} {}\n", d.name.name, d.value);
    MemoryRecorder r;
    run(c, nullptr, r);
    for (const auto& [name, table] : r.tables)
      for (const auto& row : table.rows)
        for (const double x : row) text += fmt::format("{} ", x);
    for (const auto& [group, values] : r.values)
      for (const auto& v : values)
        if (group != protocol_group && v.name.name != "cpu_time")
          text += fmt::format("{} {} {}\n", v.name.name, v.value, v.error);
    for (const Frame<2>& f : r.frames) text += fmt::format("frame {}\n", f.time);
    for (const Vec2& x : r.last_system.state.position) text += fmt::format("{} {} ", x[0], x[1]);
    for (const Vec2& v : r.last_system.state.velocity) text += fmt::format("{} {} ", v[0], v[1]);
    return text + fmt::format("{}", r.last_system.box.strain);
  } catch (const Error& e) {
    return std::string("error: ") + e.what();
  }
}

TEST(UsedKeys, EveryKeyIsUsedBySomeExperiment) {
  for (const std::string& key : all_keys()) EXPECT_THAT(users_of(key), Not(IsEmpty())) << key;
}

TEST(UsedKeys, WhatNoExperimentUsesIsRefusedByName) {
  for (const Case& kind : every_kind()) {
    EXPECT_EQ(error_of(kind), "no error") << name_of(kind);
    for (const std::string& key : all_keys()) {
      // They ask for other particles.
      if (uses(kind, key) || key == "initial.packing" || key == "bodies.dim") continue;
      Case c = kind;
      change(c, key);
      const std::string expected = key + " has no effect";
      if (c.general.experiment == "preparation" && error_of(c) == "no error")
        EXPECT_THAT(find_doubts(c), Contains(HasSubstr(expected))) << name_of(kind);
      else EXPECT_THAT(error_of(c), HasSubstr(expected)) << name_of(kind);
    }
  }
}

/// All at once, past the check: were one of them read, something would differ.
TEST(UsedKeys, WhatIsRefusedWouldChangeNothing) {
  for (const Case& kind : every_kind()) {
    Case c = kind;
    for (const std::string& key : all_keys())
      if (!uses(kind, key) && !key.starts_with("initial.")) change(c, key);
    c.given = kind.given;
    EXPECT_EQ(outcome(c), outcome(kind)) << name_of(kind);
  }
}

TEST(UsedKeys, KeysAtTheirDefaultSayNothing) {
  Case c;
  c.given = {"shear.rate", "time.steps", "jamming.pressure"};
  EXPECT_EQ(error_of(c), "no error");
}

TEST(UsedKeys, TheMessageNamesTheKeyThatCounts) {
  Case c;
  c.origin = "gel.toml";
  c.general.experiment = "jamming";
  resolve_family(c);
  c.particles.discs = 7;
  c.material.friction = 0.3;
  c.given = {"particles.N", "material.friction"};
  EXPECT_THAT(
      error_of(c),
      HasSubstr("gel.toml: particles.N has no effect (experiment = \"jamming\" does not use it); leave "
                "it away; here it is bodies.N"));
  EXPECT_THAT(
      error_of(c),
      HasSubstr("gel.toml: material.friction has no effect (experiment = \"jamming\" does not use it); "
                "leave it away; it is used by oscillatory_shear, preparation, dynamics"));
}

TEST(UsedKeys, DeformableParticlesAreNotPreparedAsMicrogels) {
  Case c;
  c.general.experiment = "preparation";
  c.general.physics = "deformable";
  c.given = {"physics"};
  EXPECT_THAT(error_of(c), HasSubstr("physics = \"deformable\" with experiment = \"preparation\""));
  EXPECT_THAT(error_of(c), HasSubstr("choose another experiment: oscillatory_shear, dynamics, jamming"));
}

TEST(UsedKeys, WhatNeedsAFileIsRefusedWithoutOne) {
  Case c;
  c.general.experiment = "dynamics";
  c.general.physics = "deformable";
  c.initial.keep_time = true;
  c.contact.floor_friction = 0.5;
  c.time.steps = 3;
  c.given = {"physics", "initial.keep_time", "contact.floor_friction", "time.steps"};
  EXPECT_THAT(error_of(c), HasSubstr("initial.keep_time has no effect (it needs a file to start from)"));
  EXPECT_THAT(error_of(c), HasSubstr("contact.floor_friction has no effect (it needs walls"));
  c.initial.state = "heap.h5";
  EXPECT_EQ(error_of(c), "no error");
}

/// Those that once passed as sound.
TEST(UsedKeys, KeysOfOtherProtocolsAreRefused) {
  const auto error_with = [](const std::string& experiment, const std::string& key, auto set) {
    Case c;
    c.general.experiment = experiment;
    set(c);
    c.given.insert(key);
    resolve_family(c);
    return error_of(c);
  };
  EXPECT_THAT(error_with("oscillatory_shear", "shear.rate", [](Case& c) { c.shear.rate = "((("; }),
              HasSubstr("shear.rate has no effect (experiment = \"oscillatory_shear\" does not use it)"));
  EXPECT_THAT(error_with("oscillatory_shear", "time.steps", [](Case& c) { c.time.steps = 5; }),
              HasSubstr("time.steps has no effect"));
  EXPECT_THAT(error_with("oscillatory_shear", "bodies.N", [](Case& c) { c.bodies.count = 5; }),
              HasSubstr("leave it away; here it is particles.N"));
  EXPECT_THAT(error_with("jamming", "material.friction", [](Case& c) { c.material.friction = 1; }),
              HasSubstr("material.friction has no effect"));
  EXPECT_THAT(error_with("jamming", "output.frames", [](Case& c) { c.output.frames = 5; }),
              HasSubstr("output.frames has no effect (experiment = \"jamming\" does not use it)"));
  EXPECT_THAT(error_with("slump", "motion.kinetic_energy", [](Case& c) { c.motion.kinetic_energy = 5; }),
              HasSubstr("motion.kinetic_energy has no effect"));
}

}  // namespace
}  // namespace supple
