#pragma once

#include <QDoubleSpinBox>
#include <QSlider>
#include <QToolButton>
#include <QWidget>

#include "engine/base/parameters.h"

namespace glissade {

/// One live parameter of the table as a slider with a number beside it. Lengths are shown in millimetres; ranges over
/// more than two decades are logarithmic. A parameter that the tuner can set has a button that switches the tuner on or
/// off, and the tuner's colour while it is on.
class ParameterSlider final : public QWidget {
  Q_OBJECT

 public:
  explicit ParameterSlider(ParameterId id, QWidget* parent = nullptr);

  ParameterId id() const { return id_; }
  /// Sets the range for an object of this size; keeps the value if it fits.
  void setObjectRadius(double radius);
  /// Shows a value (engine units) without a signal.
  void setValue(double value);
  double value() const;
  /// Sets whether the tuner sets the parameter; `own` is the user's value, which is restored when the tuner is switched
  /// off.
  void setTuned(bool tuned, double own);
  /// Makes the number read-only, for use without a keyboard.
  void setNumberReadOnly();
  /// Whether the user is changing the slider or the number, which then keep the user's value.
  bool isBeingEdited() const;

 signals:
  /// The user has set another value (engine units).
  void valueChosen(double value);
  /// The user has switched the tuner on or off.
  void tuningChosen(bool tuned);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void showUnit();
  void fitNumber();
  double fromPosition(int position) const;
  int toPosition(double value) const;
  void sliderMoved(int position);
  void numberEdited(double shown);
  QToolButton* makeTuningButton();

  ParameterId id_;
  double shownPerUnit_;  ///< for lengths: the number that is shown for a metre; else 1
  double radius_ = 1.0;  ///< radius of the object, metres
  ParameterRange range_{0.0, 1.0};
  bool logarithmic_ = false;
  QSlider* slider_;
  QDoubleSpinBox* number_;
  bool tuned_ = false;
  QToolButton* tuning_;  ///< null if the tuner never sets the parameter
};

/// The table's label in the window's language.
QString parameterLabel(const ParameterSpec& spec);

}  // namespace glissade
