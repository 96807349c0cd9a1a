#include "widgets/document/sequence_planner.h"

#include <algorithm>
#include <chrono>

#include "engine/base/thread_team.h"
#include "engine/files/judged_product.h"
#include "engine/sequence/joint_rules.h"
#include "engine/sequence/sequence_run.h"

namespace glissade {
namespace {

using Clock = std::chrono::steady_clock;

/// Share of finding the product's fits in all work.
constexpr double kFitsShare = 0.1;

/// Passes on the messages of the strategy, on the worker's thread.
class AnnouncingHost final : public SequenceHost {
 public:
  struct Announce {
    std::function<void(const GrownPlan&)> grown;
    std::function<void(const std::vector<BodyId>&)> tried;
  };

  /// `joints`: those that count.
  AnnouncingHost(const SequenceJob& job, Joints joints, WorkWatch watch, StopSource stop, ThreadTeam& team,
                 Announce announce)
      : job_(job),
        joints_(std::move(joints)),
        watch_(std::move(watch)),
        stop_(std::move(stop)),
        token_(stop_.token()),
        team_(team),
        announce_(std::move(announce)) {
    if (!job.resumed) return;
    grown_.plan = job.resumed;
    for (const AssemblyStep& step : job.resumed->steps) known_ += step.motions.size();
    stopWhereEnough(known_);
  }

  const StopToken& stopToken() const override { return token_; }
  ThreadTeam& team() override { return team_; }

  void asking(const std::vector<BodyGroup>& groups, int /*effort*/) override {
    std::vector<BodyId> bodies;
    for (const BodyGroup& group : groups) bodies.push_back(job_.product->bodies[group.front()].id);
    announce_.tried(bodies);
  }

  void stepFound(const AssemblyPlan& plan) override {
    grown_.plan = std::make_shared<const AssemblyPlan>(plan);
    noteHeld();
    const double seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
    for (std::size_t i = known_; i < plan.steps.size(); ++i) {
      grown_.foundAfter.try_emplace(plan.steps[i].only().body, seconds);
    }
    const double parts = static_cast<double>(std::max<std::size_t>(1, plan.parts()));
    watch_.report(kFitsShare + (1.0 - kFitsShare) * static_cast<double>(plan.steps.size()) / parts);
    announce_.grown(grown_);
    stopWhereEnough(plan.steps.size());
  }

  GrownPlan ended(AssemblyPlan plan) {
    if (job_.mostSteps) keepFirst(*job_.mostSteps, plan);
    grown_.plan = std::make_shared<const AssemblyPlan>(std::move(plan));
    noteHeld();
    return grown_;
  }

 private:
  /// Steps are found in waves, which may exceed `most`. The surplus steps become waiting steps.
  static void keepFirst(std::size_t most, AssemblyPlan& plan) {
    if (plan.steps.size() <= most) return;
    const auto rest = plan.steps.begin() + static_cast<std::ptrdiff_t>(most);
    for (auto step = rest; step != plan.steps.end(); ++step) {
      for (const StepMotion& motion : step->motions) {
        // Other motions need other bodies to have left.
        if (motion.proof.afterSteps <= most) plan.waiting.push_back(motion);
      }
    }
    plan.steps.erase(rest, plan.steps.end());
    std::erase_if(plan.refusals, [&](const RefusedRemoval& refused) { return refused.afterSteps > most; });
    plan.stuck.clear();
    plan.end = PlanEnd::Interrupted;
  }

  void noteHeld() {
    BodySet staying(job_.product->bodies.size(), false);
    for (const std::size_t body : job_.product->indicesOf(grown_.plan->staying)) staying[body] = true;
    grown_.held = heldByBase(*job_.product, joints_, staying, job_.staying);
  }

  void stopWhereEnough(std::size_t steps) {
    if (job_.mostSteps && steps >= *job_.mostSteps) stop_.requestStop();
  }

  const SequenceJob& job_;
  Joints joints_;
  WorkWatch watch_;
  StopSource stop_;
  StopToken token_;
  ThreadTeam& team_;
  Announce announce_;
  Clock::time_point begin_ = Clock::now();
  std::size_t known_ = 0;  ///< number of motions of the resumed plan
  GrownPlan grown_;
};

std::size_t helpers() { return usableCores() - 1; }

Result<GrownPlan> planOf(const SequenceJob& job, ProductFinder& finder, const WorkWatch& watch, const StopSource& stop,
                         const AnnouncingHost::Announce& announce) {
  ThreadTeam team(helpers());
  const WorkWatch toFind(stop.token(), watch.part(0.0, kFitsShare).progressed);
  const auto found = finder.findings(*job.product, job.classes, job.demands, team, toFind);
  if (!found) return found.error();
  watch.report(kFitsShare);
  AnnouncingHost host(job, countingJoints(found->joints, job.demands.jointUse), watch, stop, team, announce);
  SequenceRequest request{job.staying, job.strategy, job.seed, job.demands, job.resumed.get(), job.known.get()};
  request.joints = &found->joints;
  auto plan = planSequence(*job.product, found->fits, request, host);
  if (!plan) return plan.error();
  return host.ended(std::move(*plan));
}

/// Says nothing while steps change their order.
class SilentHost final : public SequenceHost {
 public:
  SilentHost(StopToken stop, ThreadTeam& team) : stop_(std::move(stop)), team_(team) {}
  const StopToken& stopToken() const override { return stop_; }
  ThreadTeam& team() override { return team_; }
  void asking(const std::vector<BodyGroup>& /*groups*/, int /*effort*/) override {}
  void stepFound(const AssemblyPlan& /*plan*/) override {}

 private:
  StopToken stop_;
  ThreadTeam& team_;
};

Result<std::variant<AssemblyPlan, OrderConflict>> orderOf(const OrderJob& order, ProductFinder& finder,
                                                          const StopToken& stop) {
  const SequenceJob& job = order.job;
  ThreadTeam team(helpers());
  const auto found = finder.findings(*job.product, job.classes, job.demands, team, WorkWatch(stop));
  if (!found) return found.error();
  SilentHost host(stop, team);
  SequenceRequest request{job.staying, job.strategy, job.seed, job.demands, job.resumed.get()};
  request.joints = &found->joints;
  return planWithOrder(*job.product, found->fits, request, order.order, host);
}

}  // namespace

SequencePlanner::SequencePlanner(std::shared_ptr<ProductFinder> finder, QObject* parent)
    : QObject(parent), finder_(std::move(finder)) {
  connect(&task_, &BackgroundTask::ended, this, [this] { planning_ = false; });
  connect(&task_, &BackgroundTask::failed, this, &SequencePlanner::failed);
}

SequencePlanner::~SequencePlanner() {
  task_.disconnect(this);
  drop();
}

/// Drops the signal if another request has come since.
void SequencePlanner::deliver(const std::function<void()>& signal, std::uint64_t request) {
  QMetaObject::invokeMethod(this, [this, signal, request] {
    if (request == request_) signal();
  });
}

void SequencePlanner::plan(const SequenceJob& job, bool atOnce) {
  drop();
  stop_ = StopSource();
  const std::uint64_t request = request_;
  const AnnouncingHost::Announce announce{
      [this, request](const GrownPlan& grown) { deliver([this, grown] { emit this->grown(grown); }, request); },
      [this, request](const std::vector<BodyId>& bodies) { deliver([this, bodies] { emit tried(bodies); }, request); }};
  planning_ = true;
  reordering_ = false;
  task_.start(
      GLISSADE_TEXT("planning the sequence"),
      [this, job, finder = finder_, stop = stop_, announce](const WorkWatch& watch) -> BackgroundTask::Delivery {
        const auto found = std::make_shared<const Result<GrownPlan>>(planOf(job, *finder, watch, stop, announce));
        return [this, found] {
          planning_ = false;
          if (*found) {
            emit planned(**found);
          } else if (found->error().kind != ErrorKind::Interrupted) {
            emit failed(found->error());
          }
        };
      },
      atOnce);
}

void SequencePlanner::reorder(const OrderJob& job, bool atOnce) {
  drop();
  stop_ = StopSource();
  planning_ = reordering_ = true;
  task_.start(
      GLISSADE_TEXT("changing the order of the steps"),
      [this, job, finder = finder_, stop = stop_.token()](const WorkWatch&) -> BackgroundTask::Delivery {
        const auto found =
            std::make_shared<Result<std::variant<AssemblyPlan, OrderConflict>>>(orderOf(job, *finder, stop));
        return [this, found] {
          planning_ = false;
          if (!*found) {
            if (found->error().kind != ErrorKind::Interrupted) emit failed(found->error());
          } else if (const auto* conflict = std::get_if<OrderConflict>(&**found)) {
            emit orderRefused(*conflict);
          } else {
            emit reordered(std::make_shared<const AssemblyPlan>(std::get<AssemblyPlan>(std::move(**found))));
          }
        };
      },
      atOnce);
}

PlanCheck checkOf(const AssemblyPlan& plan, const AssembledProduct& product, const SequenceDemands& said,
                  const WorkWatch& watch) {
  const check::PlanVerdict verdict = judgePlan(plan, product, std::nullopt, watch, &said);
  PlanCheck check;
  for (std::size_t step = 1; step <= plan.steps.size(); ++step) {
    check.steps.push_back(verdict.isValid(step) ? StepCheck::Agrees : StepCheck::Disagrees);
  }
  for (const check::Condition& condition : verdict.allConditions()) check.conditions.push_back(condition.text);
  return check;
}

void SequencePlanner::judge(const ProductPtr& product, const PlanPtr& plan, const SequenceDemands& said, bool atOnce) {
  drop();
  stop_ = StopSource();
  task_.start(
      GLISSADE_TEXT("checking the sequence"),
      [this, product, plan, said, stop = stop_.token()](const WorkWatch& watch) -> BackgroundTask::Delivery {
        const PlanCheck check = checkOf(*plan, *product, said, {stop, watch.progressed});
        if (stop.stopRequested()) return [] {};
        return [this, plan, check] { emit judged(plan, check); };
      },
      atOnce);
}

void SequencePlanner::stop() {
  if (!planning_) {
    drop();
    return;
  }
  stop_.requestStop();
}

void SequencePlanner::drop() {
  ++request_;
  planning_ = false;
  stop_.requestStop();
  task_.cancel();
}

}  // namespace glissade
