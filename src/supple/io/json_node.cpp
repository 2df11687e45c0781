#include "supple/io/json_node.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>

namespace supple {

Json parse_json(const std::string& path, const std::string& kind) {
  std::ifstream in(path);
  if (!in) throw file_error("cannot read " + path, std::strerror(errno));
  try {
    return Json::parse(in);
  } catch (const Json::exception& e) {
    throw file_error("cannot use " + path + " as " + kind, std::string("not JSON, or truncated: ") + e.what());
  }
}

}  // namespace supple
