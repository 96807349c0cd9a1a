#include "widgets/arrange/arrange_tool.h"

#include <QLocale>
#include <QMouseEvent>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "widgets/controls/length_text.h"
#include "widgets/workbench/arranged_item.h"
#include "widgets/workbench/scene_ray.h"

namespace glissade {
namespace {

/// The item snaps to features within this distance.
constexpr double kSnapPixels = 6.0;

QString withSign(double value, const QString& text) { return value > 0.0 ? QLatin1Char('+') + text : text; }

/// The view's axis along which a key moves the item: 0 to the right, 1 upwards, 2 towards the viewer.
struct NudgeKey {
  int key;
  int viewAxis;
  double sign;
};

constexpr std::array<NudgeKey, 6> kNudgeKeys{{{Qt::Key_Left, 0, -1.0},
                                              {Qt::Key_Right, 0, 1.0},
                                              {Qt::Key_Down, 1, -1.0},
                                              {Qt::Key_Up, 1, 1.0},
                                              {Qt::Key_PageUp, 2, -1.0},
                                              {Qt::Key_PageDown, 2, 1.0}}};

/// For each axis of the view, the nearest axis of the gizmo and its sign. No axis of the gizmo is used twice.
struct NearestAxes {
  std::array<int, 3> axis{};
  std::array<double, 3> sign{};
};

NearestAxes nearestAxes(const Quaternion& R_GV) {
  NearestAxes nearest;
  std::array<bool, 3> taken{};
  for (std::size_t v = 0; v < 3; ++v) {
    const Vector3 direction = R_GV * Vector3(Vector3::Unit(static_cast<int>(v)));
    double best = -1.0;
    for (int axis = 0; axis < 3; ++axis) {
      const double share = std::abs(direction[axis]);
      if (taken[static_cast<std::size_t>(axis)] || share <= best) continue;
      best = share;
      nearest.axis[v] = axis;
    }
    taken[static_cast<std::size_t>(nearest.axis[v])] = true;
    nearest.sign[v] = direction[nearest.axis[v]] < 0.0 ? -1.0 : 1.0;
  }
  return nearest;
}

}  // namespace

ArrangeTool::ArrangeTool(const WorkbenchDocument& document, SceneWidget& scene, ArrangeSnapping& features,
                         QObject* parent)
    : DragTool(scene, parent),
      document_(document),
      gizmo_(new GizmoOverlay(scene.view(), scene.widget())),
      features_(features) {
  gizmo_->hide();
  connect(&document, &WorkbenchDocument::changed, this, &ArrangeTool::followDocument);
  connect(&document, &WorkbenchDocument::editFailed, this, [this] {
    put_.reset();
    showGizmo();
  });
}

void ArrangeTool::followDocument(Changes what) {
  if (!(what & (Change::Scenario | Change::Arrangement))) return;
  const Scenario& scenario = document_.scenario()->scenario;
  if (put_ && ((what & Change::Scenario) || poseOf(scenario, put_->item) == put_->X_WB)) put_.reset();
  const bool stays = inHand_ && !(what & Change::Scenario) && poseOf(scenario, inHand_->item) == inHand_->before;
  if (stays) {
    draw(inHand_->now);
  } else {
    inHand_.reset();
    showGizmo();
  }
}

void ArrangeTool::setOn(bool on) {
  if (on == on_) return;
  restoreHeldItem();
  on_ = on;
  gizmo_->setVisible(on);
  showGizmo();
  if (on) {
    features_.prepare();
    scene_.widget()->setCursor(Qt::OpenHandCursor);
    scene_.widget()->setFocus();
  } else {
    scene_.widget()->unsetCursor();
  }
}

void ArrangeTool::setSelected(const std::optional<ArrangedItem>& selected) {
  selected_ = selected;
  if (!inHand_) showGizmo();
}

void ArrangeTool::setSnapping(bool snapping, const GizmoSteps& steps) {
  snapping_ = snapping;
  steps_ = steps;
}

bool ArrangeTool::eventFilter(QObject* watched, QEvent* event) {
  if (on_ && event->type() == QEvent::MouseMove && !holds()) {
    const auto& pointer = static_cast<const QMouseEvent&>(*event);
    hover(pointer.buttons() == Qt::NoButton ? pointer.localPos() : QPointF(-1.0, -1.0));
  }
  if (on_ && event->type() == QEvent::KeyPress && pressKey(static_cast<const QKeyEvent&>(*event))) return true;
  return DragTool::eventFilter(watched, event);
}

bool ArrangeTool::grip(const QPointF& position) {
  if (!on_ || !document_.scenario()) return false;
  if (!gripHandle(position) && !gripBody(position)) return false;
  scene_.widget()->setCursor(Qt::ClosedHandCursor);
  emit gripped(inHand_->item);
  return true;
}

bool ArrangeTool::gripHandle(const QPointF& position) {
  const auto handle = gizmo_->handleAt(position);
  if (!handle || !selected_) return false;
  const Pose before = *shownPose(selected_->item);
  inHand_ = InHand{selected_->item, before, before, GizmoDrag(*handle, gizmo_->gizmo(), rayThrough(scene_, position))};
  features_.begin(selected_->item);
  dragHandle(position, false);
  return true;
}

bool ArrangeTool::gripBody(const QPointF& position) {
  const LoadedScenario& scenario = *document_.scenario();
  const Ray ray = rayThrough(scene_, position);
  std::optional<ItemHit> hit;
  if (selected_) hit = itemAt(scenario, scene_.view(), ray, selected_->item);
  if (!hit) hit = itemAt(scenario, scene_.view(), ray);
  if (!hit) return false;
  const Pose before = *poseOf(scenario.scenario, hit->item);
  inHand_ = InHand{hit->item, before, before, PoseDrag(before, hit->p_W, scene_.view().camera().R_WV())};
  return true;
}

void ArrangeTool::moveTo(const QPointF& position) {
  if (auto* drag = std::get_if<PoseDrag>(&inHand_->drag)) {
    drag->moveTo(rayThrough(scene_, position));
    draw(drag->pose());
  } else {
    dragHandle(position, false);
  }
}

/// Turns a body while Ctrl is held. A handle snaps to steps under Ctrl only if all snapping is off.
void ArrangeTool::turn(const QPointF& position, const QPointF& by) {
  if (auto* drag = std::get_if<PoseDrag>(&inHand_->drag)) {
    drag->turn(by.x(), by.y());
    draw(drag->pose());
  } else {
    dragHandle(position, true);
  }
}

GizmoAmount ArrangeTool::snappedAmount(const GizmoDrag& drag, bool suspended) {
  const bool toSteps = suspended ? !snapping_ && !features_.isOn() : snapping_;
  const GizmoHandle& handle = drag.handle();
  FeatureSnap snap;
  if (!suspended && handle.kind != GizmoHandle::Kind::Ring && !drag.amount().shift.isZero(0.0)) {
    std::vector<Vector3> freedom;
    for (int axis = 0; axis < 3; ++axis) {
      if ((axis == handle.axis) == (handle.kind == GizmoHandle::Kind::Arrow))
        freedom.push_back(axisOf(drag.gizmo(), axis));
    }
    const Quaternion& R_WG = drag.gizmo().X_WG.orientation;
    const double pixel =
        scene_.view().camera().viewHeightAt(drag.gizmo().X_WG.position) / std::max(1, scene_.widget()->height());
    snap = features_.snap(R_WG * drag.amount().shift, freedom, kSnapPixels * pixel);
  }
  showSnap(snap);
  if (!snap.pairs.empty()) return {drag.gizmo().X_WG.orientation.conjugate() * snap.shift, 0.0};
  return toSteps ? glissade::snapped(drag.amount(), steps_) : drag.amount();
}

void ArrangeTool::showSnap(const FeatureSnap& snap) {
  scene_.view().setMeasure(features_.pictureOf(snap));
  emit snapped(features_.textOf(snap));
}

void ArrangeTool::dragHandle(const QPointF& position, bool suspended) {
  auto& drag = std::get<GizmoDrag>(inHand_->drag);
  drag.moveTo(rayThrough(scene_, position));
  const GizmoAmount amount = snappedAmount(drag, suspended);
  const Pose& from = drag.gizmo().X_WG;
  inHand_->now = motionOf(amount, drag.handle().axis, from) * inHand_->before;
  drawItemAt(inHand_->item, inHand_->now, *document_.scenario(), scene_.view());
  showGizmo(
      GizmoPicture::Held{drag.handle(), from, drag.grippedAt(), amount.angle, amountText(drag, amount), position});
  scene_.refresh();
}

QString ArrangeTool::amountText(const GizmoDrag& drag, const GizmoAmount& amount) const {
  const auto letter = [](int axis) { return QString(QLatin1Char("XYZ"[axis])); };
  const int axis = drag.handle().axis;
  if (drag.handle().kind == GizmoHandle::Kind::Ring) {
    const double degrees = amount.angle * 180.0 / std::numbers::pi;
    return QStringLiteral("∠%1 %2°").arg(letter(axis), withSign(degrees, QLocale().toString(degrees, 'f', 2)));
  }
  QStringList parts;
  for (int along = 0; along < 3; ++along) {
    if ((along == axis) != (drag.handle().kind == GizmoHandle::Kind::Arrow)) continue;
    parts << letter(along) + QLatin1Char(' ') + withSign(amount.shift[along], lengthText(amount.shift[along]));
  }
  return parts.join(QStringLiteral("   "));
}

void ArrangeTool::draw(const Pose& X_WB) {
  inHand_->now = X_WB;
  drawItemAt(inHand_->item, X_WB, *document_.scenario(), scene_.view());
  showGizmo();
  scene_.refresh();
}

void ArrangeTool::drop() {
  const InHand hand = *std::exchange(inHand_, std::nullopt);
  scene_.widget()->setCursor(Qt::OpenHandCursor);
  showSnap({});
  if (hand.now != hand.before) {
    put_ = Put{hand.item, hand.now};
    emit dropped(hand.item, hand.now);
  }
  showGizmo();
}

void ArrangeTool::restoreHeldItem() {
  if (!inHand_) return;
  draw(inHand_->before);
  inHand_.reset();
  showSnap({});
  scene_.view().restoreObstacles();
  if (on_) scene_.widget()->setCursor(Qt::OpenHandCursor);
  showGizmo();
}

bool ArrangeTool::pressKey(const QKeyEvent& event) {
  if (event.key() == Qt::Key_Escape) {
    if (holds()) {
      restoreHeldItem();
    } else {
      emit left();
    }
    return true;
  }
  if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) return false;
  for (const NudgeKey& entry : kNudgeKeys) {
    if (entry.key != event.key()) continue;
    if (!holds()) nudge(entry.viewAxis, entry.sign, event.modifiers().testFlag(Qt::ShiftModifier));
    return true;
  }
  return false;
}

/// Moves the item along the axis nearest to the direction of the key, or turns it about the axis across: the key to the
/// right turns about the upward axis, the upward key about the axis to the left.
void ArrangeTool::nudge(int viewAxis, double sign, bool turning) {
  const auto X_WG = gizmoPose();
  if (!X_WG) return;
  const NearestAxes nearest = nearestAxes(X_WG->orientation.conjugate() * scene_.view().camera().R_WV());
  if (turning && viewAxis < 2) {
    viewAxis = 1 - viewAxis;
    if (viewAxis == 0) sign = -sign;
  }
  const int axis = nearest.axis[static_cast<std::size_t>(viewAxis)];
  const double amount = sign * nearest.sign[static_cast<std::size_t>(viewAxis)];
  GizmoAmount step;
  if (turning) {
    step.angle = amount * steps_.angle;
  } else {
    step.shift[axis] = amount * steps_.distance;
  }
  put_ = Put{selected_->item, motionOf(step, axis, *X_WG) * *shownPose(selected_->item)};
  drawItemAt(put_->item, put_->X_WB, *document_.scenario(), scene_.view());
  showGizmo();
  scene_.refresh();
  emit nudged(selected_->item, Pose(put_->X_WB));
}

void ArrangeTool::hover(const QPointF& position) {
  if (!gizmo_->picture()) return;
  const auto handle = gizmo_->handleAt(position);
  if (handle == gizmo_->picture()->hovered) return;
  GizmoPicture picture = *gizmo_->picture();
  picture.hovered = handle;
  gizmo_->setPicture(picture);
  scene_.widget()->setCursor(handle ? Qt::PointingHandCursor : Qt::OpenHandCursor);
}

std::optional<Pose> ArrangeTool::shownPose(const AssemblyItem& item) const {
  if (inHand_ && inHand_->item == item) return inHand_->now;
  if (put_ && put_->item == item && document_.isArranging()) return put_->X_WB;
  return poseOf(document_.scenario()->scenario, item);
}

std::optional<Pose> ArrangeTool::gizmoPose() const {
  if (!on_ || !selected_ || !document_.scenario()) return std::nullopt;
  const auto X_WB = shownPose(selected_->item);
  if (!X_WB) return std::nullopt;
  Pose X_WG = *X_WB * selected_->X_BG;
  if (!selected_->ownAxes) X_WG.orientation = Quaternion::Identity();
  return X_WG;
}

void ArrangeTool::showGizmo(const std::optional<GizmoPicture::Held>& held) {
  auto X_WG = gizmoPose();
  if (!X_WG) {
    gizmo_->setPicture(std::nullopt);
    return;
  }
  // While a ring is turned, it keeps its axis.
  if (held) X_WG->orientation = held->from.orientation;
  gizmo_->setPicture(GizmoPicture{*X_WG, std::nullopt, held});
}

}  // namespace glissade
