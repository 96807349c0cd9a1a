#pragma once

#include "app/window/workbench.h"

namespace glissade {

/// Keeps the 3D view in step with the document and the run that is shown; standard views, layers, styles of navigation.
class ViewController final : public QObject {
  Q_OBJECT

 public:
  explicit ViewController(const Workbench& bench);

  /// Tells the session how the view is turned: deflections are read in the view's frame.
  void publishOperatorFrame();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void updateView(Changes what);
  void connectActions();
  void addNavigationAids();
  /// Which buttons and keys move the camera.
  void connectNavigationStyles();
  /// After the camera was moved.
  void showCamera();
  void zoomToSelection();
  /// Lengths may have another unit now.
  void showGridUnit();

  const Workbench& bench_;
};

}  // namespace glissade
