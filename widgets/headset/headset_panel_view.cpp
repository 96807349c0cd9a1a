#include "widgets/headset/headset_panel_view.h"

#include <QCoreApplication>
#include <QImage>
#include <QMouseEvent>
#include <QPainter>

#include "widgets/controls/queued_once.h"
#include "widgets/headset/text_picture.h"

namespace glissade {
HeadsetPanelView::HeadsetPanelView(QWidget& page, HeadsetToolsPtr tools)
    : page_(page), tools_(std::move(tools)), paintSoon_(queuedOnce(this, [this] { paint(); })) {
  page_.setAttribute(Qt::WA_DontShowOnScreen);
  page_.setAttribute(Qt::WA_QuitOnClose, false);  // the page does not keep the program alive
  page_.installEventFilter(this);
  page_.show();
  tools_->pointer.setListener(queuedOnce(this, [this] { follow(); }));
  paintSoon_();
}

HeadsetPanelView::~HeadsetPanelView() {
  tools_->pointer.setListener({});
  tools_->panel.set(nullptr);
}

/// Paints after each change: a changed widget asks its window for an update.
bool HeadsetPanelView::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::UpdateRequest || event->type() == QEvent::LayoutRequest) paintSoon_();
  return QObject::eventFilter(watched, event);
}

void HeadsetPanelView::paint() {
  QImage image(page_.size(), QImage::Format_RGBA8888_Premultiplied);
  image.fill(page_.palette().color(QPalette::Window));
  page_.render(&image);
  ++paintings_;
  tools_->panel.set(flatPicture(image));
}

void HeadsetPanelView::follow() {
  for (const PointerMailbox::Moment& moment : tools_->pointer.take()) point(moment);
}

/// Sends the hand's motion and presses as mouse events. A pressed widget receives them until the release.
void HeadsetPanelView::point(const PointerMailbox::Moment& moment) {
  const bool presses = moment && moment->pressed;
  if (moment) at_ = QPointF(moment->at.x() * page_.width(), moment->at.y() * page_.height());
  if (!pressed_) enter(moment ? page_.childAt(at_.toPoint()) : nullptr);
  if (under_ && moment && presses == pressed_) sendMouse(QEvent::MouseMove, at_);
  if (presses == pressed_) return;
  pressed_ = presses;
  if (under_) sendMouse(presses ? QEvent::MouseButtonPress : QEvent::MouseButtonRelease, at_);
}

void HeadsetPanelView::enter(QWidget* target) {
  if (target == under_) return;
  const auto tell = [this](QEvent::Type type) {
    if (!under_) return;
    under_->setAttribute(Qt::WA_UnderMouse, type == QEvent::Enter);
    QEvent event(type);
    QCoreApplication::sendEvent(under_, &event);
  };
  tell(QEvent::Leave);
  under_ = target;
  tell(QEvent::Enter);
}

void HeadsetPanelView::sendMouse(QEvent::Type type, const QPointF& at) {
  const Qt::MouseButton changed = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
  const Qt::MouseButtons held = pressed_ ? Qt::LeftButton : Qt::NoButton;
  const QPointF local = at - QPointF(under_->mapTo(&page_, QPoint()));
  QMouseEvent event(type, local, at, at, changed, held, Qt::NoModifier);
  QCoreApplication::sendEvent(under_, &event);
}

}  // namespace glissade
