#include "app/cli/check_command.h"

#include <iostream>
#include <nlohmann/json.hpp>

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

MotionCertificate judge(const std::vector<PathPoint>& points, const LoadedScenario& loaded, const StopToken& stop) {
  const CollisionWorld& world = *loaded.problem.world;
  const std::vector<double> allowances = allowancesOf(loaded.fits.allowed, world.obstacles().size());
  const IndependentCheck check(world.obstacles(), world.object(), allowances);
  return check.check(configurationsOf(points), demandsOf(points, loaded.parameters), stop);
}

/// Of a path that is refused on the edge to its first configuration outside.
MotionCertificate outsideWorkspace(std::size_t configuration) {
  MotionCertificate certificate;
  certificate.edge = configuration == 0 ? 0 : configuration - 1;
  return certificate;
}

}  // namespace

int runCheck(const CheckOptions& options) {
  if (isPlanFile(options.path)) return runPlanCheck(options);
  auto loaded = loadScenario(options.scenario);
  if (!loaded) return reportError(loaded.error(), options.format);
  const Interrupt interrupt;
  const Outcome fitted = applyOptions(options.fits, *loaded, interrupt.token());
  if (!fitted) return reportError(fitted.error(), options.format);
  const auto read = readPath(options.path);
  if (!read) return reportError(read.error(), options.format);

  const Problem& problem = loaded->problem;
  const std::vector<PathPoint> points = withUnitRotations(*read);
  if (options.requiredClearance) {
    const Outcome set = loaded->parameters.set(ParameterId::RequiredClearance, *options.requiredClearance);
    if (!set) return reportError(set.error(), options.format);
  }
  const std::optional<std::size_t> outside = firstOutside(points, problem);
  const MotionCertificate certificate =
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
    addUncertainties(*loaded, report["certificate"]);
    printJson(report);
  } else {
    std::cout << (valid ? "valid" : "invalid") << ": " << points.size() << " configurations, "
              << inWords(certificate, *problem.world) << "\n";
    std::cout << deviationInWords(*loaded);
    if (options.edges) printEdges(certificate, *problem.world);
    if (outside) {
      std::cout << "the path leaves the scenario's workspace on edge " << certificate.edge << ": configuration "
                << *outside << " is outside; it was not examined further\n";
    }
    if (!ends.start) std::cout << "the path does not begin at the scenario's start\n";
    if (!ends.goal) std::cout << "the path does not end at the scenario's goal\n";
  }
  return valid ? 0 : exitCode(ErrorKind::NoPath);
}

}  // namespace glissade::cli
