#include "engine/sequence/straight_removal.h"

#include <algorithm>
#include <set>

#include "engine/planning/path_certificate.h"
#include "engine/sequence/motion_world.h"
#include "engine/sequence/removal_directions.h"

namespace glissade {
namespace {

constexpr double kSameLine = 1.0 - 1e-9;

}  // namespace

StraightRemoval::StraightRemoval(const AssembledProduct& product, const ProductFits& fits, PreparedBodies& prepared)
    : product_(product), fits_(fits), prepared_(prepared), lines_(product.bodies.size()) {}

void StraightRemoval::learn(std::size_t body, const std::vector<PathPoint>& path) {
  if (path.size() != 2 || path.front().q.orientation.coeffs() != path.back().q.orientation.coeffs()) return;
  const RigidBody& own = product_.bodies[body];
  const Vector3 way = path.back().q.position - path.front().q.position;
  learned_[own.mesh] = own.X_WB.orientation.conjugate() * way.normalized();
}

RemovalAnswer StraightRemoval::tryRemoval(std::size_t body, const BodySet& present, const StopToken& stop) {
  Lines& lines = linesOf(body);
  std::set<std::size_t> blocking;
  for (Line* line : inOrder(body, lines)) {
    auto blocker = blockerOf(body, *line, lines, present, stop);
    if (!blocker && !stop.stopRequested()) {
      Path path = certified(body, *line, present, stop);
      if (path.certificate.status == CertificateStatus::Certified) {
        return Removed{std::move(path), "straight", fits_.fitsOf(body, present)};
      }
      // Each of the others allows for the motion, but it could not be proved of them together.
      const int nearest = path.certificate.nearest.body;
      if (nearest >= 0 && !stop.stopRequested()) {
        blocker = static_cast<std::size_t>(nearest);
        line->blockedBy[*blocker] = true;
      }
    }
    if (stop.stopRequested()) return Refused{{}, true};
    if (blocker) blocking.insert(*blocker);
  }
  return Refused{{blocking.begin(), blocking.end()}, false};
}

StraightRemoval::Lines& StraightRemoval::linesOf(std::size_t body) {
  Lines& lines = lines_[body];
  if (lines.known) return lines;
  for (const Vector3& direction : removalDirections(product_, fits_, body)) {
    lines.lines.push_back(lineAlong(body, direction));
  }
  for (const Fit& fit : fits_.fitsOf(body)) lines.order.push_back(fit.obstacle);
  for (std::size_t other = 0; other < product_.bodies.size(); ++other) {
    const bool listed = std::find(lines.order.begin(), lines.order.end(), other) != lines.order.end();
    if (other != body && !listed) lines.order.push_back(other);
  }
  lines.known = true;
  return lines;
}

StraightRemoval::Line StraightRemoval::lineAlong(std::size_t body, const Vector3& direction) const {
  const RigidBody& own = product_.bodies[body];
  BodySet others(product_.bodies.size(), true);
  others[body] = false;
  const Box3& box = prepared_.boxOf(body);
  const double margin = leavingMargin(own);
  Line line{direction, own.X_WB, box, std::vector<std::optional<bool>>(product_.bodies.size())};
  line.end.position += wayOutOf(box, boxOf(product_, others), direction, margin) * direction;
  const Vector3 way = line.end.position - own.X_WB.position;
  line.swept.extend(Box3(box.min() + way, box.max() + way));
  line.swept.min() -= Vector3::Constant(margin);
  line.swept.max() += Vector3::Constant(margin);
  return line;
}

/// That of a twin first. Its direction may be none of the body's own: then it is a line that is not kept in the list's
/// order, so that the answer does not depend on what was learned earlier.
std::vector<StraightRemoval::Line*> StraightRemoval::inOrder(std::size_t body, Lines& lines) const {
  std::vector<Line*> order;
  for (Line& line : lines.lines) order.push_back(&line);
  const RigidBody& own = product_.bodies[body];
  const auto hint = learned_.find(own.mesh);
  if (hint == learned_.end()) return order;
  const Vector3 direction = own.X_WB.orientation * hint->second;
  std::stable_partition(order.begin(), order.end(),
                        [&](const Line* line) { return line->direction.dot(direction) > kSameLine; });
  return order;
}

/// Nothing where nobody blocks it, or after a stop.
std::optional<std::size_t> StraightRemoval::blockerOf(std::size_t body, Line& line, const Lines& lines,
                                                      const BodySet& present, const StopToken& stop) {
  const auto blocked = [&](std::size_t other) { return present[other] && line.blockedBy[other].value_or(false); };
  const auto known = std::find_if(lines.order.begin(), lines.order.end(), blocked);
  if (known != lines.order.end()) return *known;
  for (const std::size_t other : lines.order) {
    if (!present[other] || line.blockedBy[other]) continue;
    const bool isBlocking = blocks(other, body, line, stop);
    if (stop.stopRequested()) return std::nullopt;
    line.blockedBy[other] = isBlocking;
    if (isBlocking) return other;
  }
  return std::nullopt;
}

bool StraightRemoval::blocks(std::size_t other, std::size_t body, const Line& line, const StopToken& stop) {
  if (fits_.isThread(body, other)) return true;
  if (!line.swept.intersects(prepared_.boxOf(other))) return false;
  const RigidBody& own = product_.bodies[body];
  const CollisionWorldPtr pair = prepared_.world(own.mesh, {{other, fits_.meshAgainst(body, other)}});
  const double required = motionParameters(own)[ParameterId::RequiredClearance];
  const MotionCheck check = pair->makeQuery()->checkMotion(own.X_WB, line.end, required, SeekViolation::Any, stop);
  return check.status != CertificateStatus::Certified;
}

Path StraightRemoval::certified(std::size_t body, const Line& line, const BodySet& present, const StopToken& stop) {
  const MotionWorld motion = motionWorld(product_, fits_, prepared_, body, present);
  Path path{{{product_.bodies[body].X_WB, Author::Computer}, {line.end, Author::Computer}}, {}};
  path.certificate =
      certifyPath(*motion.world->makeQuery(), path.points, motionParameters(product_.bodies[body]), stop);
  nameByProduct(path.certificate, motion.bodies);
  return path;
}

}  // namespace glissade
