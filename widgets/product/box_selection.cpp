#include "widgets/product/box_selection.h"

#include <QMouseEvent>

#include "widgets/controls/body_id_text.h"
#include "widgets/scene3d/camera_controller.h"

namespace glissade {
namespace {

constexpr Qt::KeyboardModifiers kBoxKeys = Qt::ControlModifier | Qt::ShiftModifier;

}  // namespace

BoxSelection::BoxSelection(const Workbench& bench)
    : QObject(&bench.window), bench_(bench), band_(new QRubberBand(QRubberBand::Rectangle, bench.scene.widget())) {
  bench.scene.widget()->installEventFilter(this);
}

bool BoxSelection::eventFilter(QObject* watched, QEvent* event) {
  const bool isMouse = event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseMove ||
                       event->type() == QEvent::MouseButtonRelease;
  if (!isMouse) return QObject::eventFilter(watched, event);
  const auto& mouse = static_cast<const QMouseEvent&>(*event);
  const bool begins = event->type() == QEvent::MouseButtonPress && mouse.button() == Qt::LeftButton &&
                      mouse.modifiers() == kBoxKeys && bench_.document.scenario();
  if (begins) from_ = mouse.pos();
  if (!from_) return QObject::eventFilter(watched, event);
  const QRect box = QRect(*from_, mouse.pos()).normalized();
  band_->setGeometry(box);
  band_->setVisible(event->type() != QEvent::MouseButtonRelease);
  if (event->type() == QEvent::MouseButtonRelease) {
    from_.reset();
    select(box);
  }
  return true;
}

void BoxSelection::select(const QRect& box) {
  const SceneView& view = bench_.scene.view();
  const QSize size = bench_.scene.widget()->size();
  const auto isWithin = [&](const Vector3& p_W) {
    const auto at = view.camera().project(p_W);
    return at && box.contains(qRound(size.width() / 2.0 + at->x() * size.height()),
                              qRound(size.height() / 2.0 + at->y() * size.height()));
  };
  SemanticSelection selection;
  for (const RigidBody& body : view.drawnObstacles()) {
    const Box3 extent = view.extentOf({body.id});
    bool isWhole = !extent.isEmpty();
    for (int corner = 0; corner < 8 && isWhole; ++corner) {
      isWhole = isWithin(extent.corner(static_cast<Box3::CornerType>(corner)));
    }
    if (isWhole) selection.bodies.insert(toQString(body.id));
  }
  bench_.document.semantics().select(selection);
}

}  // namespace glissade
