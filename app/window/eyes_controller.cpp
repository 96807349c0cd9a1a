#include "app/window/eyes_controller.h"

#include <QScreen>

#include "widgets/devices/head_controller.h"
#include "widgets/headset/headset_controller.h"
#include "widgets/headset/headset_panel_controller.h"
#include "widgets/sequence/access_controller.h"
#include "widgets/view/stereo_controller.h"

namespace glissade {

EyesController::EyesController(const Workbench& bench) : QObject(&bench.window), bench_(bench) {
  // Without a display the window has the size of the screen.
  const auto screenPixels = [&bench] {
    const bool isSeen = bench.session.clock() == SessionClock::RealTime;
    return isSeen ? bench.window.screen()->size().width() : bench.window.width();
  };
  auto* eyePlace = new EyePlaceKeeper(bench.scene, screenPixels, &bench.window);
  stereo_ = new StereoController(bench, *eyePlace);
  new HeadController(bench, *eyePlace);
  new HeadsetController(bench);
}

void EyesController::addTools(const RefusalController& refusal, SequenceController& sequence,
                              const MeasuringTools& measuring, PathPanel& path) {
  new AccessController(bench_, sequence, path);
  new HeadsetPanelController(bench_, refusal, sequence, measuring);
}

void EyesController::remember(WindowMemory& memory) { stereo_->remember(memory); }

}  // namespace glissade
