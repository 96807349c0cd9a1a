#pragma once

#include <QAction>
#include <QObject>
#include <QSet>

#include "engine/operator/input_mailbox.h"

namespace glissade {

/// Turns keys pressed over the 3D view into deflections of the six axes, in the view's frame. Released keys and a lost
/// focus deflect nothing.
///
///   A D  left, right     W S  up, down        Q E  away, nearer
///   J L  yaw             I K  pitch           U O  roll          Shift  a quarter of the speed
///   F    other axes
class KeyboardSteering final : public QObject {
  Q_OBJECT

 public:
  /// The key F triggers `otherAxes`; null: F does nothing.
  KeyboardSteering(InputMailbox& keys, QAction* otherAxes, QObject* parent);

  /// The table of keys as HTML rows, for the help page.
  static QString keyTable();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void publish();

  InputMailbox& keys_;
  QAction* otherAxes_;
  QSet<int> pressed_;
  bool slow_ = false;
};

}  // namespace glissade
