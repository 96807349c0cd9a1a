#pragma once

#include <glissade/assembly_plan.h>
#include <glissade/export.h>
#include <glissade/mesh.h>
#include <glissade/operators.h>
#include <glissade/path.h>
#include <glissade/planners.h>
#include <glissade/problem.h>
#include <glissade/product.h>
#include <glissade/result.h>
#include <glissade/samplers.h>
#include <glissade/scenario.h>
#include <glissade/stop_token.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace glissade::api {

/// Called with the finished share of the work, in [0, 1], often, on a thread that works for the function.
using Progress = std::function<void(double share)>;

/// Options of load().
struct LoadOptions {
  double deflection = 0.0;  ///< largest deviation of triangles from the surfaces of a part file, metres; 0: by its size
  std::optional<bool> fits{};             ///< fits on or off; nothing: as the file says
  std::optional<double> acceptedClash{};  ///< clashes up to this overlap are accepted, metres
  std::vector<std::string> open{};        ///< parts of several solids that are taken as their solids
  std::vector<std::string> without{};     ///< bodies of a product that are left out
  StopToken stop{};                       ///< ends the reading
};

/// Reads a file. Value is Scenario (a scenario or an OMPL.app file), Product (a scenario, or a STEP, IGES, BREP, URDF
/// or mesh file), Mesh (STL, OBJ, PLY, Collada or glTF, in the unit of the file), Path, or AssemblyPlan. Files are
/// parsed in confined processes. Errors: MalformedInput with the place, Usage, Interrupted.
template <class Value>
Result<Value> load(const std::string& file, const LoadOptions& options = {});
/// load() of a scenario.
template <>
GLISSADE_EXPORT Result<Scenario> load(const std::string& file, const LoadOptions& options);
/// load() of a product.
template <>
GLISSADE_EXPORT Result<Product> load(const std::string& file, const LoadOptions& options);
/// load() of a mesh.
template <>
GLISSADE_EXPORT Result<Mesh> load(const std::string& file, const LoadOptions& options);
/// load() of a path.
template <>
GLISSADE_EXPORT Result<Path> load(const std::string& file, const LoadOptions& options);
/// load() of an assembly plan.
template <>
GLISSADE_EXPORT Result<AssemblyPlan> load(const std::string& file, const LoadOptions& options);

/// The cost of a run so far.
struct RunCounts {
  std::uint64_t steps = 0;                 ///< configurations that the planner has worked on
  std::uint64_t nodes = 0;                 ///< nodes of the roadmap
  std::uint64_t randomConfigurations = 0;  ///< configurations drawn by a sampler: the papers' measure
  std::uint64_t collisionQueries = 0;      ///< questions for collisions
  std::uint64_t distanceQueries = 0;       ///< questions for distances
};

/// Options of plan().
struct PlanOptions {
  std::string strategy{};                            ///< id of a planner; empty: the scenario's, or "auto"
  std::optional<std::uint64_t> seed{};               ///< nothing: the scenario's, or 1
  std::string operatorName = "none";                 ///< simulated operator: "none", "expert", "default", "novice", ...
  OperatorFunction operatorFunction{};               ///< an operator from outside, instead of `operatorName`
  SamplerFunction sampler{};                         ///< draws the random configurations; empty: the planner does
  Parameters parameters{};                           ///< values that override those of the problem
  const Planners* planners = nullptr;                ///< planners from outside; null: none. It has to outlive the call.
  std::function<void(const RunCounts&)> progress{};  ///< called on the calling thread, many times a second
  StopToken stop{};                                  ///< ends the run within 50 ms
};

/// The end of a run.
struct Run {
  Result<Path> path;       ///< the certified path, or the reason why there is none
  RunCounts counts;        ///< cost of the run
  std::string strategy{};  ///< id of the planner
  std::uint64_t seed = 0;  ///< seed of the run
  double seconds = 0.0;    ///< time of planning
};

/// Plans on the calling thread. The same problem, options and seed give the same path on every machine, except for a
/// time limit. Errors of the path: NoPath, InCollision, LimitReached, Interrupted, Usage.
GLISSADE_EXPORT Run plan(const Problem& problem, const PlanOptions& options = {});
/// Plans the problem of a scenario with its strategy and its seed.
GLISSADE_EXPORT Run plan(const Scenario& scenario, const PlanOptions& options = {});

/// Options of check().
struct CheckOptions {
  std::optional<double> requiredClearance{};  ///< metres; nothing: that of the scenario
  bool trustPlan = false;                     ///< statements of a plan count as a person's word
  LoadOptions files{};                        ///< how the product is read
  Progress progress{};                        ///< finished share
  StopToken stop{};                           ///< an unfinished verdict is Undecided
};

/// The outcome of a verdict.
enum class VerdictKind {
  Valid,         ///< everything is proved
  WithoutProof,  ///< valid except for flexible bodies, whose motions are not proved
  Conditional,   ///< valid under conditions that the plan states itself
  Incomplete,    ///< every step is proved, but some parts do not leave
  Undecided,     ///< stopped
  Invalid        ///< shown to be wrong
};

/// The verdict of the judge, which shares file readers, basic geometry and measurements of pairs with the planners.
struct Verdict {
  VerdictKind kind = VerdictKind::Undecided;  ///< the outcome
  std::string text{};                         ///< report for people, in English
  std::string json{};                         ///< report as a JSON document
  Warnings warnings{};                        ///< losses and doubts from reading the files

  /// True if everything is proved, and no body is flexible.
  bool valid() const { return kind == VerdictKind::Valid; }
};

/// Judges a path or an assembly plan. The judge reads both files itself. `product`: scenario or product file.
/// Errors: MalformedInput, Usage, Interrupted.
GLISSADE_EXPORT Result<Verdict> check(const std::string& product, const std::string& pathOrPlan,
                                      const CheckOptions& options = {});
/// Judges a path of a scenario in memory. CheckOptions::files does not count.
GLISSADE_EXPORT Result<Verdict> check(const Scenario& scenario, const Path& path, const CheckOptions& options = {});
/// Judges a path of a problem in memory. CheckOptions::files does not count. Bodies have no allowances.
GLISSADE_EXPORT Result<Verdict> check(const Problem& problem, const Path& path, const CheckOptions& options = {});
/// Judges a plan of a product in memory. CheckOptions::files does not count.
GLISSADE_EXPORT Result<Verdict> check(const Product& product, const AssemblyPlan& plan,
                                      const CheckOptions& options = {});

/// Options of fits(), joints() and clearance().
struct FindOptions {
  double clearanceUpTo = 0.0;      ///< fits(): pairs with a gap up to this are listed, metres
  double clashAbove = 1e-3;        ///< fits(): overlaps above this are clashes, metres
  bool confirmsSuggested = false;  ///< joints(): suggested joints count as if a person had confirmed them
  std::size_t samples = 200;       ///< clearance(): about this number of samples
  std::size_t threads = 0;         ///< number of threads, which do not change the result; 0: one for each core
  Progress progress{};             ///< finished share
  StopToken stop{};                ///< ends the search
};

/// Two bodies of a product that touch, overlap or are near each other.
struct Fit {
  std::string a{};           ///< id
  std::string b{};           ///< id
  std::string kind{};        ///< "planar", "cylindrical", "thread", "press", "overlap", ...
  double gap = 0.0;          ///< metres; 0 if they touch or overlap
  double overlap = 0.0;      ///< metres; 0 if they do not overlap
  double uncertainty = 0.0;  ///< largest error of gap and overlap by tessellation, metres
  double allowance = 0.0;    ///< how much thinner a body is taken against the other one, metres
  std::string status{};      ///< "clear", "allowed", "accepted" or "clash"
};

/// The fits of a product. Errors: Interrupted, MalformedInput for a statement of the scenario about no pair.
GLISSADE_EXPORT Result<std::vector<Fit>> fits(const Product& product, const FindOptions& options = {});

/// How bodies of a product are joined.
struct Joint {
  std::string kind{};                    ///< "screw", "nut", "thread", "insert", "pin", "snap", "flexible", ...
  std::string state{};                   ///< "recognised", "suggested" or "confirmed"
  std::string body{};                    ///< id of the screw, nut, guest, pin, ...
  std::vector<std::string> others{};     ///< ids of the bodies that it is joined to
  std::vector<std::string> clamped{};    ///< ids of the parts that it clamps, the nearest to the head first
  Vector3 point = Vector3::Zero();       ///< on the axis, world frame
  Vector3 direction = Vector3::UnitZ();  ///< unit, world frame: exit direction of the body
  double diameter = 0.0;                 ///< outer diameter of the thread, metres; 0: no thread
  double pitch = 0.0;                    ///< metres a turn; below 0: left-handed; 0: no thread
  std::string designation{};             ///< as stated by a name, "ISO 4762 M3x8"; empty: none
  std::vector<std::string> evidence{};   ///< each fact that supports it, for people
};

/// The joints of a product, with the statements of its scenario. Errors: Interrupted, Usage for a statement about no
/// joint.
GLISSADE_EXPORT Result<std::vector<Joint>> joints(const Product& product, const FindOptions& options = {});

/// Options of sequence().
struct SequenceOptions {
  std::string strategy{};              ///< "greedy" or "best-first"; empty: best-first
  std::uint64_t seed = 1;              ///< seed of the searches
  std::vector<std::string> staying{};  ///< names of bodies that stay; empty: those of the product, or the largest body
  double timeLimit = 0.0;              ///< seconds; 0: none
  std::size_t threads = 0;             ///< number of threads, which do not change the plan; 0: one for each core
  std::function<void(const AssemblyPlan&)> progress{};  ///< called with the plan so far when a step is found
  StopToken stop{};                                     ///< ends the planning; the plan so far is the result
};

/// Plans the order in which the bodies of a product leave. A plan that is not complete is a result, too. Errors: Usage
/// for an unknown strategy or body, MalformedInput for demands of the scenario that contradict each other, Interrupted
/// where fits were not found yet.
GLISSADE_EXPORT Result<AssemblyPlan> sequence(const Product& product, const SequenceOptions& options = {});

/// Options of sweep().
struct SweepOptions {
  std::optional<double> bound{};  ///< largest distance of the surface from the sweep, metres; nothing: chosen by size
  Progress progress{};            ///< finished share
  StopToken stop{};               ///< ends the work
};

/// The volume that a body covers while it moves.
struct SweptVolume {
  Mesh surface;         ///< world frame; closed; contains every point of the body at every time
  double bound = 0.0;   ///< largest distance of the surface from the sweep, metres
  double volume = 0.0;  ///< volume that the surface encloses, cubic metres
  double excess = 0.0;  ///< estimated excess over the covered volume, as a share; infinite for a thin body
};

/// The swept volume of a body along straight motions between poses. Errors: Usage for an invalid pose or bound,
/// LimitReached for a bound that needs too much memory, Interrupted.
GLISSADE_EXPORT Result<SweptVolume> sweep(const Mesh& body, const std::vector<Pose>& poses,
                                          const SweepOptions& options = {});

/// The exact distance to the nearest obstacle at one place of a path.
struct ClearanceSample {
  double share = 0.0;  ///< share of the path's length, by the metric of the world, that lies before the place
  Pose X_WB{};         ///< configuration
  Nearest nearest{};   ///< nearest points
};

/// Samples the clearance along a path. Each configuration has a sample. The samples prove nothing between them: the
/// certificate does. Errors: Usage for an invalid pose, Interrupted.
GLISSADE_EXPORT Result<std::vector<ClearanceSample>> clearance(const World& world, const Path& path,
                                                               const FindOptions& options = {});

/// Version of the library that the program runs with: "0.1.0". GLISSADE_VERSION is the version of the headers.
GLISSADE_EXPORT const char* libraryVersion();

/// The file of one of Glissade's programs, such as "glissade-offscreen": in the folder that GLISSADE_PROGRAMS names,
/// else beside the library, else in libexec/glissade of its prefix. It is missing where its package is not installed.
GLISSADE_EXPORT std::string programFile(const std::string& name);

}  // namespace glissade::api
