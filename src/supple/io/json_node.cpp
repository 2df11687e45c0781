#include "supple/io/json_node.hpp"

#include "supple/io/path_kind.hpp"

namespace supple {

Json parse_json(const std::string& path, const std::string& kind) {
  constexpr std::size_t longest = std::size_t{4} << 30;
  const std::string text = read_whole_file(path, kind, longest);
  try {
    return Json::parse(text);
  } catch (const Json::exception& e) {
    throw file_error("cannot use " + path + " as " + kind, std::string("not JSON, or truncated: ") + e.what());
  }
}

}  // namespace supple
