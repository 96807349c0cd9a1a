// The commands of glissade-cli: the options of each command and the function that carries it out. A command returns the
// exit code.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/report.h"
#include "engine/access/hand_measures.h"
#include "engine/base/thread_team.h"
#include "engine/files/part_files.h"
#include "engine/fits/contact_report.h"
#include "engine/model/fit_options.h"
#include "engine/planning/smoothing/shortcuts.h"
#include "engine/study/study_plan.h"

namespace glissade::cli {

struct PlanOptions {
  std::string scenario;
  std::optional<std::string> strategy;  ///< planner id; the scenario's where absent
  CollisionBackend collision = CollisionBackend::Kernel;
  std::string operatorName = "none";         ///< none, novice, default, expert, task-expert, ... or replay:FILE
  std::string way;                           ///< path file with the way-points of a simulated operator; empty: none
  std::map<ParameterId, double> parameters;  ///< values that override the scenario's
  FitOptions fits;
  std::optional<std::uint64_t> seed;
  std::string out;          ///< path file to write, format by its ending; empty: none
  std::string record;       ///< run record to write; empty: none
  bool edges = false;       ///< certificates of every edge
  bool difficulty = false;  ///< report the reasons if no path is found
  Console console;
};

/// glissade-cli plan: plans in lockstep and delivers a certified path. Exit code 0 solved, 5 limit
/// reached, 4 start or goal in collision, 130 interrupted.
int runPlan(const PlanOptions& options);

struct ReplayOptions {
  std::string record;
  std::string scenario;  ///< empty: the scenario that the record names
  Console console;
};

/// glissade-cli replay: runs a recorded run again and compares the roadmaps bit by bit. Exit code 0 equal, 1 different.
/// Records of version 1 hold no fingerprints: for them the numbers of nodes are compared.
int runReplay(const ReplayOptions& options);

struct CheckOptions {
  std::string scenario;
  std::string path;
  std::optional<double> requiredClearance;  ///< metres; the scenario's where absent
  FitOptions fits;
  std::vector<std::string> without{};  ///< bodies and assemblies of a plan's product that are left out
  bool trustPlan = false;              ///< statements of the plan count as a person's word
  std::vector<std::string> open{};     ///< parts of several solids that are taken as their solids
  bool edges = false;                  ///< certificates of every edge
  double timeLimit = 0.0;              ///< seconds; 0: none
  std::size_t lanes = usableCores();   ///< threads for the steps of a plan; they do not change the verdict
  Console console;
};

/// glissade-cli check: judges a path or an assembly plan (engine/check). Exit code 0 valid, 1 invalid or incomplete, 5
/// undecided at the time limit, 6 valid except for flexible bodies, whose motions are not proved, 7 valid only under
/// conditions that the plan states itself, 130 interrupted.
int runCheck(const CheckOptions& options);

struct SmoothOptions {
  std::string scenario;
  std::string input;
  std::string output;  ///< format by its ending
  int attempts = kUsualShortcuts;
  std::uint64_t seed = 1;
  Console console;
};

/// glissade-cli smooth: shortens a path and keeps it certified. Exit code 0 written, 1 if the given path is not
/// certified.
int runSmooth(const SmoothOptions& options);

struct SweepOptions {
  std::string scenario;
  std::string path;
  std::string output;
  std::optional<double> bound;  ///< metres
  Console console;
};

/// glissade-cli sweep: writes the volume that the object covers along a path as STL or GLB. Exit code 0 written.
int runSweep(const SweepOptions& options);

struct InfoOptions {
  std::string file;
  bool places = false;              ///< build the environment model too
  bool saveRegions = false;         ///< write the regions of the forbidden places into the scenario file
  std::vector<std::string> open{};  ///< parts of several solids that are taken as their solids
  Console console;
};

/// glissade-cli info: reports bodies, triangles, units, the quality of the meshes as solids, and on request octree,
/// places and borders. For a part file it reports the bodies.
int runInfo(const InfoOptions& options);

struct FitsOptions {
  std::string file;  ///< a scenario, or a part file as usualPart() takes it
  ContactLimits limits;
  FitOptions fits{};
  std::vector<std::string> without{};  ///< bodies and assemblies that are left out
  std::vector<std::string> open{};     ///< parts of several solids that are taken as their solids
  double deflection = 0.0;             ///< metres, for STEP files; 0: from the size of each part
  std::size_t lanes = usableCores();   ///< threads; they do not change the fits
  bool csv = false;
  Console console;
};

/// glissade-cli fits: contacts, fits and clashes of a product or scenario.
int runFits(const FitsOptions& options);

struct JointsOptions {
  std::string file;  ///< a scenario, or a part file as usualPart() takes it
  std::vector<std::string> without{};
  std::vector<std::string> open{};  ///< parts of several solids that are taken as their solids
  double deflection = 0.0;          ///< metres, for STEP files; 0: from the size of each part
  bool confirmsSuggested = false;   ///< suggested joints count as if a person had confirmed each of them
  Console console;
};

/// glissade-cli joints: reports how the bodies of a product or scenario are joined, including the scenario's joints.
int runJoints(const JointsOptions& options);

/// glissade-cli liaisons: the liaison graph of a product or scenario, as CSV or JSON for other programs.
int runLiaisons(const JointsOptions& options);

struct SequenceOptions {
  std::string file;                    ///< a scenario, or a part file as usualPart() takes it
  std::string strategy;                ///< empty: kUsualStrategy, or the strategy of the resumed plan
  std::optional<std::uint64_t> seed;   ///< absent: 1, or the seed of the resumed plan
  double timeLimit = 0.0;              ///< seconds; 0: none
  std::size_t lanes = usableCores();   ///< threads; they do not change the plan
  std::vector<std::string> staying;    ///< ids or ends of ids of bodies that stay; empty: see baseOf()
  std::vector<std::string> together;   ///< demands: names with commas between them
  std::vector<std::string> before;     ///< demands: "first,then"
  std::vector<std::string> places;     ///< demands: "3,name" or "3,name,name"
  std::vector<std::string> forbidden;  ///< demands: "name,-z" or "name,0,0,-1"
  std::vector<double> gravity;         ///< direction of gravity; empty: the scenario's, or down
  std::string joints;                  ///< a name of kJointUseNames; empty: the scenario's
  std::string cost;                    ///< cost of best-first: a preset or an expression; empty: the scenario's
  std::vector<std::string> without{};  ///< bodies and assemblies that are left out
  std::vector<std::string> open{};     ///< parts of several solids that are taken as their solids
  double deflection = 0.0;             ///< metres, for STEP files; 0: from the size of each part
  std::string out;                     ///< plan file to write; empty: none
  double saveEvery = 5.0;              ///< seconds between two writings of the unfinished plan
  std::string resume;                  ///< plan file to resume; empty: none
  std::string reuse;                   ///< plan file of an earlier revision, whose motions are tried; empty: none
  FitOptions fits;
  Console console;
};

/// glissade-cli sequence: plans the order in which the parts of a product leave, with certified motions. Exit code 0 if
/// all parts except those that stay leave, alone or as units; 6 if all leave and flexible bodies have no proof; 1 if
/// some parts are stuck or leave in groups that are not taken apart; 5 time limit; 130 interrupted. The unfinished plan
/// is always written.
int runSequence(const SequenceOptions& options);

struct CompareOptions {
  std::string before;  ///< the earlier revision: as in SequenceOptions
  std::string now;     ///< the later revision
  std::string plan;    ///< assembly plan of the earlier revision; empty: none
  Console console;
};

/// glissade-cli compare: reports which parts came, went, moved or changed their shape between two revisions of a
/// product, and which steps of a plan still hold. Exit code 0 if the revisions are the same or, with a plan, all steps
/// hold and every part has one; 1 otherwise.
int runCompare(const CompareOptions& options);

struct TimesOptions {
  std::string product;  ///< the product of the plan
  std::string plan;
  std::string table;       ///< file of work times; empty: the defaults
  std::string writeTable;  ///< file to write the table in force to; empty: none
  std::optional<std::size_t> stations;
  Console console;
};

/// glissade-cli times: reports how long a person takes for the steps of an assembly plan, which steps have to follow
/// each other, and how a line divides them. Exit code 0, 2 wrong usage, 3 unreadable input.
int runTimes(const TimesOptions& options);

struct AccessOptions {
  std::string file;
  std::string path;  ///< path of the scenario's object, or empty
  std::string plan;  ///< assembly plan of the product, or empty
  HandSize hand = HandSize::Average;
  std::vector<double> eye;  ///< eye position: three numbers, metres; empty: positions are tried
  Console console;
};

/// glissade-cli access: reports whether a hand reaches the object along a path, or the parts of the steps of a plan.
/// Exit codes: 0 the hand reaches all of them and the person sees them, 1 not all, and the codes of wrong usage and
/// input.
int runAccess(const AccessOptions& options);

struct StudyOptions {
  std::string study;
  std::string out;
  std::size_t jobs = 1;
  std::string shard = "1/1";
  bool quick = false;
  bool dryRun = false;
  bool report = false;
  Console console;
};

/// glissade-cli study: carries out the runs of a study, each in its own process, and writes the tables. Exit code 0 all
/// runs have ended, with or without a path; 130 interrupted (the same command resumes the study).
int runStudyCommand(const StudyOptions& options);

struct MergeOptions {
  std::vector<std::string> folders;
  std::string out;
  bool report = false;
  Console console;
};

/// glissade-cli merge: unites the results of shards. Exit code 3 if they belong to different studies.
int runMerge(const MergeOptions& options);

struct ReportOptions {
  std::string folder;
  std::string out;              ///< empty: the folder of the results
  std::string language = "en";  ///< of the report
  Console console;
};

/// glissade-cli report: writes tables and report.html for a folder of results. Exit code 3 also where Python or
/// matplotlib is not installed.
int runReport(const ReportOptions& options);

struct BenchmarkPageOptions {
  std::string folder;
  Console console;
};

/// glissade-cli benchmark-page: writes benchmarks.html for a folder that packaging/benchmarks.sh filled.
int runBenchmarkPage(const BenchmarkPageOptions& options);

struct ConvertOptions {
  std::string input;
  std::string output;
  std::string scenario;  ///< for path formats that hold clearances
  Console console;
};

/// glissade-cli convert: converts an OMPL.app .cfg to a scenario, or a path to another path format.
int runConvert(const ConvertOptions& options);

struct NewOptions {
  std::string output;
  std::vector<std::string> moving;  ///< parts as usualPart() takes them; several parts move as one
  std::vector<std::string> statics;
  std::vector<std::string> mobiles;
  std::vector<std::string> without{};  ///< bodies that are left out
  std::optional<double> unit;          ///< metres per unit of the files; absent: from the kind of the file or its size
  std::optional<UpAxis> up;
  double deflection = 0.0;  ///< metres, for STEP files; 0: from the size of each part
  bool closeHoles = false;  ///< close planar holes of meshes
  bool groups = false;      ///< groups of OBJ files are parts
  FitOptions fits;          ///< on unless the user turns them off
  bool clear = false;       ///< move the start clear of the bodies that it touches
  Console console;
};

/// glissade-cli new: makes a scenario of part files, one of which moves.
int runNew(const NewOptions& options);

}  // namespace glissade::cli
