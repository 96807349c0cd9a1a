#pragma once

#include <QTimer>

#include "widgets/devices/device_settings.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

class MeasureController;
class SectionController;

/// The controllers of the window that the tools use.
struct MeasuringTools {
  SectionController& sections;
  MeasureController& measure;
};

/// The tools of the headset's controllers besides moving the object. A section follows the hand as long as its button
/// is held: it lies across the direction of aim, and cuts away the bodies between the person and the hand. Two points
/// where the ray meets bodies are measured. The body that the ray meets is selected. The tool belongs to the hand whose
/// button has the action; if the action comes from elsewhere, to the hand that is not the main hand.
class HandTools final : public QObject {
  Q_OBJECT

 public:
  HandTools(const Workbench& bench, const MeasuringTools& tools);

 private:
  void cut();
  void follow();
  void measurePoint();
  void selectBody();
  /// The side whose button with this action is held; nothing if none is held.
  std::optional<ControllerSide> holding(const char* action) const;
  ControllerReading reading(const char* action) const;

  const Workbench& bench_;
  MeasuringTools tools_;
  HandInputsPtr hands_;
  DeviceSettings settings_;
  QTimer timer_;  ///< runs while the button is held
};

}  // namespace glissade
