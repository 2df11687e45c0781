#include "supple/core/utf8.hpp"

#include <cstddef>

namespace supple {

bool is_utf8(std::string_view bytes) {
  for (std::size_t i = 0; i < bytes.size();) {
    const auto at = [&](std::size_t k) -> unsigned {
      return k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0;
    };
    const unsigned lead = at(i), second = at(i + 1);
    const std::size_t length = lead < 0x80       ? 1
                               : lead >> 5 == 6  ? 2
                               : lead >> 4 == 14 ? 3
                               : lead >> 3 == 30 ? 4
                                                 : 0;
    if (length == 0) return false;
    for (std::size_t k = 1; k < length; ++k)
      if (at(i + k) >> 6 != 2) return false;
    if (length == 2 && lead < 0xC2) return false;
    if (length == 3 && ((lead == 0xE0 && second < 0xA0) || (lead == 0xED && second > 0x9F))) return false;
    if (length == 4 && ((lead == 0xF0 && second < 0x90) || lead > 0xF4 || (lead == 0xF4 && second > 0x8F)))
      return false;
    i += length;
  }
  return true;
}

}  // namespace supple
