// glissade-cli: the commands that need no window. It links no Qt.
#include <signal.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstring>
#include <functional>
#include <iostream>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "app/cli/commands.h"
#include "app/cli/printable_output.h"
#include "app/version_text.h"
#include "engine/base/enum_names.h"
#include "engine/base/guarded.h"
#include "engine/base/limits.h"
#include "engine/base/number_text.h"
#include "engine/base/quantity_text.h"
#include "engine/scenario/path_exporter.h"

namespace {

using namespace glissade;
using namespace glissade::cli;

/// Converts a length as people write it to metres: 0.0005, 0.5mm, 5 cm, 1in. Units: m, cm, mm, in, inch, ft; none:
/// metres. Throws CLI::ValidationError with the reason.
double metres(const std::string& text) {
  const auto length = toMetres(text, 1.0);
  if (!length) {
    throw CLI::ValidationError("'" + text +
                               "' is not a length: give metres, or a unit as in 0.5mm (m, cm, mm, in, ft)");
  }
  if (!limits::isCoordinate(*length)) {
    throw CLI::ValidationError("'" + text + "' is beyond 1e9 m: check the unit");
  }
  return *length;
}

void addFormat(CLI::App& command, Format& format) {
  command.add_flag_callback(
      "--json", [&format] { format = Format::Json; }, "One JSON object on standard output and nothing else");
}

std::string plannerNames() {
  std::string names;
  const PlannerRegistry registry = makePlannerRegistry();
  for (const PlannerEntry& entry : registry.entries()) names += (names.empty() ? "" : ", ") + entry.id;
  return names;
}

void addLength(CLI::App& command, const std::string& option, const std::function<void(double)>& take,
               const std::string& help) {
  command.add_option_function<std::string>(
      option, [take](const std::string& text) { take(metres(text)); }, help);
}

/// Adds an option whose values are the names of an enumeration.
template <class Value, class Enum, std::size_t count>
void addChoice(CLI::App& command, const std::string& option, Value& value, const EnumNames<Enum, count>& names,
               const std::string& help) {
  command
      .add_option_function<std::string>(
          option, [&value, &names](const std::string& name) { value = *names.find(name); }, help)
      ->check(CLI::IsMember(std::set<std::string>(names.names.begin(), names.names.end())));
}

/// Adds one option for each row of the parameter table. Ranges are checked when the object's size is known.
void addParameters(CLI::App& command, std::map<ParameterId, double>& values) {
  for (const ParameterSpec& spec : parameterTable()) {
    const std::string help = std::string(spec.help) + (spec.unit.empty() ? "" : " [" + std::string(spec.unit) + "]");
    if (spec.unit == "m") {
      addLength(
          command, std::string(spec.option), [&values, id = spec.id](double value) { values[id] = value; }, help);
      continue;
    }
    command.add_option_function<double>(
        std::string(spec.option), [&values, id = spec.id](const double& value) { values[id] = value; }, help);
  }
}

void addAcceptClashes(CLI::App& command, FitOptions& options) {
  addLength(
      command, "--accept-clashes",
      [&options](double overlap) {
        if (overlap < 0.0) throw CLI::ValidationError("--accept-clashes", "is below zero: give a length, as 1.5mm");
        options.acceptedClash = overlap;
      },
      "Take clashes up to this overlap as fits, as 1.5mm");
  command.add_option("--cut", options.cut,
                     "In accepted clashes, the body that is cut where it is not clear which of the two has the hole");
}

void addFitOptions(CLI::App& command, FitOptions& options, const std::string& usual) {
  command
      .add_option_function<std::string>(
          "--fits", [&options](const std::string& mode) { options.on = mode == "on"; },
          "Whether bodies that fit where they are assembled are taken thinner against each other: on or off "
          "(default: " +
              usual + ")")
      ->check(CLI::IsMember({"on", "off"}));
  addAcceptClashes(command, options);
}

CLI::App* addPlan(CLI::App& app, PlanOptions& options) {
  CLI::App* plan = app.add_subcommand("plan", "Plan a motion and deliver it with its certificate");
  plan->add_option("SCENARIO", options.scenario, "Scenario file or OMPL.app .cfg")->required();
  plan->add_option("--strategy", options.strategy, "Planner: " + plannerNames() + " (default: the scenario's)");
  addChoice(*plan, "--collision", options.collision, kCollisionBackendNames,
            "Collision checker: kernel or fcl (default: kernel)");
  addFitOptions(*plan, options.fits, "the scenario's");
  plan->add_option("--operator", options.operatorName,
                   "Operator: none, novice, default, expert, simulated-haptic, task-novice, task-expert, misleading or "
                   "replay:FILE");
  plan->add_option("--way", options.way,
                   "A simulated operator shows the way of this path, not the scenario's way-points");
  addParameters(*plan, options.parameters);
  plan->add_flag_callback(
      "--smooth", [&options] { options.parameters.try_emplace(ParameterId::Smoothing, kUsualShortcuts); },
      "Shorten the path and keep it certified: --smoothing " + std::to_string(kUsualShortcuts));
  plan->add_flag("--edges", options.edges, "Report the certificate of every edge");
  plan->add_flag("--difficulty", options.difficulty, "Where no path is found, print the reasons");
  plan->add_option("--seed", options.seed, "Seed of everything random (default: the scenario's)");
  plan->add_option("--out", options.out, "Write the path: " + writablePathFormats());
  plan->add_option("--record", options.record, "Write a run record for replay");
  addFormat(*plan, options.format);
  return plan;
}

/// Adds the option that all commands about products have.
void addWithout(CLI::App& command, std::vector<std::string>& without) {
  command.add_option("--without", without,
                     "Leave a body or an assembly of the product out: its name (can be repeated)");
}

/// Adds the option that all commands about product files have.
void addOpen(CLI::App& command, std::vector<std::string>& open) {
  command.add_option("--open", open, "Take a part of several solids as these: its name (can be repeated)");
}

/// Adds the option of commands that work in several threads and whose results do not depend on their number.
void addLanes(CLI::App& command, std::size_t& lanes) {
  command.add_option("--lanes", lanes, "Threads; they do not change the result (default: one for each core)")
      ->check(CLI::Range(1, 1024));
}

CLI::App* addCheck(CLI::App& app, CheckOptions& options) {
  CLI::App* check = app.add_subcommand("check", "Judge a path or an assembly plan with the independent check");
  check
      ->add_option("SCENARIO", options.scenario,
                   "Scenario file or OMPL.app .cfg; of an assembly plan the product, as in sequence")
      ->required();
  check->add_option("PATH", options.path, "Assembly plan, or path: " + readablePathFormats())->required();
  addLength(
      *check, std::string(specOf(ParameterId::RequiredClearance).option),
      [&options](double value) { options.requiredClearance = value; },
      "Clearance to prove [m] (default: the scenario's)");
  addFitOptions(*check, options.fits, "the scenario's");
  check->add_flag("--edges", options.edges, "Report the certificate of every edge");
  check->add_flag("--trust-plan", options.trustPlan,
                  "What the plan states itself counts as a person's word: bends, flexible bodies, units, accepted "
                  "clashes, demands that are given up");
  addWithout(*check, options.without);
  addOpen(*check, options.open);
  check->add_option("--time-limit", options.timeLimit, "Time limit in seconds; 0: none")->capture_default_str();
  addFormat(*check, options.format);
  return check;
}

CLI::App* addSmooth(CLI::App& app, SmoothOptions& options) {
  CLI::App* smooth = app.add_subcommand("smooth", "Shorten a certified path and keep it certified");
  smooth->add_option("SCENARIO", options.scenario, "Scenario file or OMPL.app .cfg")->required();
  smooth->add_option("PATH", options.input, "Path: " + readablePathFormats())->required();
  smooth->add_option("OUT", options.output, "Write the path: " + writablePathFormats())->required();
  smooth->add_option("--attempts", options.attempts, "Shortcuts to try")
      ->check(CLI::Range(0, 1'000'000))
      ->capture_default_str();
  smooth->add_option("--seed", options.seed, "Seed of the shortcuts")->capture_default_str();
  addFormat(*smooth, options.format);
  return smooth;
}

CLI::App* addSweep(CLI::App& app, SweepOptions& options) {
  CLI::App* sweep = app.add_subcommand("sweep", "Write the swept volume of a path: all that the object covers");
  sweep->add_option("SCENARIO", options.scenario, "Scenario file or OMPL.app .cfg")->required();
  sweep->add_option("PATH", options.path, "Path: " + readablePathFormats())->required();
  sweep->add_option("OUT", options.output, "Write the swept volume: .stl (millimetres) or .glb")->required();
  addLength(
      *sweep, "--bound", [&options](double bound) { options.bound = bound; },
      "How far its surface may be from the object, as 0.5mm (default: one with which the volume is about 7 % too "
      "large)");
  addFormat(*sweep, options.format);
  return sweep;
}

CLI::App* addInfo(CLI::App& app, InfoOptions& options) {
  CLI::App* info = app.add_subcommand("info", "Show bodies, triangles, units and the quality of the meshes");
  info->add_option("FILE", options.file, "Scenario, OMPL.app .cfg, or part file (STEP, IGES, BREP, mesh, URDF)")
      ->required();
  info->add_flag("--places", options.places, "Build the environment model: octree, places, borders, compatibility");
  info->add_flag("--save-regions", options.saveRegions,
                 "Write into the scenario file where its forbidden places are, which 'check' reads");
  addOpen(*info, options.open);
  addFormat(*info, options.format);
  return info;
}

/// Adds the option for commands that take part files; a scenario states the deflection of its assets itself.
void addPartDeflection(CLI::App& command, double& deflection) {
  addLength(
      command, "--deflection",
      [&deflection](double value) {
        if (!limits::isSize(value)) throw CLI::ValidationError("--deflection", "is not from 1e-12 m to 1e9 m");
        deflection = value;
      },
      "How far triangles may be off the surfaces of a STEP file, as 0.05mm (default: by the size of each part)");
}

CLI::App* addFits(CLI::App& app, FitsOptions& options) {
  CLI::App* fits = app.add_subcommand("fits", "List the contacts, fits and clashes of a product as it is assembled");
  fits->add_option("FILE", options.file, "Scenario, STEP, IGES or BREP file, or an assembly in one (product.step:pump)")
      ->required();
  addLength(
      *fits, "--clearance-up-to", [&options](double distance) { options.limits.clearanceUpTo = distance; },
      "List pairs with a gap of up to this, too, as 0.5mm (default: 0)");
  addLength(
      *fits, "--clash-above", [&options](double overlap) { options.limits.clashOverlap = overlap; },
      "An overlap above this is a clash (default: 1mm)");
  fits->add_option("--clash-share", options.limits.clashThickness,
                   "An overlap above this share of the local thickness is a clash, too")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  addAcceptClashes(*fits, options.fits);
  addPartDeflection(*fits, options.deflection);
  addWithout(*fits, options.without);
  addOpen(*fits, options.open);
  addLanes(*fits, options.lanes);
  fits->add_flag("--csv", options.csv, "Comma-separated values, a line a pair");
  addFormat(*fits, options.format);
  return fits;
}

CLI::App* addJoints(CLI::App& app, JointsOptions& options) {
  CLI::App* joints = app.add_subcommand("joints", "List how the bodies of a product are joined: screws, nuts, inserts");
  joints
      ->add_option("FILE", options.file, "Scenario, STEP, IGES or BREP file, or an assembly in one (product.step:pump)")
      ->required();
  joints
      ->add_option_function<std::string>(
          "--joints", [&options](const std::string& mode) { options.confirmsSuggested = mode == "suggested"; },
          "suggested: joints that are suggested count as if a person had confirmed them; recognised: they do not "
          "(default)")
      ->check(CLI::IsMember({"recognised", "suggested"}));
  addPartDeflection(*joints, options.deflection);
  addWithout(*joints, options.without);
  addOpen(*joints, options.open);
  addFormat(*joints, options.format);
  return joints;
}

CLI::App* addSequence(CLI::App& app, SequenceOptions& options) {
  CLI::App* sequence =
      app.add_subcommand("sequence", "Find in which order the parts of a product leave, with a certified motion each");
  sequence
      ->add_option("FILE", options.file,
                   "Scenario, STEP, IGES or BREP file, an assembly in one (product.step:pump), or URDF file")
      ->required();
  sequence->add_option("--out", options.out, "Write the assembly plan (.json), also while it is planned");
  sequence->add_option("--save-every", options.saveEvery, "Seconds after which the plan so far is written to --out")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  sequence->add_option("--resume", options.resume, "Go on from a plan that has not ended");
  sequence->add_option("--strategy", options.strategy,
                       "How the order is searched: best-first or greedy (default: best-first, or the resumed plan's)");
  sequence->add_option("--seed", options.seed, "Seed of everything random (default: 1, or the resumed plan's)");
  addLanes(*sequence, options.lanes);
  sequence
      ->add_option("--time-limit", options.timeLimit,
                   "Time limit in seconds; the plan found so far is then written; 0: none")
      ->capture_default_str();
  sequence->add_option("--stay", options.staying, "Bodies that are not to leave (default: the largest)");
  sequence->add_option("--together", options.together, "Bodies that leave as one: names with commas between them");
  sequence->add_option("--before", options.before, "first,then: the first body leaves before the second");
  sequence->add_option("--place", options.places, "3,name: the body leaves as the third step; 3,name,name: as one");
  sequence->add_option("--forbid", options.forbidden,
                       "name,-z or name,0,0,-1: the body does not leave in this direction");
  sequence->add_option("--joints", options.joints,
                       "Joints that the plan keeps to: recognised, suggested (those too that a person would have to "
                       "confirm) or off (default: the scenario's, or recognised)");
  sequence->add_option("--gravity", options.gravity, "Direction of gravity: x y z (default: the scenario's, or 0 0 -1)")
      ->expected(3);
  sequence->add_option(
      "--cost", options.cost,
      "What a step costs for best-first: fitter, balanced, steady, few-tools, short, fragile-first, as-found, "
      "or an expression (default: the scenario's, or fitter)");
  addPartDeflection(*sequence, options.deflection);
  addWithout(*sequence, options.without);
  addOpen(*sequence, options.open);
  addFitOptions(*sequence, options.fits, "on, or the scenario's");
  addFormat(*sequence, options.format);
  return sequence;
}

CLI::App* addTimes(CLI::App& app, TimesOptions& options) {
  CLI::App* times =
      app.add_subcommand("times", "How long the steps of an assembly plan take, also divided over a line");
  times->add_option("FILE", options.product, "The product of the plan: a scenario or a STEP file")->required();
  times->add_option("PLAN", options.plan, "Assembly plan, as 'sequence --out' writes it")->required();
  times->add_option("--stations", options.stations, "Divide the steps over so many stations, one person each");
  times->add_option("--table", options.table, "File of work times (default: the program's estimates)");
  times->add_option("--write-table", options.writeTable, "Write the table of work times to a file, to be edited");
  addFormat(*times, options.format);
  return times;
}

CLI::App* addAccess(CLI::App& app, AccessOptions& options) {
  CLI::App* access = app.add_subcommand(
      "access", "Whether a hand gets to a path or to the steps of an assembly plan, and an eye sees");
  access->footer(
      "Hand, forearm and tool are sampled along each motion; this is no proof. Measures: ANSUR II (NATICK/TR-15/007).\n"
      "Exit codes: 0 all is reached and seen, 1 not all, 2 wrong usage, 3 unreadable input, 130 interrupted.");
  access->add_option("FILE", options.file, "The scenario of the path, or the product of the plan")->required();
  access->add_option("--path", options.path, "Path of the object: " + readablePathFormats());
  access->add_option("--plan", options.plan, "Assembly plan, as 'sequence --out' writes it");
  addChoice(*access, "--hand", options.hand, kHandSizeNames,
            "Whose hand: p5f 5th percentile of women, p50 average, p95m 95th percentile of men (default: p50)");
  access
      ->add_option("--eye", options.eye,
                   "From where the place is looked at: x y z in metres (default: 17 positions above it are tried)")
      ->expected(3);
  addFormat(*access, options.format);
  return access;
}

CLI::App* addConvert(CLI::App& app, ConvertOptions& options) {
  CLI::App* convert =
      app.add_subcommand("convert", "Convert an OMPL.app .cfg to a scenario, or a path to another format");
  convert->add_option("IN", options.input, "What to read: a .cfg, a scenario; or a path: " + readablePathFormats())
      ->required();
  convert->add_option("OUT", options.output, "What to write: a scenario (.json); or a path: " + writablePathFormats())
      ->required();
  convert->add_option("--scenario", options.scenario,
                      "Scenario of the path, for formats that hold its clearances or bodies");
  return convert;
}

CLI::App* addNew(CLI::App& app, NewOptions& options) {
  CLI::App* make =
      app.add_subcommand("new", "Make a scenario of part files (meshes, STEP, IGES, BREP, URDF), of which one moves");
  make->footer(
      "A part of a STEP file is named behind its file: --moves product.step:pin --static product.step makes a body\n"
      "of every other part. An assembly in the file (product.step:pump) stands for all of its parts; two parts of\n"
      "one name are pin and pin#2. A solid of a part of several (product.step:frame/solid#2) opens the part: each of\n"
      "its solids is a body. #3 is the third part that 'info' lists. A group of an OBJ file is named in the same way: "
      "--moves product.obj:lid --groups\n"
      "--static product.obj makes a body of every other group.");
  make->add_option("OUT", options.output, "Scenario file to write")->required();
  make->add_option("--moves", options.moving, "The part that moves (can be repeated: they move as one)")
      ->required()
      ->allow_extra_args(false);
  make->add_option("--static", options.statics, "Parts that stay where they are");
  make->add_option("--mobile", options.mobiles, "Parts in the way that a person could move");
  addLength(
      *make, "--unit", [&options](double unit) { options.unit = unit; },
      "A unit of the files, as 1mm, 1m, 1in or 25.4mm (default: 1m for Collada and glTF; for other meshes 1mm, or 1m "
      "where only that fits their size, which a warning says); STEP and URDF files say it themselves");
  addChoice(*make, "--up", options.up, kUpAxisNames,
            "The files' axis that points up (default: y for Collada and glTF, z for other meshes)");
  addLength(
      *make, "--deflection",
      [&options](double deflection) {
        if (!limits::isSize(deflection)) throw CLI::ValidationError("--deflection", "is not from 1e-12 m to 1e9 m");
        options.deflection = deflection;
      },
      "How far the triangles of STEP parts may be off their surfaces, as 0.05mm (default: a thousandth of each "
      "part's diagonal, from 0.01mm to 0.5mm)");
  make->add_flag("--groups", options.groups, "Take each group of an OBJ file (o or g) as a part of its own");
  make->add_flag("--close-holes", options.closeHoles, "Close the planar holes of meshes, and print how many");
  addWithout(*make, options.without);
  addFitOptions(*make, options.fits, "on");
  make->add_flag("--clear", options.clear, "Move the start clear of the bodies that it touches, and print how far");
  return make;
}

CLI::App* addStudy(CLI::App& app, StudyOptions& options) {
  CLI::App* study = app.add_subcommand("study", "Repeat runs over scenarios, strategies, parameters and seeds");
  study->add_option("STUDY", options.study, "Study file (samples/studies)")->required();
  study->add_option("--out", options.out, "Folder of the results; a study that was begun there is continued")
      ->required();
  study->add_option("--jobs", options.jobs, "Runs at once")->check(CLI::Range(1, 1024))->capture_default_str();
  study->add_option("--shard", options.shard, "I/N: only every N-th run, from the I-th; see merge")
      ->capture_default_str();
  study->add_flag("--quick", options.quick, "The study's quick section: about a minute");
  study->add_flag("--dry-run", options.dryRun, "Print what would be run; write nothing");
  return study;
}

CLI::App* addMerge(CLI::App& app, MergeOptions& options) {
  CLI::App* merge =
      app.add_subcommand("merge", "Combine the results of the parts of a study (--shard) and write its tables");
  merge->add_option("DIR", options.folders, "Folders of results")->required();
  merge->add_option("--out", options.out, "Folder of the combined results")->required();
  return merge;
}

CLI::App* addReport(CLI::App& app, ReportOptions& options) {
  CLI::App* report =
      app.add_subcommand("report", "Write the report of a study: tables, plots, findings, one HTML page");
  report->add_option("DIR", options.folder, "Folder of results")->required();
  report->add_option("--out", options.out, "Folder of report.html (default: DIR)");
  report->add_option("--language", options.language, "Language of the report")
      ->check(CLI::IsMember({"en", "fr"}))
      ->capture_default_str();
  return report;
}

CLI::App* addBenchmarkPage(CLI::App& app, std::string& folder) {
  CLI::App* page = app.add_subcommand("benchmark-page", "Write the page of results of packaging/benchmarks.sh");
  page->add_option("DIR", folder, "Folder of results")->required();
  return page;
}

CLI::App* addReplay(CLI::App& app, ReplayOptions& options) {
  CLI::App* replay = app.add_subcommand("replay", "Run a recorded run again and compare the roadmaps bit by bit");
  replay->add_option("RECORD", options.record, "Run record, or the journal of a run that was interrupted")->required();
  replay->add_option("--scenario", options.scenario, "Scenario of the run (default: the one that the record names)");
  addFormat(*replay, options.format);
  return replay;
}

int run(int argc, char** argv) {
  CLI::App app{"Glissade: certified motions for virtual assembly"};
  app.set_version_flag("--version", "glissade-cli " + versionText());
  app.require_subcommand(1);
  PlanOptions plan;
  CheckOptions check;
  SmoothOptions smooth;
  SweepOptions sweep;
  ReplayOptions replay;
  InfoOptions info;
  FitsOptions fits;
  JointsOptions joints;
  SequenceOptions sequence;
  TimesOptions times;
  AccessOptions access;
  ConvertOptions convert;
  NewOptions fresh;
  StudyOptions study;
  MergeOptions merge;
  ReportOptions report;
  std::string benchmarks;
  const CLI::App* planCommand = addPlan(app, plan);
  const CLI::App* replayCommand = addReplay(app, replay);
  const CLI::App* checkCommand = addCheck(app, check);
  const CLI::App* smoothCommand = addSmooth(app, smooth);
  const CLI::App* sweepCommand = addSweep(app, sweep);
  const CLI::App* infoCommand = addInfo(app, info);
  const CLI::App* fitsCommand = addFits(app, fits);
  const CLI::App* jointsCommand = addJoints(app, joints);
  const CLI::App* sequenceCommand = addSequence(app, sequence);
  const CLI::App* timesCommand = addTimes(app, times);
  const CLI::App* accessCommand = addAccess(app, access);
  const CLI::App* studyCommand = addStudy(app, study);
  const CLI::App* mergeCommand = addMerge(app, merge);
  const CLI::App* reportCommand = addReport(app, report);
  const CLI::App* benchmarkCommand = addBenchmarkPage(app, benchmarks);
  addConvert(app, convert);
  const CLI::App* newCommand = addNew(app, fresh);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : exitCode(ErrorKind::Usage);
  }
  if (planCommand->parsed()) return runPlan(plan);
  if (replayCommand->parsed()) return runReplay(replay);
  if (checkCommand->parsed()) return runCheck(check);
  if (smoothCommand->parsed()) return runSmooth(smooth);
  if (sweepCommand->parsed()) return runSweep(sweep);
  if (infoCommand->parsed()) return runInfo(info);
  if (fitsCommand->parsed()) return runFits(fits);
  if (jointsCommand->parsed()) return runJoints(joints);
  if (sequenceCommand->parsed()) return runSequence(sequence);
  if (timesCommand->parsed()) return runTimes(times);
  if (accessCommand->parsed()) return runAccess(access);
  if (studyCommand->parsed()) return runStudyCommand(study);
  if (mergeCommand->parsed()) return runMerge(merge);
  if (reportCommand->parsed()) return runReport(report);
  if (benchmarkCommand->parsed()) return runBenchmarkPage(benchmarks);
  if (newCommand->parsed()) return runNew(fresh);
  return runConvert(convert);
}

/// Why standard output could not be written, or nothing. A closed pipe, as of head, is no error.
std::optional<Diagnostic> unwritten(PrintableOutput& output) {
  const int error = output.flush();
  if (error == 0 || error == EPIPE) return std::nullopt;
  return Diagnostic{ErrorKind::Unwritable, "standard output", "",
                    std::string("cannot be written: ") + std::strerror(error), "Send it to another file."};
}

}  // namespace

int main(int argc, char** argv) {
  signal(SIGPIPE, SIG_IGN);
  signal(SIGXFSZ, SIG_IGN);
  PrintableOutput output(std::cout);
  const PrintableOutput errors(std::cerr);
  int status = 0;
  auto why = glissade::guarded("running the command", [&] { status = run(argc, argv); });
  if (!why && status == 0) why = unwritten(output);
  if (!why) return status;
  std::cerr << "glissade-cli: " << glissade::toString(*why) << "\n";
  return glissade::exitCode(why->kind);
}
