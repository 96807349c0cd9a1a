#pragma once

#include <QObject>
#include <QPoint>
#include <QPointer>
#include <QWidget>

namespace glissade {

/// Hides a tool tip as soon as the thing below it has another one: Qt leaves it until the pointer moves. One object
/// serves all widgets of the program.
class FreshTips final : public QObject {
 public:
  explicit FreshTips(QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// Watches the widget if the shown tip is its own.
  void watch(QWidget* widget, const QPoint& at);
  void hideIfStale();
  QString tipNow() const;

  QPointer<QWidget> widget_;  ///< the one whose tip is shown; null: none
  QPoint at_;                 ///< the pointer when the tip was shown, in the frame of the widget
};

}  // namespace glissade
