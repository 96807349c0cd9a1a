#pragma once

#include <QFrame>
#include <QLabel>
#include <QToolButton>

namespace glissade {

/// The bubble of the tour in a corner of the scene: which step it is, what to do and why.
class TourPanel final : public QFrame {
  Q_OBJECT

 public:
  explicit TourPanel(QWidget* scene);

  /// `number` from 1.
  void showStep(int number, int count, const QString& title, const QString& text);
  /// The step is done: only the next one is left to do.
  void setDone(bool done);

 signals:
  void back();
  void next();
  void doIt();
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

/// A frame around what the tour is about. It lets the mouse through.
class TourFrame final : public QWidget {
  Q_OBJECT

 public:
  explicit TourFrame(QWidget* window);

  /// A part of the window, in its coordinates; empty: nothing is marked.
  void mark(const QRect& part);

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace glissade
