#include "engine/sequence/straight_removal.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "engine/planning/path_certificate.h"
#include "engine/sequence/blocking_graph.h"
#include "engine/sequence/removal_directions.h"

namespace glissade {
namespace {

constexpr double kSameLine = 1.0 - 1e-9;
/// Slides that differ by less than this share of the group's size count as equal.
constexpr double kSameSlide = 0.05;

}  // namespace

StraightRemoval::StraightRemoval(const AssembledProduct& product, const ProductFits& fits, MotionWorlds& worlds,
                                 const ThreadDemands* threads, const Vector3& up)
    : product_(product), fits_(fits), worlds_(worlds), threads_(threads), up_(up), lines_(product.bodies.size()) {}

void StraightRemoval::learn(const BodyGroup& group, const std::vector<PathPoint>& path) {
  if (path.size() != 2 || path.front().q.orientation.coeffs() != path.back().q.orientation.coeffs()) return;
  const RigidBody& own = product_.bodies[group.front()];
  const Vector3 way = path.back().q.position - path.front().q.position;
  learned_[own.mesh] = own.X_WB.orientation.conjugate() * way.normalized();
}

RemovalAnswer StraightRemoval::tryRemoval(const BodyGroup& group, const BodySet& present, const StopToken& stop) {
  std::set<std::size_t> blocking;
  const BodySet others = without(present, group);
  std::vector<Vector3> directions = directionsOf(group);
  sortBySlide(group, others, directions);
  for (const Vector3& direction : directions) {
    const bool allMay =
        std::all_of(group.begin(), group.end(), [&](std::size_t body) { return worlds_.mayBegin(direction, body); });
    if (!allMay) continue;
    auto blocker = blockerOf(group, direction, others, stop);
    if (!blocker && !stop.stopRequested()) {
      Path path = certified(group, direction, present, stop);
      if (path.certificate.status == CertificateStatus::Certified) {
        return Removed{std::move(path), "straight", fits_.fitsOf(group, present)};
      }
      // No single body blocks the motion, but it was not proved against all of them together.
      const int nearest = path.certificate.nearest.body;
      if (nearest >= 0 && !stop.stopRequested()) {
        blocker = static_cast<std::size_t>(nearest);
        lineAlong(group.front(), direction).blockedBy[*blocker] = Blocking::Yes;
      }
    }
    if (stop.stopRequested()) return Refused{{}, true};
    if (blocker) blocking.insert(*blocker);
  }
  return Refused{{blocking.begin(), blocking.end()}, false};
}

/// Sorts by the length on which the group slides along the bodies of `others` that it fits with, the shortest first. Of
/// equal lengths, downward directions come last: in assembly they are brought from below.
void StraightRemoval::sortBySlide(const BodyGroup& group, const BodySet& others, std::vector<Vector3>& directions) {
  double size = 0.0;
  for (const std::size_t body : group) size = std::max(size, worlds_.boxOf(body).diagonal().norm());
  const auto boxOf = [&](std::size_t body) { return worlds_.boxOf(body); };
  struct Ranked {
    std::pair<long long, bool> rank;  ///< length of the slide, downward
    Vector3 direction;
  };
  std::vector<Ranked> sorted;
  for (const Vector3& direction : directions) {
    const double slide = slideOf(group, {lineAlong(group.front(), direction).way}, others, fits_, boxOf);
    sorted.push_back({{std::llround(slide / (kSameSlide * size)), senseOf(direction, up_) < 0}, direction});
  }
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Ranked& one, const Ranked& other) { return one.rank < other.rank; });
  std::transform(sorted.begin(), sorted.end(), directions.begin(), [](const Ranked& each) { return each.direction; });
}

std::vector<BodyGroup> StraightRemoval::groups(const GroupQuestion& question,
                                               const std::vector<std::pair<std::size_t, std::size_t>>& links,
                                               ThreadTeam& team, const StopToken& stop) {
  BodyGroup leaving;
  for (const std::size_t body : bodiesIn(question.present)) {
    if (!question.staying[body]) leaving.push_back(body);
  }
  if (leaving.empty()) return {};
  const std::vector<Vector3> directions = directionsOf(leaving);
  for (const Vector3& direction : directions) {
    for (const std::size_t body : leaving) lineAlong(body, direction);
  }
  const std::set<std::pair<std::size_t, std::size_t>> linked(links.begin(), links.end());
  std::vector<std::vector<BodyGroup>> along(directions.size());
  team.run(directions.size(), [&](std::size_t i) { along[i] = groupsAlong(directions[i], question, linked, stop); });
  if (stop.stopRequested()) return {};
  std::vector<BodyGroup> found;
  for (std::vector<BodyGroup>& groups : along) std::move(groups.begin(), groups.end(), std::back_inserter(found));
  return smallestDisjoint(std::move(found), [&](const BodyGroup& group) { return boxVolume(product_, group); });
}

/// Precondition: the lines of all bodies along the direction are known.
std::vector<BodyGroup> StraightRemoval::groupsAlong(const Vector3& direction, const GroupQuestion& question,
                                                    const std::set<std::pair<std::size_t, std::size_t>>& linked,
                                                    const StopToken& stop) {
  BodySet staying = question.staying;
  std::vector<Line*> lines(staying.size(), nullptr);
  for (const std::size_t body : bodiesIn(question.present)) {
    staying[body] = staying[body] || !worlds_.mayBegin(direction, body);
    if (!staying[body]) lines[body] = &lineAlong(body, direction);
  }
  const auto candidates = [&](std::size_t blocked) -> const std::vector<std::size_t>& { return lines_[blocked].order; };
  const auto blocks = [&](std::size_t blocker, std::size_t blocked) {
    return linked.count({blocker, blocked}) != 0 || isBlocking(blocker, blocked, *lines[blocked], stop);
  };
  return BlockingGraph(std::move(staying), {candidates, blocks}).groups(question.units, question.most);
}

StraightRemoval::Lines& StraightRemoval::linesOf(std::size_t body) {
  Lines& lines = lines_[body];
  if (lines.known) return lines;
  for (std::size_t other = 0; other < product_.bodies.size(); ++other) {
    if (other != body) lines.others.extend(worlds_.boxOf(other));
  }
  for (const Vector3& direction : removalDirections(product_, fits_, body)) {
    lines.lines.push_back(newLine(body, lines.others, direction));
  }
  lines.own = lines.lines.size();
  const auto add = [&](std::size_t other) {
    const bool listed = std::find(lines.order.begin(), lines.order.end(), other) != lines.order.end();
    if (other != body && !listed) lines.order.push_back(other);
  };
  for (const Fit& fit : fits_.fitsOf(body)) add(fit.obstacle);
  for (std::size_t other = 0; other < product_.bodies.size(); ++other) add(other);
  lines.known = true;
  return lines;
}

StraightRemoval::Line& StraightRemoval::lineAlong(std::size_t body, const Vector3& direction) {
  Lines& lines = linesOf(body);
  const auto known = std::find_if(lines.lines.begin(), lines.lines.end(),
                                  [&](const Line& line) { return line.direction.dot(direction) > kSameLine; });
  if (known != lines.lines.end()) return *known;
  lines.lines.push_back(newLine(body, lines.others, direction));
  return lines.lines.back();
}

StraightRemoval::Line StraightRemoval::newLine(std::size_t body, const Box3& others, const Vector3& direction) const {
  const Box3& box = worlds_.boxOf(body);
  const double margin = leavingMargin(radiusAboutOrigin(*product_.bodies[body].mesh));
  Line line{direction, wayOutOf(box, others, direction, margin) * direction, box,
            std::vector<std::atomic<Blocking>>(product_.bodies.size())};
  line.swept.extend(Box3(box.min() + line.way, box.max() + line.way));
  line.swept.min() -= Vector3::Constant(margin);
  line.swept.max() += Vector3::Constant(margin);
  return line;
}

/// The directions of the group's bodies, without duplicates. A direction that was learned from a congruent body comes
/// first if it is among them; else it is not tried, so that the answer does not depend on what was learned earlier.
std::vector<Vector3> StraightRemoval::directionsOf(const BodyGroup& group) {
  std::vector<Vector3> directions;
  for (const std::size_t body : group) {
    const Lines& lines = linesOf(body);
    for (std::size_t i = 0; i < lines.own; ++i) {
      const Vector3& direction = lines.lines[i].direction;
      const auto alike = [&](const Vector3& other) { return other.dot(direction) > kSameLine; };
      if (std::none_of(directions.begin(), directions.end(), alike)) directions.push_back(direction);
    }
  }
  const RigidBody& first = product_.bodies[group.front()];
  const auto hint = learned_.find(first.mesh);
  if (hint == learned_.end()) return directions;
  const Vector3 twin = first.X_WB.orientation * hint->second;
  std::stable_partition(directions.begin(), directions.end(),
                        [&](const Vector3& direction) { return direction.dot(twin) > kSameLine; });
  return directions;
}

/// Nothing if no body blocks the line, or after a stop.
std::optional<std::size_t> StraightRemoval::blockerOf(const BodyGroup& group, const Vector3& direction,
                                                      const BodySet& others, const StopToken& stop) {
  for (const std::size_t body : group) {
    if (const auto blocker = blockerOf(body, lineAlong(body, direction), others, stop)) return blocker;
  }
  return std::nullopt;
}

std::optional<std::size_t> StraightRemoval::blockerOf(std::size_t body, Line& line, const BodySet& others,
                                                      const StopToken& stop) {
  const std::vector<std::size_t>& order = lines_[body].order;
  const auto blocked = [&](std::size_t other) { return others[other] && line.blockedBy[other] == Blocking::Yes; };
  const auto known = std::find_if(order.begin(), order.end(), blocked);
  if (known != order.end()) return *known;
  for (const std::size_t other : order) {
    if (!others[other] || line.blockedBy[other] != Blocking::Unknown) continue;
    const bool blocks = isBlocking(other, body, line, stop);
    if (stop.stopRequested()) return std::nullopt;
    if (blocks) return other;
  }
  return std::nullopt;
}

/// The answer is not stored after a stop.
bool StraightRemoval::isBlocking(std::size_t other, std::size_t body, Line& line, const StopToken& stop) {
  const Blocking known = line.blockedBy[other];
  if (known != Blocking::Unknown) return known == Blocking::Yes;
  const Vector3* bent = fits_.bentWay(body, other);
  const RigidBody& own = product_.bodies[body];
  Pose end = own.X_WB;
  end.position += line.way;
  const bool pulls = threads_ != nullptr && !threads_->pulled(body, other, {own.X_WB, end}).empty();
  bool blocks =
      pulls || fits_.threadOf(body, other) != nullptr || (bent != nullptr && bent->dot(line.direction) < kSameLine);
  if (!blocks && line.swept.intersects(worlds_.boxOf(other))) {
    const MotionCheck check =
        worlds_.pair(body, other)
            ->makeQuery()
            ->checkMotion(own.X_WB, end, worlds_.object({body}).required, SeekViolation::Any, stop);
    blocks = check.status != CertificateStatus::Certified;
  }
  if (!stop.stopRequested()) line.blockedBy[other] = blocks ? Blocking::Yes : Blocking::No;
  return blocks;
}

/// A body that is out of the box of all others stays out when it moves further.
Path StraightRemoval::certified(const BodyGroup& group, const Vector3& direction, const BodySet& present,
                                const StopToken& stop) {
  const MotionWorld motion = worlds_.world(group, present);
  Vector3 way = Vector3::Zero();
  for (const std::size_t body : group) {
    const Vector3& own = lineAlong(body, direction).way;
    if (own.squaredNorm() >= way.squaredNorm()) way = own;
  }
  const Pose start = worlds_.object(group).X_WB;
  Pose end = start;
  end.position += way;
  Path path{{{start, Author::Computer}, {end, Author::Computer}}, {}};
  path.certificate = certifyPath(*motion.world->makeQuery(), path.points, worlds_.parameters(group), stop);
  nameByProduct(path.certificate, motion.bodies);
  return path;
}

}  // namespace glissade
