#include "engine/operator/recorded_device.h"

namespace glissade {

Pose RecordedDevice::advance(double dt, const OperatorView& view, const Box3& /*bounds*/) {
  if (dt <= 0.0) return view.q_device;
  ++step_;
  Pose q = view.q_device;
  for (; next_ < recording_.size() && recording_[next_].step <= step_; ++next_) q = recording_[next_].q_device;
  return q;
}

void RecordedDevice::restart() {
  step_ = 0;
  next_ = 0;
}

}  // namespace glissade
