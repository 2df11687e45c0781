/// run and resume: an experiment, its file, and the pictures and texts that the case asks for beside it.
#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <iostream>
#include <optional>
#include <tuple>
#include <vector>

#include "beside.hpp"
#include "commands.hpp"
#include "supple/core/error.hpp"
#include "supple/core/nearest_name.hpp"
#include "supple/core/path_kind.hpp"
#include "supple/core/text_columns.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/io/run/file_recorder.hpp"
#include "supple/io/run/run_file.hpp"
#include "supple/io/run/run_layout.hpp"
#include "supple/io/run/run_pictures.hpp"
#include "supple/io/state/state_file.hpp"
#include "supple/io/text/case_file.hpp"
#include "supple/io/text/progress.hpp"

namespace supple::command {

namespace {

namespace fs = std::filesystem;

volatile std::sig_atomic_t interrupted_by = 0, wants_checkpoint = 0;

/// The first Ctrl-C asks the experiment to stop; the second one ends the program.
void on_interrupt(int signal) {
  interrupted_by = signal;
  std::signal(signal, SIG_DFL);
}

/// A terminal that closes may say so more than once: the run still ends as after one Ctrl-C.
void on_hang_up(int signal) { interrupted_by = signal; }

/// Schedulers send it some time before they end a job (Slurm: --signal=USR1@60): the run goes on.
void on_checkpoint(int) { wants_checkpoint = 1; }

/// Writes the run and shows its progress on stderr.
class CommandRecorder : public FileRecorder {
 public:
  CommandRecorder(const std::string& path, const Case& c, Existing existing, const CheckpointSpec& spec)
      : FileRecorder(path, c, write_case(c, CaseStyle::resolved), existing, {}, spec),
        line_(std::cerr, style()) {}
  CommandRecorder(const std::string& path, const RunStart& start, const CheckpointSpec& spec)
      : FileRecorder(path, start, spec), line_(std::cerr, style()) {}

  void progress(const std::string& phase, std::int64_t done, std::int64_t total) override {
    FileRecorder::progress(phase, done, total);
    line_.update(phase, done, total);
  }
  void warning(const std::string& text) override {
    FileRecorder::warning(text);
    line_.message("warning: " + text);
  }
  void end_progress() { line_.finish(); }

 protected:
  bool asked_to_stop() override { return interrupted_by != 0; }
  bool asked_for_checkpoint() override {
    if (wants_checkpoint == 0) return false;
    wants_checkpoint = 0;
    return true;
  }

 private:
  static ProgressLine::Style style() {
    return isatty(STDERR_FILENO) ? ProgressLine::Style::bar : ProgressLine::Style::lines;
  }
  ProgressLine line_;
};

std::string run_path(const Case& c, const std::string& case_path, const std::string& asked) {
  if (!asked.empty()) return asked;
  if (!c.output.file.empty()) return c.output.file;
  return fs::path(case_path).stem().string() + ".h5";
}

std::string images_folder(const std::string& run) { return beside(run, "_images"); }

bool draws_plot(const Case& c) { return c.output.plot && experiment_of(c).figure(c) != Figure::none; }

/// Everything that the run will write must be writable before anything is computed.
void check_outputs(const Case& c, const std::string& case_path, const std::string& run, Existing existing) {
  if (run == standard_output)
    throw input_error("-o -", "a run is an HDF5 file, which is not written in one go", "give a name");
  const auto check_file = [&](const std::string& path) {
    for (const std::string& input : {case_path, c.initial.state, c.initial.packing})
      check_not_input(path, input);
    check_can_create(path, existing);
  };
  check_file(run);
  for (const std::string& input : {c.initial.state, c.initial.packing})
    check_not_input(partial_folder(run), input);
  if (draws_plot(c)) check_file(plot_path(run, c));
  if (c.output.snapshot) check_file(snapshot_path(run));
  if (c.output.text) check_file(export_path(run, "text"));
  if (c.output.images > 0 && existing == Existing::refuse && fs::exists(images_folder(run)))
    throw file_error(images_folder(run) + " exists", "nothing is overwritten unless asked",
                     "remove it, choose another name with -o, or give --force");
}

/// Draws, and adds the name of the picture to `written`. A run that is complete stays so where it has too
/// little for one.
template <class Draw>
void draw_or_warn(const std::string& what, std::vector<std::string>& written, Draw&& draw) {
  try {
    draw();
    written.push_back(what);
  } catch (const Error& e) {
    if (e.kind() == ErrorKind::file || e.kind() == ErrorKind::interrupted) throw;
    fmt::print(stderr, "warning: {} not drawn: {}\n", what, e.what());
  }
}

void draw_images_of(const Case& c, const std::string& run, Existing existing, CommandRecorder& recorder) {
  const auto progress = [&](std::int64_t done, std::int64_t total) {
    recorder.progress("draw images", done, total);
    if (recorder.stop_requested() && done < total)
      throw Error(ErrorKind::interrupted, fmt::format("{} of {} images are drawn", done, total),
                  "the run was asked to stop", run + " is complete");
  };
  const auto& [format, count] = std::tie(c.output.image_format, c.output.images);
  if (existing == Existing::replace) remove_numbered_files(images_folder(run), "image");
  make_folder(images_folder(run));
  draw_frames(images_folder(run), format, RunFile(run), count, {}, progress);
  recorder.end_progress();
}

/// Writes what [output] asks for beside the run; returns the names.
std::vector<std::string> write_beside(const Case& c, const std::string& run, Existing existing,
                                      CommandRecorder& recorder) {
  std::vector<std::string> written;
  std::optional<DrawnRun> opened;  // where anything is drawn
  const auto drawn = [&]() -> const DrawnRun& { return opened ? *opened : opened.emplace(run); };
  if (draws_plot(c)) draw_or_warn(plot_path(run, c), written, [&] { plot(drawn(), "", existing); });
  if (c.output.snapshot)
    draw_or_warn(snapshot_path(run), written, [&] { snapshot(drawn(), std::nullopt, {}, "", existing); });
  if (c.output.text) {
    export_run(run, "text", "", existing);
    written.push_back(export_path(run, "text"));
  }
  if (c.output.images > 0)
    draw_or_warn(images_folder(run) + "/", written, [&] { draw_images_of(c, run, existing, recorder); });
  return written;
}

void heed_signals() {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
  std::signal(SIGUSR1, on_checkpoint);
  if (std::signal(SIGHUP, on_hang_up) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);  // as under nohup
}

constexpr double never = 1e9;  // [s]; infinity would be beyond the clock

CheckpointSpec spec_of(const Timing& timing) {
  CheckpointSpec spec;
  if (timing.checkpoint) {
    spec.period = *timing.checkpoint > 0 ? *timing.checkpoint : never;
    spec.share = never;  // the user asked for so many
  }
  if (timing.limit > 0) spec.limit = timing.limit;
  return spec;
}

/// The word as a shell reads it.
std::string shell_word(const std::string& text) {
  const bool plain = text.find_first_not_of(
                         "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789"
                         "_-./+=:,@%") == text.npos;
  if (plain) return text;
  std::string quoted;
  for (const char c : text) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return "'" + quoted + "'";
}

/// What an error says of how to go on.
std::string what_is_left(const FileRecorder& recorder, bool stopped) {
  std::string text;
  if (recorder.began() && path_kind(recorder.path()) == PathKind::file &&
      RunFile(recorder.path()).frames() > 0)
    text = "what was computed is in " + recorder.path();
  if (!stopped || !recorder.can_resume()) return text;
  return text + (text.empty() ? "" : "; ") + "go on with: supple resume " + shell_word(recorder.path());
}

/// Computes the run and all that its case wants beside it, and prints its summary.
void compute(const Case& c, const std::optional<InitialState>& initial, CommandRecorder& recorder,
             Existing existing, Format format) {
  try {
    supple::run(c, initial ? &*initial : nullptr, recorder);
    recorder.end_progress();
    recorder.finish("complete");
  } catch (const Error& e) {
    const bool stopped = e.kind() == ErrorKind::interrupted;
    recorder.end_progress();
    recorder.finish(stopped ? "interrupted" : std::string("failed: ") + e.what());
    throw Error(e.kind(), e.what(), "", what_is_left(recorder, stopped));
  }
  const std::string file = recorder.path();
  std::vector<std::string> written = write_beside(c, file, existing, recorder);
  written.insert(written.begin(), file);
  const std::string names = hang_words("wrote", join_names(written, ""), 6);
  NewFile screen(std::string(standard_output), existing);
  screen.write(summarize(RunFile(file), format, Warnings::hidden));  // they stood there as they came
  if (format == Format::text) screen.write("\n" + names);
  else fmt::print(stderr, "{}", names);
  screen.commit();
}

}  // namespace

int stop_signal() { return interrupted_by; }

void run(const CaseChoice& choice, const std::string& path, Existing existing, Format format,
         const Timing& timing) {
  heed_signals();  // from the first moment: a stop that comes early is answered as any other
  const auto [c, initial] = load_case(choice);
  derive_case(c, initial);  // its input errors come before any file
  const std::string file = run_path(c, choice.path, path);
  check_outputs(c, choice.path, file, existing);
  for (const std::string& doubt : find_doubts(c)) fmt::print(stderr, "warning: {}\n", doubt);
  CommandRecorder recorder(file, c, existing, spec_of(timing));
  compute(c, initial, recorder, existing, format);
}

void resume(const std::string& run_path, int threads, Format format, const Timing& timing) {
  heed_signals();
  std::string file = run_path;
  if (const std::string ending = partial_folder("");
      file.ends_with(ending) && path_kind(file) == PathKind::folder)
    file.resize(file.size() - ending.size());
  const std::string folder = partial_folder(file);
  if (path_kind(folder) != PathKind::folder) {
    if (path_kind(file) != PathKind::file)
      throw file_error("there is no run " + file, "neither the file nor the folder " + folder + " exists");
    const std::string status = RunFile(file).status();
    throw file_error("cannot resume " + file, status == "complete" ? "it is complete" : "it is " + status,
                     status == "complete" ? "" : "go on from its last state with initial.state");
  }
  const RunStart start = read_start(folder);
  if (start.lacks_initial())
    throw file_error("cannot resume " + file, "no copy was kept of the state that it started from");
  Case c = start.resolved;
  if (threads > 0) c.general.threads = threads;
  const std::optional<InitialState> initial = load_initial(c, start.initial);
  CommandRecorder recorder(file, start, spec_of(timing));
  for (const std::string& reason : recorder.refused_checkpoints())
    fmt::print(stderr, "warning: an older checkpoint is used: {}\n", reason);
  compute(c, initial, recorder, Existing::replace, format);
}

}  // namespace supple::command
