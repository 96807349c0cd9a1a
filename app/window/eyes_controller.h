#pragma once

#include "app/window/workbench.h"

namespace glissade {

class StereoController;
class WindowMemory;

/// What is about the eyes of the person: where they are before the screen, stereo, the head that is tracked,
/// and the headset.
class EyesController final : public QObject {
  Q_OBJECT

 public:
  explicit EyesController(const Workbench& bench);

  void remember(WindowMemory& memory);

 private:
  StereoController* stereo_;
};

}  // namespace glissade
