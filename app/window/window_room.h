#pragma once

#include <QObject>
#include <QSize>

class QMainWindow;

namespace glissade {

class PanelDocks;

/// Keeps the window in the room that its screen has: its panels are arranged for it, and where the window grows beyond
/// it, because a panel that is shown first needs much room until its texts are wrapped, the window goes back. A size
/// that a person has given the window stays.
class WindowRoom final : public QObject {
 public:
  WindowRoom(QMainWindow& window, PanelDocks& docks);

  /// The window is at most so large; empty: it may have any size.
  void fit(const QSize& room);
  /// Of the last fit(); empty: there was none.
  const QSize& room() const { return room_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QMainWindow& window_;
  PanelDocks& docks_;
  QSize room_;
};

}  // namespace glissade
