#include "app/cli/check_command.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/interrupt.h"
#include "engine/collision/independent_check.h"
#include "engine/planning/path_certificate.h"
#include "engine/planning/path_examination.h"
#include "engine/scenario/path_reader.h"
#include "engine/scenario/scenario_io.h"

namespace glissade::cli {

int runCheck(const CheckOptions& options) {
  auto loaded = loadScenario(options.scenario);
  if (!loaded) return reportError(loaded.error(), options.format);
  reportWarnings(loaded->warnings);
  const auto read = readPath(options.path);
  if (!read) return reportError(read.error(), options.format);

  const Problem& problem = loaded->problem;
  const std::vector<PathPoint> points = withUnitRotations(*read);
  if (options.requiredClearance) {
    const Outcome set = loaded->parameters.set(ParameterId::RequiredClearance, *options.requiredClearance);
    if (!set) return reportError(set.error(), options.format);
  }
  const IndependentCheck judge(problem.world->obstacles(), problem.world->object());
  const Interrupt interrupt;
  const MotionCertificate certificate =
      judge.check(configurationsOf(points), demandsOf(points, loaded->parameters), interrupt.token());
  const PathEnds ends = endsOf(points, problem);
  const bool valid = certificate.status == CertificateStatus::Certified && ends.start && ends.goal;

  if (options.format == Format::Json) {
    nlohmann::ordered_json report;
    report["valid"] = valid;
    report["configurations"] = points.size();
    report["begins_at_start"] = ends.start;
    report["ends_at_goal"] = ends.goal;
    report["certificate"] = toJson(certificate, *problem.world, options.edges);
    report["certificate"]["surface_deviation_m"] = surfaceDeviation(*loaded);
    std::cout << report.dump(2) << "\n";
  } else {
    std::cout << (valid ? "valid" : "invalid") << ": " << points.size() << " configurations, "
              << inWords(certificate, *problem.world) << "\n";
    std::cout << deviationInWords(*loaded);
    if (options.edges) printEdges(certificate, *problem.world);
    if (!ends.start) std::cout << "the path does not begin at the scenario's start\n";
    if (!ends.goal) std::cout << "the path does not end at the scenario's goal\n";
  }
  return valid ? 0 : exitCode(ErrorKind::NoPath);
}

}  // namespace glissade::cli
