#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QObject>

#include "engine/operator/device_shaping.h"
#include "widgets/devices/axis_bar.h"
#include "widgets/devices/value_slider.h"

namespace glissade {

/// One axis of the calibration page: its live bar and the editors of its shaping, in a row of a grid.
class AxisRow final : public QObject {
  Q_OBJECT

 public:
  AxisRow(const QString& name, QGridLayout& grid, int row, QWidget* parent);

  /// The words over the columns, in row 0.
  static void addHeader(QGridLayout& grid, QWidget* parent);

  const QString& name() const { return name_; }
  const AxisShaping& shaping() const { return shaping_; }
  /// Shows it without telling anybody.
  void setShaping(const AxisShaping& shaping);
  AxisBar& bar() { return *bar_; }

 signals:
  void changed();
  /// One of the editors has the keyboard focus.
  void entered();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void addSlider(ValueSlider*& slider, const ShapingRange& range, const QString& name, double AxisShaping::*value,
                 QGridLayout& grid, int row, int column, QWidget* parent);

  QString name_;
  AxisShaping shaping_;
  AxisBar* bar_;
  ValueSlider* deadZone_;
  ValueSlider* gain_;
  ValueSlider* exponent_;
  QCheckBox* inverted_;
  QComboBox* source_;
};

}  // namespace glissade
