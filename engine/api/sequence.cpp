#include "engine/api/threads.h"
#include "engine/api/values.h"
#include "engine/base/time_limit.h"
#include "engine/sequence/product_finder.h"
#include "engine/sequence/sequence_run.h"

namespace glissade::api {
namespace {

/// Passes the plan so far on.
class ReportingHost final : public SequenceHost {
 public:
  ReportingHost(const SequenceOptions& options, StopToken stop, ThreadTeam& team)
      : options_(options), stop_(std::move(stop)), team_(team) {}

  const StopToken& stopToken() const override { return stop_; }
  ThreadTeam& team() override { return team_; }
  void asking(const std::vector<BodyGroup>& /*groups*/, int /*effort*/) override {}
  void stepFound(const glissade::AssemblyPlan& plan) override {
    if (options_.progress) options_.progress(valueOf<AssemblyPlan>({plan}));
  }

 private:
  const SequenceOptions& options_;
  StopToken stop_;
  ThreadTeam& team_;
};

Result<AssemblyPlan> planned(const Product::Impl& given, const SequenceOptions& options) {
  const ProductFile& loaded = given.loaded;
  const AssembledProduct& product = loaded.product;
  const StopToken stop = withTimeLimit(options.stop, options.timeLimit);
  SequenceDemands demands = loaded.demands;
  demands.joints = loaded.joints;
  std::vector<std::string> names = options.staying;
  names.insert(names.end(), demands.stay.begin(), demands.stay.end());
  auto staying = stayingBodies(product, names);
  if (!staying) return publicDiagnostic(staying.error());
  ThreadTeam team(helpersOf(options.threads));
  const auto found = ProductFinder().findings(product, loaded.classes, demands, team, stop);
  if (!found) return publicDiagnostic(found.error());
  ReportingHost host(options, stop, team);
  SequenceRequest request{std::move(*staying), options.strategy.empty() ? kUsualStrategy : options.strategy,
                          options.seed, std::move(demands)};
  request.joints = &found->joints;
  auto plan = planSequence(product, found->fits, request, host);
  if (!plan) return publicDiagnostic(plan.error());
  const bool timeIsOver = plan->end == glissade::PlanEnd::Interrupted && !options.stop.stopRequested();
  if (timeIsOver) plan->end = glissade::PlanEnd::TimeLimit;
  plan->deflection = given.deflection;
  return valueOf<AssemblyPlan>({std::move(*plan)});
}

}  // namespace

Result<AssemblyPlan> sequence(const Product& product, const SequenceOptions& options) {
  // The negation refuses NaN, too.
  if (!(options.timeLimit >= 0.0)) return wrongArgument("timeLimit", "is below 0");
  return attempt<AssemblyPlan>("planning a sequence", [&] { return planned(product.impl(), options); });
}

}  // namespace glissade::api
