#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QObject>
#include <QSlider>
#include <QWidget>

#include "engine/operator/device_shaping.h"

namespace glissade {

/// A slider with its value beside it. It announces values while it is dragged.
class ValueSlider final : public QWidget {
  Q_OBJECT

 public:
  ValueSlider(const ShapingRange& range, const QString& name, QWidget* parent);

  /// Shows the value without a signal.
  void setValue(double value);
  double value() const { return value_; }
  /// The slider, which has the keyboard focus.
  QSlider* slider() const { return slider_; }

 signals:
  void valueChosen(double value);

 private:
  void showText();

  double value_ = 0.0;
  QSlider* slider_;
  QLabel* text_;
};

/// The live deflection of one axis: a thin bar for the raw value above a bar for the shaped value, both from the
/// middle; the dead zone is hatched.
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

/// One axis of the calibration page: its live bar and the editors of its shaping, in a row of a grid.
class AxisRow final : public QObject {
  Q_OBJECT

 public:
  AxisRow(const QString& name, QGridLayout& grid, int row, QWidget* parent);

  /// Adds the titles of the columns, in row 0.
  static void addHeader(QGridLayout& grid, QWidget* parent);

  const QString& name() const { return name_; }
  const AxisShaping& shaping() const { return shaping_; }
  /// Shows the shaping without a signal.
  void setShaping(const AxisShaping& shaping);
  AxisBar& bar() { return *bar_; }

 signals:
  void changed();
  /// An editor has received the keyboard focus.
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
