#pragma once

#include "app/window/hand_tools.h"
#include "app/window/workbench.h"

namespace glissade {

class PathPanel;
class RefusalController;
class SequenceController;
class StereoController;
class WindowMemory;

/// What is about the eyes of the person: where they are before the screen, stereo, the head that is tracked,
/// and the headset; and whether their hand gets to what moves.
class EyesController final : public QObject {
  Q_OBJECT

 public:
  explicit EyesController(const Workbench& bench);

  void remember(WindowMemory& memory);
  /// What a person with a headset works with, and the access of a hand; once, after the parts of the window that they
  /// are about.
  void addTools(const RefusalController& refusal, SequenceController& sequence, const MeasuringTools& measuring,
                PathPanel& path);

 private:
  const Workbench& bench_;
  StereoController* stereo_;
};

}  // namespace glissade
