#include "engine/access/hand_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>

namespace glissade {
namespace {

constexpr double kSpacing = 0.01;   ///< metres
constexpr double kHandReach = 0.3;  ///< metres, from what is gripped to the middle of the forearm
constexpr double kMostSamples = 400.0;

double wayBetween(const Pose& from, const Pose& to, const Vector3& middle_W) {
  return (to * middle_W - from * middle_W).norm() + kHandReach * angleBetween(from.orientation, to.orientation);
}

/// Asks for any mesh whether it touches one of the same bodies.
class Surroundings {
 public:
  Surroundings(PreparedBodies& bodies, const std::vector<std::size_t>& choice) : bodies_(bodies), choice_(choice) {}

  /// One body that the mesh touches there.
  std::optional<std::size_t> touched(const MeshPtr& mesh, const Pose& X_WM) {
    if (choice_.empty()) return std::nullopt;
    auto& query = queries_[mesh];
    if (!query) {
      std::vector<PreparedBodies::Against> against;
      for (const std::size_t body : choice_) against.push_back({body, mesh});
      query = bodies_.world(mesh, against)->makeQuery();
    }
    const auto body = query->collidingBody(X_WM);
    if (!body) return std::nullopt;
    return choice_[static_cast<std::size_t>(*body)];
  }

 private:
  PreparedBodies& bodies_;
  const std::vector<std::size_t>& choice_;
  std::map<MeshPtr, std::unique_ptr<CollisionQuery>> queries_;
};

/// How far one hold goes.
struct Trial {
  std::vector<std::size_t> bends;  ///< of the samples that are free, in the order in which they were asked
  std::optional<std::size_t> blockedBy{};
};

/// Maximum number of the most natural holds that are examined again if no hold is free.
constexpr std::size_t kNaturalHolds = 60;

class Trials {
 public:
  Trials(PreparedBodies& bodies, const HandQuestion& question, MeshPtr forearm)
      : question_(question),
        forearm_(std::move(forearm)),
        gripped_(bodies, question.gripped),
        obstacles_(bodies, question.obstacles) {}

  /// Hand and forearm do not go through what is held.
  std::vector<std::size_t> bendsAbout(const HandHold& hold) {
    std::vector<std::size_t> bends;
    const Pose X_WH = question_.samples.front().moved * hold.X_WH;
    if (gripped_.touched(hold.hand, X_WH)) return bends;
    const std::size_t count = wristBends().size();
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t bend = (hold.firstBend + i) % count;
      if (!gripped_.touched(forearm_, X_WH * wristBends()[bend])) bends.push_back(bend);
    }
    return bends;
  }

  Trial of(const HandHold& hold, const std::vector<std::size_t>& bends, std::span<const HandSample> samples,
           const StopToken& stop) {
    Trial trial;
    for (const HandSample& sample : samples) {
      if (stop.stopRequested()) break;
      const Pose X_WH = sample.moved * hold.X_WH;
      trial.blockedBy = obstacles_.touched(hold.hand, X_WH);
      if (!trial.blockedBy && hold.tool) trial.blockedBy = obstacles_.touched(hold.tool, sample.moved * hold.X_WT);
      if (trial.blockedBy) break;
      const auto bend = freeBend(X_WH, bends, trial);
      if (!bend) break;
      trial.bends.push_back(*bend);
    }
    return trial;
  }

  /// The first of the holds that is free at all of these samples, or the one that comes nearest to the place.
  HandAnswer best(const std::vector<HandHold>& holds, std::span<const HandSample> samples, const StopToken& stop) {
    HandAnswer answer;
    answer.access = HandAccess::NoGrip;
    std::vector<const HandHold*> natural;
    for (const HandHold& hold : holds) {
      const std::vector<std::size_t> bends = bendsAbout(hold);
      if (bends.empty()) continue;
      const Trial trial = of(hold, bends, samples, stop);
      if (stop.stopRequested()) return {};
      ++answer.tried;
      if (natural.size() < kNaturalHolds) natural.push_back(&hold);
      if (trial.bends.size() < samples.size()) continue;
      answer.access = HandAccess::Free;
      answer.hold = hold;
      answer.bends.assign(trial.bends.begin(), trial.bends.end());
      return answer;
    }
    for (const HandHold* hold : natural) comeNearer(*hold, samples, answer, stop);
    return stop.stopRequested() ? HandAnswer() : answer;
  }

 private:
  /// The bend of the sample before is tried first. Where none is free, the trial says what is in the way.
  std::optional<std::size_t> freeBend(const Pose& X_WH, const std::vector<std::size_t>& bends, Trial& trial) {
    std::optional<std::size_t> inTheWay;
    const auto isFree = [&](std::size_t bend) {
      const auto body = obstacles_.touched(forearm_, X_WH * wristBends()[bend]);
      if (body && !inTheWay) inTheWay = body;
      return !body;
    };
    if (!trial.bends.empty() && isFree(trial.bends.back())) return trial.bends.back();
    for (const std::size_t bend : bends) {
      if (isFree(bend)) return bend;
    }
    trial.blockedBy = inTheWay;
    return std::nullopt;
  }

  /// A hold that comes nearer to the place than the answer's becomes the answer's.
  void comeNearer(const HandHold& hold, std::span<const HandSample> samples, HandAnswer& answer,
                  const StopToken& stop) {
    const std::vector<HandSample> fromTheEnd(samples.rbegin(), samples.rend());
    const Trial trial = of(hold, bendsAbout(hold), fromTheEnd, stop);
    const std::size_t blocked = samples.size() - std::min(samples.size(), trial.bends.size() + 1);
    if (answer.access == HandAccess::Blocked && samples[blocked].share >= answer.share) return;
    answer.access = HandAccess::Blocked;
    answer.hold = hold;
    answer.share = samples[blocked].share;
    answer.blockedBy = trial.blockedBy;
    answer.bends.assign(samples.size(), std::nullopt);
    std::copy(trial.bends.begin(), trial.bends.end(), answer.bends.rbegin());
  }

  const HandQuestion& question_;
  MeshPtr forearm_;
  Surroundings gripped_;
  Surroundings obstacles_;
};

}  // namespace

HandFollow HandFollow::point(const Vector3& p_W) {
  HandFollow follow;
  follow.kind_ = Kind::Point;
  follow.p_W_ = p_W;
  return follow;
}

HandFollow HandFollow::still() {
  HandFollow follow;
  follow.kind_ = Kind::Still;
  return follow;
}

Pose HandFollow::movedWith(const Pose& moved) const {
  switch (kind_) {
    case Kind::Rigidly: return moved;
    case Kind::Point: return Pose::translation(moved * p_W_ - p_W_);
    case Kind::Still: break;
  }
  return Pose::identity();
}

HandFollow followOf(const std::vector<Pose>& moved, const Vector3& middle_W) {
  double turned = 0.0;
  for (std::size_t i = 1; i < moved.size(); ++i) {
    turned += angleBetween(moved[i - 1].orientation, moved[i].orientation);
  }
  return turned > std::numbers::pi ? HandFollow::point(middle_W) : HandFollow::rigidly();
}

std::vector<HandSample> samplesOf(const std::vector<Pose>& moved, const HandFollow& follow, const Vector3& middle_W) {
  std::vector<Pose> hand;
  std::vector<double> arrival;
  for (const Pose& pose : moved) {
    const Pose next = follow.movedWith(pose);
    arrival.push_back(hand.empty() ? 0.0 : arrival.back() + wayBetween(hand.back(), next, middle_W));
    hand.push_back(next);
  }
  std::vector<HandSample> samples{{hand.front(), 0.0}};
  const double length = arrival.back();
  if (!(length > 0.0)) return samples;
  const double count = std::clamp(std::ceil(length / kSpacing), 1.0, kMostSamples);
  std::size_t leg = 1;
  for (double i = 1.0; i <= count; ++i) {
    const double at = length * i / count;
    while (leg + 1 < hand.size() && arrival[leg] < at) ++leg;
    const double own = arrival[leg] - arrival[leg - 1];
    const double share = own > 0.0 ? std::clamp((at - arrival[leg - 1]) / own, 0.0, 1.0) : 1.0;
    samples.push_back({interpolate(hand[leg - 1], hand[leg], share), i / count});
  }
  return samples;
}

HandAnswer HandSearch::find(const HandQuestion& question, const StopToken& stop) {
  Trials trials(bodies_, question, shapes_.forearm());
  const std::span<const HandSample> samples(question.samples);
  HandAnswer whole = trials.best(question.holds, samples, stop);
  if (whole.access != HandAccess::Blocked || question.pushed == 0) return whole;
  HandAnswer carried = trials.best(question.holds, samples.subspan(question.pushed), stop);
  if (carried.access != HandAccess::Free) return stop.stopRequested() ? HandAnswer() : whole;
  const HandAnswer push = trials.best(question.pushes, samples.first(question.pushed + 1), stop);
  if (push.access != HandAccess::Free) return stop.stopRequested() ? HandAnswer() : whole;
  carried.bends.insert(carried.bends.begin(), push.bends.begin(), push.bends.end() - 1);
  carried.push = push.hold;
  carried.pushed = question.pushed;
  carried.tried += whole.tried + push.tried;
  return carried;
}

}  // namespace glissade
