#pragma once

#include <QObject>

#include <optional>

#include "widgets/controls/action_catalogue.h"
#include "widgets/devices/device_settings.h"
#include "widgets/document/session_bridge.h"

namespace glissade {

/// Lets the grip of the controller that holds the object set α, if the person has chosen so: a firmer grip gives the
/// computer a smaller share. When the object is let go, α gets its earlier value again.
class GripController final : public QObject {
  Q_OBJECT

 public:
  GripController(SessionBridge& bridge, ActionCatalogue& actions, DeviceSettings& settings);
  ~GripController() override;

 private:
  void listen();
  void follow();
  /// Grip of the hand that holds the object; nothing if none holds it or the grip does not set α.
  std::optional<double> squeeze() const;
  void post(double alpha);

  SessionBridge& bridge_;
  const QAction* wanted_;
  HandInputsPtr hand_;
  std::optional<double> before_;  ///< α before the grip set it; nothing while the grip does not set it
  double posted_ = 0.0;
};

}  // namespace glissade
