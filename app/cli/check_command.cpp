#include "app/cli/check_command.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/interrupt.h"
#include "engine/collision/independent_check.h"
#include "engine/planning/path_certificate.h"
#include "engine/scenario/path_reader.h"
#include "engine/scenario/scenario_io.h"

namespace glissade::cli {
namespace {

/// Files may round their quaternions; a rotation has to be one exactly.
std::vector<Pose> configurations(const std::vector<PathPoint>& points) {
  std::vector<Pose> poses;
  poses.reserve(points.size());
  for (const PathPoint& point : points) poses.push_back({point.q.position, point.q.orientation.normalized()});
  return poses;
}

/// Whether the ends of the path are the scenario's start and goal (within the metric's rounding).
struct Ends {
  bool start = false;
  bool goal = false;
};

Ends endsOf(const std::vector<Pose>& path, const Problem& problem) {
  constexpr double kSame = 1e-6;
  const Se3Metric metric = problem.metric();
  Ends ends;
  ends.start = metric.distance(path.front(), problem.start) <= kSame * metric.radius();
  if (const Pose* goal = std::get_if<Pose>(&problem.goal)) {
    ends.goal = metric.distance(path.back(), *goal) <= kSame * metric.radius();
  } else {
    const double clear = problem.world->obstaclesBox().exteriorDistance(path.back().position);
    ends.goal = clear >= problem.world->objectRadius() * (1.0 - kSame);
  }
  return ends;
}

}  // namespace

int runCheck(const CheckOptions& options) {
  auto loaded = loadScenario(options.scenario);
  if (!loaded) return reportError(loaded.error(), options.format);
  reportWarnings(loaded->warnings);
  const auto points = readPath(options.path);
  if (!points) return reportError(points.error(), options.format);

  const Problem& problem = loaded->problem;
  const std::vector<Pose> path = configurations(*points);
  if (options.requiredClearance) {
    const Outcome set = loaded->parameters.set(ParameterId::RequiredClearance, *options.requiredClearance);
    if (!set) return reportError(set.error(), options.format);
  }
  const IndependentCheck judge(problem.world->obstacles(), problem.world->object());
  const Interrupt interrupt;
  const MotionCertificate certificate = judge.check(path, demandsOf(*points, loaded->parameters), interrupt.token());
  const Ends ends = endsOf(path, problem);
  const bool valid = certificate.status == CertificateStatus::Certified && ends.start && ends.goal;

  if (options.format == Format::Json) {
    nlohmann::ordered_json report;
    report["valid"] = valid;
    report["configurations"] = path.size();
    report["begins_at_start"] = ends.start;
    report["ends_at_goal"] = ends.goal;
    report["certificate"] = toJson(certificate, *problem.world, options.edges);
    std::cout << report.dump(2) << "\n";
  } else {
    std::cout << (valid ? "valid" : "invalid") << ": " << path.size() << " configurations, "
              << inWords(certificate, *problem.world) << "\n";
    if (options.edges) printEdges(certificate, *problem.world);
    if (!ends.start) std::cout << "the path does not begin at the scenario's start\n";
    if (!ends.goal) std::cout << "the path does not end at the scenario's goal\n";
  }
  return valid ? 0 : exitCode(ErrorKind::NoPath);
}

}  // namespace glissade::cli
