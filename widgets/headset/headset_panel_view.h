#pragma once

#include <QEvent>
#include <QObject>
#include <QPointer>
#include <QWidget>

#include <functional>

#include "widgets/openxr/headset_tools.h"

namespace glissade {

/// Shows a widget in the scene of a headset instead of on a screen; a hand that points at it acts as the mouse. The
/// widget is painted again when it has changed.
class HeadsetPanelView final : public QObject {
  Q_OBJECT

 public:
  /// The page must outlive this object.
  HeadsetPanelView(QWidget& page, HeadsetToolsPtr tools);
  ~HeadsetPanelView() override;

  /// The number of times that the page was painted.
  int paintings() const { return paintings_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void paint();
  void follow();
  void point(const PointerMailbox::Moment& moment);
  void enter(QWidget* target);
  void sendMouse(QEvent::Type type, const QPointF& at);

  QWidget& page_;
  HeadsetToolsPtr tools_;
  std::function<void()> paintSoon_;
  QPointer<QWidget> under_;  ///< the widget that the hand points at
  bool pressed_ = false;
  QPointF at_;  ///< position on the page, in pixels
  int paintings_ = 0;
};

}  // namespace glissade
