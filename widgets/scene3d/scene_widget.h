#pragma once

#include <QImage>
#include <QWidget>
#include <functional>
#include <memory>
#include <vector>

#include "widgets/openxr/headset.h"
#include "widgets/scene3d/camera_controller.h"
#include "widgets/scene3d/navigation_style.h"
#include "widgets/scene3d/quad_buffer.h"
#include "widgets/scene3d/scene_view.h"

namespace glissade {

/// A widget that shows a SceneView. There are two implementations: QOpenGLWidget on screen, and an image rendered by
/// OSMesa offscreen. Both handle the mouse alike (orbit, pan, zoom) and repaint on demand only. The widget handles no
/// keys, which go to the window.
class SceneWidget {
 public:
  virtual ~SceneWidget() = default;

  virtual SceneView& view() = 0;
  virtual QWidget* widget() = 0;
  /// Requests a repaint after a change of the view.
  virtual void refresh() = 0;
  /// The present picture, rendered if necessary.
  virtual QImage picture() = 0;
  /// The scene in another size (pixels), with the same camera except for the ratio of width to height.
  virtual QImage picture(const QSize& pixels) = 0;
  /// The scene from each of these places, in the size and device pixels of the widget, and in the detail of the
  /// widget's own pictures.
  virtual std::vector<QImage> picturesFrom(const std::vector<EyePlace>& eyePlaces) = 0;
  /// Sets whether another widget covers this one with picturesFrom(): it draws nothing itself then, and shows the last
  /// picture again.
  virtual void setCovered(bool covered) = 0;
  /// Makes a buffer over another widget; null if the driver has none.
  virtual std::unique_ptr<QuadBuffer> makeQuadBuffer(QWidget* parent) = 0;
  /// The headset, which is off at first. Null if the program was built without OpenXR, and if there is no display.
  virtual Headset* headset() = 0;
  virtual void setNavigationStyle(NavigationStyle style) = 0;
  /// Sets a function that is called after the user moved the camera, because steering relative to the view depends on
  /// R_WV.
  virtual void onCameraMoved(std::function<void()> callback) = 0;
};

/// Makes the scene widget that this executable has been linked with.
using SceneWidgetFactory = std::function<std::unique_ptr<SceneWidget>(QWidget* parent)>;

/// Makes a widget on screen (QOpenGLWidget); library glissade_onscreen, linked into `glissade` only.
std::unique_ptr<SceneWidget> makeOnscreenSceneWidget(QWidget* parent);
/// Makes a widget without a display (OSMesa); library glissade_osmesa, linked into `glissade-offscreen` only.
std::unique_ptr<SceneWidget> makeOffscreenSceneWidget(QWidget* parent);

}  // namespace glissade
