#pragma once

#include <QDoubleSpinBox>
#include <QSlider>
#include <QToolButton>
#include <QWidget>

#include "engine/base/parameters.h"

namespace glissade {

/// One live parameter of the table as a slider with a number beside it. Lengths are shown in
/// millimetres; ranges over more than two decades are logarithmic. One that can set itself has a
/// button that gives it to the tuner or takes it back, and the tuner's colour while it does.
class ParameterSlider final : public QWidget {
  Q_OBJECT

 public:
  explicit ParameterSlider(ParameterId id, QWidget* parent = nullptr);

  ParameterId id() const { return id_; }
  /// The range for an object of this size; keeps the value where it fits.
  void setObjectRadius(double radius);
  /// Shows a value (engine units) without announcing it.
  void setValue(double value);
  double value() const;
  /// It sets itself; `own` is the user's value, which comes back when he takes it back.
  void setTuned(bool tuned, double own);
  /// The number is only read: where there is no keyboard.
  void setNumberReadOnly();
  /// The user has the slider or the number in hand: what is shown is his.
  bool isBeingEdited() const;

 signals:
  /// The user chose another value (engine units).
  void valueChosen(double value);
  /// The user gave the parameter to the tuner, or took it back.
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
  double shownPerUnit_;  ///< of lengths: what is shown of a metre; 1 else
  double radius_ = 1.0;  ///< of the object, in metres
  ParameterRange range_{0.0, 1.0};
  bool logarithmic_ = false;
  QSlider* slider_;
  QDoubleSpinBox* number_;
  bool tuned_ = false;
  QToolButton* tuning_;  ///< null where the parameter never sets itself
};

/// The table's label in the window's language.
QString parameterLabel(const ParameterSpec& spec);

}  // namespace glissade
