#pragma once

#include <QWidget>

#include "engine/operator/device_shaping.h"

namespace glissade {

/// Shaped against raw deflection of one axis, with a dot where the device is now.
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

}  // namespace glissade
