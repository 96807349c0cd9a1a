#include "widgets/workbench/scene_ray.h"

#include <algorithm>

#include "widgets/scene3d/camera_controller.h"

namespace glissade {

Ray rayThrough(SceneWidget& scene, const QPointF& position) {
  const QWidget& widget = *scene.widget();
  const QPointF at = (position - QPointF(widget.width() / 2.0, widget.height() / 2.0)) / std::max(1, widget.height());
  return rayThrough(scene.view().camera(), at.x(), at.y());
}

}  // namespace glissade
