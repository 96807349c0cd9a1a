#pragma once

#include <QObject>
#include <QSize>

class QMainWindow;

namespace glissade {

class PanelDocks;

/// Keeps the window within the room of its screen. The panels are arranged for that room. A panel that is shown first
/// needs much room until its texts are wrapped; if the window grows beyond the room then, it shrinks again. A size that
/// a person gives the window stays.
class WindowRoom final : public QObject {
 public:
  WindowRoom(QMainWindow& window, PanelDocks& docks);

  /// Limits the size of the window; empty: any size.
  void fit(const QSize& room);
  /// The room of the last fit(); empty if there was none.
  const QSize& room() const { return room_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QMainWindow& window_;
  PanelDocks& docks_;
  QSize room_;
};

}  // namespace glissade
