#include "app/window/card_grid.h"

#include <QKeyEvent>

#include <algorithm>

namespace glissade {
namespace {

constexpr int kCardGap = 12;
/// Heights of a line.
constexpr int kNarrowestLines = 10;
constexpr int kWidestLines = 14;
constexpr int kMostColumns = 5;

}  // namespace

CardGrid::CardGrid(QWidget* parent) : QWidget(parent) {}

void CardGrid::setEntries(const std::vector<WelcomeEntry>& entries) {
  qDeleteAll(cards_);
  cards_.clear();
  for (const WelcomeEntry& entry : entries) {
    auto* card = new WelcomeCard(entry, this);
    connect(card, &QAbstractButton::clicked, this, [this, file = entry.file] { emit chosen(file); });
    connect(card, &WelcomeCard::focused, this, [this, card] { emit focused(card); });
    card->installEventFilter(this);
    card->show();
    cards_.push_back(card);
  }
  arrange();
}

int CardGrid::narrowestCard() const { return kNarrowestLines * fontMetrics().height(); }

int CardGrid::columnsIn(int width) const {
  return std::clamp((width + kCardGap) / (narrowestCard() + kCardGap), 1, kMostColumns);
}

int CardGrid::cardWidth(int width) const {
  const int columns = columnsIn(width);
  return std::min((width - (columns - 1) * kCardGap) / columns, kWidestLines * fontMetrics().height());
}

int CardGrid::widest() const { return kMostColumns * (kWidestLines * fontMetrics().height() + kCardGap) - kCardGap; }

int CardGrid::heightForWidth(int width) const {
  if (cards_.empty()) return 0;
  const int rows = (static_cast<int>(cards_.size()) + columnsIn(width) - 1) / columnsIn(width);
  return rows * (cards_.front()->heightForWidth(cardWidth(width)) + kCardGap) - kCardGap;
}

void CardGrid::arrange() {
  const int columns = columnsIn(width());
  const int across = cardWidth(width());
  for (std::size_t i = 0; i < cards_.size(); ++i) {
    const int down = cards_[i]->heightForWidth(across);
    const int row = static_cast<int>(i) / columns;
    const int column = static_cast<int>(i) % columns;
    cards_[i]->setGeometry(column * (across + kCardGap), row * (down + kCardGap), across, down);
  }
}

void CardGrid::resizeEvent(QResizeEvent* /*event*/) { arrange(); }

bool CardGrid::moveFocus(const QObject* from, int by) {
  const auto found = std::find(cards_.begin(), cards_.end(), from);
  for (auto next = (found - cards_.begin()) + by; next >= 0 && next < static_cast<std::ptrdiff_t>(cards_.size());
       next += by) {
    WelcomeCard* card = cards_[static_cast<std::size_t>(next)];
    if (!card->isEnabled()) continue;
    card->setFocus(Qt::OtherFocusReason);
    return true;
  }
  return false;
}

bool CardGrid::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
  switch (static_cast<QKeyEvent*>(event)->key()) {
    case Qt::Key_Right: return moveFocus(watched, 1);
    case Qt::Key_Left: return moveFocus(watched, -1);
    case Qt::Key_Down: return moveFocus(watched, columnsIn(width()));
    case Qt::Key_Up: return moveFocus(watched, -columnsIn(width()));
    default: return QWidget::eventFilter(watched, event);
  }
}

}  // namespace glissade
