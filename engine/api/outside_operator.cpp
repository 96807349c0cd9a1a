#include "engine/api/outside_operator.h"

#include <utility>

#include "engine/api/values.h"

namespace glissade::api {
namespace {

class OutsideOperator final : public OperatorDevice {
 public:
  explicit OutsideOperator(OperatorFunction hand) : hand_(std::move(hand)) {}

  glissade::Pose advance(double dt, const OperatorView& view, const Box3& bounds) override {
    const Pose shown = hand_({publicPose(view.q_device), dt, view.clearance(), view.contactNodes});
    if (const auto fault = faultOfPose(shown, "the operator's pose")) throw OutsideFault(fault->text());
    glissade::Pose held = enginePose(shown);
    held.position = held.position.cwiseMax(bounds.min()).cwiseMin(bounds.max());
    return held;
  }
  bool isSimulated() const override { return true; }

 private:
  OperatorFunction hand_;
};

}  // namespace

std::unique_ptr<OperatorDevice> deviceOf(OperatorFunction hand) {
  return std::make_unique<OutsideOperator>(std::move(hand));
}

}  // namespace glissade::api
