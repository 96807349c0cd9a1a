#include "widgets/devices/device_controller.h"

#include <QGuiApplication>
#include <QLabel>
#include <QStatusBar>
#include <QToolButton>

#include <algorithm>

#include "widgets/controls/diagnostic_text.h"
#include "widgets/controls/frame_name.h"
#include "widgets/controls/queued_once.h"
#include "widgets/devices/calibration_dialog.h"
#include "widgets/scene3d/camera_steering.h"

namespace glissade {
namespace {

constexpr int kCameraTick = 16;        ///< ms
constexpr double kLongestTick = 0.05;  ///< s, upper bound for a late timer
constexpr int kLongestShownName = 24;

QString shortened(const std::string& name) {
  const QString text = QString::fromStdString(name);
  return text.size() <= kLongestShownName ? text : text.left(kLongestShownName - 1) + QChar(0x2026);
}

}  // namespace

DeviceController::DeviceController(SessionBridge& bridge, ActionCatalogue& actions, SceneWidget& scene, QWidget* window)
    : QObject(window),
      bridge_(bridge),
      actions_(actions),
      scene_(scene),
      window_(window),
      hand_(bridge.hand()),
      grip_(bridge, actions, settings_),
      shapers_{HandShaper(hand_->keyboard), HandShaper(hand_->mouse6d), HandShaper(hand_->gamepad)} {
  for (HandInput* input : hand_->all()) input->shaping.set(settings_.shaping(*input));
  listen();
  connect(actions_["operator.camera"], &QAction::toggled, this,
          [this](bool camera) { setTarget(camera ? SteeringTarget::Camera : SteeringTarget::Object); });
  connect(actions_["operator.frame"], &QAction::triggered, this, [this] { chooseNextFrame(); });
  QAction* roll = actions_["operator.camera-roll"];
  roll->setChecked(settings_.cameraRolls());
  connect(roll, &QAction::toggled, this, [this](bool rolls) { settings_.setCameraRolls(rolls); });
  QAction* leftHanded = actions_["headset.left-handed"];
  leftHanded->setChecked(settings_.leftHanded());
  setLeftHanded(leftHanded->isChecked());
  connect(leftHanded, &QAction::toggled, this, [this](bool left) {
    settings_.setLeftHanded(left);
    setLeftHanded(left);
  });
  connect(actions_["operator.devices"], &QAction::triggered, this, [this] { showCalibration(); });
  cameraTimer_.setInterval(kCameraTick);
  connect(&cameraTimer_, &QTimer::timeout, this,
          [this] { steer(std::min(kLongestTick, static_cast<double>(cameraClock_.restart()) / 1000.0)); });
  if (bridge.clock() == SessionClock::Lockstep) return;
  connect(qGuiApp, &QGuiApplication::applicationStateChanged, this,
          [this](Qt::ApplicationState state) { hand_->focused = state == Qt::ApplicationActive; });
  mouseReader_ = std::make_unique<SpacenavReader>(hand_);
  gamepadReader_ = std::make_unique<GamepadReader>(hand_);
}

DeviceController::~DeviceController() {
  for (HandInput* input : hand_->withButtons()) input->mailbox.setListener({});
}

/// Devices change on their readers' threads; the window handles simultaneous changes together.
void DeviceController::listen() {
  const auto listener = queuedOnce(this, [this] { look(); });
  for (HandInput* input : hand_->withButtons()) input->mailbox.setListener(listener);
}

void DeviceController::addIndicators(QStatusBar& bar) {
  mouse_ = new QLabel(window_);
  mouse_->setObjectName(QStringLiteral("mouse-state"));
  gamepad_ = new QLabel(window_);
  gamepad_->setObjectName(QStringLiteral("gamepad-state"));
  target_ = new QToolButton(window_);
  target_->setObjectName(QStringLiteral("steering-target"));
  target_->setCheckable(true);
  target_->setFocusPolicy(Qt::TabFocus);
  target_->setToolTip(actions_["operator.camera"]->toolTip());
  connect(target_, &QToolButton::clicked, actions_["operator.camera"], &QAction::trigger);
  frame_ = new QToolButton(window_);
  frame_->setObjectName(QStringLiteral("steering-frame"));
  frame_->setFocusPolicy(Qt::TabFocus);
  frame_->setToolTip(actions_["operator.frame"]->toolTip());
  connect(frame_, &QToolButton::clicked, actions_["operator.frame"], &QAction::trigger);
  bar.addPermanentWidget(target_);
  bar.addPermanentWidget(frame_);
  bar.addPermanentWidget(mouse_);
  bar.addPermanentWidget(gamepad_);
  showTarget();
  showFrame();
  showStates();
}

void DeviceController::look() {
  for (std::size_t which = 0; which < seen_.size(); ++which) lookAt(which);
  if (calibration_ != nullptr && calibration_->isVisible()) calibration_->refresh();
  if (hand_->target == SteeringTarget::Camera && bridge_.clock() == SessionClock::RealTime && hand_->focused &&
      !cameraTimer_.isActive()) {
    cameraClock_.start();
    cameraTimer_.start();
  }
}

void DeviceController::lookAt(std::size_t which) {
  HandInput& input = *hand_->withButtons()[which];
  Seen& seen = seen_[which];
  const InputReading now = input.mailbox.reading();
  const bool failed = problemOf(input).has_value();
  if (now.connected != seen.connected || now.name != seen.name || failed != seen.failed) {
    seen.connected = now.connected;
    seen.name = now.name;
    seen.failed = failed;
    input.shaping.set(settings_.shaping(input));
    showStates();
  }
  for (std::size_t button = 0; button < kInputButtons; ++button) {
    while (seen.presses[button] != now.presses[button]) {
      ++seen.presses[button];  // before the action, which may call lookAt() again
      press(input, button);
    }
  }
}

void DeviceController::press(const HandInput& input, std::size_t button) {
  if (calibration_ != nullptr && calibration_->isVisible()) calibration_->showButton(input, button);
  QAction* action = actions_.find(settings_.action(input, button));
  // A person with a headset does not see which window has the focus, so controllers always trigger.
  const bool isWorn = input.kind == InputKind::LeftController || input.kind == InputKind::RightController;
  if (action != nullptr && (hand_->focused || isWorn)) action->trigger();
}

std::optional<Diagnostic> DeviceController::problemOf(const HandInput& input) const {
  if (input.kind == InputKind::Mouse6D && mouseReader_) return mouseReader_->problem();
  if (input.kind == InputKind::Gamepad && gamepadReader_) return gamepadReader_->problem();
  return std::nullopt;
}

void DeviceController::showState(const HandInput& input, const QString& text, QLabel& label) {
  const InputReading now = input.mailbox.reading();
  const auto problem = problemOf(input);
  label.setText(text.arg(problem ? tr("error") : now.connected ? shortened(now.name) : tr("none")));
  label.setToolTip(problem ? diagnosticLine(*problem) : QString::fromStdString(now.name));
  label.setVisible(input.kind == InputKind::Mouse6D || now.connected || problem);
  if (input.kind == InputKind::Mouse6D && !now.connected && !problem) {
    label.setToolTip(tr("No 6D mouse, or spacenavd does not run; looked for again and again"));
  }
}

void DeviceController::showStates() {
  if (mouse_ == nullptr) return;
  showState(hand_->mouse6d, tr("6D mouse: %1"), *mouse_);
  showState(hand_->gamepad, tr("Gamepad: %1"), *gamepad_);
}

void DeviceController::setTarget(SteeringTarget target) {
  hand_->target = target;
  for (HandShaper& shaper : shapers_) shaper.restart();
  showTarget();
  look();
}

void DeviceController::showTarget() {
  if (target_ == nullptr) return;
  const bool camera = hand_->target == SteeringTarget::Camera;
  target_->setText(camera ? tr("Moves: camera") : tr("Moves: object"));
  target_->setChecked(camera);
}

void DeviceController::setLeftHanded(bool left) {
  hand_->mainHand = left ? ControllerSide::Left : ControllerSide::Right;
}

/// Changes the axes in which all present devices move, and keeps them for these devices.
void DeviceController::chooseNextFrame() {
  constexpr int kFrames = 3;
  const int now = static_cast<int>(hand_->keyboard.shaping.get().frame);
  for (HandInput* input : hand_->all()) {
    DeviceShaping shaping = input->shaping.get();
    shaping.frame = static_cast<MotionFrame>((now + 1) % kFrames);
    input->shaping.set(shaping);
    settings_.setShaping(*input, shaping);
  }
  showFrame();
}

/// Shows the axes of the keyboard. Another device may have others by its calibration.
void DeviceController::showFrame() {
  if (frame_ == nullptr) return;
  const QString name = frameName(hand_->keyboard.shaping.get().frame);
  frame_->setText(name);
  actions_["operator.frame"]->setData(name);  // emits changed(), which updates other texts
}

void DeviceController::showCalibration() {
  if (calibration_ == nullptr) calibration_ = new CalibrationDialog(hand_, settings_, actions_, window_);
  calibration_->show();
  calibration_->raise();
  calibration_->activateWindow();
}

void DeviceController::advance(std::uint64_t steps) {
  const SnapshotPtr snapshot = bridge_.snapshot();
  if (!snapshot) return;
  const double dt = 1.0 / snapshot->parameters[ParameterId::StepsPerSecond];
  for (std::uint64_t step = 0; step < steps && hand_->target == SteeringTarget::Camera; ++step) steer(dt);
}

/// Steers the camera for one tick. The timer rests while all devices rest.
void DeviceController::steer(double dt) {
  const bool maySteer = hand_->target == SteeringTarget::Camera && hand_->focused;
  bool atRest = true;
  for (std::size_t which = 0; which < shapers_.size(); ++which) {
    const DeviceShaping shaping = hand_->all()[which]->shaping.get();
    const Deflection deflection = shapers_[which].deflection(dt, shaping, maySteer);
    if (deflection.atRest()) continue;
    atRest = false;
    steerCamera(scene_.view().camera(), deflection, {shaping.linearSpeed, shaping.angularSpeed}, dt,
                actions_["operator.camera-roll"]->isChecked());
  }
  if (atRest) {
    cameraTimer_.stop();
    return;
  }
  emit cameraMoved();
  scene_.refresh();
}

}  // namespace glissade
