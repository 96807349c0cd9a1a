#pragma once

#include <QTimer>

#include "app/window/workbench.h"
#include "widgets/devices/device_settings.h"

namespace glissade {

class MeasureController;
class SectionController;

/// What the tools are of the window.
struct MeasuringTools {
  SectionController& sections;
  MeasureController& measure;
};

/// What a controller of the headset does besides moving the object. A section follows the hand as long as its button is
/// held: it lies across the aim, and what is between the person and the hand is cut away. Two points where the ray
/// meets bodies are measured. It is the hand whose button has the action, or the other hand where the action comes from
/// elsewhere.
class HandTools final : public QObject {
  Q_OBJECT

 public:
  HandTools(const Workbench& bench, const MeasuringTools& tools);

 private:
  void cut();
  void follow();
  void measurePoint();
  /// Whose button with this action is held; nothing: none is.
  std::optional<ControllerSide> holding(const char* action) const;
  ControllerReading reading(const char* action) const;

  const Workbench& bench_;
  MeasuringTools tools_;
  HandInputsPtr hands_;
  DeviceSettings settings_;
  QTimer timer_;  ///< while the button is held
};

}  // namespace glissade
