#pragma once

#include <QComboBox>

namespace glissade {

/// How many planner steps a second a run makes: full speed, one of the usual paces, or a number that is typed.
class PaceBox final : public QComboBox {
  Q_OBJECT

 public:
  explicit PaceBox(QWidget* parent = nullptr);

  /// Shows a pace without announcing it; 0 is full speed.
  void setPace(double stepsPerSecond);
  double pace() const { return pace_; }

 signals:
  void paceChosen(double stepsPerSecond);

 private:
  /// What is chosen or typed; what is no pace changes nothing.
  void takeText(const QString& text);

  double pace_ = 0.0;
};

}  // namespace glissade
