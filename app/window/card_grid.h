#pragma once

#include <QWidget>

#include <vector>

#include "app/window/welcome_card.h"

namespace glissade {

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
