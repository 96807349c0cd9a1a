#include "widgets/scene3d/section_overlay.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

#include "widgets/scene3d/axis_colours.h"
#include "widgets/scene3d/camera_controller.h"
#include "widgets/scene3d/handle_painter.h"

namespace glissade {
namespace {

constexpr double kSectionArrowPixels = 58.0;
/// Distance of the pointer below which it takes a handle.
constexpr double kHandleMargin = 10.0;
/// A section whose direction differs less from an axis has the axis' colour.
constexpr double kAlongAxis = 0.9999;
constexpr double kFaintOutline = 0.45;
constexpr double kMarkedFill = 0.12;
const QColor kFaceColour(0xb0, 0x5a, 0xa8);

QColor colourOf(const SectionPlane& section) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(section.direction[axis]) > kAlongAxis) return {kAxisColours[static_cast<std::size_t>(axis)]};
  }
  return kFaceColour;
}

double distanceToLine(const QPointF& p, const QLineF& line) {
  const QPointF along = line.p2() - line.p1();
  const double squared = QPointF::dotProduct(along, along);
  const double t = squared > 0.0 ? std::clamp(QPointF::dotProduct(p - line.p1(), along) / squared, 0.0, 1.0) : 0.0;
  const QPointF to = p - line.p1() - t * along;
  return std::hypot(to.x(), to.y());
}

}  // namespace

SectionOverlay::SectionOverlay(const SceneView& view, QWidget* scene) : SceneOverlay(view, scene) {
  setObjectName(QStringLiteral("sections-overlay"));
}

void SectionOverlay::setSections(const std::vector<SectionPlane>& sections, const Box3& box) {
  sections_ = sections;
  box_ = box;
  if (hovered_ && *hovered_ >= sections_.size()) hovered_.reset();
  if (held_ && held_->section >= sections_.size()) held_.reset();
  update();
}

void SectionOverlay::setHovered(const std::optional<std::size_t>& section) {
  hovered_ = section;
  update();
}

void SectionOverlay::setHeld(const std::optional<Held>& held) {
  held_ = held;
  update();
}

std::optional<QLineF> SectionOverlay::shaftOf(std::size_t section) const {
  if (!sections_[section].on || box_.isEmpty()) return std::nullopt;
  const SectionHandle handle = this->handle(section);
  const auto middle = onScreen(handle.middle);
  if (!middle) return std::nullopt;
  if (isKnob(handle, view().camera())) return QLineF(*middle, *middle);
  const auto tip = onScreen(tipOf(handle, view().camera(), kSectionArrowPixels / std::max(1, height())));
  return tip ? std::make_optional(QLineF(*middle, *tip)) : std::nullopt;
}

std::optional<std::size_t> SectionOverlay::sectionAt(const QPointF& position) const {
  std::optional<std::size_t> nearest;
  double least = kHandleMargin;
  for (std::size_t i = 0; i < sections_.size(); ++i) {
    const auto shaft = shaftOf(i);
    if (!shaft || distanceToLine(position, *shaft) >= least) continue;
    least = distanceToLine(position, *shaft);
    nearest = i;
  }
  return nearest;
}

std::optional<QPointF> SectionOverlay::pointOn(std::size_t section) const {
  const auto shaft = shaftOf(section);
  return shaft ? std::make_optional(shaft->pointAt(0.8)) : std::nullopt;
}

bool SectionOverlay::isMarked(std::size_t section) const {
  return held_ ? held_->section == section : hovered_ == section;
}

void SectionOverlay::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  for (std::size_t i = 0; i < sections_.size(); ++i) paintOutline(painter, i);
  for (std::size_t i = 0; i < sections_.size(); ++i) paintHandle(painter, i);
  if (held_) HandlePainter(painter, palette()).amount(held_->place, held_->pointer, size());
}

void SectionOverlay::paintOutline(QPainter& painter, std::size_t section) const {
  if (!sections_[section].on) return;
  QPolygonF outline;
  for (const Vector3& corner : outlineInBox(planeOf(sections_[section]), box_)) {
    const auto at = onScreen(corner);
    if (!at) return;
    outline << *at;
  }
  QColor colour = colourOf(sections_[section]);
  if (isMarked(section)) {
    QColor fill = colour;
    fill.setAlphaF(kMarkedFill);
    painter.setBrush(fill);
  } else {
    painter.setBrush(Qt::NoBrush);
    colour.setAlphaF(kFaintOutline);
  }
  painter.setPen(QPen(colour, isMarked(section) ? 2.0 : 1.2));
  painter.drawPolygon(outline);
}

void SectionOverlay::paintHandle(QPainter& painter, std::size_t section) const {
  const auto shaft = shaftOf(section);
  if (!shaft) return;
  const HandlePainter handles(painter, palette());
  const QColor colour = colourOf(sections_[section]);
  handles.arrow(shaft->p1(), shaft->p2(), colour, isMarked(section));
  handles.knob(shaft->p1(), colour, isMarked(section));
}

}  // namespace glissade
