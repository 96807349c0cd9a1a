#include "widgets/section/section_tool.h"

#include <QKeyEvent>
#include <QMouseEvent>

#include <utility>

#include "widgets/controls/length_text.h"
#include "widgets/workbench/scene_ray.h"

namespace glissade {

SectionTool::SectionTool(SceneWidget& scene, QObject* parent)
    : DragTool(scene, parent), overlay_(new SectionOverlay(scene.view(), scene.widget())) {
  overlay_->hide();
}

void SectionTool::setSections(const std::vector<SectionPlane>& sections, const Box3& box) {
  sections_ = sections;
  box_ = box;
  if (inHand_ && inHand_->section >= sections.size()) inHand_.reset();
  if (sections.empty()) hover({-1.0, -1.0});
  overlay_->setSections(sections, box);
  overlay_->setVisible(!sections.empty());
}

bool SectionTool::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::MouseMove && !holds()) {
    const auto& pointer = static_cast<const QMouseEvent&>(*event);
    if (pointer.buttons() == Qt::NoButton) hover(pointer.localPos());
  }
  const bool escape = event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape;
  if (escape && holds()) {
    const InHand hand = *std::exchange(inHand_, std::nullopt);
    overlay_->setHeld(std::nullopt);
    emit dragged(hand.section, hand.before);
    return true;
  }
  return DragTool::eventFilter(watched, event);
}

void SectionTool::hover(const QPointF& position) {
  const auto section = sections_.empty() ? std::nullopt : overlay_->sectionAt(position);
  if (section == overlay_->hovered()) return;
  if (section && !overlay_->hovered()) {
    cursorBefore_ = scene_.widget()->cursor();
    scene_.widget()->setCursor(Qt::PointingHandCursor);
  } else if (!section) {
    scene_.widget()->setCursor(cursorBefore_);
  }
  overlay_->setHovered(section);
}

bool SectionTool::grip(const QPointF& position) {
  const auto section = sections_.empty() ? std::nullopt : overlay_->sectionAt(position);
  if (!section) return false;
  const SectionPlane& gripped = sections_[*section];
  inHand_ = InHand{*section, gripped.place,
                   SectionDrag(gripped, handleOf(gripped, box_), scene_.view().camera(), rayThrough(scene_, position))};
  showPlace(position);
  return true;
}

void SectionTool::moveTo(const QPointF& position) {
  inHand_->drag.moveTo(rayThrough(scene_, position));
  emit dragged(inHand_->section, inHand_->drag.place());
  if (inHand_) showPlace(position);
}

void SectionTool::turn(const QPointF& position, const QPointF& /*by*/) { moveTo(position); }

void SectionTool::drop() {
  inHand_.reset();
  overlay_->setHeld(std::nullopt);
}

void SectionTool::showPlace(const QPointF& pointer) {
  overlay_->setHeld(SectionOverlay::Held{inHand_->section, lengthText(inHand_->drag.place()), pointer});
}

}  // namespace glissade
