#include "app/window/eyes_controller.h"

#include <QScreen>

#include "widgets/devices/head_controller.h"
#include "widgets/headset/headset_controller.h"
#include "widgets/headset/headset_panel_controller.h"
#include "widgets/sequence/access_controller.h"
#include "widgets/view/named_views_controller.h"
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
  headset_ = new HeadsetController(bench);
}

void EyesController::addTools(const RefusalController& refusal, SequenceController& sequence,
                              const MeasuringTools& measuring, PathPanel& path, const NamedViewsController& views) {
  new AccessController(bench_, sequence, path);
  auto* panel = new HeadsetPanelController(bench_, refusal, sequence, measuring);
  connect(&views, &NamedViewsController::viewsChanged, panel, &HeadsetPanelController::setViews);
  connect(panel, &HeadsetPanelController::viewChosen, headset_,
          [this](const NamedView& view) { headset_->standAt(view.pose); });
}

void EyesController::remember(WindowMemory& memory) { stereo_->remember(memory); }

}  // namespace glissade
