#pragma once

#include <chrono>
#include <memory>
#include <thread>

#include "engine/operator/operator_input.h"

namespace glissade {

/// A 3Dconnexion mouse through the spacenavd daemon (libspnav). The daemon may be absent, die and
/// come back: the device reconnects with back-off. libspnav holds one connection per process: make
/// at most one of these at a time.
class SpacenavDevice final : public OperatorDevice {
 public:
  SpacenavDevice();
  ~SpacenavDevice() override;

  Pose advance(double dt, const OperatorView& view, const Box3& bounds) override;
  bool connected() const override;

  struct Connection;

 private:
  std::shared_ptr<Connection> connection_;
};

}  // namespace glissade
