#pragma once

#include <QWidget>

namespace glissade {

/// One axis, live: the raw deflection as a thin bar above the shaped one, both from the middle; the dead
/// zone is hatched.
class AxisBar final : public QWidget {
  Q_OBJECT

 public:
  explicit AxisBar(QWidget* parent);

  void setValues(double raw, double shaped);
  void setDeadZone(double deadZone);
  double shaped() const { return shaped_; }

  QSize sizeHint() const override { return {180, 22}; }
  QSize minimumSizeHint() const override { return {110, 20}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double raw_ = 0.0;
  double shaped_ = 0.0;
  double deadZone_ = 0.0;
};

}  // namespace glissade
