/// Runs that go on from the files of other runs, as the command does it.
#pragma once
#include <gmock/gmock.h>

#include "supple/experiment/adopt_state.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/io/run/file_recorder.hpp"
#include "supple/io/state/packing_file.hpp"
#include "supple/io/state/state_file.hpp"
#include "supple/io/text/case_file.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple::testing {

inline Case case_of(const std::string& text) {
  Case c = read_case_text(text, "case.toml");
  resolve_family(c);
  return c;
}

class ContinuedRun : public TemporaryFolder {
 protected:
  InitialState load(const std::string& name) const {
    return name.ends_with("_packing.json") ? as_initial(read_any_packing_json(in_folder(name)))
                                           : read_state(in_folder(name));
  }
  /// Runs the case from `state` (a file of this folder; empty: from nothing) into the file `name`, as the
  /// command does.
  void record(const std::string& name, Case c, const std::string& state = "") const {
    std::optional<InitialState> initial;
    if (!state.empty()) initial = load(state);
    const InitialState* from = initial ? &*initial : nullptr;
    FileRecorder recorder(in_folder(name), adopt_state(c, from), "", Existing::replace);
    run(c, from, recorder);
    recorder.finish("complete");
  }
  /// Writes the JSON of a run beside it, and returns the name.
  std::string exported(const std::string& name) const {
    const InitialState state = load(name);
    const bool bodies = has_bodies(state.system);
    const std::string json = name.substr(0, name.find('.')) + (bodies ? "_packing.json" : "_state.json");
    if (bodies) write_packing_json(as_packing(state), in_folder(json), Existing::replace);
    else write_state_json(state, in_folder(json), Existing::replace);
    return json;
  }
  /// The error of derive() for this case and `state`; empty where there is none.
  std::string error_from(Case c, const std::string& state) const {
    (state.ends_with("_packing.json") ? c.initial.packing : c.initial.state) = state;
    resolve_family(c);
    const InitialState initial = load(state);
    try {
      derive(c, &initial);
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::input);
      return e.what();
    }
    return "";
  }
};

}  // namespace supple::testing
