#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/documents/plan_words.h"
#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/body_group.h"
#include "engine/sequence/held_by_base.h"
#include "engine/sequence/order_rules.h"
#include "engine/sequence/product_finder.h"
#include "engine/sequence/sequence_run.h"
#include "widgets/controls/background_task.h"

namespace glissade {

using ProductPtr = std::shared_ptr<const AssembledProduct>;
using PlanPtr = std::shared_ptr<const AssemblyPlan>;

/// The input of a search for a plan.
struct SequenceJob {
  ProductPtr product;
  BodySet staying;
  SequenceDemands demands;
  std::string strategy = kUsualStrategy;
  std::uint64_t seed = 1;
  PlanPtr resumed;                       ///< planning continues this plan; null: it begins anew
  PlanPtr known;                         ///< a plan of this product for other demands: its motions need not be searched
  std::optional<std::size_t> mostSteps;  ///< planning stops once the plan has this many steps
  std::vector<std::string> classes{};    ///< the classes of the bodies, for joints; empty: not known
};

/// A plan as far as it has been found.
struct GrownPlan {
  PlanPtr plan;
  /// Seconds from the beginning of planning until each motion was found, by the first body of the motion; without those
  /// that were known before.
  std::map<BodyId, double> foundAfter;
  std::vector<HeldByBase> held{};  ///< why bodies stay with the base
};

/// Another order of the steps of a plan.
struct OrderJob {
  SequenceJob job;                 ///< `resumed`: the plan; `demands`: those with the new places
  std::vector<std::size_t> order;  ///< indices of the plan's steps
};

/// Verdict of the independent check on the plan; `said` are a person's statements about the product.
PlanCheck checkOf(const AssemblyPlan& plan, const AssembledProduct& product, const SequenceDemands& said,
                  const WorkWatch& watch);

/// Plans a sequence on a worker, with all cores, and judges plans there. Steps are announced while they are found. The
/// class connects the GUI thread with the engine.
class SequencePlanner final : public QObject {
  Q_OBJECT

 public:
  explicit SequencePlanner(std::shared_ptr<ProductFinder> finder, QObject* parent = nullptr);
  ~SequencePlanner() override;

  /// `atOnce`: planning ends before this function returns.
  void plan(const SequenceJob& job, bool atOnce);
  /// Puts the steps into another order without a search, see planWithOrder().
  void reorder(const OrderJob& job, bool atOnce);
  /// Judges the plan by the independent check. `said`: a person's statements about the product; other statements of the
  /// plan become conditions of the verdict.
  void judge(const ProductPtr& product, const PlanPtr& plan, const SequenceDemands& said, bool atOnce);
  /// Ends planning; the plan so far is announced by planned(). A judgement under way is forgotten.
  void stop();
  /// Forgets the work under way.
  void drop();
  bool isPlanning() const { return planning_; }
  bool isReordering() const { return planning_ && reordering_; }
  BackgroundTask& task() { return task_; }

 signals:
  void grown(const glissade::GrownPlan& plan);
  /// Motions of these bodies, or of groups that begin with them, are tried now.
  void tried(const std::vector<glissade::BodyId>& bodies);
  /// Planning ended: the plan is complete, stuck or stopped.
  void planned(const glissade::GrownPlan& plan);
  void reordered(const glissade::PlanPtr& plan);
  void orderRefused(const glissade::OrderConflict& why);
  void judged(const glissade::PlanPtr& plan, const glissade::PlanCheck& check);
  void failed(const glissade::Diagnostic& why);

 private:
  void deliver(const std::function<void()>& signal, std::uint64_t request);

  BackgroundTask task_;
  std::shared_ptr<ProductFinder> finder_;
  StopSource stop_;
  std::uint64_t request_ = 0;
  bool planning_ = false;
  bool reordering_ = false;  ///< the last work was that of reorder()
};

}  // namespace glissade
