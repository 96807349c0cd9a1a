#pragma once

#include <QTimer>

#include <optional>

#include "app/window/workbench.h"
#include "engine/sequence/led_part.h"

namespace glissade {

class SequenceController;

/// Walks a person with a headset through the instruction: the product is assembled step by step. The part of the step
/// is marked where its motion begins; the main hand takes it and leads it along this motion, until it snaps where it
/// belongs. Then the next part is to be taken. The panel's next and previous step go elsewhere.
class InstructionWalk final : public QObject {
  Q_OBJECT

 public:
  InstructionWalk(const Workbench& bench, SequenceController& sequence);
  ~InstructionWalk() override;

  /// What is to be done now; empty while nobody walks through it.
  const QString& hint() const { return hint_; }

 signals:
  void hintChanged();

 private:
  void setOn(bool on);
  void followPlan();
  /// Of the plan.
  void goTo(std::size_t step);
  void tick();
  void follow(const ControllerReading& now);
  bool reaches(const ControllerReading& now) const;
  std::optional<double> aimedDistance(const ControllerReading& now) const;
  std::vector<RigidBody> partsOfStep() const;
  void finishStep();
  void say(const QString& hint);
  void tell(const ControllerReading& now);
  ControllerInput& hand() const { return hands_->controller(hands_->mainHand); }

  const Workbench& bench_;
  SequenceController& sequence_;
  HandInputsPtr hands_;
  QTimer timer_;  ///< while a person walks through it
  std::size_t step_ = 0;
  std::optional<LedPart> part_;  ///< nothing: all is assembled
  std::optional<Pose> X_GB_;     ///< of the part in the hand, while it is held
  bool closed_ = false;          ///< the hand
  QString hint_;
};

}  // namespace glissade
