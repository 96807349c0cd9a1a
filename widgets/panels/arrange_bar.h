#pragma once

#include <QBoxLayout>
#include <QFrame>
#include <QLabel>

#include "widgets/commands/action_catalogue.h"
#include "widgets/panels/quantity_box.h"

namespace glissade {

/// A bar over the scene while things are arranged: what is arranged, snapping with its steps, what else can be done,
/// and the keys. Esc in it leaves the mode.
class ArrangeBar final : public QFrame {
  Q_OBJECT

 public:
  /// Stays at the bottom of `scene`; hidden at first.
  ArrangeBar(const ActionCatalogue& actions, QWidget* scene);

  /// What is arranged; empty: nothing is selected.
  void showItem(const QString& name);
  void setSteps(double metres, double radians);
  double distanceStep() const;  ///< metres
  double angleStep() const;     ///< radians

 signals:
  void stepsChanged();
  void left();
  /// It covers so many pixels of the scene from its lower border; 0: it is hidden.
  void covered(int height);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QLayout* makeControls(const ActionCatalogue& actions);
  QuantityBox* addStep(QuantityBox::Quantity quantity, double most, const QString& suffix, const QString& name);
  void showKeys();
  void fit();

  QBoxLayout* top_;
  QLabel* item_;
  QLabel* keys_;
  QuantityBox* distance_;
  QuantityBox* angle_;
};

}  // namespace glissade
