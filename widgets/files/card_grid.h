#pragma once

#include <QAbstractButton>
#include <QImage>
#include <QWidget>

#include <vector>

namespace glissade {

/// The content of a card of the welcome page.
struct WelcomeEntry {
  QString file;  ///< the file that a click opens
  QString name;
  QString text;            ///< up to four lines
  QImage light;            ///< picture for a light background; null: none
  QImage dark;             ///< picture for a dark background
  bool isThere = true;     ///< false: grey, and cannot be opened
  QString whole = {};      ///< tool tip; empty: `text`
  bool isOneLine = false;  ///< `text` is elided at its beginning, as paths are
};

/// A picture with a name and a text. A click, Enter or the space bar chooses it.
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
  /// The lines of the name, and of the text, of a card of this width.
  QStringList nameLines(int width) const;
  QStringList textLines(int width) const;
  void drawPicture(QPainter& painter, const QRect& place) const;
  void drawTexts(QPainter& painter, QRect place) const;

  WelcomeEntry entry_;
};

/// Shows cards in rows, as many in a row as the width allows. The arrow keys move from card to card.
class CardGrid final : public QWidget {
  Q_OBJECT

 public:
  explicit CardGrid(QWidget* parent);

  void setEntries(const std::vector<WelcomeEntry>& entries);
  const std::vector<WelcomeCard*>& cards() const { return cards_; }
  int heightForWidth(int width) const override;
  /// The width of a full row; wider grids leave the rest free.
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
  int cardHeight(int across) const;
  void arrange();
  /// Moves the focus by `by` cards, or further in that direction to the next card that can have the focus.
  bool moveFocus(const QObject* from, int by);

  std::vector<WelcomeCard*> cards_;
};

}  // namespace glissade
