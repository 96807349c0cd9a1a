#pragma once

#include <QTimer>

#include <optional>

#include "engine/sequence/led_part.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

class SequenceController;

/// Leads a person with a headset through the instruction, step by step. The part of the step is marked at the start of
/// its motion. The main hand grips the part and leads it along the motion until it snaps to its assembled pose. Then
/// the next part is marked. The panel's buttons for the next and the previous step go to other steps.
class InstructionWalk final : public QObject {
  Q_OBJECT

 public:
  InstructionWalk(const Workbench& bench, SequenceController& sequence);
  ~InstructionWalk() override;

  /// The action that the person has to do now; empty while the instruction is off.
  const QString& hint() const { return hint_; }

 signals:
  void hintChanged();

 private:
  void setOn(bool on);
  void followPlan();
  /// Goes to the first motion of a step in the order of assembly.
  void goTo(std::size_t step);
  void goTo(std::size_t step, std::size_t motion);
  const StepMotion& motionInHand() const;
  void showPart();
  void tick();
  void follow(const ControllerReading& now);
  bool reaches(const ControllerReading& now) const;
  std::optional<double> aimedDistance(const ControllerReading& now) const;
  std::vector<RigidBody> partsInHand() const;
  void finishMotion();
  void say(const QString& hint);
  void tell(const ControllerReading& now);
  ControllerInput& hand() const { return hands_->controller(hands_->mainHand); }

  const Workbench& bench_;
  SequenceController& sequence_;
  HandInputsPtr hands_;
  QTimer timer_;  ///< runs while a person walks through the instruction
  std::size_t step_ = 0;
  std::size_t motion_ = 0;       ///< index in the step
  std::optional<LedPart> part_;  ///< nothing: the product is assembled
  std::optional<Pose> X_GB_;     ///< pose of the gripped part in the hand; nothing while none is gripped
  bool closed_ = false;          ///< the hand was closed at the last tick
  QString hint_;
};

}  // namespace glissade
