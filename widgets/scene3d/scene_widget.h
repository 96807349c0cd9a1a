#pragma once

#include <QImage>
#include <QWidget>
#include <functional>
#include <memory>
#include <vector>

#include "widgets/headset/headset.h"
#include "widgets/scene3d/camera_controller.h"
#include "widgets/scene3d/navigation_style.h"
#include "widgets/scene3d/quad_buffer.h"
#include "widgets/scene3d/scene_view.h"

namespace glissade {

/// A widget that shows a SceneView. Two implementations: QOpenGLWidget on screen, an image rendered
/// by OSMesa offscreen; both handle the mouse alike (orbit, pan, zoom) and repaint on demand only.
/// The widget has no keys of its own: keys go to the window.
class SceneWidget {
 public:
  virtual ~SceneWidget() = default;

  virtual SceneView& view() = 0;
  virtual QWidget* widget() = 0;
  /// Something changed in the view: repaint soon.
  virtual void refresh() = 0;
  /// The picture as it is now, rendered if need be.
  virtual QImage picture() = 0;
  /// The scene in another size (pixels), with the same camera but for the ratio of width to height.
  virtual QImage picture(const QSize& pixels) = 0;
  /// The scene as it is seen from each of these places, at the size and in the device pixels of the widget; as
  /// exact as what the widget draws itself.
  virtual std::vector<QImage> picturesFrom(const std::vector<EyePlace>& eyePlaces) = 0;
  /// Another widget covers this one with picturesFrom(): it draws nothing itself, and shows the last of them again.
  virtual void setCovered(bool covered) = 0;
  /// Over another widget; null where the driver has none.
  virtual std::unique_ptr<QuadBuffer> makeQuadBuffer(QWidget* parent) = 0;
  /// Shows the view in a headset, off at first. Null where the program was built without OpenXR, and where there is no
  /// display.
  virtual Headset* headset() = 0;
  virtual void setNavigationStyle(NavigationStyle style) = 0;
  /// Called after the user moved the camera (R_WV changed: view-relative steering).
  virtual void onCameraMoved(std::function<void()> callback) = 0;
};

/// Makes the scene widget that this executable has been linked with.
using SceneWidgetFactory = std::function<std::unique_ptr<SceneWidget>(QWidget* parent)>;

/// On screen (QOpenGLWidget); library glissade_onscreen, linked into `glissade` only.
std::unique_ptr<SceneWidget> makeOnscreenSceneWidget(QWidget* parent);
/// Without a display (OSMesa); library glissade_osmesa, linked into `glissade-offscreen` only.
std::unique_ptr<SceneWidget> makeOffscreenSceneWidget(QWidget* parent);

}  // namespace glissade
