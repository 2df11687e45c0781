/// Whether bytes are those that were written.
#pragma once
#include <cstdint>
#include <string_view>

namespace supple {

/// CRC-32 as in PNG, gzip and Ethernet (polynomial 0x04c11db7, reflected), by zlib.
std::uint32_t checksum(std::string_view bytes);

}  // namespace supple
