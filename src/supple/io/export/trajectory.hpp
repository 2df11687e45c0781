/// Writes all frames of a run for other programs.
#pragma once
#include <string>

#include "supple/core/new_file.hpp"
#include "supple/io/export/vtp.hpp"
#include "supple/io/run/run_file.hpp"

namespace supple {

/// Where exports put bodies: in 2D in the leaning cell, in 3D where they are in the run, to the last bit.
template <int Dim>
inline constexpr Placement export_placement = Dim == 2 ? Placement::in_cell : Placement::unwrapped;

/// Every frame in one file of extended XYZ (see XyzFile), of a run in two dimensions or in three. Throws an
/// input error where the run has no frames, and file errors.
void export_xyz(const RunFile& run, const std::string& path, Existing existing = Existing::refuse);

/// Every frame as VTK PolyData in frame_folder(path), frame0000000.vtp and so on, and the collection `path`
/// (.pvd) that gives their times. With Existing::replace nothing of an older export stays in the folder. Each
/// instant is written once. The time is that of the run or, where it does not rise from frame to frame, the
/// number of the frame. Throws an input error where the run has no frames or no such cells (check_cells), and
/// file errors.
void export_vtp(const RunFile& run, const std::string& path, Existing existing = Existing::refuse,
                Cells cells = Cells::polygons);

/// The folder of the frames of a collection: "out/a_frames" for "out/a.pvd".
std::string frame_folder(const std::string& path);

/// Throws the file error that export_vtp() would throw before it writes.
void check_can_export_vtp(const std::string& path, Existing existing);

}  // namespace supple
