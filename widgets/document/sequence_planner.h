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
  std::vector<double>
      foundAfter;          ///< seconds since planning began, for each of the last steps, which were found since then
  std::size_t asking = 0;  ///< number of parts whose removal is being searched now
  int effort = 0;          ///< 0: straight motions; above: searches
};

/// Verdict of the independent check on the plan; `said` are a person's statements about the product.
PlanCheck checkOf(const AssemblyPlan& plan, const AssembledProduct& product, const SequenceDemands& said,
                  const WorkWatch& watch);

/// Plans a sequence on a worker, with all cores, and judges plans there. Steps are announced while they are found. The
/// class connects the GUI thread with the engine.
class SequencePlanner final : public QObject {
  Q_OBJECT

 public:
  explicit SequencePlanner(QObject* parent = nullptr);
  ~SequencePlanner() override;

  /// `atOnce`: planning ends before this function returns.
  void plan(const SequenceJob& job, bool atOnce);
  /// Judges the plan by the independent check. `said`: a person's statements about the product; other statements of the
  /// plan become conditions of the verdict.
  void judge(const ProductPtr& product, const PlanPtr& plan, const SequenceDemands& said, bool atOnce);
  /// Ends planning; the plan so far is announced by planned(). A judgement under way is forgotten.
  void stop();
  /// Forgets the work under way.
  void drop();
  bool isPlanning() const { return planning_; }
  BackgroundTask& task() { return task_; }

 signals:
  void grown(const glissade::GrownPlan& plan);
  /// Planning ended: the plan is complete, stuck or stopped.
  void planned(const glissade::GrownPlan& plan);
  void judged(const glissade::PlanPtr& plan, const glissade::PlanCheck& check);
  void failed(const glissade::Diagnostic& why);

 private:
  void deliver(const std::function<void()>& signal, std::uint64_t request);

  /// The fits and joints of the product that was planned last, which do not depend on demands. It is used on the
  /// worker.
  struct KnownProduct {
    std::mutex mutex;
    ProductPtr product;
    std::shared_ptr<const ProductFits> fits;  ///< found with `bends`; null: not searched yet
    std::vector<evidence::SnapWord> bends;
    std::vector<std::string> classes;
    std::shared_ptr<const Joints> joints;  ///< found with `classes`; null: not searched yet
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
