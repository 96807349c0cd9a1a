#include "widgets/controls/author_bar.h"

#include <QPainter>

#include <numeric>

#include "widgets/controls/author_colour.h"

namespace glissade {
namespace {

constexpr int kBarHeight = 8;
constexpr int kGap = 4;

QColor colourOf(std::size_t author) {
  const Colour colour = authorColour(static_cast<Author>(author));
  return QColor::fromRgbF(colour[0], colour[1], colour[2]);
}

}  // namespace

AuthorBar::AuthorBar(QWidget* parent) : QWidget(parent), names_{tr("computer"), tr("operator"), tr("contact")} {
  setToolTip(
      tr("Computer: random configurations. Operator: where he held the object. Contact: drawn on the tangent plane of "
         "his nearest obstacle."));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize AuthorBar::sizeHint() const { return {160, kBarHeight + kGap + 2 * fontMetrics().height()}; }

void AuthorBar::setShares(const PerAuthor<double>& shares, const PerAuthor<QString>& numbers) {
  shares_ = shares;
  numbers_ = numbers;
  QStringList spoken;
  for (std::size_t i = 0; i < names_.size(); ++i) spoken << names_[i] + QLatin1Char(' ') + numbers_[i];
  setAccessibleName(spoken.join(QStringLiteral(", ")));
  update();
}

void AuthorBar::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const double sum = std::accumulate(shares_.begin(), shares_.end(), 0.0);
  painter.fillRect(0, 0, width(), kBarHeight, palette().color(QPalette::Mid));
  double done = 0.0;
  for (std::size_t i = 0; i < shares_.size() && sum > 0.0; ++i) {
    const int from = static_cast<int>(width() * done / sum);
    done += shares_[i];
    painter.fillRect(from, 0, static_cast<int>(width() * done / sum) - from, kBarHeight, colourOf(i));
  }
  // Each author has one column, with the name over the number, whatever their lengths.
  const int top = kBarHeight + kGap;
  const int line = fontMetrics().height();
  const int side = fontMetrics().ascent() - 2;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const int x = static_cast<int>(i) * width() / static_cast<int>(names_.size());
    painter.fillRect(x, top + 2, side, side, colourOf(i));
    painter.drawText(x + side + kGap, top + fontMetrics().ascent(), names_[i]);
    painter.drawText(x + side + kGap, top + line + fontMetrics().ascent(), numbers_[i]);
  }
}

}  // namespace glissade
