#include "widgets/files/card_grid.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QTextLayout>

#include <algorithm>

#include "widgets/controls/dark_palette.h"
#include "widgets/workbench/scenario_pictures.h"

namespace glissade {
namespace {

constexpr int kCardPadding = 8;
constexpr int kCardRadius = 6;
constexpr int kMostNameLines = 2;
constexpr int kMostTextLines = 4;
constexpr double kAwayOpacity = 0.35;

QFont nameFont(const QWidget& card) {
  QFont font = card.font();
  font.setBold(true);
  return font;
}

/// The text in at most `most` lines; the last line is elided.
QStringList linesOf(const QString& text, const QFont& font, int width, int most) {
  QStringList lines;
  QTextLayout layout(text, font);
  layout.beginLayout();
  const QFontMetrics metrics(font);
  for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
    line.setLineWidth(width);
    if (lines.size() + 1 == most) {
      lines << metrics.elidedText(text.mid(line.textStart()), Qt::ElideRight, width);
      break;
    }
    lines << text.mid(line.textStart(), line.textLength());
  }
  layout.endLayout();
  return lines;
}

constexpr int kCardGap = 12;
/// Widths in heights of a line.
constexpr int kNarrowestLines = 10;
constexpr int kWidestLines = 14;
constexpr int kMostColumns = 5;

}  // namespace

WelcomeCard::WelcomeCard(const WelcomeEntry& entry, QWidget* parent) : QAbstractButton(parent), entry_(entry) {
  setText(entry.name);
  setAccessibleName(entry.name);
  setAccessibleDescription(entry.whole.isEmpty() ? entry.text : entry.whole);
  setToolTip(accessibleDescription());
  setEnabled(entry.isThere);
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::PointingHandCursor);
}

int WelcomeCard::pictureHeight(int width) const {
  return width * kScenarioPictureSize.height() / kScenarioPictureSize.width();
}

QStringList WelcomeCard::nameLines(int width) const {
  return linesOf(entry_.name, nameFont(*this), width - 2 * kCardPadding, kMostNameLines);
}

QStringList WelcomeCard::textLines(int width) const {
  const int room = width - 2 * kCardPadding;
  if (entry_.isOneLine) return {fontMetrics().elidedText(entry_.text, Qt::ElideLeft, room)};
  return linesOf(entry_.text, font(), room, kMostTextLines);
}

int WelcomeCard::heightForWidth(int width) const {
  const auto lines = static_cast<int>(nameLines(width).size() + textLines(width).size());
  return pictureHeight(width) + lines * fontMetrics().lineSpacing() + 2 * kCardPadding;
}

QSize WelcomeCard::sizeHint() const {
  const int width = kScenarioPictureSize.width() / 2;
  return {width, heightForWidth(width)};
}

void WelcomeCard::drawPicture(QPainter& painter, const QRect& place) const {
  const QImage& picture = isDark(palette()) ? entry_.dark : entry_.light;
  if (picture.isNull()) {
    painter.fillRect(place, palette().color(QPalette::Button));
    return;
  }
  painter.setOpacity(entry_.isThere ? 1.0 : kAwayOpacity);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(place, picture);
  painter.setOpacity(1.0);
}

void WelcomeCard::drawTexts(QPainter& painter, QRect place) const {
  const QFont bold = nameFont(*this);
  const int line = fontMetrics().lineSpacing();
  const auto draw = [&](const QString& text, const QFont& font, const QColor& colour) {
    painter.setFont(font);
    painter.setPen(colour);
    painter.drawText(QRect(place.topLeft(), QSize(place.width(), line)), Qt::AlignLeft | Qt::AlignVCenter, text);
    place.setTop(place.top() + line);
  };
  const QColor faint = palette().color(QPalette::Disabled, QPalette::Text);
  const QColor ink = entry_.isThere ? palette().color(QPalette::Text) : faint;
  for (const QString& text : nameLines(width())) draw(text, bold, ink);
  for (const QString& text : textLines(width())) draw(text, font(), faint);
}

void WelcomeCard::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const bool marked = hasFocus() || (isEnabled() && (underMouse() || isDown()));
  const double border = hasFocus() ? 2.0 : 1.0;
  const QRectF frame = QRectF(rect()).adjusted(border / 2, border / 2, -border / 2, -border / 2);
  QPainterPath outline;
  outline.addRoundedRect(frame, kCardRadius, kCardRadius);
  painter.fillPath(outline, palette().color(QPalette::Base));
  painter.save();
  painter.setClipPath(outline);
  const QRect picture(0, 0, width(), pictureHeight(width()));
  drawPicture(painter, picture);
  painter.restore();
  drawTexts(painter, rect().adjusted(kCardPadding, picture.height() + kCardPadding, -kCardPadding, 0));
  const QColor edge = palette().color(QPalette::Disabled, QPalette::Text);
  painter.setPen(QPen(marked ? palette().color(QPalette::Highlight) : edge, border));
  painter.setOpacity(marked ? 1.0 : kAwayOpacity);
  painter.drawPath(outline);
}

void WelcomeCard::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    click();
  } else {
    QAbstractButton::keyPressEvent(event);
  }
}

void WelcomeCard::focusInEvent(QFocusEvent* event) {
  QAbstractButton::focusInEvent(event);
  emit focused();
}

void WelcomeCard::enterEvent(QEvent* event) {
  QAbstractButton::enterEvent(event);
  update();
}

void WelcomeCard::leaveEvent(QEvent* event) {
  QAbstractButton::leaveEvent(event);
  update();
}

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
  return rows * (cardHeight(cardWidth(width)) + kCardGap) - kCardGap;
}

/// All cards are as high as the one with the longest texts.
int CardGrid::cardHeight(int across) const {
  int highest = 0;
  for (const WelcomeCard* card : cards_) highest = std::max(highest, card->heightForWidth(across));
  return highest;
}

void CardGrid::arrange() {
  const int columns = columnsIn(width());
  const int across = cardWidth(width());
  const int down = cardHeight(across);
  for (std::size_t i = 0; i < cards_.size(); ++i) {
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
