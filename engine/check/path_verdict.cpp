#include "engine/check/path_verdict.h"
#include "engine/check/product.h"

#include <algorithm>
#include <cmath>

#include "engine/base/tolerances.h"
#include "engine/evidence/pulled_thread.h"
#include "engine/geometry/se3_metric.h"

namespace glissade::check {
namespace {

constexpr double kRoundingOfRadius = 1e-6;  ///< share of the object's radius
constexpr double kNearEnds = 1e-5;          ///< metres: bodies that are farther apart have no allowance

Box3 obstaclesBox(const Question& question) {
  Box3 box;
  for (std::size_t i = 0; i + 1 < question.product.bodies.size(); ++i) {
    const Body& body = question.product.bodies[i];
    box.extend(boundingBox(*body.mesh, body.X_WB));
  }
  return box;
}

void judgeEnds(const Question& question, const std::vector<Pose>& path, PathVerdict& verdict) {
  const Se3Metric metric(radiusAboutOrigin(*question.object().mesh));
  const double same = kRoundingOfRadius * metric.radius();
  verdict.beginsAtStart = metric.distance(path.front(), question.object().X_WB) <= same;
  if (question.goal) {
    verdict.endsAtGoal = metric.distance(path.back(), *question.goal) <= same;
    return;
  }
  const Box3 box = obstaclesBox(question);
  verdict.endsAtGoal =
      box.isEmpty() || box.exteriorDistance(path.back().position) >= metric.radius() * (1.0 - kRoundingOfRadius);
}

/// The first configuration outside of the workspace. Edges are straight, so they stay inside if both of their ends do.
std::optional<std::size_t> firstOutside(const Question& question, const std::vector<Pose>& path) {
  Box3 bounds = question.workspace;
  bounds.extend(question.object().X_WB.position);
  if (question.goal) bounds.extend(question.goal->position);
  const Vector3 margin = Vector3::Constant(kRoundingOfRadius * radiusAboutOrigin(*question.object().mesh));
  const Box3 allowed(bounds.min() - margin, bounds.max() + margin);
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (!allowed.contains(path[i].position)) return i;
  }
  return std::nullopt;
}

/// Tests the axes that can separate the segment from the closed box: the coordinate axes, and their products with the
/// segment.
bool meetsBox(const Vector3& from, const Vector3& to, const Box3& box, double margin) {
  const Vector3 half = 0.5 * (box.max() - box.min()) + Vector3::Constant(margin);
  const Vector3 middle = 0.5 * (from + to) - 0.5 * (box.min() + box.max());
  const Vector3 way = 0.5 * (to - from);
  const Vector3 reach = way.cwiseAbs();
  if ((middle.cwiseAbs().array() > (half + reach).array()).any()) return false;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const Eigen::Index u = (axis + 1) % 3;
    const Eigen::Index v = (axis + 2) % 3;
    if (std::abs(middle[u] * way[v] - middle[v] * way[u]) > half[u] * reach[v] + half[v] * reach[u]) return false;
  }
  return true;
}

void judgeForbidden(const Question& question, const std::vector<Pose>& path, PathVerdict& verdict) {
  if (!question.forbidden.empty()) {
    verdict.forbiddenMargin = tolerance::kForbiddenMargin * radiusAboutOrigin(*question.object().mesh);
    verdict.forbidden = firstForbidden(path, question.forbidden, verdict.forbiddenMargin);
  } else if (question.product.forbidsPlaces) {
    verdict.refusals.push_back(GLISSADE_TEXT("the scenario forbids places, and where they are is not known"));
  }
}

double largestOfOthers(const std::vector<Body>& bodies, double (*valueOf)(const Body&)) {
  double largest = 0.0;
  for (std::size_t i = 0; i + 1 < bodies.size(); ++i) largest = std::max(largest, valueOf(bodies[i]));
  return largest;
}

/// Refuses allowances whose bodies are not the object and another body.
void checkNames(const Question& question, const std::vector<StatedAllowance>& stated, PathVerdict& verdict) {
  for (const StatedAllowance& each : stated) {
    const Body* other = question.product.find(each.body);
    const bool known = other != nullptr && other != &question.object();
    if (known && (each.moving.empty() || each.moving == question.object().id)) continue;
    verdict.refusals.push_back(
        {GLISSADE_TEXT("the file states an allowance of '%1' against '%2', which are not the object and another body"),
         {each.moving.text(), each.body.text()}});
  }
}

/// Notes threads that the path pulls the object off. It is valid all the same: the path of one object need not be one
/// of its assembly.
void notePull(const PairQuestion& asked, const PairFit& fit, const FitWords& words, PlacedBodies& placed,
              PathVerdict& verdict, const StopToken& stop) {
  if (fit.thread || fit.acceptedClash || !fit.isThinned() || !words.partingOf(asked.moving.id, asked.other.id).empty())
    return;
  double overlap = 0.0;
  for (const AppliedAllowance& each : fit.applied) overlap = std::max(overlap, each.evidence.overlap);
  const bool isCalled =
      asked.stated && std::any_of(asked.stated->begin(), asked.stated->end(), [&](const StatedAllowance& each) {
        return each.isThread && each.isAbout(asked.moving.id, asked.other.id, asked.first);
      });
  const Placement moving{asked.moving, asked.assembled.front()};
  const Placement other{asked.other, asked.other.X_WB};
  const std::vector<CommonThread> threads =
      commonThreads({placed.at(moving), placed.at(other), overlap, isCalled, fit.inSolid ? &*fit.inSolid : nullptr,
                     asked.moving.name, asked.other.name},
                    stop);
  const Message pulled = pulledThread(threads, asked.path);
  if (pulled.empty()) return;
  verdict.pulls.push_back({GLISSADE_TEXT("not for assembly: '%1' is pulled off '%2' without being unscrewed: %3"),
                           {asked.moving.name, asked.other.name, pulled}});
}

}  // namespace

double deflectionOf(const Body& body) {
  double largest = body.mesh->faces.empty() ? body.deflection : 0.0;
  for (const SurfaceFace& face : body.mesh->faces) largest = std::max(largest, face.deflection);
  return largest;
}

std::optional<ForbiddenEdge> firstForbidden(const std::vector<Pose>& path, const std::vector<ForbiddenRegion>& regions,
                                            double margin) {
  for (std::size_t i = 0; i < std::max<std::size_t>(1, path.size() - 1); ++i) {
    const Vector3& to = path[std::min(i + 1, path.size() - 1)].position;
    for (const ForbiddenRegion& region : regions) {
      const bool meets = std::any_of(region.boxes.begin(), region.boxes.end(),
                                     [&](const Box3& box) { return meetsBox(path[i].position, to, box, margin); });
      if (meets) return ForbiddenEdge{i, region.place};
    }
  }
  return std::nullopt;
}

PathVerdict judgePath(const Question& question, const Path& path, const WorkWatch& watch) {
  PathVerdict verdict;
  verdict.configurations = path.points.size();
  const std::vector<Pose> configurations = configurationsOf(path.points);
  const std::vector<Body>& bodies = question.product.bodies;
  verdict.deviation = deflectionOf(bodies.back()) + largestOfOthers(bodies, deflectionOf);
  verdict.spacing = bodies.back().spacing + largestOfOthers(bodies, [](const Body& body) { return body.spacing; });
  judgeEnds(question, configurations, verdict);
  verdict.outside = firstOutside(question, configurations);
  judgeForbidden(question, configurations, verdict);
  if (verdict.outside) {
    verdict.motion.verdict.edge = *verdict.outside == 0 ? 0 : *verdict.outside - 1;
    verdict.motion.why = {
        GLISSADE_TEXT("configuration %1 is outside the scenario's workspace; the path was not examined further"),
        {*verdict.outside}};
    return verdict;
  }
  if (path.allowances) checkNames(question, *path.allowances, verdict);
  MotionQuestion motion{bodies.back(),
                        Pose::identity(),
                        configurations,
                        demandsOf(path.points, question.requiredClearance, question.contactGap),
                        {}};
  std::vector<Pose> ends{question.object().X_WB};
  if (question.goal) ends.push_back(*question.goal);
  PlacedBodies placed;
  Box3 ofEnds;
  for (const Pose& end : ends) ofEnds.extend(boundingBox(*question.object().mesh, end));
  for (std::size_t i = 0; i + 1 < bodies.size(); ++i) {
    if (watch.stop.stopRequested()) break;
    MotionPair pair{i, &bodies[i], {}};
    const bool stated = path.allowances.has_value();
    if (stated || question.product.fits.on) {
      const Box3 box = boundingBox(*bodies[i].mesh, bodies[i].X_WB);
      const bool near = ofEnds.exteriorDistance(box) <= verdict.deviation + verdict.spacing + kNearEnds;
      const PairQuestion asked{bodies.back(), bodies[i], ends, path.allowances, bodies.back().id, configurations};
      const bool marked = question.product.fits.about(bodies.back().id, bodies[i].id) != nullptr;
      if (stated || near || marked) pair.fit = fitOf(asked, question.product.fits, placed, watch.stop);
      notePull(asked, pair.fit, question.product.fits, placed, verdict, watch.stop);
    }
    verdict.allowances.insert(verdict.allowances.end(), pair.fit.applied.begin(), pair.fit.applied.end());
    verdict.refusals.insert(verdict.refusals.end(), pair.fit.refusals.begin(), pair.fit.refusals.end());
    motion.pairs.push_back(std::move(pair));
  }
  MotionBodies prepared(bodies);
  verdict.motion = judgeMotion(motion, prepared, watch);
  return verdict;
}

}  // namespace glissade::check
