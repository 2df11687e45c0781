#include "supple/io/state/packing_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "supple/io/state/held_keys_json.hpp"
#include "supple/io/state/packing_layout.hpp"

namespace supple {

namespace {

bool is_relative(const JsonNode& root, const char* key) {
  if (!root.has(key)) return true;
  const JsonNode kind = root.at(key);
  const std::string name = kind.text();
  if (name != "relative" && name != "absolute")
    throw kind.fault("is \"" + name + "\", not relative or absolute");
  return name == "relative";
}

/// The file as one particle, or its list of them; nothing is copied.
class ListedParticles {
 public:
  explicit ListedParticles(const JsonNode& root)
      : root_(root), alone_(!root.has("particles") && (root.has("vertices") || root.has("faces"))) {
    if (!alone_ && root.at("particles").size() == 0) throw root.at("particles").fault("is empty");
  }
  bool is_one_alone() const { return alone_; }
  std::size_t size() const { return alone_ ? 1 : root_.at("particles").size(); }
  JsonNode operator[](std::size_t b) const { return alone_ ? root_ : root_.at("particles")[b]; }
  bool any_surface() const {
    for (std::size_t b = 0; b < size(); ++b)
      if (is_surface((*this)[b])) return true;
    return false;
  }
  /// What the points of the first particle say.
  int dimensions() const {
    const JsonNode first = (*this)[0];
    if (is_surface(first)) return 3;
    if (!first.has("x")) return 2;
    const JsonNode x = first.at("x");
    return x.is_list() && x.size() > 0 && x[0].is_list() && x[0].size() == 3 ? 3 : 2;
  }

 private:
  static bool is_surface(const JsonNode& particle) {
    return particle.has("vertices") || particle.has("faces");
  }

  JsonNode root_;
  bool alone_;
};

/// Stiffnesses of shapes and contacts. An object "stiffness" has them all, absolute; otherwise they stand in
/// the file, and the texts "stiffness" and "contact_stiffness" say what they mean.
template <int Dim>
void read_stiffnesses(const JsonNode& root, const ListedParticles& particles, ShapeSpec& spec,
                      Harmonic& contact) {
  const bool in_object = root.has("stiffness") && root.at("stiffness").json().is_object();
  const JsonNode from = in_object ? root.at("stiffness") : root;
  if (in_object)
    from.expect_only([] {
      std::vector<std::string> names{"k_c"};
      ShapeSpec any;
      for_each_stiffness<Dim>(any, [&](const char* name, double) { names.emplace_back(name); });
      return names;
    }());
  const bool needed = Dim == 2 || particles.any_surface();
  for_each_stiffness<Dim>(spec, [&](const std::string& name, double& k) {
    if (in_object && root.has(name))
      throw root.at(name).fault("stands beside \"stiffness\", which has all stiffnesses", "leave one away");
    const bool is_optional = name == "gamma" || !needed;
    k = is_optional && !from.has(name) ? 0 : read_stiffness(from.at(name));
  });
  if (in_object && root.has("k_c"))
    throw root.at("k_c").fault("stands beside \"stiffness\", which has all stiffnesses", "leave one away");
  const bool absolute = in_object || !is_relative(root, "stiffness");
  spec.kind = absolute ? StiffnessKind::absolute : StiffnessKind::relative;
  contact.relative = root.has("contact_stiffness") ? is_relative(root, "contact_stiffness") : !in_object;
  if (!particles.is_one_alone() || from.has("k_c")) contact.stiffness = read_stiffness(from.at("k_c"));
}

/// Names of species, which become keys of the packing.
std::vector<std::string> read_species(const JsonNode& root, HeldKeys& keys) {
  std::vector<std::string> names;
  if (!root.has("species")) return names;
  const JsonNode list = root.at("species");
  for (std::size_t k = 0; k < list.size(); ++k) {
    const std::string name = list[k].text();
    if (std::find(names.begin(), names.end(), name) != names.end())
      throw list[k].fault(fmt::format("is \"{}\" again", name));
    names.push_back(name);
    keys[species_section(k) + ".name"] = name == fmt::format("{}", k + 1) ? std::string() : name;
  }
  return names;
}

/// The kind of contacts, which stands among the laws "case" too.
void read_contact_kind(const JsonNode& root, HeldKeys& keys) {
  if (!root.has("contact")) return;
  const JsonNode contact = root.at("contact");
  const std::string kind = contact.text();
  if (kind != "rough" && kind != "smooth") throw contact.fault("is \"" + kind + "\", not rough or smooth");
  const auto [at, is_new] = keys.emplace("contact.kind", kind);
  if (!is_new && at->second != KeyValue(kind))
    throw contact.fault(fmt::format("is \"{}\", but \"{}\" says {}", kind, held_keys_name, shown(at->second)),
                        "leave one away");
}

/// The cell of a particle alone, which has none: it is not periodic.
template <int Dim>
Box<Dim> read_no_cell(const JsonNode& root) {
  for (const char* key : {"strain", "periodic", "walls"})
    if (root.has(key)) throw root.at(key).fault("of no cell", "give the cell, \"box\"");
  Box<Dim> cell;
  for (bool& periodic : cell.periodic) periodic = false;
  return cell;
}
/// As large as the particle.
template <int Dim>
void fit_cell(System<Dim>& system) {
  const auto& x = system.state.position;
  for (int d = 0; d < Dim; ++d) {
    const auto [low, high] =
        std::minmax_element(x.begin(), x.end(), [d](const auto& a, const auto& b) { return a[d] < b[d]; });
    system.box.length[d] = (*high)[d] - (*low)[d] + 2 * system.state.radius[0];
  }
}

template <int Dim>
StoredPackingOf<Dim> read_packing(const JsonNode& root, const ListedParticles& particles) {
  std::vector<std::string> of_file = keys_of_packing<Dim>(), of_particle = keys_of_particle<Dim>();
  const bool alone = particles.is_one_alone();
  if (alone) of_file.insert(of_file.end(), of_particle.begin(), of_particle.end());
  expect_keys<Dim>(root, of_file, keys_of_packing<5 - Dim>());
  StoredPackingOf<Dim> packing;
  const bool has_cell = !alone || root.has("box");
  packing.system.box = has_cell ? read_cell<Dim>(root) : read_no_cell<Dim>(root);
  packing.environment = read_environment<Dim>(root, packing.system.box);
  if (!has_cell) packing.environment.stands = {};
  packing.keys = read_held_keys(root);
  read_contact_kind(root, packing.keys);
  CommonOfParticles common;
  common.alone = alone;
  if (!alone) common.species = read_species(root, packing.keys);
  read_stiffnesses<Dim>(root, particles, common.spec, packing.contact);
  for (std::size_t b = 0; b < particles.size(); ++b) {
    if (!alone) expect_keys<Dim>(particles[b], of_particle, keys_of_particle<5 - Dim>());
    read_particle(particles[b], common, packing.system);
  }
  if (!has_cell) fit_cell(packing.system);
  std::vector<double>& floor = packing.system.floor_contact;
  if (std::all_of(floor.begin(), floor.end(), [](double at) { return std::isnan(at); })) floor.clear();
  return packing;
}

}  // namespace

InitialState as_initial(AnyPacking packing) {
  return std::visit(
      [](auto& of) {
        InitialState initial;
        initial.units = reduced_units();
        initial.system = std::move(of.system);
        initial.contact = of.contact;
        initial.keys = std::move(of.keys);
        initial.environment = of.environment;
        return initial;
      },
      packing);
}

AnyPacking as_packing(const InitialState& state) {
  return std::visit(
      [&]<int Dim>(const System<Dim>& system) -> AnyPacking {
        return StoredPackingOf<Dim>{system, state.contact.value_or(Harmonic{}), state.keys,
                                    state.environment};
      },
      state.system);
}

AnyPacking read_any_packing_json(const std::string& path) {
  const Json json = parse_json(path, "a packing");
  const JsonNode root(json, path);
  if (root.has("params") && !root.has("particles"))
    throw root.fault(
        "is a state of discs of microgels: start from it by initial.state, not initial.packing;");
  const ListedParticles particles(root);
  if (particles.dimensions() == 2) return read_packing<2>(root, particles);
  return read_packing<3>(root, particles);
}

template <int Dim>
StoredPackingOf<Dim> read_packing_json(const std::string& path) {
  AnyPacking any = read_any_packing_json(path);
  if (auto* packing = std::get_if<StoredPackingOf<Dim>>(&any)) return std::move(*packing);
  throw input_error(
      fmt::format("{} holds {} and not {}", path, shapes_of_packing<5 - Dim>, shapes_of_packing<Dim>),
      fmt::format("the points of its first particle have {} numbers", numbers_of_point<5 - Dim>),
      fmt::format("give one whose points have {}", numbers_of_point<Dim>));
}

template StoredPackingOf<2> read_packing_json(const std::string&);
template StoredPackingOf<3> read_packing_json(const std::string&);

}  // namespace supple
