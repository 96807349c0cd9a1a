#include "widgets/headset/instruction_walk.h"

#include <algorithm>

#include "engine/operator/controllers/grasping_hand.h"
#include "engine/sequence/plan_bodies.h"
#include "widgets/scene3d/scene_pick.h"
#include "widgets/sequence/sequence_controller.h"

namespace glissade {
namespace {

constexpr int kWalkTick = 16;  ///< ms
/// Largest share of a step's motion on the slider: a share of 1 would be the next step.
constexpr double kFarthestOfStep = 0.99;
constexpr const char* kWalkAction = "headset.instruction";

}  // namespace

InstructionWalk::InstructionWalk(const Workbench& bench, SequenceController& sequence)
    : QObject(&bench.window), bench_(bench), sequence_(sequence), hands_(bench.session.hand()) {
  timer_.setInterval(kWalkTick);
  connect(&timer_, &QTimer::timeout, this, &InstructionWalk::tick);
  connect(bench.actions[kWalkAction], &QAction::toggled, this, &InstructionWalk::setOn);
  connect(&sequence, &SequenceController::planShown, this, &InstructionWalk::followPlan);
  connect(sequence.panel(), &SequencePanel::stepChosen, this, [this](int step) {
    if (timer_.isActive()) goTo(static_cast<std::size_t>(step));
  });
  followPlan();
}

InstructionWalk::~InstructionWalk() { hands_->controllersMoveObject = true; }

/// Ends the walk, because another plan is another instruction.
void InstructionWalk::followPlan() {
  const ShownPlan& shown = sequence_.shown();
  const bool hasSteps = shown.plan && shown.product && !shown.growing && !shown.plan->steps.empty();
  bench_.enable(kWalkAction, hasSteps && bench_.scene.headset() != nullptr);
  if (timer_.isActive()) bench_.actions[kWalkAction]->setChecked(false);
}

void InstructionWalk::setOn(bool on) {
  hands_->controllersMoveObject = !on;
  hand().place.setFeedback({});
  if (!on) {
    timer_.stop();
    part_.reset();
    X_GB_.reset();
    say({});
    return;
  }
  bench_.actions["sequence.play"]->setChecked(false);
  bench_.actions["sequence.assembly-order"]->setChecked(true);
  sequence_.panel()->showExploded(0.0);
  closed_ = true;  // a hand that is already closed grips nothing
  timer_.start();
  goTo(sequence_.shown().plan->steps.size() - 1);
}

void InstructionWalk::goTo(std::size_t step) {
  const ShownPlan& shown = sequence_.shown();
  const AssemblyStep& way = shown.plan->steps[step];
  const RigidBody& first = shown.product->bodies[bodiesOf(way, *shown.product).front()];
  step_ = step;
  part_.emplace(StepWay(way, first), first.X_WB);
  X_GB_.reset();
  sequence_.panel()->showTime(static_cast<double>(step) + kFarthestOfStep * part_->share());
  say(tr("Take %1").arg(sequence_.panel()->partsText(step)));
  if (part_->isAssembled()) finishStep();  // a motion without length ends at once
}

/// Moves the part with the hand that grips it; a part that is let go stays.
void InstructionWalk::tick() {
  const ControllerReading now = hand().place.reading();
  const bool isClosed = now.X_WG && now.squeeze >= (closed_ ? GraspingHand::kLetsGo : GraspingHand::kTakes);
  if (!isClosed) X_GB_.reset();
  if (isClosed && !closed_ && part_ && reaches(now)) X_GB_ = inverse(*now.X_WG) * part_->X_WB();
  closed_ = isClosed;
  if (X_GB_) follow(now);
  tell(now);
}

void InstructionWalk::follow(const ControllerReading& now) {
  const double before = part_->share();
  part_->lead(*now.X_WG * *X_GB_);
  if (part_->share() == before) return;
  sequence_.panel()->showTime(static_cast<double>(step_) + kFarthestOfStep * part_->share());
  if (part_->isAssembled()) finishStep();
}

void InstructionWalk::finishStep() {
  X_GB_.reset();
  if (step_ > 0) {
    goTo(step_ - 1);
    return;
  }
  part_.reset();
  say(tr("The product is assembled"));
}

std::vector<RigidBody> InstructionWalk::partsOfStep() const {
  const ShownPlan& shown = sequence_.shown();
  const Pose moved =
      part_->X_WB() * inverse(shown.product->bodies[bodiesOf(shown.plan->steps[step_], *shown.product).front()].X_WB);
  std::vector<RigidBody> parts;
  for (const std::size_t body : bodiesOf(shown.plan->steps[step_], *shown.product)) {
    parts.push_back(shown.product->bodies[body]);
    parts.back().X_WB = moved * parts.back().X_WB;
  }
  return parts;
}

/// Whether the hand can grip the part: it is near the box of the part, or points at the part, also through other
/// bodies.
bool InstructionWalk::reaches(const ControllerReading& now) const {
  const Vector3 reach = Vector3::Constant(GraspingHand::kReach / now.scale);
  for (const RigidBody& part : partsOfStep()) {
    const Box3 box = boundingBox(*part.mesh, part.X_WB);
    if (Box3(box.min() - reach, box.max() + reach).contains(now.X_WG->position)) return true;
  }
  return aimedDistance(now).has_value();
}

std::optional<double> InstructionWalk::aimedDistance(const ControllerReading& now) const {
  if (!now.X_WA || !part_) return std::nullopt;
  const auto hit = pickBody(partsOfStep(), {now.X_WA->position, now.X_WA->orientation * -Vector3::UnitZ()});
  return hit ? std::optional(hit->distance) : std::nullopt;
}

void InstructionWalk::say(const QString& hint) {
  hint_ = hint;
  emit hintChanged();
}

/// Draws the hand that grips the part like a hand that holds the object.
void InstructionWalk::tell(const ControllerReading& now) {
  hand().place.setFeedback({X_GB_.has_value(), 0.0, X_GB_ ? std::nullopt : aimedDistance(now)});
}

}  // namespace glissade
