#pragma once

#include <memory>
#include <mutex>

#include "engine/operator/operator_input.h"

namespace glissade {

/// The six axes that the window's keys deflect: written by the GUI thread, read by the operator
/// thread, latest wins.
class DeflectionMailbox {
 public:
  void set(const Deflection& deflection) {
    const std::lock_guard lock(mutex_);
    deflection_ = deflection;
  }
  Deflection get() const {
    const std::lock_guard lock(mutex_);
    return deflection_;
  }

 private:
  mutable std::mutex mutex_;
  Deflection deflection_;
};

/// Steers with keys: full deflection is reached smoothly while a key is held, so that a tap is a
/// small precise step; release is at once.
class KeyboardDevice final : public OperatorDevice {
 public:
  explicit KeyboardDevice(std::shared_ptr<const DeflectionMailbox> keys) : keys_(std::move(keys)) {}

  Pose advance(double dt, const OperatorView& view, const Box3& bounds) override;
  void restart() override { actual_ = Deflection(); }

 private:
  std::shared_ptr<const DeflectionMailbox> keys_;
  Deflection actual_;
};

}  // namespace glissade
