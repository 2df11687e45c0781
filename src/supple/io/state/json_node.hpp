/// Reading of JSON files, with errors that say where in the file. For .cpp files only, as it includes the
/// JSON library.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/core/nearest_name.hpp"

namespace supple {

using Json = nlohmann::json;

/// The whole file. Throws a file error where it cannot be read or is not JSON; `kind` names what was
/// expected, such as "a state".
Json parse_json(const std::string& path, const std::string& kind);

/// A value of a file, and where it stands ("state.json: initial.spheres[3].m"). Every function that reads it
/// throws a file error that says where, and what is wrong.
class JsonNode {
 public:
  JsonNode(const Json& value, std::string path) : value_(value), where_(std::move(path)), separator_(": ") {}

  bool has(const std::string& key) const { return value_.is_object() && value_.contains(key); }
  JsonNode at(const std::string& key) const {
    if (!value_.is_object()) throw fault("is not an object");
    if (!value_.contains(key)) throw fault("has no \"" + key + "\"");
    return {value_[key], where_ + separator_ + key, "."};
  }
  /// The names in an object.
  std::vector<std::string> keys() const {
    if (!value_.is_object()) throw fault("is not an object");
    std::vector<std::string> out;
    for (const auto& member : value_.items()) out.push_back(member.key());
    return out;
  }
  const Json& json() const { return value_; }
  /// Throws where the object has a key that is not among these.
  void expect_only(const std::vector<std::string>& known) const {
    for (const std::string& key : keys())
      if (std::find(known.begin(), known.end(), key) == known.end()) {
        const auto near = nearest_name(key, known);
        throw fault("has an unknown key \"" + key + "\"" +
                    (near ? "; did you mean \"" + *near + "\"?" : "; its keys are " + join_names(known)));
      }
  }
  bool is_list() const { return value_.is_array(); }
  std::size_t size() const {
    if (!value_.is_array()) throw fault("is not a list");
    return value_.size();
  }
  JsonNode operator[](std::size_t k) const {
    return {value_[k], where_ + "[" + std::to_string(k) + "]", "."};
  }

  double number() const {
    if (!value_.is_number()) throw fault("is not a number");
    const double x = value_.get<double>();
    if (!std::isfinite(x)) throw fault("is not finite");
    return x;
  }
  double positive() const {
    const double x = number();
    if (!(x > 0)) throw fault("is " + value_.dump() + ", not positive");
    return x;
  }
  bool truth() const {
    if (!value_.is_boolean()) throw fault("is not true or false");
    return value_.get<bool>();
  }
  /// A whole number that can count something in memory.
  std::int32_t index() const {
    if (!value_.is_number_integer()) throw fault("is not a whole number");
    if (value_ < 0 || value_ > std::numeric_limits<std::int32_t>::max())
      throw fault("is " + value_.dump() + ", which counts nothing here");
    return value_.get<std::int32_t>();
  }
  std::string text() const {
    if (!value_.is_string()) throw fault("is not a text");
    return value_.get<std::string>();
  }
  Error fault(const std::string& what, const std::string& to_do = {},
              const std::string& why = "the file cannot be used") const {
    return file_error(where_ + " " + what, why, to_do);
  }

 private:
  JsonNode(const Json& value, std::string where, const char* separator)
      : value_(value), where_(std::move(where)), separator_(separator) {}

  const Json& value_;
  std::string where_;
  const char* separator_;  ///< between this and a key below it
};

}  // namespace supple
