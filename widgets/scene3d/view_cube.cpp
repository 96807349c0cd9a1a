#include "widgets/scene3d/view_cube.h"

#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "widgets/scene3d/camera_controller.h"

namespace glissade {
namespace {

constexpr int kCubeSize = 92;
constexpr int kCubeMargin = 8;
/// Half an edge of the cube in pixels.
constexpr double kHalfEdge = 26.0;
/// Share of a half edge from the middle of a face beyond which a point belongs to its edge or corner.
constexpr double kInnerShare = 0.58;
constexpr double kStep = std::numbers::pi / 4.0;

/// The name of the face on this side.
QString faceName(int axis, double side) {
  if (axis == 0) return side < 0.0 ? ViewCube::tr("Left") : ViewCube::tr("Right");
  if (axis == 1) return side < 0.0 ? ViewCube::tr("Front") : ViewCube::tr("Back");
  return side < 0.0 ? ViewCube::tr("Bottom") : ViewCube::tr("Top");
}

/// The axes of a face's text: to the right and upwards.
std::array<Vector3, 2> textAxes(int axis, double side) {
  if (axis == 0) return {Vector3(0.0, side, 0.0), Vector3::UnitZ()};
  if (axis == 1) return {Vector3(-side, 0.0, 0.0), Vector3::UnitZ()};
  return {Vector3::UnitX(), Vector3(0.0, side, 0.0)};
}

/// The third of the face in which a coordinate lies: -1, 0 or 1.
double thirdOf(double coordinate) {
  if (std::abs(coordinate) < kInnerShare) return 0.0;
  return coordinate < 0.0 ? -1.0 : 1.0;
}

/// The borders of a third.
std::array<double, 2> bordersOf(double third) {
  if (third < 0.0) return {-1.0, -kInnerShare};
  if (third > 0.0) return {kInnerShare, 1.0};
  return {-kInnerShare, kInnerShare};
}

}  // namespace

ViewCube::ViewCube(const SceneView& view, QWidget* scene) : QWidget(scene), view_(view) {
  setObjectName(QStringLiteral("view-cube"));
  setAccessibleName(tr("View cube"));
  setAccessibleDescription(tr("Arrow keys go round the scene, Home looks from a corner"));
  setToolTip(
      tr("Click a face, an edge or a corner to look from there. Arrow keys go round, Home looks from a corner."));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  resize(kCubeSize, kCubeSize);
  scene->installEventFilter(this);
  goToCorner(scene->size());
}

bool ViewCube::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) goToCorner(static_cast<QWidget*>(watched)->size());
  return QWidget::eventFilter(watched, event);
}

void ViewCube::goToCorner(const QSize& scene) { move(scene.width() - width() - kCubeMargin, kCubeMargin); }

QPointF ViewCube::pointOf(const Vector3& p) const {
  const Vector3 p_V = view_.camera().R_WV().conjugate() * p;
  return QPointF(width() / 2.0 + kHalfEdge * p_V.x(), height() / 2.0 - kHalfEdge * p_V.y());
}

std::optional<Vector3> ViewCube::directionAt(const QPointF& at) const {
  const Quaternion R_WV = view_.camera().R_WV();
  const Vector3 origin =
      R_WV * Vector3((at.x() - width() / 2.0) / kHalfEdge, (height() / 2.0 - at.y()) / kHalfEdge, 10.0);
  const Vector3 ray = R_WV * Vector3(0.0, 0.0, -1.0);
  double enter = -std::numeric_limits<double>::infinity();
  double leave = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    constexpr double kParallel = 1e-12;
    if (std::abs(ray[axis]) < kParallel) {
      if (std::abs(origin[axis]) > 1.0) return std::nullopt;
      continue;
    }
    const double one = (-1.0 - origin[axis]) / ray[axis];
    const double other = (1.0 - origin[axis]) / ray[axis];
    enter = std::max(enter, std::min(one, other));
    leave = std::min(leave, std::max(one, other));
  }
  if (enter > leave) return std::nullopt;
  const Vector3 p = origin + enter * ray;
  return Vector3(thirdOf(p.x()), thirdOf(p.y()), thirdOf(p.z()));
}

void ViewCube::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Vector3 toEye = view_.camera().R_WV() * Vector3::UnitZ();
  for (int axis = 0; axis < 3; ++axis) {
    if (toEye[axis] != 0.0) paintFace(painter, axis, toEye[axis] > 0.0 ? 1.0 : -1.0);
  }
  if (!hasFocus()) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(palette().color(QPalette::Highlight), 1.5));
  painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 6, 6);
}

void ViewCube::paintFace(QPainter& painter, int axis, double side) const {
  const auto [right, up] = textAxes(axis, side);
  const Vector3 centre = side * Vector3(Vector3::Unit(axis));
  const auto quad = [&, r = right, u = up](double x0, double x1, double y0, double y1) {
    return QPolygonF({pointOf(centre + x0 * r + y0 * u), pointOf(centre + x1 * r + y0 * u),
                      pointOf(centre + x1 * r + y1 * u), pointOf(centre + x0 * r + y1 * u)});
  };
  QColor ground = palette().color(QPalette::Base);
  ground.setAlphaF(0.88);
  painter.setPen(QPen(palette().color(QPalette::PlaceholderText), 1.0));
  painter.setBrush(ground);
  painter.drawPolygon(quad(-1.0, 1.0, -1.0, 1.0));
  if (hovered_ && (*hovered_)[axis] == side) {
    const auto x = bordersOf(hovered_->dot(right));
    const auto y = bordersOf(hovered_->dot(up));
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Highlight));
    painter.drawPolygon(quad(x[0], x[1], y[0], y[1]));
  }
  const QPointF across = pointOf(centre + right) - pointOf(centre);
  const QPointF along = pointOf(centre) - pointOf(centre + up);
  QFont small = font();
  small.setPixelSize(12);
  const QString name = faceName(axis, side);
  const QFontMetricsF metrics(small);
  const double fits = std::min(1.0, 1.7 * kHalfEdge / metrics.horizontalAdvance(name));
  painter.save();
  const QPointF middle = pointOf(centre);
  painter.setTransform(QTransform(across.x() / kHalfEdge, across.y() / kHalfEdge, along.x() / kHalfEdge,
                                  along.y() / kHalfEdge, middle.x(), middle.y()),
                       true);
  painter.scale(fits, fits);
  QPainterPath text;
  text.addText(-metrics.horizontalAdvance(name) / 2.0, metrics.ascent() / 2.0 - 1.0, small, name);
  const bool marked = hovered_ && *hovered_ == centre;
  painter.fillPath(text, palette().color(marked ? QPalette::HighlightedText : QPalette::Text));
  painter.restore();
}

void ViewCube::mousePressEvent(QMouseEvent* event) {
  const auto direction = directionAt(event->localPos());
  if (direction && event->button() == Qt::LeftButton) emit lookFrom(*direction);
}

void ViewCube::mouseMoveEvent(QMouseEvent* event) {
  hovered_ = directionAt(event->localPos());
  update();
}

void ViewCube::leaveEvent(QEvent* /*event*/) {
  hovered_.reset();
  update();
}

void ViewCube::focusInEvent(QFocusEvent* /*event*/) { update(); }
void ViewCube::focusOutEvent(QFocusEvent* /*event*/) { update(); }

void ViewCube::turnBy(double yaw, double pitch) {
  const Vector3 toEye = view_.camera().R_WV() * Vector3::UnitZ();
  const double azimuth = std::atan2(toEye.y(), toEye.x()) + yaw;
  const double limit = std::numbers::pi / 2.0;
  const double elevation = std::clamp(std::asin(std::clamp(toEye.z(), -1.0, 1.0)) + pitch, -limit, limit);
  emit lookFrom(
      Vector3(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)));
}

void ViewCube::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Left: turnBy(-kStep, 0.0); break;
    case Qt::Key_Right: turnBy(kStep, 0.0); break;
    case Qt::Key_Up: turnBy(0.0, kStep); break;
    case Qt::Key_Down: turnBy(0.0, -kStep); break;
    case Qt::Key_Home: emit lookFrom(Vector3(-1.0, -1.2, 0.9)); break;
    default: QWidget::keyPressEvent(event);
  }
}

}  // namespace glissade
