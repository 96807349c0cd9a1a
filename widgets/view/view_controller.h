#pragma once

#include "widgets/workbench/workbench.h"

namespace glissade {

/// Keeps the 3D view in step with the document and the shown run; has standard views, layers, styles of navigation.
class ViewController final : public QObject {
  Q_OBJECT

 public:
  explicit ViewController(const Workbench& bench);

  /// Gives the session the orientation of the view, because deflections are in the view's frame.
  void publishOperatorFrame();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void updateView(Changes what);
  void connectActions();
  void addNavigationAids();
  /// Lets actions choose which buttons and keys move the camera.
  void connectNavigationStyles();
  /// Updates the window after the camera has moved.
  void showCamera();
  void zoomToSelection();
  /// Updates the unit of the grid after the unit of lengths has changed.
  void showGridUnit();

  const Workbench& bench_;
};

}  // namespace glissade
