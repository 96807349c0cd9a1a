#pragma once

#include <memory>
#include <utility>

#include "engine/operator/haptic/haptic_device.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {

/// The mesh with every triangle divided into n * n.
inline TriangleMesh subdivided(const TriangleMesh& mesh, std::uint32_t n) {
  TriangleMesh fine;
  for (const TriangleIndices& triangle : mesh.triangles) {
    const Vector3& a = mesh.vertices[triangle[0]];
    const Vector3 u = (mesh.vertices[triangle[1]] - a) / n;
    const Vector3 v = (mesh.vertices[triangle[2]] - a) / n;
    const auto add = [&](std::uint32_t i, std::uint32_t j) { fine.vertices.push_back(a + i * u + j * v); };
    const auto first = static_cast<std::uint32_t>(fine.vertices.size());
    for (std::uint32_t i = 0; i <= n; ++i) {
      for (std::uint32_t j = 0; i + j <= n; ++j) add(i, j);
    }
    const auto at = [&](std::uint32_t i, std::uint32_t j) { return first + i * (n + 1) - i * (i - 1) / 2 + j; };
    for (std::uint32_t i = 0; i < n; ++i) {
      for (std::uint32_t j = 0; i + j < n; ++j) {
        fine.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
        if (i + j + 1 < n) fine.triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    }
  }
  return welded(fine);
}

/// Two Ls of more than 100,000 triangles each: one is static, the other is moved.
inline CollisionWorldPtr denseWorld() {
  const auto dense = std::make_shared<const TriangleMesh>(subdivided(*makeL(), 65));
  RigidBody standing;
  standing.id = "standing";
  standing.name = "standing";
  standing.mesh = dense;
  return CollisionWorld::build({standing}, dense);
}

/// Measures the energy that the hand gives to a device, and the largest wrench.
class WatchedDevice final : public HapticDevice {
 public:
  struct Record {
    double energyIn = 0.0;   ///< energy from the hand into the rendered wrench, joules
    double lowest = 0.0;     ///< lowest value of energyIn so far
    double strongest = 0.0;  ///< largest wrench as a share of the limits
    Pose X_WD;
  };

  WatchedDevice(std::unique_ptr<HapticDevice> device, std::shared_ptr<Record> record)
      : device_(std::move(device)), record_(std::move(record)) {}

  HapticState advance(double dt) override {
    const HapticState state = device_->advance(dt);
    record_->energyIn -= wrench_.force_W.dot(state.X_WD.position - record_->X_WD.position) +
                         wrench_.torque_W.dot(rotationVector(record_->X_WD.orientation, state.X_WD.orientation));
    record_->lowest = std::min(record_->lowest, record_->energyIn);
    record_->X_WD = state.X_WD;
    return state;
  }
  void render(const Wrench& wrench) override {
    wrench_ = wrench;
    record_->strongest = std::max(
        {record_->strongest, wrench.force_W.norm() / limits().force, wrench.torque_W.norm() / limits().torque});
    device_->render(wrench);
  }
  HapticLimits limits() const override { return device_->limits(); }
  void place(const Pose& X_WD) override {
    record_->X_WD = X_WD;
    device_->place(X_WD);
  }

 private:
  std::unique_ptr<HapticDevice> device_;
  std::shared_ptr<Record> record_;
  Wrench wrench_;
};

}  // namespace glissade
