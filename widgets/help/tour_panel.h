#pragma once

#include <QFrame>
#include <QLabel>
#include <QToolButton>

namespace glissade {

/// The panel of the tour in a corner of the scene: the number of the step, the action and its reason.
class TourPanel final : public QFrame {
  Q_OBJECT

 public:
  explicit TourPanel(QWidget* scene);

  /// Shows a step; `number` counts from 1.
  void showStep(int number, int count, const QString& title, const QString& text);
  /// Marks the step as done, so that only the button for the next step remains.
  void setDone(bool done);

 signals:
  void back();
  void next();
  void stepRequested();
  void end();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QToolButton* addButton(const QString& text, void (TourPanel::*clicked)());
  void place();

  QLabel* where_;
  QLabel* title_;
  QLabel* text_;
  QToolButton* doIt_;
  QToolButton* back_;
  QToolButton* next_;
  QToolButton* end_;
};

/// A frame around the target of a step. It lets mouse events through.
class TourFrame final : public QWidget {
  Q_OBJECT

 public:
  explicit TourFrame(QWidget* window);

  /// Marks a part of the window, in the window's coordinates; an empty one removes the mark.
  void mark(const QRect& part);

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace glissade
