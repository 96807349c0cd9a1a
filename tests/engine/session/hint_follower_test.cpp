// Tests that a person who follows the hints gets there: a scripted novice at the keys, who is taken to the places to
// help as in the window, and sees nothing but the direction of the arrow and the axis to turn.
#include <gtest/gtest.h>

#include <cstdlib>

#include "engine/base/random_stream.h"
#include "engine/operator/hand_guide.h"
#include "engine/operator/sliding_hand.h"
#include "engine/planning/difficulty/help_places.h"
#include "engine/planning/smoothing/shortcuts.h"
#include "engine/session/grown_roadmap.h"
#include "tests/engine/support/loaded_scenario.h"
#include "tests/engine/support/session_support.h"

namespace glissade {
namespace {

/// A novice, who presses keys for the directions in which the arrow is longest. Where the arrow has stayed as it is for
/// two seconds, the novice tries another key now and then.
class NoviceAtTheKeys final : public OperatorDevice {
 public:
  NoviceAtTheKeys(const CollisionWorld& world, std::uint64_t seed)
      : metric_(world.objectRadius()),
        sight_(pointWorld(world)->makeQuery()),
        object_(world.makeQuery()),
        random_(seed, "novice") {}

  void show(std::vector<Pose> passage) { guide_.emplace(std::move(passage), metric_, 0.5 * metric_.radius()); }

  Pose advance(double dt, const OperatorView& view, const Box3& bounds) override {
    if (!guide_) return view.q_device;
    time_ += dt;
    left_ -= dt;
    if (left_ <= 0.0) choose(view.q_device);
    return integrate(view.q_device, keys_, bounds, dt);
  }

 private:
  static constexpr double kReaction = 0.25;  ///< seconds
  static constexpr double kPatience = 2.0;   ///< seconds
  static constexpr double kSpeed = 0.4;      ///< radii per second, and radians per second
  static constexpr double kSeen = 0.01;      ///< least way and least turn that are seen, radii and radians
  static constexpr double kClear = 0.3;      ///< share of the longest component at which another key is pressed, too

  /// The keys are pressed no longer than is needed.
  Vector3 keysFor(const Vector3& way) const {
    const double most = way.cwiseAbs().maxCoeff();
    Vector3 pressed = Vector3::Zero();
    for (int axis = 0; axis < 3; ++axis) {
      const double length = std::abs(way[axis]);
      if (length < std::max(kSeen, kClear * most)) continue;
      pressed[axis] = std::copysign(std::min(kSpeed, length / left_), way[axis]);
    }
    return pressed;
  }
  Vector3 anyKey() {
    Vector3 pressed = Vector3::Zero();
    pressed[static_cast<int>(random_.uniform(0.0, 2.999))] = random_.uniform() < 0.5 ? -0.5 * kSpeed : 0.5 * kSpeed;
    return pressed;
  }

  void choose(const Pose& q) {
    left_ = kReaction * random_.uniform(0.7, 1.5);
    const auto target = guide_->lead(q, *sight_, *object_);
    if (!target) return;
    if (metric_.distance(*target, before_) > 0.02 * metric_.radius()) {
      before_ = *target;
      since_ = time_;
    }
    keys_.linear_W = metric_.radius() * keysFor((target->position - q.position) / metric_.radius());
    keys_.angular_W = keysFor(rotationVector(q.orientation, target->orientation));
    if (time_ - since_ < kPatience || random_.uniform() < 0.5) return;
    if (random_.uniform() < 0.5) {
      keys_.linear_W = metric_.radius() * anyKey();
    } else {
      keys_.angular_W = anyKey();
    }
  }

  Se3Metric metric_;
  std::unique_ptr<CollisionQuery> sight_;
  std::unique_ptr<CollisionQuery> object_;
  RandomStream random_;
  std::optional<HandGuide> guide_;  ///< nothing: there is no arrow, and the novice waits
  Twist keys_;
  Pose before_;         ///< end of the arrow when it moved last
  double since_ = 0.0;  ///< time at which it moved
  double time_ = 0.0;
  double left_ = 0.0;  ///< seconds until the next choice
};

/// A run by hand at the pace of a person.
class HintedRun {
 public:
  HintedRun(const LoadedScenario& environment, std::uint64_t seed)
      : problem_(environment.problem), parameters_(environment.parameters), seed_(seed) {
    auto novice = std::make_unique<NoviceAtTheKeys>(*problem_.world, seed);
    novice_ = novice.get();
    SessionConfig config{problem_, parameters_, "by-hand", seed, nullptr};
    config.device = std::make_unique<SlidingHand>(problem_.world, std::move(novice));
    session_ = makeLockstepSession(std::move(config));
    session_->post(command::Start{});
    advance(5.0);  // the window offers help after five seconds
  }

  /// Goes from place to place until the run is solved or the time is over; each gets half a minute.
  SnapshotPtr follow(double seconds) {
    while (!isOver(seconds)) {
      for (const HelpPlace& place : places()) {
        if (isOver(seconds)) break;
        session_->post(command::SetDevicePose{place.fromStart});
        novice_->show(place.passage);
        advance(30.0);
      }
    }
    return session_->snapshot();
  }

 private:
  void advance(double seconds) {
    session_->advance(static_cast<std::uint64_t>(seconds * parameters_[ParameterId::StepsPerSecond]));
  }
  bool isOver(double seconds) const {
    return !isRunning(*session_->snapshot()) || session_->snapshot()->virtualSeconds >= seconds;
  }
  std::vector<HelpPlace> places() const {
    const GrownRoadmap grown = grownRoadmap(*session_->snapshot());
    return helpPlaces(problem_, grown.nodes, grown.edges, parameters_, seed_,
                      leastPenetration(problem_, parameters_, seed_, kWholeWayBudget));
  }

  const Problem& problem_;
  ParameterValues parameters_;
  std::uint64_t seed_;
  NoviceAtTheKeys* novice_;  ///< owned by the session
  std::unique_ptr<LockstepSession> session_;
};

/// GLISSADE_NOVICES: number of the novices, each with a seed of its own.
TEST(HintFollower, ANoviceSolvesTheEnvironments) {
  const char* asked = std::getenv("GLISSADE_NOVICES");
  const int seeds = asked != nullptr ? std::atoi(asked) : 1;
  constexpr int kFirst = 3;  // the computer's part of its paths has detours before it is shortened
  for (const auto& [name, seconds] : {std::pair("environment-1", 90.0), std::pair("environment-2", 240.0)}) {
    const LoadedScenario environment = test::loadedSample(name);
    int solved = 0;
    for (int seed = kFirst; seed < kFirst + seeds; ++seed) {
      const SnapshotPtr end = HintedRun(environment, static_cast<std::uint64_t>(seed)).follow(seconds);
      if (!end->path || end->virtualSeconds > seconds) continue;
      ++solved;
      const auto lengths = end->path->lengthByAuthor(environment.problem.metric());
      std::cout << name << ", seed " << seed << ": " << end->virtualSeconds << " s, computer " << lengths[0]
                << ", operator " << lengths[1] << ", contact " << lengths[2] << " m\n";
      const Path again = withShortcutsOfComputer(*end->path, environment.problem, environment.parameters, 99, 300);
      EXPECT_GT(again.lengthByAuthor(environment.problem.metric())[0], 0.75 * lengths[0]) << "the computer's detours";
    }
    EXPECT_GE(10 * solved, 8 * seeds) << name;
  }
}

}  // namespace
}  // namespace glissade
