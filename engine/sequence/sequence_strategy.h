#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/message.h"
#include "engine/base/thread_team.h"
#include "engine/fits/liaison_graph.h"
#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/joint_rules.h"
#include "engine/sequence/order_rules.h"
#include "engine/sequence/product_fits.h"
#include "engine/sequence/removal_trial.h"
#include "engine/sequence/standing.h"
#include "engine/sequence/step_cost.h"
#include "engine/sequence/tool_choice.h"

namespace glissade {

/// The input of a strategy. Refers to its members during the call.
struct SequenceQuestion {
  const AssembledProduct& product;
  BodySet staying;  ///< bodies that are not to leave
  std::uint64_t seed = 1;
  RemovalTrial& trial;
  const AssemblyPlan* resumed = nullptr;  ///< an unfinished plan of the same product, seed and strategy; or null
  OrderRules rules{};
  std::vector<FastenerKind> fasteners{};   ///< kind of each body; empty: not known
  Standing* standing = nullptr;            ///< null: support is not checked
  std::vector<bool> fragile{};             ///< one entry for each body; empty: no body is fragile
  ToolChoices tools{};                     ///< tools for each body; empty: not known
  const StepCost* cost = nullptr;          ///< cost for best-first; null: the usual one
  const JointRules* joints = nullptr;      ///< null: there are none
  BodySet there{};                         ///< bodies that are there at the beginning; empty: all
  const ProductFits* fits = nullptr;       ///< fits that motions rely on; null: not known
  const LiaisonGraph* liaisons = nullptr;  ///< what holds the bodies to each other; null: not known
  BodyGroup isolated{};                    ///< see isolatedBodies(); empty: none, or not known
  Vector3 up = Vector3::UnitZ();           ///< upward direction of the work place, unit, frame of the product

  BodySet initial() const { return there.empty() ? BodySet(product.bodies.size(), true) : there; }
};

/// Receives the progress of a strategy. Called on the strategy's thread.
class SequenceHost {
 public:
  virtual ~SequenceHost() = default;
  virtual const StopToken& stopToken() const = 0;
  /// Threads that carry out trials. Their number does not change the plan.
  virtual ThreadTeam& team() = 0;
  /// Trials of these groups with this effort begin.
  virtual void asking(const std::vector<BodyGroup>& groups, int effort) = 0;
  /// The plan so far, which can be resumed as an interrupted one. The predecessors of its steps are not known yet
  /// (AssemblyStep::after is empty).
  virtual void stepFound(const AssemblyPlan& plan) = 0;
};

/// Decides the order in which removals are tried and carried out.
class SequenceStrategy {
 public:
  virtual ~SequenceStrategy() = default;
  /// The plan as far as it was found; its end is Interrupted after a stop. Seed and question determine the plan.
  virtual AssemblyPlan plan(const SequenceQuestion& question, SequenceHost& host) = 0;
};

/// Id, texts and factory of a strategy.
struct SequenceStrategyEntry {
  std::string id;
  Message label;
  Message description;  ///< one sentence
  std::function<std::unique_ptr<SequenceStrategy>()> make;
};

class SequenceStrategyRegistry {
 public:
  void add(SequenceStrategyEntry entry) { entries_.push_back(std::move(entry)); }
  /// Null if the id is unknown.
  const SequenceStrategyEntry* find(std::string_view id) const;
  const std::vector<SequenceStrategyEntry>& entries() const { return entries_; }

 private:
  std::vector<SequenceStrategyEntry> entries_;
};

/// The strategies greedy and best-first.
SequenceStrategyRegistry makeSequenceStrategyRegistry();

}  // namespace glissade
