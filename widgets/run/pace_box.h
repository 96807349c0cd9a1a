#pragma once

#include <QComboBox>

namespace glissade {

/// The number of planner steps a second of a run: full speed, one of the usual paces, or a number that is typed.
class PaceBox final : public QComboBox {
  Q_OBJECT

 public:
  explicit PaceBox(QWidget* parent = nullptr);

  /// Shows a pace without a signal; 0 is full speed.
  void setPace(double stepsPerSecond);
  double pace() const { return pace_; }

 signals:
  void paceChosen(double stepsPerSecond);

 private:
  /// Takes the selected or typed pace; any other text changes nothing.
  void takeText(const QString& text);

  double pace_ = 0.0;
};

}  // namespace glissade
