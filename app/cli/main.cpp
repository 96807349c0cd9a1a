// glissade-cli: the commands that need no window. It links no Qt.
#include <signal.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstring>
#include <functional>
#include <iostream>
#include <map>
#include <optional>
#include <string>

#include "app/cli/commands.h"
#include "app/cli/printable_output.h"
#include "app/version_text.h"
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

void addConsole(const Command& command, Console& console) {
  command.flag("--json", console.json, GLISSADE_TEXT("One JSON object on standard output and nothing else"));
}

std::string plannerNames() {
  std::string names;
  const PlannerRegistry registry = makePlannerRegistry();
  for (const PlannerEntry& entry : registry.entries()) names += (names.empty() ? "" : ", ") + entry.id;
  return names;
}

void addLength(const Command& command, const std::string& option, const std::function<void(double)>& take,
               const std::string& help) {
  command.optionFor<std::string>(
      option, [take](const std::string& text) { take(metres(text)); }, help);
}

/// Adds one option for each row of the parameter table. Ranges are checked when the object's size is known.
void addParameters(const Command& command, std::map<ParameterId, double>& values) {
  for (const ParameterSpec& spec : parameterTable()) {
    const std::string help =
        std::string(spec.help.english) + (spec.unit.empty() ? "" : " [" + std::string(spec.unit) + "]");
    if (spec.unit == "m") {
      command.length(
          std::string(spec.option), [&values, id = spec.id](double value) { values[id] = value; }, help);
      continue;
    }
    command.optionFor<double>(
        std::string(spec.option), [&values, id = spec.id](const double& value) { values[id] = value; }, help);
  }
}

void addAcceptClashes(const Command& command, FitOptions& options) {
  command.length(
      "--accept-clashes",
      [&options](double overlap) {
        if (overlap < 0.0)
          throw CLI::ValidationError("--accept-clashes", GLISSADE_TEXT("is below zero: give a length, as 1.5mm"));
        options.acceptedClash = overlap;
      },
      GLISSADE_TEXT("Take clashes up to this overlap as fits, as 1.5mm"));
  command.option(
      "--cut", options.cut,
      GLISSADE_TEXT("In accepted clashes, the body that is cut where it is not clear which of the two has the hole"));
}

void addFitOptions(const Command& command, FitOptions& options, const std::string& usual) {
  command
      .optionFor<std::string>(
          "--fits", [&options](const std::string& mode) { options.on = mode == "on"; },
          "Whether bodies that fit where they are assembled are taken thinner against each other: on or off "
          "(default: " +
              usual + ")")
      ->check(CLI::IsMember({"on", "off"}));
  addAcceptClashes(command, options);
}

Command addPlan(const Command& app, PlanOptions& options) {
  const Command plan = app.subcommand("plan", GLISSADE_TEXT("Plan a motion and deliver it with its certificate"));
  plan.option("SCENARIO", options.scenario, GLISSADE_TEXT("Scenario file or OMPL.app .cfg"))->required();
  plan.option("--strategy", options.strategy, "Planner: " + plannerNames() + " (default: the scenario's)");
  const std::map<std::string, CollisionBackend> backends{{"kernel", CollisionBackend::Kernel},
                                                         {"fcl", CollisionBackend::Fcl}};
  plan.optionFor<std::string>(
      "--collision",
      [&options, backends](const std::string& name) {
        const auto backend = backends.find(name);
        if (backend == backends.end()) throw CLI::ValidationError("--collision", "'" + name + "' is not kernel or fcl");
        options.collision = backend->second;
      },
      GLISSADE_TEXT("Collision checker: kernel or fcl (default: kernel)"));
  addFitOptions(plan, options.fits, GLISSADE_TEXT("the scenario's"));
  plan.option("--operator", options.operatorName,
              GLISSADE_TEXT(
                  "Operator: none, novice, default, expert, simulated-haptic, task-novice, task-expert, misleading or "
                  "replay:FILE"));
  plan.option("--way", options.way,
              GLISSADE_TEXT("A simulated operator shows the way of this path, not the scenario's way-points"));
  addParameters(plan, options.parameters);
  plan->add_flag_callback(
      "--smooth", [&options] { options.parameters.try_emplace(ParameterId::Smoothing, kUsualShortcuts); },
      "Shorten the path and keep it certified: --smoothing " + std::to_string(kUsualShortcuts));
  plan.flag("--edges", options.edges, GLISSADE_TEXT("Report the certificate of every edge"));
  plan.flag("--difficulty", options.difficulty, GLISSADE_TEXT("Where no path is found, print the reasons"));
  plan.option("--seed", options.seed, GLISSADE_TEXT("Seed of everything random (default: the scenario's)"));
  plan.option("--out", options.out, "Write the path: " + toString(writablePathFormats()));
  plan.option("--record", options.record, GLISSADE_TEXT("Write a run record for replay"));
  addConsole(plan, options.console);
  return plan;
}

/// Adds the option that all commands about products have.
void addWithout(const Command& command, std::vector<std::string>& without) {
  command.option("--without", without,
                 GLISSADE_TEXT("Leave a body or an assembly of the product out: its name (can be repeated)"));
}

/// Adds the option that all commands about product files have.
void addOpen(const Command& command, std::vector<std::string>& open) {
  command.option("--open", open, GLISSADE_TEXT("Take a part of several solids as these: its name (can be repeated)"));
}

/// Adds the option of commands that work in several threads and whose results do not depend on their number.
void addLanes(const Command& command, std::size_t& lanes) {
  command
      .option("--lanes", lanes, GLISSADE_TEXT("Threads; they do not change the result (default: one for each core)"))
      ->check(CLI::Range(1, 1024));
}

Command addCheck(const Command& app, CheckOptions& options) {
  const Command check =
      app.subcommand("check", GLISSADE_TEXT("Judge a path or an assembly plan with the independent check"));
  check
      .option("SCENARIO", options.scenario,
              GLISSADE_TEXT("Scenario file or OMPL.app .cfg; of an assembly plan the product, as in sequence"))
      ->required();
  check.option("PATH", options.path, "Assembly plan, or path: " + toString(readablePathFormats()))->required();
  check.length(
      std::string(specOf(ParameterId::RequiredClearance).option),
      [&options](double value) { options.requiredClearance = value; },
      GLISSADE_TEXT("Clearance to prove [m] (default: the scenario's)"));
  addFitOptions(check, options.fits, GLISSADE_TEXT("the scenario's"));
  check.flag("--edges", options.edges, GLISSADE_TEXT("Report the certificate of every edge"));
  check.flag(
      "--trust-plan", options.trustPlan,
      GLISSADE_TEXT("What the plan states itself counts as a person's word: bends, flexible bodies, units, accepted "
                    "clashes, demands that are given up"));
  addWithout(check, options.without);
  addOpen(check, options.open);
  check.option("--time-limit", options.timeLimit, GLISSADE_TEXT("Time limit in seconds; 0: none"))
      ->capture_default_str();
  addConsole(check, options.console);
  return check;
}

Command addSmooth(const Command& app, SmoothOptions& options) {
  const Command smooth = app.subcommand("smooth", GLISSADE_TEXT("Shorten a certified path and keep it certified"));
  smooth.option("SCENARIO", options.scenario, GLISSADE_TEXT("Scenario file or OMPL.app .cfg"))->required();
  smooth.option("PATH", options.input, "Path: " + toString(readablePathFormats()))->required();
  smooth.option("OUT", options.output, "Write the path: " + toString(writablePathFormats()))->required();
  smooth.option("--attempts", options.attempts, GLISSADE_TEXT("Shortcuts to try"))
      ->check(CLI::Range(0, 1'000'000))
      ->capture_default_str();
  smooth.option("--seed", options.seed, GLISSADE_TEXT("Seed of the shortcuts"))->capture_default_str();
  addConsole(smooth, options.console);
  return smooth;
}

Command addSweep(const Command& app, SweepOptions& options) {
  const Command sweep =
      app.subcommand("sweep", GLISSADE_TEXT("Write the swept volume of a path: all that the object covers"));
  sweep.option("SCENARIO", options.scenario, GLISSADE_TEXT("Scenario file or OMPL.app .cfg"))->required();
  sweep.option("PATH", options.path, "Path: " + toString(readablePathFormats()))->required();
  sweep.option("OUT", options.output, GLISSADE_TEXT("Write the swept volume: .stl (millimetres) or .glb"))->required();
  sweep.length(
      "--bound", [&options](double bound) { options.bound = bound; },
      GLISSADE_TEXT(
          "How far its surface may be from the object, as 0.5mm (default: one with which the volume is about 7 % too "
          "large)"));
  addConsole(sweep, options.console);
  return sweep;
}

Command addInfo(const Command& app, InfoOptions& options) {
  const Command info =
      app.subcommand("info", GLISSADE_TEXT("Show bodies, triangles, units and the quality of the meshes"));
  info.option("FILE", options.file,
              GLISSADE_TEXT("Scenario, OMPL.app .cfg, or part file (STEP, IGES, BREP, mesh, URDF)"))
      ->required();
  info.flag("--places", options.places,
            GLISSADE_TEXT("Build the environment model: octree, places, borders, compatibility"));
  info.flag("--save-regions", options.saveRegions,
            GLISSADE_TEXT("Write into the scenario file where its forbidden places are, which 'check' reads"));
  addOpen(info, options.open);
  addConsole(info, options.console);
  return info;
}

/// Adds the option for commands that take part files; a scenario states the deflection of its assets itself.
void addPartDeflection(const Command& command, double& deflection) {
  command.length(
      "--deflection",
      [&deflection](double value) {
        if (!limits::isSize(value))
          throw CLI::ValidationError("--deflection", GLISSADE_TEXT("is not from 1e-12 m to 1e9 m"));
        deflection = value;
      },
      GLISSADE_TEXT(
          "How far triangles may be off the surfaces of a STEP file, as 0.05mm (default: by the size of each part)"));
}

Command addFits(const Command& app, FitsOptions& options) {
  const Command fits =
      app.subcommand("fits", GLISSADE_TEXT("List the contacts, fits and clashes of a product as it is assembled"));
  fits.option("FILE", options.file,
              GLISSADE_TEXT("Scenario, STEP, IGES or BREP file, or an assembly in one (product.step:pump)"))
      ->required();
  fits.length(
      "--clearance-up-to", [&options](double distance) { options.limits.clearanceUpTo = distance; },
      GLISSADE_TEXT("List pairs with a gap of up to this, too, as 0.5mm (default: 0)"));
  fits.length(
      "--clash-above", [&options](double overlap) { options.limits.clashOverlap = overlap; },
      GLISSADE_TEXT("An overlap above this is a clash (default: 1mm)"));
  fits.option("--clash-share", options.limits.clashThickness,
              GLISSADE_TEXT("An overlap above this share of the local thickness is a clash, too"))
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  addAcceptClashes(fits, options.fits);
  addPartDeflection(fits, options.deflection);
  addWithout(fits, options.without);
  addOpen(fits, options.open);
  addLanes(fits, options.lanes);
  fits.flag("--csv", options.csv, GLISSADE_TEXT("Comma-separated values, a line a pair"));
  addConsole(fits, options.console);
  return fits;
}

Command addJoints(const Command& app, JointsOptions& options) {
  const Command joints =
      app.subcommand("joints", GLISSADE_TEXT("List how the bodies of a product are joined: screws, nuts, inserts"));
  joints
      .option("FILE", options.file,
              GLISSADE_TEXT("Scenario, STEP, IGES or BREP file, or an assembly in one (product.step:pump)"))
      ->required();
  joints
      .optionFor<std::string>(
          "--joints", [&options](const std::string& mode) { options.confirmsSuggested = mode == "suggested"; },
          GLISSADE_TEXT(
              "suggested: joints that are suggested count as if a person had confirmed them; recognised: they do not "
              "(default)"))
      ->check(CLI::IsMember({"recognised", "suggested"}));
  addPartDeflection(joints, options.deflection);
  addWithout(joints, options.without);
  addOpen(joints, options.open);
  addConsole(joints, options.console);
  return joints;
}

Command addSequence(const Command& app, SequenceOptions& options) {
  const Command sequence = app.subcommand(
      "sequence", GLISSADE_TEXT("Find in which order the parts of a product leave, with a certified motion each"));
  sequence
      .option("FILE", options.file,
              GLISSADE_TEXT("Scenario, STEP, IGES or BREP file, an assembly in one (product.step:pump), or URDF file"))
      ->required();
  sequence.option("--out", options.out, GLISSADE_TEXT("Write the assembly plan (.json), also while it is planned"));
  sequence
      .option("--save-every", options.saveEvery,
              GLISSADE_TEXT("Seconds after which the plan so far is written to --out"))
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  sequence.option("--resume", options.resume, GLISSADE_TEXT("Go on from a plan that has not ended"));
  sequence.option(
      "--strategy", options.strategy,
      GLISSADE_TEXT("How the order is searched: best-first or greedy (default: best-first, or the resumed plan's)"));
  sequence.option("--seed", options.seed,
                  GLISSADE_TEXT("Seed of everything random (default: 1, or the resumed plan's)"));
  addLanes(sequence, options.lanes);
  sequence
      .option("--time-limit", options.timeLimit,
              GLISSADE_TEXT("Time limit in seconds; the plan found so far is then written; 0: none"))
      ->capture_default_str();
  sequence.option("--stay", options.staying, GLISSADE_TEXT("Bodies that are not to leave (default: the largest)"));
  sequence.option("--together", options.together,
                  GLISSADE_TEXT("Bodies that leave as one: names with commas between them"));
  sequence.option("--before", options.before, GLISSADE_TEXT("first,then: the first body leaves before the second"));
  sequence.option("--place", options.places,
                  GLISSADE_TEXT("3,name: the body leaves as the third step; 3,name,name: as one"));
  sequence.option("--forbid", options.forbidden,
                  GLISSADE_TEXT("name,-z or name,0,0,-1: the body does not leave in this direction"));
  sequence.option(
      "--joints", options.joints,
      GLISSADE_TEXT("Joints that the plan keeps to: recognised, suggested (those too that a person would have to "
                    "confirm) or off (default: the scenario's, or recognised)"));
  sequence
      .option("--gravity", options.gravity,
              GLISSADE_TEXT("Direction of gravity: x y z (default: the scenario's, or 0 0 -1)"))
      ->expected(3);
  sequence.option(
      "--cost", options.cost,
      GLISSADE_TEXT(
          "What a step costs for best-first: fitter, balanced, steady, few-tools, short, fragile-first, as-found, "
          "or an expression (default: the scenario's, or fitter)"));
  addPartDeflection(sequence, options.deflection);
  addWithout(sequence, options.without);
  addOpen(sequence, options.open);
  addFitOptions(sequence, options.fits, GLISSADE_TEXT("on, or the scenario's"));
  addConsole(sequence, options.console);
  return sequence;
}

Command addTimes(const Command& app, TimesOptions& options) {
  const Command times =
      app.subcommand("times", GLISSADE_TEXT("How long the steps of an assembly plan take, also divided over a line"));
  times.option("FILE", options.product, GLISSADE_TEXT("The product of the plan: a scenario or a STEP file"))
      ->required();
  times.option("PLAN", options.plan, GLISSADE_TEXT("Assembly plan, as 'sequence --out' writes it"))->required();
  times.option("--stations", options.stations,
               GLISSADE_TEXT("Divide the steps over so many stations, one person each"));
  times.option("--table", options.table, GLISSADE_TEXT("File of work times (default: the program's estimates)"));
  times.option("--write-table", options.writeTable,
               GLISSADE_TEXT("Write the table of work times to a file, to be edited"));
  addConsole(times, options.console);
  return times;
}

Command addAccess(const Command& app, AccessOptions& options) {
  const Command access = app.subcommand(
      "access", GLISSADE_TEXT("Whether a hand gets to a path or to the steps of an assembly plan, and an eye sees"));
  access->footer(
      "Hand, forearm and tool are sampled along each motion; this is no proof. Measures: ANSUR II (NATICK/TR-15/007).\n"
      "Exit codes: 0 all is reached and seen, 1 not all, 2 wrong usage, 3 unreadable input, 130 interrupted.");
  access.option("FILE", options.file, GLISSADE_TEXT("The scenario of the path, or the product of the plan"))
      ->required();
  access.option("--path", options.path, "Path of the object: " + toString(readablePathFormats()));
  access.option("--plan", options.plan, GLISSADE_TEXT("Assembly plan, as 'sequence --out' writes it"));
  std::map<std::string, HandSize> sizes;
  for (const HandSize size : kHandSizes) sizes[kHandSizeNames.of(size)] = size;
  access
      .optionFor<std::string>(
          "--hand", [&options, sizes](const std::string& size) { options.hand = sizes.at(size); },
          GLISSADE_TEXT(
              "Whose hand: p5f 5th percentile of women, p50 average, p95m 95th percentile of men (default: p50)"))
      ->check(CLI::IsMember(sizes));
  access
      .option("--eye", options.eye,
              GLISSADE_TEXT(
                  "From where the place is looked at: x y z in metres (default: 17 positions above it are tried)"))
      ->expected(3);
  addConsole(access, options.console);
  return access;
}

Command addConvert(const Command& app, ConvertOptions& options) {
  const Command convert =
      app.subcommand("convert", GLISSADE_TEXT("Convert an OMPL.app .cfg to a scenario, or a path to another format"));
  convert
      .option("IN", options.input, "What to read: a .cfg, a scenario; or a path: " + toString(readablePathFormats()))
      ->required();
  convert
      .option("OUT", options.output, "What to write: a scenario (.json); or a path: " + toString(writablePathFormats()))
      ->required();
  convert.option("--scenario", options.scenario,
                 GLISSADE_TEXT("Scenario of the path, for formats that hold its clearances or bodies"));
  return convert;
}

Command addNew(const Command& app, NewOptions& options) {
  const Command make = app.subcommand(
      "new", GLISSADE_TEXT("Make a scenario of part files (meshes, STEP, IGES, BREP, URDF), of which one moves"));
  make->footer(
      "A part of a STEP file is named behind its file: --moves product.step:pin --static product.step makes a body\n"
      "of every other part. An assembly in the file (product.step:pump) stands for all of its parts; two parts of\n"
      "one name are pin and pin#2. A solid of a part of several (product.step:frame/solid#2) opens the part: each of\n"
      "its solids is a body. #3 is the third part that 'info' lists. A group of an OBJ file is named in the same way: "
      "--moves product.obj:lid --groups\n"
      "--static product.obj makes a body of every other group.");
  make.option("OUT", options.output, GLISSADE_TEXT("Scenario file to write"))->required();
  make.option("--moves", options.moving, GLISSADE_TEXT("The part that moves (can be repeated: they move as one)"))
      ->required()
      ->allow_extra_args(false);
  make.option("--static", options.statics, GLISSADE_TEXT("Parts that stay where they are"));
  make.option("--mobile", options.mobiles, GLISSADE_TEXT("Parts in the way that a person could move"));
  make.length(
      "--unit", [&options](double unit) { options.unit = unit; },
      GLISSADE_TEXT("A unit of the files, as 1mm, 1m, 1in or 25.4mm (default: 1m for Collada and glTF; for other "
                    "meshes 1mm, or 1m "
                    "where only that fits their size, which a warning says); STEP and URDF files say it themselves"));
  const std::map<std::string, UpAxis> axes{{"y", UpAxis::Y}, {"z", UpAxis::Z}};
  make.optionFor<std::string>(
          "--up", [&options, axes](const std::string& axis) { options.up = axes.at(axis); },
          GLISSADE_TEXT("The files' axis that points up (default: y for Collada and glTF, z for other meshes)"))
      ->check(CLI::IsMember(axes));
  make.length(
      "--deflection",
      [&options](double deflection) {
        if (!limits::isSize(deflection))
          throw CLI::ValidationError("--deflection", GLISSADE_TEXT("is not from 1e-12 m to 1e9 m"));
        options.deflection = deflection;
      },
      GLISSADE_TEXT(
          "How far the triangles of STEP parts may be off their surfaces, as 0.05mm (default: a thousandth of each "
          "part's diagonal, from 0.01mm to 0.5mm)"));
  make.flag("--groups", options.groups, GLISSADE_TEXT("Take each group of an OBJ file (o or g) as a part of its own"));
  make.flag("--close-holes", options.closeHoles, GLISSADE_TEXT("Close the planar holes of meshes, and print how many"));
  addWithout(make, options.without);
  addFitOptions(make, options.fits, GLISSADE_TEXT("on"));
  make.flag("--clear", options.clear,
            GLISSADE_TEXT("Move the start clear of the bodies that it touches, and print how far"));
  return make;
}

Command addStudy(const Command& app, StudyOptions& options) {
  const Command study =
      app.subcommand("study", GLISSADE_TEXT("Repeat runs over scenarios, strategies, parameters and seeds"));
  study.option("STUDY", options.study, GLISSADE_TEXT("Study file (samples/studies)"))->required();
  study.option("--out", options.out, GLISSADE_TEXT("Folder of the results; a study that was begun there is continued"))
      ->required();
  study.option("--jobs", options.jobs, GLISSADE_TEXT("Runs at once"))
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  study.option("--shard", options.shard, GLISSADE_TEXT("I/N: only every N-th run, from the I-th; see merge"))
      ->capture_default_str();
  study.flag("--quick", options.quick, GLISSADE_TEXT("The study's quick section: about a minute"));
  study.flag("--dry-run", options.dryRun, GLISSADE_TEXT("Print what would be run; write nothing"));
  return study;
}

Command addMerge(const Command& app, MergeOptions& options) {
  const Command merge = app.subcommand(
      "merge", GLISSADE_TEXT("Combine the results of the parts of a study (--shard) and write its tables"));
  merge.option("DIR", options.folders, GLISSADE_TEXT("Folders of results"))->required();
  merge.option("--out", options.out, GLISSADE_TEXT("Folder of the combined results"))->required();
  return merge;
}

Command addReport(const Command& app, ReportOptions& options) {
  const Command report =
      app.subcommand("report", GLISSADE_TEXT("Write the report of a study: tables, plots, findings, one HTML page"));
  report.option("DIR", options.folder, GLISSADE_TEXT("Folder of results"))->required();
  report.option("--out", options.out, GLISSADE_TEXT("Folder of report.html (default: DIR)"));
  report.option("--language", options.language, GLISSADE_TEXT("Language of the report"))
      ->check(CLI::IsMember({"en", "fr"}))
      ->capture_default_str();
  return report;
}

Command addBenchmarkPage(const Command& app, std::string& folder) {
  const Command page =
      app.subcommand("benchmark-page", GLISSADE_TEXT("Write the page of results of packaging/benchmarks.sh"));
  page.option("DIR", folder, GLISSADE_TEXT("Folder of results"))->required();
  return page;
}

Command addReplay(const Command& app, ReplayOptions& options) {
  const Command replay =
      app.subcommand("replay", GLISSADE_TEXT("Run a recorded run again and compare the roadmaps bit by bit"));
  replay.option("RECORD", options.record, GLISSADE_TEXT("Run record, or the journal of a run that was interrupted"))
      ->required();
  replay.option("--scenario", options.scenario,
                GLISSADE_TEXT("Scenario of the run (default: the one that the record names)"));
  addConsole(replay, options.console);
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
                    std::string("cannot be written: ") + std::strerror(error),
                    GLISSADE_TEXT("Send it to another file.")};
}

}  // namespace

int main(int argc, char** argv) {
  signal(SIGPIPE, SIG_IGN);
  signal(SIGXFSZ, SIG_IGN);
  PrintableOutput output(std::cout);
  const PrintableOutput errors(std::cerr);
  int status = 0;
  auto why = glissade::guarded(GLISSADE_TEXT("running the command"), [&] { status = run(argc, argv); });
  if (!why && status == 0) why = unwritten(output);
  if (!why) return status;
  std::cerr << "glissade-cli: " << glissade::toString(*why) << "\n";
  return glissade::exitCode(why->kind);
}
