#pragma once

#include <QRubberBand>

#include <optional>

#include "widgets/workbench/workbench.h"

namespace glissade {

/// Selects the visible bodies that lie wholly within a box: Ctrl+Shift and a drag with the left button draw it.
class BoxSelection final : public QObject {
 public:
  /// It must be made after all other tools of the scene, so that it sees the mouse first.
  explicit BoxSelection(const Workbench& bench);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void select(const QRect& box);

  const Workbench& bench_;
  QRubberBand* band_;
  std::optional<QPoint> from_;  ///< the corner of the box that is drawn now
};

}  // namespace glissade
