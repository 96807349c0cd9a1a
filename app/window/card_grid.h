#pragma once

#include <QAbstractButton>
#include <QImage>
#include <QWidget>

#include <vector>

namespace glissade {

/// What a card of the welcome page shows.
struct WelcomeEntry {
  QString file;  ///< what a click opens
  QString name;
  QString text;            ///< one line or two
  QImage light;            ///< on a light ground; null: there is none
  QImage dark;             ///< on a dark ground
  bool isThere = true;     ///< false: greyed, and nothing can be opened
  QString whole = {};      ///< tool tip; empty: `text`
  bool isOneLine = false;  ///< `text` is elided in its middle, as paths are
};

/// A picture with a name and a text, which is clicked, or chosen with Enter or the space bar.
class WelcomeCard final : public QAbstractButton {
  Q_OBJECT

 public:
  explicit WelcomeCard(const WelcomeEntry& entry, QWidget* parent);

  QSize sizeHint() const override;
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;

 signals:
  void focused();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void enterEvent(QEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  int pictureHeight(int width) const;
  void drawPicture(QPainter& painter, const QRect& place) const;
  void drawTexts(QPainter& painter, QRect place) const;

  WelcomeEntry entry_;
};

/// Cards in rows of as many as the width has room for. The arrow keys go from card to card.
class CardGrid final : public QWidget {
  Q_OBJECT

 public:
  explicit CardGrid(QWidget* parent);

  void setEntries(const std::vector<WelcomeEntry>& entries);
  const std::vector<WelcomeCard*>& cards() const { return cards_; }
  int heightForWidth(int width) const override;
  /// The width of a full row: more room is left free.
  int widest() const;

 signals:
  void chosen(const QString& file);
  void focused(QWidget* card);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  int narrowestCard() const;
  int columnsIn(int width) const;
  int cardWidth(int width) const;
  void arrange();
  /// The card whose place is `by` after that of the card, or the next one in that direction that can have the focus.
  bool moveFocus(const QObject* from, int by);

  std::vector<WelcomeCard*> cards_;
};

}  // namespace glissade
