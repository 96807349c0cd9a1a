#pragma once

#include "widgets/headset/hand_tools.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

class HeadsetController;
class NamedViewsController;
class PathPanel;
class RefusalController;
class SequenceController;
class StereoController;
class WindowMemory;

/// Makes the controllers about the person's eyes and hand: the eyes before the screen, stereo, head tracking, the
/// headset, and the access of a hand.
class EyesController final : public QObject {
  Q_OBJECT

 public:
  explicit EyesController(const Workbench& bench);

  void remember(WindowMemory& memory);
  /// Adds the tools of a person with a headset and the access of a hand. It is called once, after the parts of the
  /// window that the tools use exist.
  void addTools(const RefusalController& refusal, SequenceController& sequence, const MeasuringTools& measuring,
                PathPanel& path, const NamedViewsController& views);

 private:
  const Workbench& bench_;
  StereoController* stereo_;
  HeadsetController* headset_;
};

}  // namespace glissade
