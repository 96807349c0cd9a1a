#include "widgets/scene3d/gizmo_overlay.h"

#include <QFontMetrics>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/scene3d/axis_colours.h"
#include "widgets/scene3d/handle_painter.h"

namespace glissade {
namespace {

using Kind = GizmoHandle::Kind;

constexpr double kArmPixels = 92.0;
/// Distance of the pointer below which it takes a handle.
constexpr double kMarginPixels = 9.0;
constexpr double kLineWidth = 2.5;
constexpr double kMarkedWidth = 5.0;
constexpr double kFaint = 0.22;
constexpr int kTurnSteps = 48;

QColor colourOf(int axis, double alpha = 1.0) {
  QColor colour(kAxisColours[static_cast<std::size_t>(axis)]);
  colour.setAlphaF(alpha);
  return colour;
}

}  // namespace

GizmoOverlay::GizmoOverlay(const SceneView& view, QWidget* scene) : SceneOverlay(view, scene) {
  setObjectName(QStringLiteral("gizmo"));
}

void GizmoOverlay::setPicture(const std::optional<GizmoPicture>& picture) {
  picture_ = picture;
  update();
}

Gizmo GizmoOverlay::gizmoOf(const Pose& X_WG) const {
  return gizmoAt(X_WG, view().camera(), kArmPixels / std::max(1, height()));
}

Gizmo GizmoOverlay::gizmo() const { return gizmoOf(picture_->X_WG); }

std::optional<GizmoHandle> GizmoOverlay::handleAt(const QPointF& position) const {
  if (!picture_) return std::nullopt;
  const double pixels = std::max(1, height());
  const Eigen::Vector2d pointer((position.x() - width() / 2.0) / pixels, (position.y() - height() / 2.0) / pixels);
  return glissade::handleAt(gizmo(), view().camera(), pointer, kMarginPixels / pixels);
}

std::optional<QPointF> GizmoOverlay::pointOn(const GizmoHandle& handle) const {
  if (!picture_ || !isUsable(handle, gizmo(), view().camera())) return std::nullopt;
  const std::vector<Vector3> outline = outlineOf(handle, gizmo());
  for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
    const auto at = onScreen(handle.kind == Kind::Ring ? outline[i] : 0.5 * (outline[i] + outline[i + 1]));
    if (at && handleAt(*at) == handle) return at;
  }
  return std::nullopt;
}

bool GizmoOverlay::isMarked(const GizmoHandle& handle) const {
  return picture_->held ? picture_->held->handle == handle : picture_->hovered == handle;
}

void GizmoOverlay::paintEvent(QPaintEvent* /*event*/) {
  if (!picture_ || !onScreen(picture_->X_WG.position)) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (picture_->held && picture_->held->handle.kind == Kind::Ring) paintTurn(painter, *picture_->held);
  for (auto handle = kGizmoHandles.rbegin(); handle != kGizmoHandles.rend(); ++handle) {
    if (!isUsable(*handle, gizmo(), view().camera())) continue;
    const bool others = picture_->held && !isMarked(*handle);
    painter.setOpacity(others ? kFaint : 1.0);
    switch (handle->kind) {
      case Kind::Ring: paintRing(painter, *handle); break;
      case Kind::Square: paintSquare(painter, *handle); break;
      case Kind::Arrow: paintArrow(painter, *handle); break;
    }
  }
  painter.setOpacity(1.0);
  if (picture_->held) HandlePainter(painter, palette()).amount(picture_->held->amount, picture_->held->pointer, size());
}

/// Paints a ring. The half behind its centre is faint, because it cannot be taken.
void GizmoOverlay::paintRing(QPainter& painter, const GizmoHandle& handle) const {
  const Gizmo gizmo = this->gizmo();
  QPolygonF back;
  std::vector<QPolygonF> front(1);
  for (const Vector3& p_W : outlineOf(handle, gizmo)) {
    const auto at = onScreen(p_W);
    if (!at) return;
    back << *at;
    if (isBeforeCentre(p_W, gizmo, view().camera())) {
      front.back() << *at;
    } else if (!front.back().isEmpty()) {
      front.emplace_back();
    }
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colourOf(handle.axis, kFaint), 1.5));
  painter.drawPolyline(back);
  for (const QPolygonF& part : front) {
    if (part.size() > 1)
      HandlePainter(painter, palette()).line(part, colourOf(handle.axis), isMarked(handle) ? kMarkedWidth : kLineWidth);
  }
}

/// Paints a square in the colour of the axis that it does not move along.
void GizmoOverlay::paintSquare(QPainter& painter, const GizmoHandle& handle) const {
  QPolygonF corners;
  for (const Vector3& p_W : outlineOf(handle, gizmo())) {
    const auto at = onScreen(p_W);
    if (!at) return;
    corners << *at;
  }
  painter.setPen(Qt::NoPen);
  painter.setBrush(colourOf(handle.axis, isMarked(handle) ? 0.85 : 0.4));
  painter.drawPolygon(corners);
  HandlePainter(painter, palette()).line(corners, colourOf(handle.axis), isMarked(handle) ? kLineWidth : 1.5);
}

void GizmoOverlay::paintArrow(QPainter& painter, const GizmoHandle& handle) const {
  const std::vector<Vector3> ends = outlineOf(handle, gizmo());
  const auto from = onScreen(ends.front());
  const auto tip = onScreen(ends.back());
  if (!from || !tip) return;
  HandlePainter(painter, palette()).arrow(*from, *tip, colourOf(handle.axis), isMarked(handle));
  paintLetter(painter, handle.axis, isMarked(handle));
}

void GizmoOverlay::paintLetter(QPainter& painter, int axis, bool marked) const {
  const auto at = onScreen(letterOf(gizmo(), axis));
  if (!at) return;
  QFont bold = font();
  bold.setBold(true);
  painter.setFont(bold);
  const QString letter(QLatin1Char("XYZ"[axis]));
  const double size = 1.5 * QFontMetricsF(bold).height() / 2.0;
  QColor ground = marked ? colourOf(axis) : palette().color(QPalette::Base);
  if (!marked) ground.setAlphaF(0.8);
  painter.setPen(Qt::NoPen);
  painter.setBrush(ground);
  painter.drawEllipse(*at, size, size);
  painter.setPen(marked ? QColor(Qt::white) : palette().color(QPalette::Text));
  painter.drawText(QRectF(at->x() - size, at->y() - size, 2.0 * size, 2.0 * size), Qt::AlignCenter, letter);
}

/// Paints the sector by which the ring has turned.
void GizmoOverlay::paintTurn(QPainter& painter, const GizmoPicture::Held& held) const {
  const Gizmo from = gizmoOf(held.from);
  const Vector3 aside = axisOf(from, held.handle.axis).cross(held.grippedAt);
  const auto centre = onScreen(from.X_WG.position);
  if (!centre) return;
  QPolygonF sector(QVector<QPointF>{*centre});
  for (int i = 0; i <= kTurnSteps; ++i) {
    const double angle = held.angle * i / kTurnSteps;
    const Vector3 out = std::cos(angle) * held.grippedAt + std::sin(angle) * aside;
    const auto at = onScreen(from.X_WG.position + ringRadius(from) * out);
    if (at) sector << *at;
  }
  painter.setPen(QPen(colourOf(held.handle.axis), 1.5));
  painter.setBrush(colourOf(held.handle.axis, 0.3));
  painter.drawPolygon(sector);
}

}  // namespace glissade
