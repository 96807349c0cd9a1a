#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QTimer>
#include <QWidget>

#include <vector>

#include "engine/operator/device_shaping.h"
#include "engine/operator/hand_inputs.h"
#include "widgets/controls/action_catalogue.h"
#include "widgets/devices/axis_row.h"
#include "widgets/devices/device_settings.h"

namespace glissade {

/// Plots shaped against raw deflection of one axis, with a dot at the present deflection.
class ResponseCurve final : public QWidget {
  Q_OBJECT

 public:
  explicit ResponseCurve(QWidget* parent);

  void setAxis(const QString& title, const AxisShaping& axis);
  void setRaw(double raw);

  QSize sizeHint() const override { return {190, 190}; }
  QSize minimumSizeHint() const override { return {150, 150}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString title_;
  AxisShaping axis_;
  double raw_ = 0.0;
};

/// The calibration page: the six axes of a device, raw and shaped, live, and the settings of their shaping. A change
/// takes effect at once and is kept for the device of that name.
class CalibrationDialog final : public QDialog {
  Q_OBJECT

 public:
  CalibrationDialog(HandInputsPtr hand, DeviceSettings& settings, const ActionCatalogue& actions, QWidget* parent);

  /// Shows the devices as they are now.
  void refresh();
  /// Shows the action of the button that was pressed.
  void showButton(const HandInput& input, std::size_t button);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QLayout* makeHeader();
  QWidget* makeAxes();
  QWidget* makeMotion();
  QWidget* makeButtons();
  void chooseDevice(int index);
  void choosePreset(int index);
  void resetDevice();
  /// Applies and keeps the editors' values.
  void apply();
  void showShaping(const DeviceShaping& shaping);
  void showAction();
  void nameButtons();
  HandInput& input() const { return *hand_->withButtons()[static_cast<std::size_t>(device_->currentIndex())]; }

  HandInputsPtr hand_;
  DeviceSettings& settings_;
  const ActionCatalogue& actions_;
  DeviceShaping shown_;
  DominantAxis dominant_;
  int current_ = 0;  ///< the axis whose curve is drawn
  QTimer timer_;

  QWidget* axes_ = nullptr;
  QWidget* motion_ = nullptr;
  QComboBox* device_;
  QLabel* state_;
  QComboBox* preset_;
  std::vector<AxisRow*> rows_;
  ResponseCurve* curve_;
  QCheckBox* dominantAxis_;
  QCheckBox* translationLocked_;
  QCheckBox* rotationLocked_;
  QComboBox* frame_;
  ValueSlider* linearSpeed_;
  ValueSlider* angularSpeed_;
  QComboBox* button_;
  QComboBox* action_;
  QLabel* trouble_;
};

}  // namespace glissade
