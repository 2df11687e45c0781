#include "supple/experiment/used_keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "supple/core/error.hpp"
#include "supple/experiment/bodies_of_case.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/key_sets.hpp"

namespace supple {

namespace {

bool has_links(const Case& c) { return c.particles.permanent_links; }
bool has_plateau(const Case& c) { return c.material.elastic_law == "plateau"; }
bool adheres(const Case& c) {
  return c.contact.law == "adhesive" ||
         std::any_of(c.pairs.begin(), c.pairs.end(), [](const auto& pair) { return pair.law == "adhesive"; });
}
bool has_family(const Case& c, std::initializer_list<std::string_view> families) {
  const std::vector<Species> all = species_of(c);
  return std::any_of(all.begin(), all.end(), [&](const Species& s) {
    return std::find(families.begin(), families.end(), s.family) != families.end();
  });
}
bool has_central_share(const Case& c) {
  const std::string& law = c.material.elastic_law;
  return law == "divergent" || law == "plateau" || law == "expression";
}

const std::vector<Need>& needs() {
  using enum Need::Of;
  static const std::vector<Need> all{
      {"initial.keep_time", start, [](const Case&) { return false; }, "a file to start from"},
      {"jamming.search", value,
       [](const Case& c) { return !starts_from_file(c) || c.jamming.search != "pressure"; },
       "particles made from [bodies]: a packing that is given goes on by the root search"},
      {"particles.cut particles.cut_lines particles.edge_fuzziness particles.avoid_horizontal_angle_degree "
       "particles.avoid_height_spanning_particles particles.max_cut_tries particles.cut_top_bottom "
       "particles.remove_link_fraction material.tensile_law material.tensile_range "
       "material.interface_reenforcement_central material.interface_reenforcement_tangential",
       value, has_links, "particles.permanent_links = true"},
      {"particles.edge_fuzziness", value,
       [](const Case& c) { return !has_links(c) || c.particles.cut == "voronoi"; },
       "particles.cut = \"voronoi\""},
      {"particles.avoid_horizontal_angle_degree", value,
       [](const Case& c) { return !has_links(c) || c.particles.cut == "lines"; },
       "particles.cut = \"lines\""},
      {"material.tensile_range", value,
       [](const Case& c) { return !has_links(c) || c.material.tensile_law != "linear"; },
       "material.tensile_law = \"exponential\" or \"saturating\""},
      {"material.elastic_expression", value,
       [](const Case& c) { return c.material.elastic_law == "expression"; },
       "material.elastic_law = \"expression\""},
      {"material.plateau_begin material.plateau_end material.plateau_slope", value, has_plateau,
       "material.elastic_law = \"plateau\""},
      {"material.central_repulsion_coefficient", value, has_central_share,
       "material.elastic_law = \"divergent\", \"plateau\" or \"expression\""},
      {"material.attraction_range", value, [](const Case& c) { return c.material.elastic_law == "adhesive"; },
       "material.elastic_law = \"adhesive\""},
      {"contact.attraction_range", value, adheres, "contact.law = \"adhesive\""},
      {"box.plates", value, [](const Case& c) { return c.box.boundary != "periodic"; },
       "box.boundary = \"lees_edwards\" or \"fixed\""},
      {"bodies.A0 bodies.A0_ratio bodies.A0_ratio_large bodies.k_a bodies.k_l bodies.k_b bodies.gamma "
       "bodies.k_perimeter",
       value, [](const Case& c) { return starts_from_file(c) || has_soft(c); },
       "a family of deformable particles"},
      {"bodies.k_s", value, [](const Case& c) { return starts_from_file(c) || has_family(c, {"network"}); },
       "the family \"network\""},
      {"bodies.E", value,
       [](const Case& c) {
         return starts_from_file(c) || has_family(c, {"network", "elastic"});
       },
       "the family \"elastic\" or \"network\""},
      {"bodies.nu", value, [](const Case& c) { return starts_from_file(c) || has_family(c, {"elastic"}); },
       "the family \"elastic\""},
      {"bodies.vertices bodies.vertex_rule bodies.diameter_ratio bodies.discs", value,
       [](const Case& c) { return starts_from_file(c) || has_polygons(c); },
       "a family of polygons or surfaces"},
      {"bodies.k_v species.k_v", value, [](const Case& c) { return c.bodies.dimensions == 3; },
       "bodies.dim = 3"},
      {"bodies.k_l species.k_l bodies.k_perimeter species.k_perimeter bodies.vertex_rule bodies.discs", value,
       [](const Case& c) { return c.bodies.dimensions == 2; }, "bodies.dim = 2"},
      {"bodies.yield_strain", value, [](const Case& c) { return c.bodies.flow_time > 0; },
       "bodies.flow_time"},
      {"bodies.A0_ratio_large", value, [](const Case& c) { return !has_soft(c) || c.bodies.shape_ratio > 0; },
       "bodies.A0_ratio, that of the small ones"},
      {"time.step_factor", value, [](const Case& c) { return c.time.time_step == 0; },
       "time.step = 0: it multiplies the step that is chosen"},
      {"output.image_format", value, [](const Case& c) { return c.output.images > 0; }, "output.images"},
  };
  return all;
}

/// The key with kind_of_section(): that of "species.2.N" is "species.N".
std::string declared_name(std::string_view key) {
  const std::string kind = kind_of_section(section_of(key));
  return (kind.empty() ? "" : kind + ".") + std::string(key.substr(key.rfind('.') + 1));
}

/// Whether `keys`, with spaces between, names the key.
bool names(std::string_view keys, std::string_view key) {
  return fmt::format(" {} ", keys).find(fmt::format(" {} ", declared_name(key))) != std::string::npos;
}

/// Of entries "section.*", "section.key" and, to take one out again, "-section.key", the last that fits
/// decides.
bool declares(const UsedKeys& entries, std::string_view key) {
  const std::string name = declared_name(key), section = name.substr(0, name.rfind('.') + 1);
  bool used = false;
  for (std::string_view entry : entries) {
    const bool out = entry.starts_with('-');
    if (out) entry.remove_prefix(1);
    const bool all = entry.ends_with(".*");
    if (all ? !section.empty() && entry.substr(0, entry.size() - 1) == section : entry == name) used = !out;
  }
  return used;
}

/// The experiment of the case; null where it names none.
const Experiment* experiment_or_none(const Case& c) {
  for (const Experiment& e : experiments())
    if (e.name == c.general.experiment) return &experiment_of(c);
  return nullptr;
}

/// The need of this kind that is not met.
const Need* unmet(const Case& c, std::string_view key, Need::Of of) {
  const auto find = [&](const std::vector<Need>& among) -> const Need* {
    for (const Need& need : among)
      if (need.of == of && names(need.keys, key) && !need.met(c)) return &need;
    return nullptr;
  };
  const Experiment* e = experiment_or_none(c);
  const Need* of_experiment = e ? find(e->needs) : nullptr;
  return of_experiment ? of_experiment : find(needs());
}

/// Whether the key is one of the runs that start from what this experiment leaves.
bool is_of_next(const Case& c, std::string_view key) {
  const Experiment* e = experiment_or_none(c);
  const Experiment* next = e ? find_experiment(e->next, *e->matter) : nullptr;
  return next && declares(next->keys, key);
}

std::string described(const Case& c) {
  std::string text = fmt::format("experiment = \"{}\"", c.general.experiment);
  const Experiment* e = experiment_or_none(c);
  Case plain;
  plain.general.experiment = c.general.experiment;
  if (e && e != &experiment_of(plain)) text += fmt::format(" of {}", e->matter->name);
  return text;
}

/// A key of the same name in another section that the experiment uses, or else who uses the key.
std::string advice(const Case& c, std::string_view key) {
  const std::string_view name = key.substr(key.rfind('.') + 1);
  std::vector<std::string> here;
  for_each_key(c, [&](const std::string& other, const auto& field, const auto&) {
    if (field.name == name && other != key && uses(c, other)) here.push_back(other);
  });
  if (!here.empty()) return fmt::format("leave it away; here it is {}", fmt::join(here, ", "));
  for (const Experiment& e : experiments())
    if (e.name == c.general.experiment && declares(e.keys, key))
      return fmt::format("leave it away; it is used with physics = \"{}\"", e.matter->physics);
  return fmt::format("leave it away; it is used by {}", fmt::join(users_of(key), ", "));
}

}  // namespace

UsedKeys with(UsedKeys common, const UsedKeys& more) {
  common.insert(common.end(), more.begin(), more.end());
  return common;
}

std::vector<std::string> sections_of(const Case& c) {
  std::vector<std::string> sections;
  for_each_key(c, [&](const std::string& key, const auto&, const auto&) {
    const std::string section(section_of(key));
    if ((sections.empty() || sections.back() != section) && uses(c, key)) sections.push_back(section);
  });
  return sections;
}

bool uses(const Case& c, std::string_view key) {
  const Experiment* e = experiment_or_none(c);
  return e && declares(e->keys, key);
}

std::vector<std::string> users_of(std::string_view key) {
  std::vector<std::string> users;
  for (const Experiment& e : experiments())
    if (declares(e.keys, key) && (users.empty() || users.back() != e.name)) users.push_back(e.name);
  return users;
}

std::vector<std::string> find_useless_keys(const Case& c, Start start) {
  const Case defaults;
  std::vector<std::string> problems;
  for_each_key(c, [&](const std::string& key, const auto& field, const auto& section) {
    const auto is_default = [&](auto member) {
      bool same = false;
      for_each_section(defaults, [&](std::string_view, const auto& of_defaults) {
        if constexpr (std::is_same_v<decltype(of_defaults), decltype(section)>)
          same = of_defaults.*member == section.*member;
      });
      return same;
    };
    if (!c.is_given(key) || std::visit(is_default, field.member)) return;
    const bool used = uses(c, key);
    const Need* lacking = used && start == Start::nothing ? unmet(c, key, Need::Of::start) : nullptr;
    if (used ? !lacking : is_of_next(c, key)) return;
    const std::string place = c.origin.empty() ? "" : c.origin + ": ";
    if (lacking)
      problems.push_back(input_error(fmt::format("{}{} has no effect", place, key),
                                     fmt::format("it needs {}", lacking->needed), "leave it away")
                             .what());
    else
      problems.push_back(input_error(fmt::format("{}{} has no effect", place, key),
                                     fmt::format("{} does not use it", described(c)), advice(c, key))
                             .what());
  });
  return problems;
}

std::vector<std::string> find_idle_keys(const Case& c) {
  std::vector<std::string> idle;
  for (const std::string& key : c.given) {
    if (!uses(c, key)) {
      if (is_of_next(c, key))
        idle.push_back(
            fmt::format("{} has no effect on {}: it is of the runs that start from it", key, described(c)));
    } else if (const Need* need = unmet(c, key, Need::Of::value)) {
      idle.push_back(fmt::format("{} has no effect without {}", key, need->needed));
    }
  }
  return idle;
}

}  // namespace supple
