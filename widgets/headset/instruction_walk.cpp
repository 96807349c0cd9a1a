#include "widgets/headset/instruction_walk.h"

#include <algorithm>

#include "engine/operator/controllers/grasping_hand.h"
#include "engine/sequence/plan_playback.h"
#include "widgets/scene3d/scene_pick.h"
#include "widgets/sequence/sequence_controller.h"

namespace glissade {
namespace {

constexpr int kWalkTick = 16;  ///< ms
/// Largest share of a motion on the slider: a share of 1 would be the next motion.
constexpr double kFarthest = 0.99;
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

void InstructionWalk::goTo(std::size_t step) { goTo(step, sequence_.shown().plan->steps[step].motions.size() - 1); }

void InstructionWalk::goTo(std::size_t step, std::size_t motion) {
  step_ = step;
  motion_ = motion;
  const RigidBody& first = sequence_.shown().product->body(motionInHand().body);
  part_.emplace(StepWay(motionInHand(), first), first.X_WB);
  X_GB_.reset();
  showPart();
  say(tr("Take %1").arg(joinedNames(motionInHand().bodies(), *sequence_.shown().product)));
  if (part_->isAssembled()) finishMotion();  // a motion without length ends at once
}

const StepMotion& InstructionWalk::motionInHand() const {
  return sequence_.shown().plan->steps[step_].motions[motion_];
}

void InstructionWalk::showPart() {
  const PlayedMotion played{step_, motion_, kFarthest * part_->share()};
  sequence_.panel()->showTime(played.time(*sequence_.shown().plan));
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
  showPart();
  if (part_->isAssembled()) finishMotion();
}

void InstructionWalk::finishMotion() {
  X_GB_.reset();
  if (motion_ > 0) {
    goTo(step_, motion_ - 1);
    return;
  }
  if (step_ > 0) {
    goTo(step_ - 1);
    return;
  }
  part_.reset();
  say(tr("The product is assembled"));
}

std::vector<RigidBody> InstructionWalk::partsInHand() const {
  const ShownPlan& shown = sequence_.shown();
  const StepMotion& motion = motionInHand();
  const Pose moved = part_->X_WB() * inverse(shown.product->body(motion.body).X_WB);
  std::vector<RigidBody> parts;
  for (const BodyId& id : motion.bodies()) {
    parts.push_back(shown.product->body(id));
    parts.back().X_WB = moved * parts.back().X_WB;
  }
  return parts;
}

/// Whether the hand can grip the part: it is near the box of the part, or points at the part, also through other
/// bodies.
bool InstructionWalk::reaches(const ControllerReading& now) const {
  const Vector3 reach = Vector3::Constant(GraspingHand::kReach / now.scale);
  for (const RigidBody& part : partsInHand()) {
    const Box3 box = boundingBox(*part.mesh, part.X_WB);
    if (Box3(box.min() - reach, box.max() + reach).contains(now.X_WG->position)) return true;
  }
  return aimedDistance(now).has_value();
}

std::optional<double> InstructionWalk::aimedDistance(const ControllerReading& now) const {
  if (!now.X_WA || !part_) return std::nullopt;
  const auto hit = pickBody(partsInHand(), {now.X_WA->position, now.X_WA->orientation * -Vector3::UnitZ()});
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
