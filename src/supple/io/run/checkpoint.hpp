/// Checkpoints of a run, beside its segments in `<run>.partial`:
///
///     start.h5                     the case with the keys that were given: written before anything is
///     computed initial.h5, initial.json     what the run started from, if it did
///     checkpoint-NNNNNN-CCCCCCCC.h5  the last two; C: CRC-32 of the bytes
///         /           attributes: format, supple_version, case (CRC-32 of the case), segments,
///                     contacts, cpu_time
///         /kept       numbers and lists by name; systems
///         /pending    what was recorded before there was a first segment
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "supple/experiment/case.hpp"
#include "supple/io/hdf5/hdf5.hpp"
#include "supple/model/kept.hpp"

namespace supple {

/// What a run was started with.
struct RunStart {
  Case resolved;
  std::string case_text;
  std::string initial;  ///< file of the state or packing that it started from; empty: none
  /// Whether it started from a state, but from no file of which a copy was kept.
  bool lacks_initial() const {
    return initial.empty() && !(resolved.initial.state.empty() && resolved.initial.packing.empty());
  }
};
/// Keeps it in `folder`, with the file that the case starts from. Throws a file error where it cannot.
void write_start(const std::string& folder, const RunStart& start);
/// Throws a file error where there is none, or it is damaged.
RunStart read_start(const std::string& folder);

/// A place from which a run goes on.
struct Checkpoint {
  std::int64_t number = 0;    ///< checkpoints are counted from 1
  int segments = 0;           ///< the complete segments before it; later ones are of the time after it
  std::int64_t contacts = 0;  ///< rows of contacts in them
  double cpu_time = 0;        ///< of the run so far [s]
  Kept kept;
  h5::Group pending;  ///< layout of a segment
};

/// Writes a checkpoint whole, and removes all but this and the one before it. `pending` writes what no
/// segment holds. Throws a file error where it cannot; the checkpoints before are then still there.
template <class Pending>
void write_checkpoint(const std::string& folder, const std::string& case_text, const Checkpoint& checkpoint,
                      Pending&& pending);

/// The last checkpoint in `folder` that is whole and of this case and version; nullopt where there is none at
/// all. Each one that was refused is told in `refused`. Throws a file error where all are refused.
std::optional<Checkpoint> read_checkpoint(const std::string& folder, const std::string& case_text,
                                          std::vector<std::string>& refused);

/// Whether a file of this name in the folder of a run was written by a run.
bool is_of_a_run(const std::string& name);

// Implementation.

/// A new checkpoint in memory, and its way to disk.
h5::Group begin_checkpoint(const std::string& folder, const std::string& case_text,
                           const Checkpoint& checkpoint);
void publish_checkpoint(h5::Group& root, const std::string& folder, std::int64_t number);

template <class Pending>
void write_checkpoint(const std::string& folder, const std::string& case_text, const Checkpoint& checkpoint,
                      Pending&& pending) {
  h5::Group root = begin_checkpoint(folder, case_text, checkpoint);
  h5::Group group = root.create_group("pending");
  pending(group);
  publish_checkpoint(root, folder, checkpoint.number);
}

}  // namespace supple
