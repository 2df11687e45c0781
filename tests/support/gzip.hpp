/// Compressed test data.
#pragma once
#include <zlib.h>

#include <stdexcept>
#include <string>

namespace supple::testing {

/// The whole text of a gzip file.
inline std::string read_gzip(const std::string& path) {
  gzFile file = gzopen(path.c_str(), "rb");
  if (!file) throw std::runtime_error("cannot open " + path);
  std::string text;
  char buffer[1 << 16];
  int count;
  while ((count = gzread(file, buffer, sizeof buffer)) > 0)
    text.append(buffer, static_cast<std::size_t>(count));
  gzclose(file);
  if (count < 0) throw std::runtime_error("cannot read " + path);
  return text;
}

}  // namespace supple::testing
