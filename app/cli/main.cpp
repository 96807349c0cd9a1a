// glissade-cli: the commands that need no window. It links no Qt.
#include <signal.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/parsed_command.h"
#include "app/cli/printable_output.h"
#include "engine/base/enum_names.h"
#include "engine/base/guarded.h"
#include "engine/base/limits.h"
#include "engine/base/version_text.h"
#include "engine/files/path_exporter.h"
#include "engine/operator/simulated_operators.h"

namespace {

using namespace glissade;
using namespace glissade::cli;

void addConsole(const ParsedCommand& command, Console& console) {
  command.flag("--json", console.json, GLISSADE_TEXT("One JSON object on standard output and nothing else"));
}

std::string plannerNames() {
  std::string names;
  const PlannerRegistry registry = makePlannerRegistry();
  for (const PlannerEntry& entry : registry.entries()) names += (names.empty() ? "" : ", ") + entry.id;
  return names;
}

/// Adds an option whose values are the names of an enumeration.
template <class Value, class Enum, std::size_t count>
void addChoice(const ParsedCommand& command, const std::string& option, Value& value,
               const EnumNames<Enum, count>& names, const Message& help) {
  command
      .optionFor<std::string>(
          option, [&value, &names](const std::string& name) { value = *names.find(name); }, help)
      ->check(CLI::IsMember(std::set<std::string>(names.names.begin(), names.names.end())));
}

/// Adds one option for each row of the parameter table. Ranges are checked when the object's size is known.
void addParameters(const ParsedCommand& command, std::map<ParameterId, double>& values) {
  for (const ParameterSpec& spec : parameterTable()) {
    const Message help =
        spec.unit.empty() ? Message(spec.help) : Message{CatalogueText{"%1 [%2]"}, {spec.help, spec.unit}};
    const std::string option(spec.option);
    const auto take = [&values, id = spec.id](double value) { values[id] = value; };
    if (spec.unit == "m") {
      command.length(option, take, help);
    } else {
      command.optionFor<double>(option, take, help);
    }
  }
}

void addAcceptClashes(const ParsedCommand& command, FitOptions& options) {
  command.length(
      "--accept-clashes",
      [&options, command](double overlap) {
        const Message below = GLISSADE_TEXT("is below zero: give a length, as 1.5mm");
        if (overlap < 0.0) throw CLI::ValidationError("--accept-clashes", command.text(below));
        options.acceptedClash = overlap;
      },
      GLISSADE_TEXT("Take clashes up to this overlap as fits, as 1.5mm; advised: each clash by its own overlap"),
      ParsedCommand::NamedLength{"advised", kAdvisedClashes});
  command.option(
      "--cut", options.cut,
      GLISSADE_TEXT("In accepted clashes, the body that is cut where it is not clear which of the two has the hole"));
}

void addFitOptions(const ParsedCommand& command, FitOptions& options, const Message& usual) {
  command
      .optionFor<std::string>("--fits", [&options](const std::string& mode) { options.on = mode == "on"; },
                              {GLISSADE_TEXT("Whether bodies that fit where they are assembled have an allowance "
                                             "against each other: on or off (default: %1)"),
                               {usual}})
      ->check(CLI::IsMember({"on", "off"}));
  addAcceptClashes(command, options);
}

ParsedCommand addPlan(const ParsedCommand& app, PlanOptions& options) {
  const ParsedCommand plan = app.subcommand("plan", GLISSADE_TEXT("Plan a motion and deliver it with its certificate"));
  plan.option("SCENARIO", options.scenario, GLISSADE_TEXT("Scenario file or OMPL.app .cfg"))->required();
  plan.option("--strategy", options.strategy,
              {GLISSADE_TEXT("Planner: %1 (default: the scenario's)"), {plannerNames()}});
  addChoice(plan, "--collision", options.collision, kCollisionBackendNames,
            GLISSADE_TEXT("Collision checker: kernel or fcl (default: kernel)"));
  addFitOptions(plan, options.fits, GLISSADE_TEXT("the scenario's"));
  plan.option("--operator", options.operatorName,
              {GLISSADE_TEXT("Operator: %1 or replay:FILE"), {simulatedOperatorNames()}});
  plan.option("--way", options.way,
              GLISSADE_TEXT("A simulated operator follows this path, not the scenario's way-points"));
  addParameters(plan, options.parameters);
  plan.app().add_flag_callback(
      "--smooth", [&options] { options.parameters.try_emplace(ParameterId::Smoothing, kUsualShortcuts); },
      plan.text({GLISSADE_TEXT("Shorten the path and keep it certified: --smoothing %1"), {kUsualShortcuts}}));
  plan.flag("--edges", options.edges, GLISSADE_TEXT("Report the certificate of every edge"));
  plan.flag("--difficulty", options.difficulty, GLISSADE_TEXT("Where no path is found, print the reasons"));
  plan.option("--seed", options.seed, GLISSADE_TEXT("Seed of everything random (default: the scenario's)"));
  plan.option("--out", options.out, {GLISSADE_TEXT("Write the path: %1"), {writablePathFormats()}});
  plan.option("--record", options.record, GLISSADE_TEXT("Write a run record for replay"));
  addConsole(plan, options.console);
  return plan;
}

/// Adds the option that all commands about products have.
void addWithout(const ParsedCommand& command, std::vector<std::string>& without) {
  command.option("--without", without,
                 GLISSADE_TEXT("Exclude a body or an assembly of the product: its name (can be repeated)"));
}

/// Adds the option that all commands about product files have.
void addOpen(const ParsedCommand& command, std::vector<std::string>& open) {
  command.option("--open", open,
                 GLISSADE_TEXT("Split a part of several solids into these: its name (can be repeated)"));
}

/// Adds the option of commands that work in several threads and whose results do not depend on their number.
void addLanes(const ParsedCommand& command, std::size_t& lanes) {
  command
      .option("--lanes", lanes, GLISSADE_TEXT("Threads; they do not change the result (default: one for each core)"))
      ->check(CLI::Range(1, 1024));
}

ParsedCommand addCheck(const ParsedCommand& app, CheckOptions& options) {
  const ParsedCommand check =
      app.subcommand("check", GLISSADE_TEXT("Check a path or an assembly plan with the independent check"));
  check
      .option("SCENARIO", options.scenario,
              GLISSADE_TEXT("Scenario file or OMPL.app .cfg; of an assembly plan the product, as in sequence"))
      ->required();
  check.option("PATH", options.path, {GLISSADE_TEXT("Assembly plan, or path: %1"), {readablePathFormats()}})
      ->required();
  check.length(
      std::string(specOf(ParameterId::RequiredClearance).option),
      [&options](double value) { options.requiredClearance = value; },
      GLISSADE_TEXT("Clearance to certify [m] (default: the scenario's)"));
  addFitOptions(check, options.fits, GLISSADE_TEXT("the scenario's"));
  check.flag("--edges", options.edges, GLISSADE_TEXT("Report the certificate of every edge"));
  check.flag("--trust-plan", options.trustPlan,
             GLISSADE_TEXT("What the plan states itself counts as the user's decision: bends, flexible bodies, units, "
                           "accepted clashes, constraints that are given up"));
  addWithout(check, options.without);
  addOpen(check, options.open);
  addLanes(check, options.lanes);
  check.option("--time-limit", options.timeLimit, GLISSADE_TEXT("Time limit in seconds; 0: none"))
      ->capture_default_str();
  addConsole(check, options.console);
  return check;
}

ParsedCommand addSmooth(const ParsedCommand& app, SmoothOptions& options) {
  const ParsedCommand smooth =
      app.subcommand("smooth", GLISSADE_TEXT("Shorten a certified path and keep it certified"));
  smooth.option("SCENARIO", options.scenario, GLISSADE_TEXT("Scenario file or OMPL.app .cfg"))->required();
  smooth.option("PATH", options.input, {GLISSADE_TEXT("Path: %1"), {readablePathFormats()}})->required();
  smooth.option("OUT", options.output, {GLISSADE_TEXT("Write the path: %1"), {writablePathFormats()}})->required();
  smooth.option("--attempts", options.attempts, GLISSADE_TEXT("Shortcuts to try"))
      ->check(CLI::Range(0, 1'000'000))
      ->capture_default_str();
  smooth.option("--seed", options.seed, GLISSADE_TEXT("Seed of the shortcuts"))->capture_default_str();
  addConsole(smooth, options.console);
  return smooth;
}

ParsedCommand addSweep(const ParsedCommand& app, SweepOptions& options) {
  const ParsedCommand sweep =
      app.subcommand("sweep", GLISSADE_TEXT("Write the swept volume of a path: all that the object covers"));
  sweep.option("SCENARIO", options.scenario, GLISSADE_TEXT("Scenario file or OMPL.app .cfg"))->required();
  sweep.option("PATH", options.path, {GLISSADE_TEXT("Path: %1"), {readablePathFormats()}})->required();
  sweep.option("OUT", options.output, GLISSADE_TEXT("Write the swept volume: .stl (millimetres) or .glb"))->required();
  sweep.length(
      "--bound", [&options](double bound) { options.bound = bound; },
      GLISSADE_TEXT(
          "How far its surface may be from the object, as 0.5mm (default: one with which the volume is about 7 % too "
          "large)"));
  addConsole(sweep, options.console);
  return sweep;
}

ParsedCommand addInfo(const ParsedCommand& app, InfoOptions& options) {
  const ParsedCommand info =
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

void checkDeflection(double metres, const ParsedCommand& command) {
  if (limits::isSize(metres)) return;
  throw CLI::ValidationError("--deflection", command.text(GLISSADE_TEXT("is not from 1e-12 m to 1e9 m")));
}

/// Adds the option for commands that take part files; a scenario states the deflection of its assets itself.
void addPartDeflection(const ParsedCommand& command, double& deflection) {
  command.length(
      "--deflection",
      [&deflection, command](double value) {
        checkDeflection(value, command);
        deflection = value;
      },
      GLISSADE_TEXT("Mesh tolerance: how far triangles may be off the surfaces of a STEP file, as 0.05mm (default: "
                    "automatic, by the size of each part)"));
}

ParsedCommand addFits(const ParsedCommand& app, FitsOptions& options) {
  const ParsedCommand fits =
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

/// Adds the options of commands about the joints of a product.
ParsedCommand addJointOptions(const ParsedCommand& joints, JointsOptions& options) {
  joints
      .option("FILE", options.file,
              GLISSADE_TEXT("Scenario, STEP, IGES or BREP file, or an assembly in one (product.step:pump)"))
      ->required();
  joints
      .optionFor<std::string>(
          "--joints", [&options](const std::string& mode) { options.confirmsSuggested = mode == "suggested"; },
          GLISSADE_TEXT("suggested: joints that are suggested count as if the user had confirmed them; recognised: "
                        "they do not (default)"))
      ->check(CLI::IsMember({"recognised", "suggested"}));
  addPartDeflection(joints, options.deflection);
  addWithout(joints, options.without);
  addOpen(joints, options.open);
  addConsole(joints, options.console);
  return joints;
}

ParsedCommand addJoints(const ParsedCommand& app, JointsOptions& options) {
  return addJointOptions(
      app.subcommand("joints", GLISSADE_TEXT("List how the bodies of a product are joined: screws, nuts, inserts")),
      options);
}

ParsedCommand addLiaisons(const ParsedCommand& app, JointsOptions& options) {
  return addJointOptions(app.subcommand("liaisons", GLISSADE_TEXT("Write the liaison graph as CSV or JSON")), options);
}

ParsedCommand addSequence(const ParsedCommand& app, SequenceOptions& options) {
  const ParsedCommand sequence = app.subcommand(
      "sequence",
      GLISSADE_TEXT("Find in which order the parts of a product are removed, with a certified motion each"));
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
  sequence.option("--resume", options.resume, GLISSADE_TEXT("Resume a plan that has not ended"));
  sequence.option("--reuse", options.reuse,
                  GLISSADE_TEXT("Try the motions of this plan of an earlier revision before new ones are searched"));
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
  sequence.option("--stay", options.staying,
                  GLISSADE_TEXT("Bodies fixed as base: they are not removed (default: a large one that touches many)"));
  sequence.option("--together", options.together,
                  GLISSADE_TEXT("Bodies that are removed as one: names with commas between them"));
  sequence.option("--before", options.before, GLISSADE_TEXT("first,then: the first body is removed before the second"));
  sequence.option("--place", options.places,
                  GLISSADE_TEXT("3,name: the body is removed in the third step; 3,name,name: as one"));
  sequence.option("--forbid", options.forbidden,
                  GLISSADE_TEXT("name,-z or name,0,0,-1: the body is not removed in this direction"));
  sequence.option("--joints", options.joints,
                  GLISSADE_TEXT("Joints that the plan respects: recognised, suggested (those too that the user would "
                                "have to confirm) or off (default: the scenario's, or recognised)"));
  sequence
      .option("--gravity", options.gravity,
              GLISSADE_TEXT("Direction of gravity: x y z (default: the scenario's, or such that the base lies well)"))
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

ParsedCommand addTimes(const ParsedCommand& app, TimesOptions& options) {
  const ParsedCommand times = app.subcommand(
      "times", GLISSADE_TEXT("Assembly times: how long the steps of an assembly plan take, also balanced over a line"));
  times.option("FILE", options.product, GLISSADE_TEXT("The product of the plan: a scenario or a STEP file"))
      ->required();
  times.option("PLAN", options.plan, GLISSADE_TEXT("Assembly plan, as 'sequence --out' writes it"))->required();
  times.option("--stations", options.stations,
               GLISSADE_TEXT("Balance the steps over so many stations, one person each"));
  times.option("--table", options.table, GLISSADE_TEXT("File of work times (default: the program's estimates)"));
  times.option("--write-table", options.writeTable,
               GLISSADE_TEXT("Write the table of work times to a file, to be edited"));
  addConsole(times, options.console);
  return times;
}

ParsedCommand addCompare(const ParsedCommand& app, CompareOptions& options) {
  const ParsedCommand compare = app.subcommand(
      "compare",
      GLISSADE_TEXT(
          "Compare two revisions of a product: parts that came, went, moved or changed, and steps that hold"));
  compare.app().footer(compare.text(GLISSADE_TEXT(
      "Parts correspond by their names. With a plan of the earlier revision, each of its steps is judged in "
      "the later one.\nExit codes: 0 the same, or all steps hold; 1 there are differences, or steps do not "
      "hold; 2 wrong usage, 3 unreadable input, 130 interrupted.")));
  compare.option("OLD", options.before, GLISSADE_TEXT("The earlier revision: a scenario or a part file"))->required();
  compare.option("NEW", options.now, GLISSADE_TEXT("The later revision"))->required();
  compare.option("--plan", options.plan, GLISSADE_TEXT("Assembly plan of the earlier revision"));
  addConsole(compare, options.console);
  return compare;
}

ParsedCommand addAccess(const ParsedCommand& app, AccessOptions& options) {
  const ParsedCommand access = app.subcommand(
      "access",
      GLISSADE_TEXT(
          "Hand access: whether a hand reaches a path or the steps of an assembly plan, and whether they are visible"));
  access.app().footer(
      access.text(GLISSADE_TEXT("Hand, forearm and tool are sampled along each motion; this is no proof. Measures: "
                                "ANSUR II (NATICK/TR-15/007).\nExit codes: 0 all is reachable and visible, 1 not all, "
                                "2 wrong usage, 3 unreadable input, 130 interrupted.")));
  access.option("FILE", options.file, GLISSADE_TEXT("The scenario of the path, or the product of the plan"))
      ->required();
  access.option("--path", options.path, {GLISSADE_TEXT("Path of the object: %1"), {readablePathFormats()}});
  access.option("--plan", options.plan, GLISSADE_TEXT("Assembly plan, as 'sequence --out' writes it"));
  addChoice(access, "--hand", options.hand, kHandSizeNames,
            GLISSADE_TEXT(
                "Whose hand: p5f 5th percentile of women, p50 average, p95m 95th percentile of men (default: p50)"));
  access
      .option("--eye", options.eye,
              GLISSADE_TEXT("Viewpoint on the work: x y z in metres (default: 17 positions above it are tried)"))
      ->expected(3);
  addConsole(access, options.console);
  return access;
}

ParsedCommand addConvert(const ParsedCommand& app, ConvertOptions& options) {
  const ParsedCommand convert =
      app.subcommand("convert", GLISSADE_TEXT("Convert an OMPL.app .cfg to a scenario, or a path to another format"));
  convert
      .option("IN", options.input,
              {GLISSADE_TEXT("What to read: a .cfg, a scenario; or a path: %1"), {readablePathFormats()}})
      ->required();
  convert
      .option("OUT", options.output,
              {GLISSADE_TEXT("What to write: a scenario (.json); or a path: %1"), {writablePathFormats()}})
      ->required();
  convert.option("--scenario", options.scenario,
                 GLISSADE_TEXT("Scenario of the path, for formats that hold its clearances or bodies"));
  return convert;
}

ParsedCommand addNew(const ParsedCommand& app, NewOptions& options) {
  const ParsedCommand make = app.subcommand(
      "new", GLISSADE_TEXT("Make a scenario of part files (meshes, STEP, IGES, BREP, URDF), with one moving part"));
  make.app().footer(make.text(GLISSADE_TEXT(
      "A part of a STEP file is named behind its file: --moves product.step:pin --static product.step makes a body\n"
      "of every other part. An assembly in the file (product.step:pump) stands for all of its parts; two parts of\n"
      "one name are pin and pin#2. A solid of a part of several (product.step:frame/solid#2) opens the part: each of\n"
      "its solids is a body. #3 is the third part that 'info' lists. A group of an OBJ file is named in the same way: "
      "--moves product.obj:lid --groups\n"
      "--static product.obj makes a body of every other group.")));
  make.option("OUT", options.output, GLISSADE_TEXT("Scenario file to write"))->required();
  make.option("--moves", options.moving, GLISSADE_TEXT("The moving part (can be repeated: they move as one)"))
      ->required()
      ->allow_extra_args(false);
  make.option("--static", options.statics, GLISSADE_TEXT("Static parts: they do not move"));
  make.option("--mobile", options.mobiles, GLISSADE_TEXT("Parts in the way that a person could move"));
  make.length(
      "--unit", [&options](double unit) { options.unit = unit; },
      GLISSADE_TEXT("A unit of the files, as 1mm, 1m, 1in or 25.4mm (default: 1m for Collada and glTF; for other "
                    "meshes 1mm, or 1m "
                    "where only that fits their size, which a warning says); STEP and URDF files say it themselves"));
  addChoice(make, "--up", options.up, kUpAxisNames,
            GLISSADE_TEXT("The files' axis that points up (default: y for Collada and glTF, z for other meshes)"));
  make.length(
      "--deflection",
      [&options, make](double deflection) {
        checkDeflection(deflection, make);
        options.deflection = deflection;
      },
      GLISSADE_TEXT("Mesh tolerance: how far the triangles of STEP parts may be off their surfaces, as 0.05mm "
                    "(default: a thousandth of each part's diagonal, from 0.01mm to 0.5mm)"));
  make.flag("--groups", options.groups, GLISSADE_TEXT("Split OBJ files: each group (o or g) is a part of its own"));
  make.flag("--close-holes", options.closeHoles, GLISSADE_TEXT("Close the planar holes of meshes, and print how many"));
  addWithout(make, options.without);
  addFitOptions(make, options.fits, Message("on"));
  make.flag(
      "--clear", options.clear,
      GLISSADE_TEXT("Resolve collisions at the start: move it clear of the bodies that it touches, and print how far"));
  return make;
}

ParsedCommand addStudy(const ParsedCommand& app, StudyOptions& options) {
  const ParsedCommand study =
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
  study.flag("--report", options.report, GLISSADE_TEXT("Write report.html, too (needs Python and matplotlib)"));
  study.flag("--dry-run", options.dryRun, GLISSADE_TEXT("Print what would be run; write nothing"));
  return study;
}

ParsedCommand addMerge(const ParsedCommand& app, MergeOptions& options) {
  const ParsedCommand merge = app.subcommand(
      "merge", GLISSADE_TEXT("Combine the results of the parts of a study (--shard) and write its tables"));
  merge.option("DIR", options.folders, GLISSADE_TEXT("Folders of results"))->required();
  merge.option("--out", options.out, GLISSADE_TEXT("Folder of the combined results"))->required();
  merge.flag("--report", options.report, GLISSADE_TEXT("Write report.html, too (needs Python and matplotlib)"));
  return merge;
}

ParsedCommand addReport(const ParsedCommand& app, ReportOptions& options) {
  const ParsedCommand report =
      app.subcommand("report", GLISSADE_TEXT("Write the report of a study: tables, plots, findings, one HTML page"));
  report.option("DIR", options.folder, GLISSADE_TEXT("Folder of results"))->required();
  report.option("--out", options.out, GLISSADE_TEXT("Folder of report.html and of the tables (default: DIR)"));
  report.option("--language", options.language, GLISSADE_TEXT("Language of the report"))
      ->check(CLI::IsMember({"en", "fr"}))
      ->capture_default_str();
  return report;
}

ParsedCommand addBenchmarkPage(const ParsedCommand& app, BenchmarkPageOptions& options) {
  const ParsedCommand page =
      app.subcommand("benchmark-page", GLISSADE_TEXT("Write the page of results of packaging/benchmarks.sh"));
  page.option("DIR", options.folder, GLISSADE_TEXT("Folder of results"))->required();
  return page;
}

ParsedCommand addReplay(const ParsedCommand& app, ReplayOptions& options) {
  const ParsedCommand replay =
      app.subcommand("replay", GLISSADE_TEXT("Run a recorded run again and compare the roadmaps bit by bit"));
  replay.option("RECORD", options.record, GLISSADE_TEXT("Run record, or the journal of a run that was interrupted"))
      ->required();
  replay.option("--scenario", options.scenario,
                GLISSADE_TEXT("Scenario of the run (default: the one that the record names)"));
  addConsole(replay, options.console);
  return replay;
}

/// A command with its options, and what it does.
struct RunnableCommand {
  ParsedCommand command;
  std::function<int(Language)> run;
};

template <class Options>
RunnableCommand runnable(const ParsedCommand& app, ParsedCommand (*add)(const ParsedCommand&, Options&),
                         int (*run)(const Options&)) {
  const auto options = std::make_shared<Options>();
  return {add(app, *options), [options, run](Language language) {
            options->console.language = language;
            return run(*options);
          }};
}

std::vector<RunnableCommand> addCommands(const ParsedCommand& app) {
  return {runnable(app, addPlan, runPlan),
          runnable(app, addReplay, runReplay),
          runnable(app, addCheck, runCheck),
          runnable(app, addSmooth, runSmooth),
          runnable(app, addSweep, runSweep),
          runnable(app, addInfo, runInfo),
          runnable(app, addFits, runFits),
          runnable(app, addJoints, runJoints),
          runnable(app, addLiaisons, runLiaisons),
          runnable(app, addSequence, runSequence),
          runnable(app, addCompare, runCompare),
          runnable(app, addTimes, runTimes),
          runnable(app, addAccess, runAccess),
          runnable(app, addStudy, runStudyCommand),
          runnable(app, addMerge, runMerge),
          runnable(app, addReport, runReport),
          runnable(app, addBenchmarkPage, runBenchmarkPage),
          runnable(app, addConvert, runConvert),
          runnable(app, addNew, runNew)};
}

/// The language that the arguments ask for, before they are parsed, so that the help is in it.
Language languageOfHelp(int argc, char** argv) {
  const std::string option = "--language";
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == option && i + 1 < argc) return languageOf(argv[i + 1]).value_or(Language::English);
    if (word.rfind(option + "=", 0) == 0) {
      return languageOf(word.substr(option.size() + 1)).value_or(Language::English);
    }
  }
  return Language::English;
}

int run(int argc, char** argv, Console& console) {
  CLI::App parser;
  console.language = languageOfHelp(argc, argv);
  const ParsedCommand app = commandLine(parser, console.language, "glissade-cli " + versionText());
  std::string language = "en";
  app.option("--language", language, GLISSADE_TEXT("Language of messages and texts, also behind a command"))
      ->check(CLI::IsMember({"en", "fr"}))
      ->capture_default_str();
  const std::vector<RunnableCommand> commands = addCommands(app);
  try {
    parser.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return parser.exit(error) == 0 ? 0 : exitCode(ErrorKind::Usage);
  }
  console.language = *languageOf(language);
  const auto chosen = std::find_if(commands.begin(), commands.end(),
                                   [](const RunnableCommand& each) { return each.command.app().parsed(); });
  return chosen->run(console.language);
}

/// Why standard output could not be written, or nothing. A closed pipe, as of head, is no error.
std::optional<Diagnostic> unwritten(PrintableOutput& output) {
  const int error = output.flush();
  if (error == 0 || error == EPIPE) return std::nullopt;
  return Diagnostic{ErrorKind::Unwritable,
                    "",
                    GLISSADE_TEXT("standard output"),
                    {GLISSADE_TEXT("cannot be written: %1"), {std::strerror(error)}},
                    GLISSADE_TEXT("Send it to another file.")};
}

}  // namespace

int main(int argc, char** argv) {
  signal(SIGPIPE, SIG_IGN);
  signal(SIGXFSZ, SIG_IGN);
  PrintableOutput output(std::cout);
  const PrintableOutput errors(std::cerr);
  Console console;
  int status = 0;
  auto why = glissade::guarded(GLISSADE_TEXT("running the command"), [&] { status = run(argc, argv, console); });
  if (!why && status == 0) why = unwritten(output);
  if (!why) return status;
  noteError(*why, console);
  return glissade::exitCode(why->kind);
}
