#pragma once

#include <glissade/export.h>
#include <glissade/functions.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace glissade::api {

/// Who drew the configuration from which a node was grown (paper 1, section 3).
enum class Author : std::uint8_t { Computer, Operator, Contact };

/// The tree of a node: from the start, from the goal, or from a way of the hand that neither has reached yet.
enum class Tree : std::uint8_t { Start, Goal, Hand };

/// The nodes and edges of a run so far. The vectors of the nodes have the same length.
struct Roadmap {
  std::vector<Pose> nodes{};                            ///< configurations X_WB
  std::vector<Author> authors{};                        ///< author of each node
  std::vector<Tree> trees{};                            ///< tree in which each node first grew
  std::vector<std::array<std::uint32_t, 2>> edges{};    ///< indices of nodes; the papers count an edge twice
  std::vector<std::array<std::uint32_t, 2>> dropped{};  ///< edges whose proof has failed; they are in `edges`, too
};

/// The state of a run.
enum class SessionState {
  Running,  ///< step() goes on
  Solved,   ///< path() is certified
  Ended     ///< there is no path: see failure()
};

/// A run that the caller carries on step by step, with a simulated operator, an operator from outside, or none:
/// Algorithm 1 of paper 1 with α, N and d that change between two steps. The same problem, options, steps and changes
/// give the same roadmap, bit by bit. Copies carry on the same run. A session with its copies belongs to one thread at
/// a time.
class GLISSADE_EXPORT Session {
 public:
  /// A run that is ready for its first step. Errors (Usage): those of plan(); a planner from outside, because a
  /// function cannot go on where it has returned. `progress` and `stop` of the options are not used.
  static Result<Session> make(const Problem& problem, const PlanOptions& options = {});
  /// A run of the scenario's problem.
  static Result<Session> make(const Scenario& scenario, const PlanOptions& options = {});

  /// Carries out at most this many planner steps. A step hands one configuration to the roadmap (Add_Tree of Algorithm
  /// 1), and is 1 / steps_per_second of the operator's time. Fewer steps where the run ends, or after a stop.
  SessionState step(std::uint64_t steps = 1, const StopToken& stop = {});
  /// Sets parameters, such as "alpha" or "contact_distance", from the next iteration on. Error (Usage): an unknown
  /// parameter or a value out of its range; then none is set.
  Outcome set(const Parameters& parameters);

  /// The state.
  SessionState state() const;
  /// The reason why the run has ended without a path; nothing: it has not.
  std::optional<Diagnostic> failure() const;
  /// Cost so far.
  RunCounts counts() const;
  /// All parameters with their values.
  Parameters parameters() const;
  /// The pose in the operator's hand.
  Pose hand() const;
  /// The roadmap so far.
  Roadmap roadmap() const;
  /// The certified path; nothing until the run is solved.
  std::optional<Path> path() const;

  /// Private data.
  struct Impl;
  /// For the library.
  explicit Session(std::shared_ptr<Impl> impl) : impl_(std::move(impl)) {}
  Session(const Session&) = default;             ///< carries on the same run
  Session& operator=(const Session&) = default;  ///< carries on the same run

 private:
  std::shared_ptr<Impl> impl_;
};

}  // namespace glissade::api
