#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/thread_team.h"
#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/joint_rules.h"
#include "engine/sequence/order_rules.h"
#include "engine/sequence/product_fits.h"
#include "engine/sequence/removal_trial.h"
#include "engine/sequence/standing.h"
#include "engine/sequence/step_cost.h"
#include "engine/sequence/tool_choice.h"

namespace glissade {

/// What is asked of a strategy. Refers to its members for the time of the call.
struct SequenceQuestion {
  const AssembledProduct& product;
  BodySet staying;  ///< bodies that are not to leave
  std::uint64_t seed = 1;
  RemovalTrial& trial;
  const AssemblyPlan* resumed = nullptr;  ///< a plan of the same product, seed and strategy that had not ended; or null
  OrderRules rules{};
  std::vector<FastenerKind> fasteners{};  ///< of each body; empty: not known
  Standing* standing = nullptr;           ///< null: not asked
  std::vector<bool> fragile{};            ///< of each body; empty: none is
  ToolChoices tools{};                    ///< of each body; empty: not known
  const StepCost* cost = nullptr;         ///< of best-first; null: the usual one
  const JointRules* joints = nullptr;     ///< null: there are none
  BodySet there{};                        ///< bodies that are there at the beginning; empty: all
  const ProductFits* fits = nullptr;      ///< that motions rest on; null: not known

  BodySet initial() const { return there.empty() ? BodySet(product.bodies.size(), true) : there; }
};

/// What a strategy tells while it works, and asks. Called on the strategy's thread.
class SequenceHost {
 public:
  virtual ~SequenceHost() = default;
  virtual const StopToken& stopToken() const = 0;
  /// Threads that carry out trials. Their number does not change the plan.
  virtual ThreadTeam& team() = 0;
  /// So many bodies are asked now, with this effort.
  virtual void asking(std::size_t bodies, int effort) = 0;
  /// The plan so far, as one that was interrupted: it can be resumed. What has to be carried out before each step is
  /// not known yet (AssemblyStep::after is empty).
  virtual void stepFound(const AssemblyPlan& plan) = 0;
};

/// In which order bodies are asked and leave.
class SequenceStrategy {
 public:
  virtual ~SequenceStrategy() = default;
  /// The plan as far as it was found; its end says Interrupted after a stop. Seed and question decide the plan.
  virtual AssemblyPlan plan(const SequenceQuestion& question, SequenceHost& host) = 0;
};

/// How a strategy is known and made. Registered by explicit calls.
struct SequenceStrategyEntry {
  std::string id;
  std::string label;
  std::string description;  ///< one sentence
  std::function<std::unique_ptr<SequenceStrategy>()> make;
};

class SequenceStrategyRegistry {
 public:
  void add(SequenceStrategyEntry entry) { entries_.push_back(std::move(entry)); }
  /// Null where the id is unknown.
  const SequenceStrategyEntry* find(std::string_view id) const;
  const std::vector<SequenceStrategyEntry>& entries() const { return entries_; }

 private:
  std::vector<SequenceStrategyEntry> entries_;
};

/// greedy, best-first.
SequenceStrategyRegistry makeSequenceStrategyRegistry();

}  // namespace glissade
