#include "widgets/view/stereo_controller.h"

#include <QActionGroup>
#include <QMouseEvent>

#include <algorithm>

#include "widgets/scene3d/stereo_screen.h"
#include "widgets/view/full_screen.h"
#include "widgets/view/stereo_dialog.h"
#include "widgets/workbench/scene_ray.h"
#include "widgets/workbench/window_memory.h"

namespace glissade {
namespace {

/// Milliseconds without motion after which the pointer rests.
constexpr int kRest = 300;

}  // namespace

StereoController::StereoController(const Workbench& bench, EyePlaceKeeper& eyePlace)
    : QObject(&bench.window),
      bench_(bench),
      eyePlace_(eyePlace),
      screen_(new StereoScreen(bench.scene, [&eyePlace] { return eyePlace.eyes(); })),
      fullScreen_(new FullScreen(bench.window, bench.actions)) {
  rest_.setSingleShot(true);
  rest_.setInterval(kRest);
  connect(&rest_, &QTimer::timeout, this, &StereoController::pickPlanePoint);
  connectActions();
  askForQuadBuffer();
  bench.scene.widget()->installEventFilter(this);
  eyePlace.setPlanePoint([this] { return planePoint(); });
  connect(&bench.document, &WorkbenchDocument::changedForView, this, [this](Changes what) {
    if (!(what & Change::Scenario)) return;
    pointed_.reset();
    apply();
  });
}

void StereoController::connectActions() {
  auto* group = new QActionGroup(this);
  for (const StereoModeEntry& entry : kStereoModes) {
    QAction* action = group->addAction(bench_.actions[QLatin1String(entry.action)]);
    connect(action, &QAction::triggered, this, [this, mode = entry.mode] {
      StereoSettings settings = settings_;
      settings.mode = mode;
      change(settings);
    });
  }
  bench_.onAction("stereo.swap", this, [this] {
    StereoSettings settings = settings_;
    settings.swapped = bench_.actions["stereo.swap"]->isChecked();
    change(settings);
  });
  bench_.onAction("stereo.settings", this, [this] { showDialog(); });
  bench_.onAction("view.true-size", this, [this] { showAtTrueSize(); });
  connect(bench_.actions["view.full-screen"], &QAction::toggled, this, &StereoController::setFullScreen);
  connect(fullScreen_, &FullScreen::left, this, [this] { bench_.actions["view.full-screen"]->setChecked(false); });
  apply();
}

void StereoController::askForQuadBuffer() {
  if (bench_.scene.makeQuadBuffer(nullptr) != nullptr) return;
  QAction* action = bench_.actions["stereo.quad-buffer"];
  action->setEnabled(false);
  action->setStatusTip(tr("The graphics driver has no buffers of their own for each eye"));
  action->setToolTip(action->statusTip());
}

void StereoController::remember(WindowMemory& memory) {
  settings_ = memory.stereo();
  memory_ = &memory;
  apply();
}

void StereoController::change(const StereoSettings& settings) {
  settings_ = settings;
  if (memory_ != nullptr) memory_->saveStereo(settings_);
  apply();
}

/// Applies the settings. Without a scenario there is no stereo.
void StereoController::apply() {
  if (!bench_.actions[QLatin1String(entryOf(settings_.mode).action)]->isEnabled()) settings_.mode = StereoMode::Off;
  bench_.actions[QLatin1String(entryOf(settings_.mode).action)]->setChecked(true);
  bench_.actions["stereo.swap"]->setChecked(settings_.swapped);
  const StereoMode shown = bench_.document.scenario() ? settings_.mode : StereoMode::Off;
  eyePlace_.setScreen(settings_.screen);
  eyePlace_.setStereo(shown != StereoMode::Off);
  screen_->setMode(shown, settings_.swapped);
  if (dialog_ == nullptr) return;
  dialog_->setSettings(settings_);
  dialog_->showPictureSize(eyePlace_.pictureSize());
}

void StereoController::showDialog() {
  if (dialog_ == nullptr) {
    dialog_ = new StereoDialog(bench_.actions, settings_, &bench_.window);
    connect(dialog_, &StereoDialog::changed, this, &StereoController::change);
  }
  dialog_->showPictureSize(eyePlace_.pictureSize());
  dialog_->show();
  dialog_->raise();
  dialog_->activateWindow();
}

void StereoController::setFullScreen(bool on) {
  if (on) {
    fullScreen_->enter(settings_.display);
    bench_.scene.widget()->setFocus();
  } else {
    fullScreen_->leave();
  }
}

void StereoController::showAtTrueSize() {
  bench_.scene.view().camera().setViewHeight(eyePlace_.pictureSize().height());
  bench_.scene.refresh();
}

std::optional<Vector3> StereoController::planePoint() const {
  switch (settings_.convergence) {
    case Convergence::Focus: return std::nullopt;
    case Convergence::Object: return bench_.scene.view().objectPose().position;
    case Convergence::Pointer: return pointed_;
  }
  return std::nullopt;
}

bool StereoController::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::MouseMove) {
    pointer_ = static_cast<QMouseEvent*>(event)->localPos();
    const bool isAsked = settings_.convergence == Convergence::Pointer && settings_.mode != StereoMode::Off;
    if (isAsked && static_cast<QMouseEvent*>(event)->buttons() == Qt::NoButton) rest_.start();
  }
  return QObject::eventFilter(watched, event);
}

void StereoController::pickPlanePoint() {
  const ScenarioPtr& scenario = bench_.document.scenario();
  if (!scenario) return;
  const SceneView& view = bench_.scene.view();
  std::vector<RigidBody> bodies = view.drawnObstacles();
  if (!view.showsSequence()) {
    bodies.push_back(scenario->object);
    bodies.back().X_WB = view.objectPose();
  }
  const Ray ray = rayThrough(bench_.scene, pointer_);
  const auto hit = pickBody(bodies, ray, {}, view.sections());
  if (!hit) return;
  pointed_ = ray.origin + hit->distance * ray.direction;
  bench_.scene.refresh();
}

}  // namespace glissade
