#pragma once

#include <QObject>

#include <optional>

#include "widgets/bridge/session_bridge.h"
#include "widgets/commands/action_catalogue.h"
#include "widgets/devices/device_settings.h"

namespace glissade {

/// The computer's share follows the grip of the controller that holds the object, where the person wants it so: the
/// firmer the grip, the less the computer decides. Let go, the share is as it was before.
class GripController final : public QObject {
  Q_OBJECT

 public:
  GripController(SessionBridge& bridge, ActionCatalogue& actions, DeviceSettings& settings);
  ~GripController() override;

 private:
  void listen();
  void follow();
  /// Of the hand that holds the object; nothing: none does, or α is not the grip's.
  std::optional<double> squeeze() const;
  void post(double alpha);

  SessionBridge& bridge_;
  const QAction* wanted_;
  HandInputsPtr hand_;
  std::optional<double> before_;  ///< α as it was set, while the grip decides it
  double posted_ = 0.0;
};

}  // namespace glissade
