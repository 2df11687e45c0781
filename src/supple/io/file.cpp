#include "supple/io/file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "supple/core/error.hpp"

namespace supple {

void write_whole_file(const std::string& path, std::string_view bytes) {
  const std::string temporary = path + "." + std::to_string(::getpid()) + ".part";
  const auto fail = [&](int code) {
    std::remove(temporary.c_str());
    throw file_error("cannot write '" + path + "'", std::strerror(code), "choose a folder that exists and is writable");
  };
  std::FILE* file = std::fopen(temporary.c_str(), "wb");
  if (!file) fail(errno);
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  const int write_code = errno;
  if (std::fclose(file) != 0) fail(errno);
  if (!written) fail(write_code);
  if (std::rename(temporary.c_str(), path.c_str()) != 0) fail(errno);
}

}  // namespace supple
