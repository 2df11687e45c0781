/// The `supple` command: options, help and exit codes. What the commands do is in commands.hpp.
#include <CLI/CLI.hpp>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <optional>
#include <string>
#include <system_error>

#include "command_line.hpp"
#include "commands.hpp"
#include "supple/core/error.hpp"
#include "supple/core/version.hpp"
#include "supple/experiment/experiments.hpp"

namespace {

using supple::Existing;
using supple::TriangleEdges;
namespace command = supple::command;

constexpr auto about =
    "Supple: simulation of soft particles.\n"
    "\n"
    "  supple init oscillatory_shear     writes a case to edit: oscillatory_shear.toml\n"
    "  supple check oscillatory_shear.toml\n"
    "  supple run oscillatory_shear.toml\n"
    "  supple show oscillatory_shear.h5";
constexpr auto exit_codes =
    "Exit codes: 0 done, 2 bad input, 3 numerics failed, 4 file trouble,\n"
    "130 interrupted by Ctrl-C or the time limit, 128 + N by signal N.\n"
    "Help on one command: supple COMMAND --help";

/// What the options of one call are read into.
struct Options {
  command::CaseChoice choice;
  std::string experiment = "oscillatory_shear", run, output, to = "csv", cells = "polygons", color, view,
              section, physics;
  std::optional<int> frame;
  command::Timing timing;
  bool force = false, json = false, edges = false;

  Existing existing() const { return force ? Existing::replace : Existing::refuse; }
  command::Format format() const { return json ? command::Format::json : command::Format::text; }
};

void add_threads(CLI::App& c, Options& o) {
  c.add_option_function<std::string>(
       "--threads",
       [&o](const std::string& n) { o.choice.threads = command::whole_number("--threads", n, 1, 1024); },
       "Threads, from 1 to 1024; results do not depend on them")
      ->type_name("N");
}
void add_timing(CLI::App& c, Options& o) {
  c.add_option_function<std::string>(
       "--checkpoint",
       [&o](const std::string& text) { o.timing.checkpoint = command::seconds("--checkpoint", text); },
       "Time between checkpoints, from which supple resume goes on; 0: only when stopped (default: 60s)")
      ->type_name("TIME");
  c.add_option_function<std::string>(
       "--time-limit",
       [&o](const std::string& text) { o.timing.limit = command::seconds("--time-limit", text); },
       "Stop before this time is over, with a checkpoint: 90s, 30min, 12h, H:MM:SS, D-HH:MM:SS")
      ->type_name("TIME");
}
void add_case(CLI::App& c, Options& o) {
  c.add_option("case", o.choice.path, "Case to read (TOML)")->required()->type_name("CASE.toml");
  c.add_option("--set", o.choice.set,
               "Set a key of the case, e.g. --set shear.amplitude=0.5; can be repeated")
      ->type_name("SECTION.KEY=VALUE")
      ->expected(1)
      ->take_all();
  add_threads(c, o);
}
void add_run(CLI::App& c, Options& o) {
  c.add_option("run", o.run, "Run to read (HDF5), finished or not")->required()->type_name("RUN.h5");
}
void add_output(CLI::App& c, Options& o, const std::string& help) {
  c.add_option("-o,--output", o.output, help)->type_name("FILE");
  c.add_flag("--force", o.force,
             "Replace files that exist; no links, pipes, devices, nor what the command reads");
}
void add_json(CLI::App& c, Options& o) { c.add_flag("--json", o.json, "Print JSON, for scripts"); }

void add_case_commands(CLI::App& app, Options& o) {
  CLI::App* init = app.add_subcommand("init", "Write a commented case to start from");
  init->add_option("experiment", o.experiment,
                   "What to run: oscillatory_shear (default), dynamics, jamming, ...; see supple list")
      ->type_name("EXPERIMENT");
  init->add_option("--physics", o.physics,
                   "With dynamics: deformable, for polygons instead of microgel discs")
      ->type_name("NAME")
      ->each(
          [](const std::string& name) { command::check_choice("--physics", name, supple::physics_names()); });
  add_output(*init, o, "Case to write; - for the screen (default: EXPERIMENT.toml)");
  init->callback([&] { command::init(o.experiment, o.physics, o.output, o.existing()); });

  CLI::App* check =
      app.add_subcommand("check", "Validate a case; print derived numbers and warnings; run nothing");
  add_case(*check, o);
  add_json(*check, o);
  check->callback([&] { command::check(o.choice, o.format()); });

  CLI::App* run = app.add_subcommand("run", "Run a case. Ctrl-C stops it; supple resume goes on");
  add_case(*run, o);
  add_output(*run, o, "Run to write (default: the name of the case with .h5)");
  add_json(*run, o);
  add_timing(*run, o);
  run->callback([&] { command::run(o.choice, o.output, o.existing(), o.format(), o.timing); });

  CLI::App* resume =
      app.add_subcommand("resume", "Go on with a run that was stopped or killed, as if it had not been");
  resume->add_option("run", o.run, "Run to go on with (HDF5)")->required()->type_name("RUN.h5");
  add_threads(*resume, o);
  add_json(*resume, o);
  add_timing(*resume, o);
  resume->callback([&] { command::resume(o.run, o.choice.threads, o.format(), o.timing); });

  CLI::App* list =
      app.add_subcommand("list", "List experiments, laws and every parameter with unit and meaning");
  list->add_option("what", o.section,
                   "Only this section of the case, e.g. material, or the keys that this experiment uses")
      ->type_name("SECTION|EXPERIMENT");
  add_json(*list, o);
  list->callback([&] { command::list(o.section, o.format()); });
}

void add_run_commands(CLI::App& app, Options& o) {
  CLI::App* show = app.add_subcommand("show", "Print the summary of a run: its results with units");
  add_run(*show, o);
  add_json(*show, o);
  add_output(*show, o, "File to write; - for the screen (default)");
  show->callback([&] { command::show(o.run, o.format(), o.output.empty() ? "-" : o.output, o.existing()); });

  CLI::App* exporting = app.add_subcommand("export", "Write a run in another format");
  add_run(*exporting, o);
  exporting
      ->add_option(
          "--to", o.to,
          "csv: main table with units; contacts: every contact of every frame; energy: the table of "
          "output.energies; trajectory: frames of discs in the published columns; text: the "
          "published text format; state: final state of discs as JSON; "
          "packing: of deformable particles; xyz, vtp: all frames for OVITO, ParaView; hdf5: one file of a "
          "run that is going on or was killed")
      ->type_name("FORMAT")
      ->each([](const std::string& name) {
        command::check_choice(
            "--to", name,
            {"csv", "contacts", "energy", "trajectory", "text", "state", "packing", "xyz", "vtp", "hdf5"});
      })
      ->capture_default_str();
  exporting
      ->add_option(
          "--cells", o.cells,
          "With vtp: polygons (vertices); outlines (with the discs on vertices); triangles (of the outlines: "
          "right areas of particles that are not convex). In 3D those of surfaces, by either name")
      ->type_name("CELLS")
      ->each([](const std::string& name) {
        command::check_choice("--cells", name, {"polygons", "outlines", "triangles"});
      })
      ->capture_default_str();
  add_output(*exporting, o,
             "File to write; - for standard output (default: the name of the run with .csv, .txt, "
             "_state.json, ...)");
  exporting->callback([&] { command::export_run(o.run, o.to, o.output, o.existing(), o.cells); });

  CLI::App* snapshot = app.add_subcommand("snapshot", "Draw the cell: particles and their contacts");
  add_run(*snapshot, o);
  snapshot
      ->add_option_function<std::string>(
          "--frame",
          [&o](const std::string& n) {
            constexpr int most = std::numeric_limits<int>::max();
            o.frame = command::whole_number("--frame", n, -most, most);
          },
          "Which frame, from 0; negative: from the end (default: the most sheared, or the last)")
      ->type_name("N");
  snapshot
      ->add_option(
          "--color", o.color,
          "Number that colours particles: pressure, shape_parameter, contacts, ..., of discs stress_xx, ... "
          "(default: id, those that touch differ)")
      ->type_name("NAME");
  snapshot
      ->add_option(
          "--view", o.view,
          "From where to look, in 3D: corner, x, y, z, or AZIMUTH,ELEVATION in degrees (default: corner)")
      ->type_name("VIEW");
  snapshot->add_flag("--edges", o.edges, "Draw the edges of triangles, too, in 3D");
  add_output(*snapshot, o,
             "Picture: .png .jpg .svg .pdf or .ps; - for standard output, as png (default: RUN_cell.png)");
  snapshot->callback([&] {
    const TriangleEdges edges = o.edges ? TriangleEdges::drawn : TriangleEdges::hidden;
    command::snapshot(o.run, o.frame, {o.color, o.view, edges}, o.output, o.existing());
  });

  CLI::App* plot =
      app.add_subcommand("plot", "Draw the figure of a run: stress, pressure, force or energies");
  add_run(*plot, o);
  add_output(*plot, o,
             "Picture: .png .jpg .svg .pdf or .ps; - for standard output, as png (default: RUN_stress.png, "
             "RUN_pressure.png, "
             "...)");
  plot->callback([&] { command::plot(o.run, o.output, o.existing()); });
}

/// Reads the command line and does what it says.
void parse(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success&) {
    throw;
  } catch (const CLI::ParseError& e) {
    throw command::explain(app, e);
  }
}

int obey(int argc, char** argv) {
  Options options;
  CLI::App app{about, "supple"};
  app.footer(exit_codes);
  app.set_version_flag("--version", std::string("supple ") + supple::version());
  app.require_subcommand(1);
  add_case_commands(app, options);
  add_run_commands(app, options);
  if (argc == 1) {
    std::fputs(app.help().c_str(), stderr);
    return static_cast<int>(supple::ErrorKind::input);
  }
  try {
    if (const auto help = command::help_asked_for(app, {argv + 1, argv + argc})) {
      std::fputs(help->c_str(), stdout);
      return 0;
    }
    parse(app, argc, argv);
  } catch (const CLI::Success& asked) {  // for help or the version
    return app.exit(asked);
  } catch (const supple::Error& e) {
    std::fprintf(stderr, "supple: %s\n", e.what());
    const bool by_signal = e.kind() == supple::ErrorKind::interrupted && command::stop_signal() != 0;
    return by_signal ? 128 + command::stop_signal() : e.exit_code();
  } catch (const std::bad_alloc&) {
    std::fputs(
        "supple: not enough memory for this (the case or file asks for more than there is); make it "
        "smaller\n",
        stderr);
    return static_cast<int>(supple::ErrorKind::input);
  } catch (const std::filesystem::filesystem_error& e) {
    std::fprintf(stderr, "supple: cannot use %s (%s)\n", e.path1().c_str(), e.code().message().c_str());
    return static_cast<int>(supple::ErrorKind::file);
  } catch (const std::system_error& e) {  // of what is printed
    std::fprintf(stderr, "supple: %s\n", e.what());
    return static_cast<int>(supple::ErrorKind::file);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "supple: %s (unexpected; please report it)\n", e.what());
    return static_cast<int>(supple::ErrorKind::numerics);
  }
  return 0;
}

/// Whether what was printed is out: a full disk may lie behind `supple show RUN > FILE`.
bool printed() {
  std::cout.flush();
  return std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a limit of file size is then an error of the write
  const int code = obey(argc, argv);
  if (code != 0 || printed()) return code;
  std::fprintf(stderr, "supple: cannot write standard output: %s\n", std::strerror(errno));
  return static_cast<int>(supple::ErrorKind::file);
}
