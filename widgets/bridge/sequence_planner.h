#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/body_group.h"
#include "engine/sequence/order_rules.h"
#include "engine/sequence/product_fits.h"
#include "engine/sequence/sequence_run.h"
#include "engine/study/plan_words.h"
#include "widgets/bridge/background_task.h"

namespace glissade {

using ProductPtr = std::shared_ptr<const AssembledProduct>;
using PlanPtr = std::shared_ptr<const AssemblyPlan>;

/// What is planned.
struct SequenceJob {
  ProductPtr product;
  BodySet staying;
  SequenceDemands demands;
  std::string strategy = kUsualStrategy;
  std::uint64_t seed = 1;
  PlanPtr resumed;                       ///< goes on from this plan; null: begins anew
  PlanPtr known;                         ///< of the same product with other demands: its motions need not be searched
  std::optional<std::size_t> mostSteps;  ///< stops once the plan has so many
  std::vector<std::string> classes{};    ///< of the bodies, for joints; empty: not known
};

/// A plan as far as it is there.
struct GrownPlan {
  PlanPtr plan;
  std::vector<double>
      foundAfter;          ///< seconds since planning began, of the steps that were found since then, the last ones
  std::size_t asking = 0;  ///< parts that are asked now
  int effort = 0;          ///< 0: straight motions; above: searches
};

/// What the independent check says of the plan, where a person has said this of the product.
PlanCheck checkOf(const AssemblyPlan& plan, const AssembledProduct& product, const SequenceDemands& said,
                  const WorkWatch& watch);

/// Plans a sequence on a worker, with all cores, and judges plans there. Steps are announced while they are found. A
/// class that crosses between the GUI thread and the engine.
class SequencePlanner final : public QObject {
  Q_OBJECT

 public:
  explicit SequencePlanner(QObject* parent = nullptr);
  ~SequencePlanner() override;

  /// `atOnce`: before this returns.
  void plan(const SequenceJob& job, bool atOnce);
  /// Judges the plan by the independent check. `said`: by a person of the product; what else the plan says is a
  /// condition.
  void judge(const ProductPtr& product, const PlanPtr& plan, const SequenceDemands& said, bool atOnce);
  /// Planning ends with the plan so far, which is announced by planned(). Judging is forgotten.
  void stop();
  /// Forgets what is under way.
  void drop();
  bool isPlanning() const { return planning_; }
  BackgroundTask& task() { return task_; }

 signals:
  void grown(const glissade::GrownPlan& plan);
  /// Complete, stuck or stopped.
  void planned(const glissade::GrownPlan& plan);
  void judged(const glissade::PlanPtr& plan, const glissade::PlanCheck& check);
  void failed(const glissade::Diagnostic& why);

 private:
  void deliver(const std::function<void()>& signal, std::uint64_t request);

  /// Of the product that was planned last: its fits and the joints that are found do not depend on demands. Used on the
  /// worker.
  struct KnownProduct {
    std::mutex mutex;
    ProductPtr product;
    std::shared_ptr<const ProductFits> fits;  ///< with these bends; null: not looked for yet
    std::vector<check::SnapWord> bends;
    std::vector<std::string> classes;
    std::shared_ptr<const Joints> joints;  ///< with these classes; null: not looked for yet
  };
  static Result<std::shared_ptr<const ProductFits>> fitsOf(KnownProduct& known, const SequenceJob& job,
                                                           const Joints& joints, ThreadTeam& team,
                                                           const WorkWatch& watch);
  static void know(KnownProduct& known, const ProductPtr& product);
  static Result<Joints> jointsOf(KnownProduct& known, const SequenceJob& job, const StopToken& stop);

  BackgroundTask task_;
  std::shared_ptr<KnownProduct> known_ = std::make_shared<KnownProduct>();
  StopSource stop_;
  std::uint64_t request_ = 0;
  bool planning_ = false;
};

}  // namespace glissade
