/// What stands where in a run file. One run is one HDF5 file, or, while it is going on or after it was
/// killed, the segments `<run>.partial/segment-NNNNNN.h5`, each complete and of the same layout with only
/// what is new in it:
///
///     /             attributes: format, supple_version, compiler, experiment, physics, seed, status,
///                   unit_length, unit_mass, unit_time (SI), units, sign_of_stress,
///                   definition_of_strain, definition_of_phase
///     /case         the resolved case as TOML text; each key again as an attribute, "section.key"
///     /box /discs   the cell at the start; radius, mass, inertia, particle of each site; body_begin: sites
///                   [body_begin[b], body_begin[b+1]) form body b (absent for microgel discs); in 3D facet,
///                   the sites of each triangle, seen counter-clockwise from outside; of solids
///                   boundary_sites, how many of the sites of each body are on its boundary (the first ones),
///                   and bond, the sites of each spring
///     /tables/T/C   column C of table T, one value per row; attributes unit, meaning
///     /frames       F frames of N sites and B bodies: step, time, ... (F); position, velocity, force
///                   (F, N, 2); angle, spin, torque, mobility (F, N); length of the cell (F, 2); in 3D (F, N,
///                   3) and (F, 3), spin and torque too;
///                   body/NAME (F, B), a number of each body; system/NAME (F), a number of the whole;
///                   contacts of frame k: contact_count[k] rows of contact_first, ... from row
///                   contact_begin[k] on (all first < second)
///     /constants /results /material /protocol
///                   one scalar per number; attributes unit, meaning and, where known, error
///     /warnings     texts
///     /final_state  the whole system and its forces (see system_archive.hpp)
#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "supple/experiment/case.hpp"
#include "supple/experiment/recorder.hpp"
#include "supple/io/hdf5/hdf5.hpp"

namespace supple {

inline constexpr auto run_format = "supple run 1";

/// A named number of a run; error < 0: not known.
using RunValue = MemoryRecorder::Value;

/// A strain, or a place in cells, that no run reaches.
inline constexpr double far_away = 1e9;
/// Whether these can be the lengths of a cell.
template <int Dim>
bool is_cell(const VecOf<double, Dim>& length) {
  for (int d = 0; d < Dim; ++d)
    if (!(length[d] > 0 && std::isfinite(length[d]))) return false;
  return true;
}

/// Folder of the segments of the run `path`.
std::string partial_folder(const std::string& path);
std::string segment_name(int index);

/// Writes the attributes of the root (all but status), the case, and `info`.
template <int Dim>
void write_header(h5::Group& root, const Case& resolved, const std::string& case_text,
                  const RunInfo<Dim>& info);
/// Writes the case, as text and as values; read_stored_case() reads it.
void store_case(h5::Group& root, const Case& resolved, const std::string& case_text);
/// The dimensions of a run: 2 or 3. Throws a file error for any other number.
int dimensions_of(const h5::Group& root);
template <int Dim>
RunInfo<Dim> read_info(const h5::Group& root);
Case read_stored_case(const h5::Group& root);

void write_value(h5::Group& group, const RunValue& value);
std::vector<RunValue> read_values(const h5::Group& group);

/// Writes frames, which must have the same sites and the same names of numbers; their contacts begin at row
/// `contacts` of the run.
template <int Dim>
void write_frames(h5::Group& root, const std::vector<Frame<Dim>>& frames, const Units& units,
                  std::int64_t contacts);
/// Frame `k` of this file, whose first contact is row `contacts` of the run. Throws a file error where its
/// arrays do not fit the sites, bodies and frames of the run.
template <int Dim>
Frame<Dim> read_frame(const h5::Group& frames, std::uint64_t k, std::int64_t contacts,
                      const RunInfo<Dim>& info);

}  // namespace supple
