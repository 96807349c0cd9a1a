#pragma once

#include <QFrame>
#include <QGridLayout>
#include <QLabel>
#include <QToolButton>

#include "widgets/controls/action_catalogue.h"
#include "widgets/controls/quantity_box.h"

namespace glissade {

/// A bar over the scene while things are arranged: the selected item, snapping with its steps, further actions, and the
/// keys. Esc in it leaves the mode.
class ArrangeBar final : public QFrame {
  Q_OBJECT

 public:
  /// The bar stays at the bottom of `scene`; hidden at first.
  ArrangeBar(const ActionCatalogue& actions, QWidget* scene);

  /// Shows the name of the selected item; empty: nothing is selected.
  void showItem(const QString& name);
  /// Shows the snap of the dragged item in place of the keys; empty: shows the keys.
  void showSnap(const QString& what);
  const QString& snap() const { return snap_; }
  void setSteps(double metres, double radians);
  double distanceStep() const;  ///< metres
  double angleStep() const;     ///< radians

 signals:
  void stepsChanged();
  void left();
  /// The bar covers this height of the scene from its lower border, in pixels; 0: it is hidden.
  void covered(int height);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* makeControls(const ActionCatalogue& actions);
  QToolButton* makeEndButton();
  QuantityBox* addStep(QuantityBox::Quantity quantity, const QString& name);
  void showUnit();
  void setDistance(double metres);
  void showKeys();
  void fit();

  QGridLayout* grid_;
  QLabel* item_;
  QLabel* keys_;
  QuantityBox* distance_;
  QuantityBox* angle_;
  QWidget* controls_;
  QString snap_;           ///< the text of showSnap()
  double perMetre_ = 1.0;  ///< the number that the field shows for a metre
};

}  // namespace glissade
