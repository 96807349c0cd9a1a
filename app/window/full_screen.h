#pragma once

#include <QMainWindow>
#include <QPointer>

#include "widgets/commands/action_catalogue.h"

namespace glissade {

/// Shows the scene alone on a whole screen: the window without its menus, bars and panels. Commands keep their keys.
class FullScreen final : public QObject {
  Q_OBJECT

 public:
  FullScreen(QMainWindow& window, const ActionCatalogue& actions);

  /// On the display of this name, or on that of the window where there is none.
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
