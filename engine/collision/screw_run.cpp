#include "engine/collision/screw_run.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/geometry/pose.h"

namespace glissade {
namespace {

/// Least turn of a run. Motions that turn less are proved as fast one by one.
constexpr double kLeastTurn = 1.01 * 2.0 * std::numbers::pi;
/// Bounds of the angle of an edge, radians. Smaller angles do not determine the axis, and near half a turn the sense is
/// not certain.
constexpr double kLeastEdge = 1e-4;
constexpr double kMostEdge = 3.0;
/// Largest relative difference of the axes and pitches of a run's edges (relative to the object's radius for lengths).
constexpr double kAlike = 1e-3;

/// One edge as a turn about an axis with an advance along it.
struct EdgeScrew {
  Vector3 point;
  Vector3 axis;
  double turn;  ///< angle in radians, > 0
  double advance;
};

std::optional<EdgeScrew> screwOf(const Pose& from, const Pose& to) {
  Quaternion rotation = to.orientation * from.orientation.conjugate();
  if (rotation.w() < 0.0) rotation.coeffs() = -rotation.coeffs();
  const double sine = rotation.vec().norm();
  const double turn = 2.0 * std::atan2(sine, rotation.w());
  if (turn < kLeastEdge || turn > kMostEdge) return std::nullopt;
  const Vector3 axis = rotation.vec() / sine;
  const Vector3 way = to.position - from.position;
  const double advance = way.dot(axis);
  const Vector3 across = way - advance * axis;
  const Vector3 point = from.position + 0.5 * across + axis.cross(across) / (2.0 * std::tan(0.5 * turn));
  return EdgeScrew{point, axis, turn, advance};
}

bool alike(const EdgeScrew& a, const EdgeScrew& b, double radius) {
  if ((a.axis - b.axis).norm() > kAlike) return false;
  if (std::abs(a.advance / a.turn - b.advance / b.turn) > kAlike * radius) return false;
  return (b.point - a.point).cross(a.axis).norm() <= kAlike * radius;
}

/// The common screw motion of the edges; nothing where they have none.
std::optional<ScrewRun> runOf(const std::vector<EdgeScrew>& edges, std::size_t first, const std::vector<Pose>& path,
                              double radius) {
  double turn = 0.0;
  double advance = 0.0;
  Vector3 axis = Vector3::Zero();
  Vector3 point = Vector3::Zero();
  for (const EdgeScrew& edge : edges) {
    turn += edge.turn;
    advance += edge.advance;
    axis += edge.turn * edge.axis;
    point += edge.turn * (edge.point - edges.front().point);
  }
  if (turn < kLeastTurn || advance == 0.0) return std::nullopt;
  ScrewRun run{first, first + edges.size() - 1, {}, advance, 0.0};
  run.screw = {edges.front().point + point / turn, axis.normalized(), 2.0 * std::numbers::pi * advance / turn};
  double atEnds = 0.0;
  double chord = 0.0;
  double turned = 0.0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    turned += edges[i].turn;
    const Pose exact = screwed(run.screw, path[first], turned / turn * advance);
    const Pose& q = path[first + i + 1];
    atEnds = std::max(atEnds,
                      (q.position - exact.position).norm() + radius * angleBetween(q.orientation, exact.orientation));
    // A chord deviates from its helix by at most an eighth of the radius times the square of its angle.
    const double arm = (q.position - run.screw.point_W).cross(run.screw.axis_W).norm() + atEnds;
    chord = std::max(chord, arm * edges[i].turn * edges[i].turn / 8.0);
  }
  run.off = 2.0 * atEnds + chord;
  return run;
}

}  // namespace

std::vector<ScrewRun> screwRunsOf(const std::vector<Pose>& path, double objectRadius) {
  std::vector<ScrewRun> runs;
  std::vector<EdgeScrew> edges;
  std::size_t first = 0;
  const auto close = [&] {
    if (edges.empty()) return;
    if (const auto run = runOf(edges, first, path, objectRadius)) runs.push_back(*run);
    edges.clear();
  };
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const auto edge = screwOf(path[i], path[i + 1]);
    if (!edge || (!edges.empty() && !alike(edges.front(), *edge, objectRadius))) close();
    if (!edge) continue;
    if (edges.empty()) first = i;
    edges.push_back(*edge);
  }
  close();
  return runs;
}

}  // namespace glissade
