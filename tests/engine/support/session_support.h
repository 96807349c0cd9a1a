#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <thread>

#include "engine/session/session.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {

/// A device that goes straight from wherever it is to a target at 1 m/s, and rests there.
class HomingDevice final : public OperatorDevice {
 public:
  explicit HomingDevice(const Vector3& target) : target_(target) {}

  Pose advance(double dt, const OperatorView& view, const Box3& bounds) override {
    const Vector3 way = target_ - view.q_device.position;
    if (way.norm() < 1e-9) return view.q_device;
    Twist twist;
    twist.linear_W = way.normalized() * std::min(1.0, way.norm() / std::max(dt, 1e-9));
    return integrate(view.q_device, twist, bounds, dt);
  }
  void restart() override { ++restarts; }

  int restarts = 0;

 private:
  Vector3 target_;
};

inline SessionConfig sessionConfig(const Problem& problem, std::unique_ptr<OperatorDevice> device = nullptr) {
  return {problem, ParameterValues(problem.world->objectRadius()), "contact-birrt", 1, std::move(device)};
}

/// Lets a session of either kind go on until the condition holds or patience ends.
inline bool waitFor(Session& session, const std::function<bool(const SessionSnapshot&)>& condition,
                    std::chrono::seconds patience = std::chrono::seconds(60)) {
  const auto end = std::chrono::steady_clock::now() + patience;
  auto* lockstep = dynamic_cast<LockstepSession*>(&session);
  while (std::chrono::steady_clock::now() < end) {
    if (condition(*session.snapshot())) return true;
    if (lockstep != nullptr) {
      lockstep->advance(5);
    } else {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }
  return condition(*session.snapshot());
}

inline std::vector<RoadmapNode> allNodes(const RoadmapChunks& chunks) {
  std::vector<RoadmapNode> nodes;
  for (const auto& chunk : chunks) nodes.insert(nodes.end(), chunk->nodes.begin(), chunk->nodes.end());
  return nodes;
}

inline bool hasEnded(const SessionSnapshot& snapshot) {
  return snapshot.state == SessionState::Solved || snapshot.state == SessionState::Failed ||
         snapshot.state == SessionState::Stopped;
}

}  // namespace glissade
