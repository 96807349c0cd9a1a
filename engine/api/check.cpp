#include <nlohmann/json.hpp>

#include "engine/api/values.h"
#include "engine/check/read_path.h"
#include "engine/check/read_question.h"
#include "engine/check/verdict_report.h"
#include "engine/files/forbidden_places_of.h"
#include "engine/files/judged_product.h"
#include "engine/files/plan_file.h"
#include "engine/planning/coarse/prohibitions.h"

namespace glissade::api {
namespace {

constexpr const char* kJudging = "judging a path or a plan";

std::string textOf(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

WorkWatch watchOf(const CheckOptions& options) { return {options.stop, options.progress}; }

std::optional<Diagnostic> faultOf(const CheckOptions& options) {
  if (!options.requiredClearance || *options.requiredClearance > 0.0) return std::nullopt;
  return wrongArgument("requiredClearance", "is not above 0");
}

Verdict verdictOn(const check::PathVerdict& verdict, const check::Question& question) {
  VerdictKind kind = VerdictKind::Undecided;
  if (verdict.valid()) kind = question.product.missing.empty() ? VerdictKind::Valid : VerdictKind::Conditional;
  if (verdict.refused()) kind = VerdictKind::Invalid;
  return {kind, check::reportText(verdict, question, false), textOf(check::reportJson(verdict, question, true)),
          publicWarnings(question.product.warnings)};
}

VerdictKind kindOf(const check::PlanVerdict& verdict, const check::Product& product) {
  switch (verdict.outcome()) {
    case check::PlanOutcome::Valid:
      if (verdict.stepsWithoutProof() > 0) return VerdictKind::WithoutProof;
      return product.missing.empty() ? VerdictKind::Valid : VerdictKind::Conditional;
    case check::PlanOutcome::Conditional: return VerdictKind::Conditional;
    case check::PlanOutcome::Incomplete: return VerdictKind::Incomplete;
    case check::PlanOutcome::Undecided: return VerdictKind::Undecided;
    case check::PlanOutcome::Invalid: break;
  }
  return VerdictKind::Invalid;
}

Verdict verdictOn(const check::PlanVerdict& verdict, const check::Product& product) {
  return {kindOf(verdict, product), check::reportText(verdict, product), textOf(check::reportJson(verdict, product)),
          publicWarnings(product.warnings)};
}

Result<Verdict> checkPathFile(const std::string& product, const std::string& file, const CheckOptions& options) {
  const auto path = check::readPath(file);
  if (!path) return publicDiagnostic(path.error());
  const FitOptions fits{options.files.fits, options.files.acceptedClash};
  auto question = check::readQuestion(product, fits, options.stop);
  if (!question) return publicDiagnostic(question.error());
  if (const auto added = addForbiddenPlaces(product, options.stop, *question); !added) {
    return publicDiagnostic(added.error());
  }
  if (options.requiredClearance) question->requiredClearance = *options.requiredClearance;
  return verdictOn(check::judgePath(*question, *path, watchOf(options)), *question);
}

Result<Verdict> checkPlanFile(const std::string& file, const std::string& planFile, const CheckOptions& options) {
  const auto plan = check::readPlan(planFile);
  if (!plan) return publicDiagnostic(plan.error());
  const FitOptions fits{options.files.fits, options.files.acceptedClash};
  auto product = check::readProduct(file, plan->deflection, fits, options.stop, {options.files.open, plan->bodies});
  if (!product) return publicDiagnostic(product.error());
  if (const auto left = check::leaveOut(options.files.without, *product); !left) {
    return publicDiagnostic(left.error());
  }
  auto verdict = check::judgePlan(*product, *plan, options.requiredClearance, watchOf(options));
  verdict.planIsTrusted = options.trustPlan;
  return verdictOn(verdict, *product);
}

Verdict judged(check::Question question, const Path& path, const CheckOptions& options) {
  if (options.requiredClearance) question.requiredClearance = *options.requiredClearance;
  check::Path points;
  for (const PathPoint& point : path.impl().path.points) {
    points.points.push_back({point.q, point.author == Author::Contact});
  }
  return verdictOn(check::judgePath(question, points, watchOf(options)), question);
}

void forbid(const ForbiddenPlaces& places, check::Question& question) {
  for (const ForbiddenPlace& place : places) question.forbidden.push_back({place.name, place.boxes});
  question.product.forbidsPlaces = !question.forbidden.empty();
}

/// The question of a problem in memory, as the judge takes it.
Result<check::Question> questionOf(const Problem::Impl& given, const StopToken& stop) {
  const CollisionWorld& world = *given.problem.world;
  check::Question question;
  question.product.bodies = judgedBodies(world.obstacles());
  question.product.bodies.push_back(
      {"object", "object", MeshPtr(given.problem.world, &world.object()), given.problem.start});
  if (const auto* goal = std::get_if<glissade::Pose>(&given.problem.goal)) question.goal = *goal;
  question.workspace = given.problem.bounds;
  question.requiredClearance = given.parameters[ParameterId::RequiredClearance];
  question.contactGap = given.parameters[ParameterId::ContactGap];
  const auto forbidden = Prohibitions().of(given.problem, stop);
  if (!forbidden) return publicDiagnostic(forbidden.error());
  if (*forbidden) forbid((*forbidden)->places(), question);
  return question;
}

}  // namespace

Result<Verdict> check(const std::string& product, const std::string& pathOrPlan, const CheckOptions& options) {
  if (const auto fault = faultOf(options)) return *fault;
  return attempt<Verdict>(kJudging, [&] {
    return check::isPlan(pathOrPlan) ? checkPlanFile(product, pathOrPlan, options)
                                     : checkPathFile(product, pathOrPlan, options);
  });
}

Result<Verdict> check(const Scenario& scenario, const Path& path, const CheckOptions& options) {
  if (const auto fault = faultOf(options)) return *fault;
  return attempt<Verdict>(kJudging, [&]() -> Result<Verdict> {
    const LoadedScenario& loaded = *scenario.impl().loaded;
    check::Question question = judgedQuestion(loaded);
    const auto places = forbiddenPlacesOf(loaded, loaded.scenario, options.stop);
    if (!places) return publicDiagnostic(places.error());
    forbid(*places, question);
    return judged(std::move(question), path, options);
  });
}

Result<Verdict> check(const Problem& problem, const Path& path, const CheckOptions& options) {
  if (const auto fault = faultOf(options)) return *fault;
  return attempt<Verdict>(kJudging, [&]() -> Result<Verdict> {
    auto question = questionOf(problem.impl(), options.stop);
    if (!question) return question.error();
    return judged(*question, path, options);
  });
}

Result<Verdict> check(const Product& product, const AssemblyPlan& plan, const CheckOptions& options) {
  if (const auto fault = faultOf(options)) return *fault;
  return attempt<Verdict>(kJudging, [&]() -> Result<Verdict> {
    const ProductFile& loaded = product.impl().loaded;
    const glissade::AssemblyPlan& given = plan.impl().plan;
    if (const auto same = checkSameBodies(given, loaded.product, ""); !same) return publicDiagnostic(same.error());
    auto verdict = judgePlan(given, loaded.product, options.requiredClearance, watchOf(options), &loaded.demands);
    verdict.planIsTrusted = options.trustPlan;
    return verdictOn(verdict, judgedProduct(loaded.product));
  });
}

}  // namespace glissade::api
