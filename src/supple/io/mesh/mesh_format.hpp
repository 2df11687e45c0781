/// The formats of mesh files, and their endings.
#pragma once
#include <optional>
#include <string>

namespace supple {

enum class MeshFormat { obj, off, ply, stl };

/// The format that the ending of a path says, in lower or upper case: .obj, .off, .ply, .stl.
std::optional<MeshFormat> format_of_ending(const std::string& path);

}  // namespace supple
