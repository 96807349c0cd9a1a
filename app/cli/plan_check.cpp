#include "app/cli/plan_check.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/interrupt.h"
#include "engine/scenario/plan_file.h"
#include "engine/scenario/product_file.h"
#include "engine/sequence/plan_judge.h"

namespace glissade::cli {
namespace {

using Json = nlohmann::ordered_json;

Json toJson(const StepJudgement& judgement, const AssembledProduct& product) {
  const int nearest = judgement.certificate.nearest.body;
  return {{"body", judgement.body},
          {"valid", judgement.valid()},
          {"certified", judgement.certificate.status == CertificateStatus::Certified},
          {"against_thread", judgement.certificate.againstThread},
          {"ends_outside", judgement.endsOutside},
          {"allowances_as_fits", judgement.allowancesAsFits},
          {"against_demand", judgement.againstDemand},
          {"min_clearance_m", number(judgement.certificate.minClearance)},
          {"nearest", nearest < 0 ? Json(nullptr) : Json(product.bodies[static_cast<std::size_t>(nearest)].id)}};
}

void print(const StepJudgement& judgement, std::size_t number, const AssembledProduct& product) {
  if (judgement.valid()) return;
  std::cout << "step " << number << " (" << judgement.body << ") is invalid:";
  if (judgement.certificate.status != CertificateStatus::Certified) {
    const int body = judgement.certificate.nearest.body;
    std::cout << " its motion is "
              << (judgement.certificate.status == CertificateStatus::Violated ? "violated" : "undecided") << " on edge "
              << judgement.certificate.edge;
    const bool thread = judgement.certificate.againstThread;
    if (thread) std::cout << ", because it is no turn in the thread it has with '";
    if (body >= 0) std::cout << (thread ? "" : " by '") << product.bodies[static_cast<std::size_t>(body)].name << "'";
    std::cout << ";";
  }
  if (!judgement.endsOutside) std::cout << " it does not end outside of the others' bounding box;";
  if (!judgement.allowancesAsFits) std::cout << " it allows for more than the fits of the product;";
  if (!judgement.againstDemand.empty()) std::cout << " " << judgement.againstDemand << ";";
  std::cout << "\n";
}

}  // namespace

int runPlanCheck(const CheckOptions& options) {
  const Interrupt interrupt;
  const auto plan = readPlan(options.path);
  if (!plan) return reportError(plan.error(), options.format);
  auto loaded = loadProduct(options.scenario, interrupt.token(), plan->deflection);
  if (!loaded) return reportError(loaded.error(), options.format);
  AssembledProduct& product = loaded->product;
  product.fits = withOptions(product.fits, options.fits);
  std::vector<std::string> ids;
  for (const RigidBody& body : product.bodies) ids.push_back(body.id);
  if (const Outcome same = checkSameBodies(*plan, ids, options.path); !same) {
    return reportError(same.error(), options.format);
  }
  reportWarnings(loaded->warnings);
  const auto judgements = judgePlan(*plan, product, options.requiredClearance, interrupt.token());
  if (!judgements) return reportError(judgements.error(), options.format);
  std::size_t valid = 0;
  for (const StepJudgement& judgement : *judgements) valid += judgement.valid() ? 1 : 0;
  const bool all = valid == plan->steps.size();
  const std::size_t remaining = plan->parts() - plan->removed();
  if (options.format == Format::Json) {
    Json report{{"valid", all},
                {"complete", remaining == 0},
                {"parts", plan->parts()},
                {"steps_valid", valid},
                {"steps", Json::array()}};
    for (const StepJudgement& judgement : *judgements) report["steps"].push_back(toJson(judgement, product));
    report["surface_deviation_m"] = loaded->deviation;
    printJson(report);
  } else {
    for (std::size_t i = 0; i < judgements->size(); ++i) print((*judgements)[i], i + 1, product);
    std::cout << (all ? "valid" : "invalid") << ": " << valid << " of " << plan->steps.size()
              << " steps are certified, " << remaining << " of " << plan->parts() << " parts have no step\n";
    if (loaded->deviation > 0.0) {
      std::cout << "the certificates are about triangles: surfaces may be " << loaded->deviation * 1e3
                << " mm nearer than they are\n";
    }
  }
  return all ? 0 : exitCode(ErrorKind::NoPath);
}

}  // namespace glissade::cli
