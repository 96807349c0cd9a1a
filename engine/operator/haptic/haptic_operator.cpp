#include "engine/operator/haptic/haptic_operator.h"

namespace glissade {

HapticOperator::HapticOperator(CollisionWorldPtr world, std::unique_ptr<HapticDevice> device)
    : world_(std::move(world)), device_(std::move(device)) {}

Pose HapticOperator::advance(double dt, const OperatorView& view, const Box3& bounds) {
  orders_.guidance = view.guidance;
  orders_.bounds = bounds;
  if (view.q_device != q_ || !loop_) {
    orders_.q = q_ = view.q_device;
    ++orders_.placements;
  }
  if (loop_) {
    loop_->order(orders_);
  } else {
    loop_ = std::make_unique<HapticLoop>(world_, std::move(device_), orders_);
  }
  const HapticReport report = loop_->report();
  if (report.failure) std::rethrow_exception(report.failure);
  if (dt <= 0.0 || report.placements != orders_.placements) return q_;
  wrench_ = report.cycle.wrench;
  return q_ = report.cycle.q;
}

SteppedHapticOperator::SteppedHapticOperator(const CollisionWorldPtr& world, std::unique_ptr<HapticDevice> device)
    : query_(world->makeQuery()),
      objectRadius_(world->objectRadius()),
      servo_(std::move(device), world->objectRadius()) {}

Pose SteppedHapticOperator::advance(double dt, const OperatorView& view, const Box3& bounds) {
  if (!placed_ || view.q_device != cycle_.q) {
    servo_.place(view.q_device);
    cycle_ = {view.q_device, {}, 0.0};
    placed_ = true;
  }
  const double reach = reachOf(view.guidance, objectRadius_);
  for (owed_ += dt; owed_ >= HapticServo::kPeriod; owed_ -= HapticServo::kPeriod) {
    if (servo_.object().needsSurroundings()) servo_.learn(lookAround(*query_, servo_.object().pose(), reach));
    cycle_ = servo_.cycle(HapticServo::kPeriod, view.guidance, bounds);
  }
  return cycle_.q;
}

DeviceEntry hapticEntry(std::string id, CatalogueText label, CatalogueText description, bool simulated,
                        std::function<std::unique_ptr<HapticDevice>(const DeviceContext&)> make) {
  const auto makeOperator = [make = std::move(make)](const DeviceContext& context) -> std::unique_ptr<OperatorDevice> {
    if (!context.world) return nullptr;
    auto device = make(context);
    if (!device) return nullptr;
    if (context.realTime) return std::make_unique<HapticOperator>(context.world, std::move(device));
    return std::make_unique<SteppedHapticOperator>(context.world, std::move(device));
  };
  return {std::move(id), label, description, simulated, makeOperator};
}

}  // namespace glissade
