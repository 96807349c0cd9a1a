#include "widgets/headset/headset_controller.h"

#include <QLocale>

#include <cmath>

#include "widgets/openxr/picture_rate.h"

namespace glissade {
namespace {

constexpr int kTick = 500;     ///< ms
constexpr int kPatience = 20;  ///< ticks until the window says that no controller is known
/// Share of a direction in the horizontal plane below which a camera looks straight up or down.
constexpr double kVertical = 0.02;
/// Position of the sign, below the sign of the head tracker.
constexpr QPoint kSignPlace(10, 48);

}  // namespace

QString HeadsetController::troubleText(const HeadsetStatus& status) {
  switch (status.trouble) {
    case HeadsetTrouble::None: return tr("Searching for a headset");
    case HeadsetTrouble::NoDisplay: return tr("A headset needs an X display with OpenGL, and there is none. Retrying");
    case HeadsetTrouble::NoRuntime: return tr("No OpenXR runtime answers. Start the program of your headset. Retrying");
    case HeadsetTrouble::NoOpenGl:
      return tr("The OpenXR runtime takes no pictures by OpenGL. Choose another one. Retrying");
    case HeadsetTrouble::NoHeadset: return tr("No headset is connected. Connect one. Retrying");
    case HeadsetTrouble::SessionLost: return tr("The headset was lost. Nothing else is lost. Searching again");
    case HeadsetTrouble::RuntimeLost: return tr("The OpenXR runtime has ended. Nothing else is lost. Searching again");
    case HeadsetTrouble::Failed:
      return tr("The headset does not work: %1. Retrying").arg(QString::fromStdString(status.detail));
  }
  return {};
}

QString HeadsetController::textOf(const HeadsetStatus& status) {
  switch (status.state) {
    case HeadsetState::Off: return {};
    case HeadsetState::Running:
      if (status.stalls) return tr("The headset has not asked for a picture for seconds. Its program may be busy");
      if (!status.refused.empty()) {
        return tr("The OpenXR runtime refused %1. The headset works without it")
            .arg(QString::fromStdString(status.refused));
      }
      return {};
    case HeadsetState::Searching:
    case HeadsetState::Lost: return troubleText(status);
    case HeadsetState::Idle:
      return tr("The headset %1 is connected. Put it on").arg(QString::fromStdString(status.name));
    case HeadsetState::Left: return tr("The headset was left. Choose View > Headset to come back");
  }
  return {};
}

QString HeadsetController::textOf(const HeadsetFigures& figures) {
  if (figures.drawCalls == 0) return tr("The headset has shown no pictures yet");
  const QLocale locale;
  return tr("A picture of an eye: %1 draw calls, %2 triangles, %3 ms to choose them, %4 ms in OpenGL; the scene is "
            "simplified %5 of %6 times")
      .arg(locale.toString(figures.drawCalls), locale.toString(static_cast<qlonglong>(figures.triangles)),
           locale.toString(1e3 * figures.cullSeconds, 'f', 2), locale.toString(1e3 * figures.drawSeconds, 'f', 2))
      .arg(figures.detailStep)
      .arg(PictureRate::kSteps - 1);
}

HeadsetController::HeadsetController(const Workbench& bench)
    : QObject(&bench.window), bench_(bench), sign_(new QLabel(bench.scene.widget())), headset_(bench.scene.headset()) {
  sign_->setObjectName(QStringLiteral("headset-sign"));
  sign_->setAutoFillBackground(true);
  sign_->setMargin(6);
  sign_->move(kSignPlace);
  sign_->hide();
  if (headset_ == nullptr) {
    disable();
    return;
  }
  headset_->setHands(bench.session.hand());
  headset_->onChanged(
      [this] { QMetaObject::invokeMethod(this, &HeadsetController::showStatus, Qt::QueuedConnection); });
  timer_.setInterval(kTick);
  connect(&timer_, &QTimer::timeout, this, &HeadsetController::tick);
  connect(bench.actions["view.headset"], &QAction::toggled, this, &HeadsetController::setOn);
  for (const char* id : {"headset.on-table", "headset.to-place"}) {
    bench.onAction(id, this, [this] { place(startPlace()); });
  }
  bench.onAction("headset.leave", this, [this] { bench_.actions["view.headset"]->setChecked(false); });
  bench.onAction("headset.figures", this, [this] { showFigures(); });
  connect(&bench.document, &WorkbenchDocument::changed, this, [this](Changes what) {
    if (what & Change::Scenario) place(startPlace());  // only another scenario moves the person, not an edit
  });
  const auto showTheme = [this] { setBackground(); };
  connect(bench.actions["view.dark"], &QAction::toggled, this, showTheme, Qt::QueuedConnection);
}

void HeadsetController::disable() {
  for (const char* id : {"view.headset", "headset.on-table", "headset.to-place", "headset.panel-in-front",
                         "headset.leave", "headset.section", "headset.measure", "headset.select", "headset.left-handed",
                         "headset.grip-alpha", "headset.figures"}) {
    QAction* action = bench_.actions[QLatin1String(id)];
    action->setEnabled(false);
    action->setStatusTip(tr("This program was built without OpenXR, or there is no display"));
    action->setToolTip(action->statusTip());
  }
}

void HeadsetController::setOn(bool on) {
  if (on) {
    place(startPlace());
    headset_->start();
    timer_.start();
  } else {
    headset_->stop();
    timer_.stop();
  }
  showStatus();
}

RoomPlacement HeadsetController::startPlace() const {
  const bool onTable = bench_.actions["headset.on-table"]->isChecked();
  return placeRoom(bench_.scene.view().extent(), onTable ? ProductSize::OnTable : ProductSize::True);
}

void HeadsetController::place(const RoomPlacement& room) {
  headset_->setPlacement(room);
  setBackground();
}

void HeadsetController::standAt(const CameraPose& view) {
  const Vector3 back_W = view.R_WV * Vector3::UnitZ();
  const bool isVertical = std::hypot(back_W.x(), back_W.y()) < kVertical;
  const Vector3 ahead_W = isVertical ? Vector3(view.R_WV * Vector3::UnitY()) : Vector3(-back_W);
  place(placeRoomAt(view.focus + view.distance * back_W, ahead_W, startPlace().scale));
}

void HeadsetController::setBackground() {
  const SceneView& view = bench_.scene.view();
  headset_->setBackground(view.background(), view.backgroundBelow());
}

void HeadsetController::tick() {
  const HandInputs& hands = *bench_.session.hand();
  const bool isKnown = !hands.leftController.buttons.mailbox.reading().name.empty() ||
                       !hands.rightController.buttons.mailbox.reading().name.empty();
  const bool lacks = headset_->status().state == HeadsetState::Running && !isKnown;
  ticksWithoutControllers_ = lacks ? ticksWithoutControllers_ + 1 : 0;
  showStatus();
}

void HeadsetController::showStatus() {
  const HeadsetStatus status = headset_->status();
  const bool lacksControllers = ticksWithoutControllers_ >= kPatience;
  if (status == shown_ && lacksControllers == lacksControllers_) return;
  shown_ = status;
  lacksControllers_ = lacksControllers;
  QAction& action = *bench_.actions["view.headset"];
  if (status.state == HeadsetState::Left && action.isChecked()) {
    const QSignalBlocker blocker(action);
    action.setChecked(false);
  }
  QString text = textOf(status);
  if (text.isEmpty() && lacksControllers) {
    text =
        tr("The headset reports no controllers that are known here. Known are Touch, Index, Vive, Windows Mixed "
           "Reality, and OpenXR's simple controller");
  }
  sign_->setText(text);
  sign_->adjustSize();
  sign_->setVisible(!text.isEmpty() && status.state != HeadsetState::Left);
  if (!text.isEmpty()) bench_.messages.showStatus(text);
  if (status.state == HeadsetState::Off) bench_.messages.showStatus(tr("The headset is off"));
  if (status.state == HeadsetState::Running && text.isEmpty()) {
    bench_.messages.showStatus(tr("The scene is shown in the headset %1").arg(QString::fromStdString(status.name)));
  }
  bench_.scene.refresh();
}

void HeadsetController::showFigures() { bench_.messages.showStatus(textOf(headset_->figures())); }

}  // namespace glissade
