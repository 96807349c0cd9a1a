#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "engine/operator/operator_input.h"

namespace glissade {

/// Several devices in one hand: each moves the object from where the one before has left it. One that holds it at a
/// place of its own comes last, and overrules the others.
class CombinedDevice final : public OperatorDevice {
 public:
  explicit CombinedDevice(std::vector<std::unique_ptr<OperatorDevice>> devices) : devices_(std::move(devices)) {}

  Pose advance(double dt, const OperatorView& view, const Box3& bounds) override {
    OperatorView moved = view;
    for (const auto& device : devices_) moved.q_device = device->advance(dt, moved, bounds);
    return moved.q_device;
  }
  void restart() override {
    for (const auto& device : devices_) device->restart();
  }
  void regrip() override {
    for (const auto& device : devices_) device->regrip();
  }
  void feel(const std::optional<Wrench>& pushedBack) override {
    for (const auto& device : devices_) device->feel(pushedBack);
  }
  bool holds() const override {
    return std::any_of(devices_.begin(), devices_.end(), [](const auto& device) { return device->holds(); });
  }

  bool connected() const override {
    return std::any_of(devices_.begin(), devices_.end(), [](const auto& device) { return device->connected(); });
  }

 private:
  std::vector<std::unique_ptr<OperatorDevice>> devices_;
};

}  // namespace glissade
