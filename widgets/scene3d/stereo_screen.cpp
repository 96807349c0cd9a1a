#include "widgets/scene3d/stereo_screen.h"

#include <QChildEvent>
#include <QCoreApplication>
#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>

#include "widgets/scene3d/camera_controller.h"

namespace glissade {
namespace {

/// An arrow whose tip is the pointer, in pixels.
const QPolygonF kArrow(QVector<QPointF>{{0, 0}, {0, 17}, {4, 13}, {7, 19}, {9.5, 18}, {6.8, 12}, {12, 12}});

void paintPointer(QPainter& painter, const QPointF& at) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(Qt::white, 1.0));
  painter.setBrush(Qt::black);
  painter.drawPolygon(kArrow.translated(at));
}

/// Puts the camera of a view at the place of an eye during its lifetime.
class AtEyePlace {
 public:
  AtEyePlace(SceneView& view, const EyePlace& eyePlace) : view_(view), before_(view.camera().eyePlace()) {
    view_.camera().setEyePlace(eyePlace);
  }
  ~AtEyePlace() { view_.camera().setEyePlace(before_); }
  AtEyePlace(const AtEyePlace&) = delete;
  AtEyePlace& operator=(const AtEyePlace&) = delete;

 private:
  SceneView& view_;
  EyePlace before_;
};

}  // namespace

StereoScreen::StereoScreen(SceneWidget& scene, Eyes eyes)
    : QWidget(scene.widget()), scene_(scene), eyes_(std::move(eyes)) {
  setObjectName(QStringLiteral("stereo-screen"));
  setFocusPolicy(Qt::NoFocus);
  setMouseTracking(true);
  setCursor(Qt::BlankCursor);
  hide();
  resize(scene.widget()->size());
  scene.widget()->installEventFilter(this);
  for (QObject* child : scene.widget()->children()) watch(child);
}

void StereoScreen::watch(QObject* child) {
  if (child != this && child->isWidgetType()) child->installEventFilter(this);
}

void StereoScreen::setMode(StereoMode mode, bool swapped) {
  mode_ = mode;
  swapped_ = swapped;
  pressedIn_.reset();
  pointerEye_ = eyePointAt(mode, QPointF(), size()).eye;
  if (swapped) pointerEye_ = otherEye(pointerEye_);
  setAttribute(Qt::WA_TransparentForMouseEvents, !hasParts(mode));
  if (mode == StereoMode::QuadBuffer && !quadBuffer_) quadBuffer_ = scene_.makeQuadBuffer(this);
  if (mode != StereoMode::QuadBuffer) quadBuffer_.reset();
  if (quadBuffer_) {
    quadBuffer_->widget()->resize(size());
    quadBuffer_->widget()->show();
  }
  scene_.setCovered(mode != StereoMode::Off);
  setVisible(mode != StereoMode::Off);
  raise();
  scene_.refresh();
}

/// Keeps this widget on top of the widgets over the scene.
bool StereoScreen::eventFilter(QObject* watched, QEvent* event) {
  if (watched == scene_.widget()) {
    if (event->type() == QEvent::Resize) {
      resize(scene_.widget()->size());
      if (quadBuffer_) quadBuffer_->widget()->resize(size());
    }
    if (event->type() == QEvent::ChildAdded) {
      watch(static_cast<QChildEvent*>(event)->child());
      raise();
    }
  } else if (event->type() == QEvent::ZOrderChange) {
    raise();
  }
  return QWidget::eventFilter(watched, event);
}

QPoint StereoScreen::cornerOnScreen() const { return (QPointF(mapToGlobal(QPoint())) * devicePixelRatioF()).toPoint(); }

std::array<QImage, 2> StereoScreen::picturesOfEyes() {
  const std::array<EyePlace, 2> eyes = eyes_();
  scene_.view().camera().setEyePlace(eyes[static_cast<std::size_t>(pointerEye_)]);
  const std::vector<QImage> seen = scene_.picturesFrom({eyes[0], eyes[1]});
  std::array<QImage, 2> pictures{seen[0], seen[1]};
  for (std::size_t i = 0; i < eyes.size(); ++i) paintOver(pictures[i], eyes[i]);
  return pictures;
}

/// Paints all widgets over the scene, as this eye sees them.
void StereoScreen::paintOver(QImage& picture, const EyePlace& eyePlace) {
  const AtEyePlace at(scene_.view(), eyePlace);
  QPainter painter(&picture);
  for (QObject* child : scene_.widget()->children()) {
    auto* over = qobject_cast<QWidget*>(child);
    if (over == nullptr || over == this || over->isWindow() || !over->isVisible()) continue;
    over->render(&painter, over->pos(), QRegion(), QWidget::DrawChildren);
  }
  if (hasParts(mode_) && (underMouse() || pressedIn_)) paintPointer(painter, pointer_);
}

/// The widgets under this one are painted before it. If only a part of it is painted, the whole is painted next.
void StereoScreen::paintEvent(QPaintEvent* event) {
  if (event->rect().contains(rect()) || composed_.isNull()) {
    std::array<QImage, 2> pictures = picturesOfEyes();
    if (swapped_) std::swap(pictures[0], pictures[1]);
    if (quadBuffer_) quadBuffer_->show(pictures[0], pictures[1]);
    composed_ = composeStereo(mode_, pictures[0], pictures[1], cornerOnScreen());
    composed_.setDevicePixelRatio(pictures[0].devicePixelRatio());
  } else {
    update();
  }
  QPainter(this).drawImage(0, 0, composed_);
}

/// Moves the pointer, and puts the camera at the eye that sees it, so that the scene is picked from this eye.
EyePoint StereoScreen::point(const QPointF& at) {
  EyePoint seen = eyePointAt(mode_, at, size());
  if (pressedIn_) seen = {*pressedIn_, pointOfEye(mode_, *pressedIn_, at, size())};
  pointer_ = seen.at;
  pointerEye_ = swapped_ ? otherEye(seen.eye) : seen.eye;
  scene_.view().camera().setEyePlace(eyes_()[static_cast<std::size_t>(pointerEye_)]);
  return seen;
}

/// The widget that would get the mouse there without this one.
QWidget* StereoScreen::widgetAt(const QPointF& at) const {
  const QObjectList& children = scene_.widget()->children();
  for (auto child = children.rbegin(); child != children.rend(); ++child) {
    auto* over = qobject_cast<QWidget*>(*child);
    if (over == nullptr || over == this || over->isWindow() || !over->isVisible()) continue;
    if (over->testAttribute(Qt::WA_TransparentForMouseEvents) || !over->geometry().contains(at.toPoint())) continue;
    QWidget* deeper = over->childAt(over->mapFromParent(at.toPoint()));
    return deeper != nullptr ? deeper : over;
  }
  return scene_.widget();
}

void StereoScreen::enter(QWidget* target) {
  if (target == under_) return;
  if (under_) {
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(under_, &leave);
  }
  under_ = target;
}

void StereoScreen::forwardMouse(const QMouseEvent& event) {
  const EyePoint seen = point(event.localPos());
  if (!pressedIn_) enter(widgetAt(seen.at));
  if (!under_) return;
  const bool pressed = event.type() == QEvent::MouseButtonPress || event.type() == QEvent::MouseButtonDblClick;
  if (pressed) {
    pressedIn_ = seen.eye;
    if (under_->focusPolicy() & Qt::ClickFocus) under_->setFocus(Qt::MouseFocusReason);
  }
  const QPointF local = QPointF(under_->mapFrom(scene_.widget(), QPoint())) + seen.at;
  QMouseEvent forwarded(event.type(), local, event.windowPos(), event.screenPos(), event.button(), event.buttons(),
                        event.modifiers());
  QCoreApplication::sendEvent(under_, &forwarded);
  if (event.buttons() == Qt::NoButton) pressedIn_.reset();
  update();
}

void StereoScreen::forwardWheel(const QWheelEvent& event) {
  const EyePoint seen = point(event.position());
  QWidget* target = widgetAt(seen.at);
  QWheelEvent forwarded(QPointF(target->mapFrom(scene_.widget(), QPoint())) + seen.at, event.globalPosition(),
                        event.pixelDelta(), event.angleDelta(), event.buttons(), event.modifiers(), event.phase(),
                        event.inverted());
  QCoreApplication::sendEvent(target, &forwarded);
}

void StereoScreen::forwardHelp(const QHelpEvent& event) {
  const EyePoint seen = point(event.pos());
  QWidget* target = widgetAt(seen.at);
  QHelpEvent forwarded(event.type(), target->mapFrom(scene_.widget(), seen.at.toPoint()), event.globalPos());
  QCoreApplication::sendEvent(target, &forwarded);
}

bool StereoScreen::event(QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove: forwardMouse(static_cast<QMouseEvent&>(*event)); return true;
    case QEvent::Wheel: forwardWheel(static_cast<QWheelEvent&>(*event)); return true;
    case QEvent::ToolTip:
    case QEvent::WhatsThis:
    case QEvent::QueryWhatsThis: forwardHelp(static_cast<QHelpEvent&>(*event)); return true;
    case QEvent::Leave:
      enter(nullptr);
      update();
      break;
    default: break;
  }
  return QWidget::event(event);
}

}  // namespace glissade
