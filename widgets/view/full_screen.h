#pragma once

#include <QMainWindow>
#include <QPointer>

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// Shows only the scene on a whole screen: the window without menus, bars and panels. Shortcuts keep working.
class FullScreen final : public QObject {
  Q_OBJECT

 public:
  FullScreen(QMainWindow& window, const ActionCatalogue& actions);

  /// Enters full screen on the display of this name, or on the window's display if there is none.
  void enter(const QString& display);
  void leave();
  bool isOn() const { return on_; }

 signals:
  void left();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QList<QWidget*> around() const;

  QMainWindow& window_;
  const ActionCatalogue& actions_;
  bool on_ = false;
  QByteArray panels_;
  QRect geometry_;
  bool maximized_ = false;
  QList<QPointer<QWidget>> hidden_;
};

}  // namespace glissade
