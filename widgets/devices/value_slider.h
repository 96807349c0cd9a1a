#pragma once

#include <QLabel>
#include <QSlider>
#include <QWidget>

#include "engine/operator/device_shaping.h"

namespace glissade {

/// A slider with its value beside it. Values come while it is dragged.
class ValueSlider final : public QWidget {
  Q_OBJECT

 public:
  ValueSlider(const ShapingRange& range, const QString& name, QWidget* parent);

  /// Shows the value without telling anybody.
  void setValue(double value);
  double value() const { return value_; }
  /// The part that has the keyboard focus.
  QSlider* slider() const { return slider_; }

 signals:
  void valueChosen(double value);

 private:
  void showText();

  double value_ = 0.0;
  QSlider* slider_;
  QLabel* text_;
};

}  // namespace glissade
