#include "widgets/devices/grip_controller.h"

#include <QAction>

#include <cmath>

#include "engine/operator/controllers/grip_authority.h"
#include "widgets/controls/queued_once.h"

namespace glissade {
namespace {

/// α changes in steps of 1 / kSteps, so that the log of a run does not fill with the tremor of a hand.
constexpr double kSteps = 20.0;

}  // namespace

GripController::GripController(SessionBridge& bridge, ActionCatalogue& actions, DeviceSettings& settings)
    : bridge_(bridge), wanted_(actions["headset.grip-alpha"]), hand_(bridge.hand()) {
  QAction* wanted = actions["headset.grip-alpha"];
  wanted->setChecked(settings.alphaFollowsGrip());
  connect(wanted, &QAction::toggled, this, [this, &settings](bool follows) {
    settings.setAlphaFollowsGrip(follows);
    follow();
  });
  listen();
}

GripController::~GripController() {
  for (ControllerInput* controller : hand_->controllers()) controller->place.setListener({});
}

/// Follows the controllers, which change on the headset's thread.
void GripController::listen() {
  const auto listener = queuedOnce(this, [this] { follow(); });
  for (ControllerInput* controller : hand_->controllers()) controller->place.setListener(listener);
}

void GripController::follow() {
  const SnapshotPtr& snapshot = bridge_.snapshot();
  if (!snapshot) return;
  const std::optional<double> squeezed = squeeze();
  if (squeezed) {
    if (!before_) before_ = posted_ = snapshot->parameters[ParameterId::Alpha];
    post(alphaOfGrip(*before_, *squeezed));
  } else if (before_) {
    bridge_.post(command::SetParameter{ParameterId::Alpha, *before_});
    before_.reset();
  }
}

/// The grip does not set α while the tuner does.
std::optional<double> GripController::squeeze() const {
  const bool tuned = (bridge_.snapshot()->parameters.integer(ParameterId::Tuning) & kTunedAlpha) != 0;
  if (!wanted_->isChecked() || tuned) return std::nullopt;
  for (const ControllerInput* controller : hand_->controllers()) {
    if (controller->place.feedback().holds) return controller->place.reading().squeeze;
  }
  return std::nullopt;
}

void GripController::post(double alpha) {
  const double step = std::round(kSteps * alpha) / kSteps;
  if (step == posted_) return;
  posted_ = step;
  bridge_.post(command::SetParameter{ParameterId::Alpha, step});
}

}  // namespace glissade
