#include "app/cli/check_command.h"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/cli/interrupt.h"
#include "app/cli/plan_check.h"
#include "engine/collision/independent_check.h"
#include "engine/planning/path_bounds.h"
#include "engine/planning/path_certificate.h"
#include "engine/planning/path_examination.h"
#include "engine/scenario/path_reader.h"
#include "engine/scenario/plan_file.h"
#include "engine/scenario/scenario_io.h"

namespace glissade::cli {
namespace {

struct Judgement {
  MotionCertificate certificate;
  std::string whyUndecided;  ///< empty where the certificate is a verdict
  std::string whyRefused{};  ///< what is wrong with a motion in a thread; else empty
};

std::string threadInWords(const MotionCertificate& certificate, const LoadedScenario& loaded) {
  std::ostringstream text;
  for (const Fit& fit : loaded.fits.allowed) {
    if (!fit.thread || static_cast<int>(fit.obstacle) != certificate.nearest.body) continue;
    const std::string& body = loaded.obstacles[fit.obstacle].name;
    text << "'" << loaded.object.name << "' and '" << body << "' are a thread, which comes apart by turning only: ";
    if (fit.thread->rule.mayTurn) {
      text << "each turn about its axis advances by " << fit.thread->rule.pitch * 1e3 << " mm";
    } else {
      text << "'" << body << "' is turned, and has to leave first";
    }
  }
  return text.str();
}

Judgement judge(const std::vector<PathPoint>& points, const LoadedScenario& loaded, const StopToken& stop) {
  const CollisionWorld& world = *loaded.problem.world;
  const std::vector<double> allowances = allowancesOf(loaded.fits.allowed, world.obstacles().size());
  const IndependentCheck check(world.obstacles(), world.object(), allowances, threadRulesOf(loaded.fits.allowed));
  const std::vector<Pose> path = configurationsOf(points);
  const std::vector<EdgeDemand> demands = demandsOf(points, loaded.parameters);
  Judgement judgement{check.check(path, demands, stop), ""};
  if (judgement.certificate.againstThread) judgement.whyRefused = threadInWords(judgement.certificate, loaded);
  if (judgement.certificate.status != CertificateStatus::Undecided) return judgement;
  if (stop.stopRequested()) {
    judgement.whyUndecided = "the check was stopped";
  } else {
    const std::size_t edge = judgement.certificate.edge;
    judgement.whyUndecided =
        check.whyUndecided(path[edge], path[std::min(edge + 1, path.size() - 1)], demands[edge].clearance);
  }
  return judgement;
}

/// Of a path that is refused on the edge to its first configuration outside.
Judgement outsideWorkspace(std::size_t configuration) {
  Judgement judgement;
  judgement.certificate.edge = configuration == 0 ? 0 : configuration - 1;
  judgement.whyUndecided = "configuration " + std::to_string(configuration) +
                           " is outside the scenario's workspace; the path was not examined further";
  return judgement;
}

}  // namespace

int runCheck(const CheckOptions& options) {
  if (isPlanFile(options.path)) return runPlanCheck(options);
  const Interrupt interrupt;
  auto loaded = loadScenario(options.scenario, options.fits, interrupt.token());
  if (!loaded) return reportError(loaded.error(), options.format);
  reportWarnings(loaded->warnings);
  reportWarnings(loaded->fits.warnings);
  const auto read = readPath(options.path);
  if (!read) return reportError(read.error(), options.format);

  const Problem& problem = loaded->problem;
  const std::vector<PathPoint> points = withUnitRotations(*read);
  if (options.requiredClearance) {
    const Outcome set = loaded->parameters.set(ParameterId::RequiredClearance, *options.requiredClearance);
    if (!set) return reportError(set.error(), options.format);
  }
  const std::optional<std::size_t> outside = firstOutside(points, problem);
  const auto [certificate, whyUndecided, whyRefused] =
      outside ? outsideWorkspace(*outside) : judge(points, *loaded, interrupt.token());
  const PathEnds ends = endsOf(points, problem);
  const bool valid = certificate.status == CertificateStatus::Certified && ends.start && ends.goal && !outside;

  if (options.format == Format::Json) {
    nlohmann::ordered_json report;
    report["valid"] = valid;
    report["configurations"] = points.size();
    report["begins_at_start"] = ends.start;
    report["ends_at_goal"] = ends.goal;
    report["outside_workspace"] = outside ? nlohmann::ordered_json(*outside) : nlohmann::ordered_json(nullptr);
    report["certificate"] = toJson(certificate, *problem.world, options.edges);
    if (!whyUndecided.empty()) report["certificate"]["why_undecided"] = whyUndecided;
    if (!whyRefused.empty()) report["certificate"]["why_refused"] = whyRefused;
    addUncertainties(*loaded, points, report["certificate"]);
    printJson(report);
  } else {
    std::cout << (valid ? "valid" : "invalid") << ": " << points.size() << " configurations, "
              << inWords(certificate, *problem.world) << (whyUndecided.empty() ? "" : ": ") << whyUndecided
              << (whyRefused.empty() ? "" : ": ") << whyRefused << "\n";
    std::cout << deviationInWords(*loaded, points);
    if (options.edges) printEdges(certificate, *problem.world);
    if (!ends.start) std::cout << "the path does not begin at the scenario's start\n";
    if (!ends.goal) std::cout << "the path does not end at the scenario's goal\n";
  }
  return valid ? 0 : exitCode(ErrorKind::NoPath);
}

}  // namespace glissade::cli
