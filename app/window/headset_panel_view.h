#pragma once

#include <QEvent>
#include <QObject>
#include <QPointer>
#include <QWidget>

#include <functional>

#include "widgets/headset/headset_tools.h"

namespace glissade {

/// A widget that no screen shows: its picture stands in the scene of a headset, and a hand that points there is its
/// mouse. It is painted again when something of it has changed.
class HeadsetPanelView final : public QObject {
  Q_OBJECT

 public:
  /// The widget outlives this.
  HeadsetPanelView(QWidget& page, HeadsetToolsPtr tools);
  ~HeadsetPanelView() override;

  /// So often it was painted.
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
  QPointer<QWidget> under_;  ///< what the hand points at
  bool pressed_ = false;
  QPointF at_;  ///< of the page, in pixels
  int paintings_ = 0;
};

}  // namespace glissade
