#include "engine/session/operator_hand.h"

#include <limits>

#include "engine/base/guarded.h"

namespace glissade {
namespace {

NearestObstacle noObstacle() {
  NearestObstacle none;
  none.distance = std::numeric_limits<double>::infinity();
  return none;
}

}  // namespace

OperatorHand::OperatorHand(const Problem& problem, std::unique_ptr<OperatorDevice> device)
    : bounds_(problem.bounds),
      start_(problem.start),
      world_(problem.world),
      device_(std::move(device)),
      objectRadius_(problem.world->objectRadius()) {
  sample_.q_device = problem.start;
}

void OperatorHand::put(const Pose& q_device) {
  if (q_device == sample_.q_device) return;
  sample_.q_device = q_device;
  ++sample_.moves;
  nearestIsKnown_ = false;
}

void OperatorHand::restart() {
  put(start_);
  if (device_) device_->restart();
}

Diagnostic OperatorHand::giveUp(Diagnostic why) {
  device_.reset();
  // If memory does not suffice for these words, the diagnostic is unchanged.
  (void)guarded(kWork, [&] {
    why.location = GLISSADE_TEXT("device");
    why.advice = GLISSADE_TEXT("Choose a device again.");
  });
  return why;
}

void OperatorHand::advance(double dt, const OperatorFrame& frame, const StartTreeDistance& tree,
                           const Guidance& guidance) {
  guidance_ = guidance;
  if (!device_) return;
  const OperatorView view{sample_.q_device,
                          frame,
                          [&tree](const Pose& q) { return tree(q); },
                          tree.contactNodes(),
                          [this] { return sample().nearest.distance; },
                          guidance};
  put(device_->advance(dt, view, bounds_));
}

const OperatorSample& OperatorHand::sample() {
  if (!nearestIsKnown_) {
    if (!query_ && world_->isPrepared()) query_ = world_->makeQuery();
    nearestIsKnown_ = query_ != nullptr;
    sample_.nearest = query_ ? query_->nearestObstacle(sample_.q_device) : noObstacle();
  }
  const auto rendered = device_ ? device_->rendered() : std::nullopt;
  sample_.guidance = rendered ? *rendered : guidanceWrench(guidance_, sample_.q_device, sample_.nearest, objectRadius_);
  sample_.hand = device_ ? device_->hand() : std::nullopt;
  return sample_;
}

}  // namespace glissade
