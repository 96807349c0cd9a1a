#include "engine/evidence/pulled_thread.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "engine/evidence/crests.h"
#include "engine/evidence/drawn_nut.h"
#include "engine/evidence/overlap.h"
#include "engine/evidence/thread.h"
#include "engine/geometry/thread_standards.h"

namespace glissade::evidence {
namespace {

/// Largest tilt of an axis that counts as none, radians.
constexpr double kTilt = 1e-4;
constexpr double kFullTurn = 2.0 * std::numbers::pi;
/// Turn from which the pitch is computed, radians.
constexpr double kEnoughTurn = 0.01;
/// Largest pitch of a turn, in diameters of the shaft: a steeper motion is a pull with a turn. Screws for wood have
/// 0.45. The lead of a modelled helix may be larger.
constexpr double kSteepest = 0.5;
constexpr double kLeadOff = 0.1;

/// Difference below which radii are equal, metres.
constexpr double kLeastPressed = 5e-7;
/// Radius of inserts for plastic and sheet metal, largest radial excess of what is melted in, and largest gap of what
/// fits exactly, metres.
constexpr double kLargestInsert = 8e-3;
constexpr double kMostInsertExcess = 1.5e-3;
constexpr double kExactFit = 3e-6;

/// Holes of screws in plastic and wood are drawn wider than those of the standard.
bool isDeepAsThread(const CommonThread& round, const LeavingPair& pair) {
  const bool isScrew = screwSizeIn(pair.nameOfMoving) || screwSizeIn(pair.nameOfOther);
  const bool isDeep =
      hasDepthOfThread(round.radius, round.depth) || (isScrew && round.depth > kLeastThreadDepth * round.radius);
  return isDeep && round.depth < kMostThreadDepth * round.radius && pair.overlap >= 0.5 * round.depth;
}

bool isEngagedAfter(const CommonThread& thread, double advance) {
  return thread.low + advance < thread.highOther && thread.high + advance > thread.lowOther;
}

std::optional<CommonThread> aroundEachOther(const RoundFace& own, const RoundFace& other) {
  if (own.isShaft == other.isShaft || own.axis.cross(other.axis).norm() >= kParallelAxes) return std::nullopt;
  const auto [shaft, hole] = own.isShaft ? std::pair(own.radius, other.radius) : std::pair(other.radius, own.radius);
  const double beside = (other.point - own.point).cross(own.axis).norm();
  if (beside > std::max(2.0 * kOnCylinder, shaft - hole)) return std::nullopt;
  const double from = (other.point - own.point).dot(own.axis);
  const double sense = own.axis.dot(other.axis) < 0.0 ? -1.0 : 1.0;
  const auto [low, high] = std::minmax({from + sense * other.low, from + sense * other.high});
  const CommonThread pair{own.point, own.axis, shaft - hole, shaft, own.low, own.high, low, high, own.isShaft};
  return isEngagedAfter(pair, 0.0) ? std::optional(pair) : std::nullopt;
}

/// The name of a screw and its crests agree: no mesh is thicker, and no screw is drawn thinner.
bool isOfSize(const DrawnCrests& crests, const std::optional<double>& size) {
  constexpr double kThinnest = 0.75;
  constexpr double kThickest = 1.12;
  if (!size) return false;
  const double share = 2.0 * crests.radius / *size;
  return share >= kThinnest && share <= kThickest;
}

/// Crests of the one that go into a round wall of the other one.
class ModelledThreads {
 public:
  ModelledThreads(const LeavingPair& pair, const StopToken& stop) : pair_(pair), stop_(stop) {}

  std::vector<CommonThread> find() {
    const auto sizeOfMoving = screwSizeIn(pair_.nameOfMoving);
    const auto sizeOfOther = screwSizeIn(pair_.nameOfOther);
    for (const RoundFace& wall : pair_.other.rounds) add(wall, pair_.moving, sizeOfMoving, true);
    for (const RoundFace& wall : pair_.moving.rounds) add(wall, pair_.other, sizeOfOther, false);
    return std::move(threads_);
  }

 private:
  void add(const RoundFace& wall, const PlacedBody& crested, const std::optional<double>& size, bool movingHasCrests) {
    if (stop_.stopRequested()) return;
    const auto crests = crestsInto(wall, crested.mesh, stop_);
    if (!crests || (crests->lead == 0.0 && !isOfSize(*crests, size))) return;
    const double shaft = std::max(crests->radius, wall.radius);
    const double depth = std::abs(crests->radius - wall.radius);
    if (pair_.overlap < 0.5 * depth) return;
    const std::pair<double, double> ofCrests(crests->low, crests->high);
    const std::pair<double, double> ofWall(wall.low, wall.high);
    const auto& own = movingHasCrests ? ofCrests : ofWall;
    const auto& other = movingHasCrests ? ofWall : ofCrests;
    threads_.push_back({crests->point, wall.axis, depth, shaft, own.first, own.second, other.first, other.second,
                        movingHasCrests != wall.isShaft, crests->lead});
  }

  const LeavingPair& pair_;
  const StopToken& stop_;
  std::vector<CommonThread> threads_;
};

/// Follows the motion about the axis of a thread until it is free.
class TurnOut {
 public:
  explicit TurnOut(const CommonThread& thread) : thread_(thread) {}

  /// Length of the thread that is pulled, metres; 0: it is turned out.
  double pulled(const std::vector<Pose>& path) {
    const Pose start = inverse(path.front());
    double turnedUpTo = 0.0;
    for (std::size_t i = 1; i < path.size() && isEngagedAfter(thread_, advance_); ++i) {
      if (!follow(path[i - 1] * start, path[i] * start)) break;
      turnedUpTo = advance_;
    }
    if (!isEngagedAfter(thread_, turnedUpTo)) return 0.0;
    const double rest =
        std::min(thread_.high + turnedUpTo - thread_.lowOther, thread_.highOther - thread_.low - turnedUpTo);
    return rest > std::max(isTooSteep() ? 0.0 : pitch_.value_or(0.0), kOnCylinder) ? rest : 0.0;
  }

  /// Pitch in metres a turn, below 0: left-handed; 0: the motion does not turn.
  double pitch() const { return (isRight_ ? 1.0 : -1.0) * pitch_.value_or(0.0); }

 private:
  bool isTooSteep() const {
    const double steepest = std::max(kSteepest * 2.0 * thread_.radius, (1.0 + kLeadOff) * std::abs(thread_.pitch));
    return pitch_.value_or(0.0) > steepest;
  }

  /// True if the edge turns about the axis by the pitch.
  bool follow(const Pose& from, const Pose& to) {
    const Eigen::AngleAxisd rotation((to.orientation * from.orientation.conjugate()).normalized());
    const Vector3 vector = rotation.angle() * rotation.axis();
    const double turn = vector.dot(thread_.axis);
    if ((vector - turn * thread_.axis).norm() > kTilt || std::abs(turn) > std::numbers::pi - 1e-6) return false;
    turn_ += turn;
    const Vector3 way = to * thread_.point - thread_.point;
    advance_ = way.dot(thread_.axis);
    if (!pitch_ && std::abs(turn_) >= kEnoughTurn) {
      pitch_ = std::abs(advance_ / turn_) * kFullTurn;
      isRight_ = advance_ * turn_ > 0.0;
    }
    if (isTooSteep()) return false;
    const double pitch = pitch_.value_or(0.0);
    const double play = std::max(kThreadPlay * pitch, kOnCylinder);
    const double expected = (isRight_ ? 1.0 : -1.0) * turn_ / kFullTurn * pitch;
    return std::abs(advance_ - expected) <= play && (way - advance_ * thread_.axis).norm() <= play;
  }

  const CommonThread& thread_;
  std::optional<double> pitch_;  ///< pitch of the motion, metres; nothing before the first turn
  bool isRight_ = true;
  double turn_ = 0.0;     ///< radians
  double advance_ = 0.0;  ///< metres
};

}  // namespace

bool isCoreOfThread(double radius, double depth) {
  constexpr double kMostPressed = 0.35e-3;
  if (depth <= kMostPressed) return false;
  const double pitch = pitchOfCore(2.0 * radius, depth);
  if (pitch <= 0.0 || depth <= kClashOverlap) return pitch > 0.0;
  return isCoarsePitch(2.0 * radius, pitch) || isCoreByStandard(pitch, depth);
}

bool hasDepthOfThread(double radius, double depth) {
  constexpr double kLeastPitches = 0.2;
  return (depth > kLeastThreadDepth * radius && depth >= kLeastPitches * usualThreadSize(2.0 * radius).pitch) ||
         isCoreOfThread(radius, depth);
}

RoundOverlap roundOverlap(const PlacedBody& one, const PlacedBody& other) {
  RoundOverlap most;
  for (const RoundFace& own : one.rounds) {
    for (const RoundFace& others : other.rounds) {
      const auto round = aroundEachOther(own, others);
      if (!round || round->depth >= kMostThreadDepth * round->radius || round->depth <= most.depth) continue;
      most = {round->depth, round->radius};
    }
  }
  return most;
}

/// The threads that are modelled. If there is none, the shafts that are too thick for their holes. If there is none
/// either, and the file calls the pair a thread or one is a nut, the closest shaft and hole.
std::vector<CommonThread> commonThreads(const LeavingPair& pair, const StopToken& stop) {
  if (const ScrewInSolid* screw = pair.inSolid) {
    const bool isShaft = true;
    return {{screw->point, screw->axis, 0.0, screw->radius, screw->low, screw->high, screw->low, screw->high, isShaft}};
  }
  std::vector<CommonThread> threads;
  if (pair.overlap > 0.0) threads = ModelledThreads(pair, stop).find();
  if (!threads.empty()) return threads;
  std::optional<CommonThread> closest;
  for (const RoundFace& own : pair.moving.rounds) {
    for (const RoundFace& other : pair.other.rounds) {
      const auto round = aroundEachOther(own, other);
      if (!round) continue;
      if (isDeepAsThread(*round, pair)) threads.push_back(*round);
      if (!closest || std::abs(round->depth) < std::abs(closest->depth)) closest = round;
    }
  }
  if (!threads.empty() || !closest) return threads;
  if (pair.isCalledThread || isNutOnShaft(*closest, pair)) threads.push_back(*closest);
  return threads;
}

Message pulledThread(const std::vector<CommonThread>& threads, const std::vector<Pose>& path) {
  for (const CommonThread& thread : threads) {
    const double pulled = TurnOut(thread).pulled(path);
    if (pulled <= 0.0) continue;
    return {GLISSADE_TEXT("%1 of a thread of %2"), {Length{pulled}, Length{2.0 * thread.radius}}};
  }
  return {};
}

bool isPressedIn(const PlacedBody& one, const PlacedBody& other) {
  for (const RoundFace& own : one.rounds) {
    for (const RoundFace& hole : other.rounds) {
      const auto pair = aroundEachOther(own, hole);
      const bool isTight = pair && pair->depth > kLeastPressed && pair->depth < kMostThreadDepth * pair->radius;
      if (isTight && !hasDepthOfThread(pair->radius, pair->depth)) return true;
    }
  }
  return false;
}

bool isInsertIn(const PlacedBody& guest, const PlacedBody& host, bool isNamed) {
  const auto isRing = [&](const CommonThread& pair) {
    return pair.radius <= kLargestInsert && std::any_of(guest.rounds.begin(), guest.rounds.end(), [&](const auto& own) {
             const auto beside = aroundEachOther({pair.point, pair.axis, pair.radius, true, pair.low, pair.high}, own);
             return beside && beside->depth > 0.0;
           });
  };
  for (const RoundFace& own : guest.rounds) {
    for (const RoundFace& hole : host.rounds) {
      const auto pair = aroundEachOther(own, hole);
      if (!pair || !pair->movingIsShaft || pair->depth > kMostInsertExcess) continue;
      if (isNamed ? pair->depth >= -kExactFit : pair->depth > kLeastPressed && isRing(*pair)) return true;
    }
  }
  return false;
}

std::vector<TurnedThread> turnedThreads(const std::vector<CommonThread>& threads, const std::vector<Pose>& path) {
  std::vector<TurnedThread> turned;
  for (const CommonThread& thread : threads) {
    TurnOut motion(thread);
    if (motion.pulled(path) > 0.0 || motion.pitch() == 0.0) continue;
    turned.push_back({motion.pitch(), 2.0 * thread.radius, thread.pitch});
  }
  return turned;
}

}  // namespace glissade::evidence
