#include "widgets/controls/cell_delegates.h"

#include <QAbstractItemView>
#include <QApplication>

#include <algorithm>

namespace glissade {
namespace {

/// The last blank of the text that is not between a number and its unit; -1 if there is none.
int lastBreak(const QString& text) {
  int at = text.lastIndexOf(QLatin1Char(' '));
  while (at > 0 && at + 1 < text.size() && text[at - 1].isDigit() && text[at + 1].isLetter()) {
    at = text.lastIndexOf(QLatin1Char(' '), at - 1);
  }
  return at;
}

const QStyle& styleOf(const QStyleOptionViewItem& option) {
  return option.widget != nullptr ? *option.widget->style() : *QApplication::style();
}

int textWidth(const QStyleOptionViewItem& option) {
  const QStyle& style = styleOf(option);
  const int margin = style.pixelMetric(QStyle::PM_FocusFrameHMargin, &option, option.widget) + 1;
  return style.subElementRect(QStyle::SE_ItemViewItemText, &option, option.widget).width() - 2 * margin;
}

bool fits(const QStringList& lines, const QFontMetrics& metrics, int width) {
  return std::all_of(lines.begin(), lines.end(),
                     [&](const QString& line) { return metrics.horizontalAdvance(line) <= width; });
}

void addFirstLines(const QAbstractItemModel& model, int column, const QModelIndex& parent, QStringList& lines) {
  for (int row = 0; row < model.rowCount(parent); ++row) {
    lines << model.index(row, column, parent).data().toString().section(QLatin1Char('\n'), 0, 0);
    addFirstLines(model, column, model.index(row, 0, parent), lines);
  }
}

}  // namespace

QString wholeWords(const QString& line, const QFontMetrics& metrics, int width) {
  QString shown = line;
  for (QString rest = line; metrics.horizontalAdvance(shown) > width;) {
    const int end = lastBreak(rest);
    const bool isNumber = std::any_of(rest.begin(), rest.end(), [](QChar letter) { return letter.isDigit(); });
    if (end < 0) return isNumber ? QStringLiteral("…") : metrics.elidedText(line, Qt::ElideRight, width);
    rest.truncate(end);
    shown = rest + QStringLiteral(" …");
  }
  return shown;
}

QStringList wrappedLines(const QString& line, const QFontMetrics& metrics, int width, int most) {
  QStringList lines;
  QString rest = line;
  while (lines.size() + 1 < most && metrics.horizontalAdvance(rest) > width) {
    QString begin = rest;
    int end = lastBreak(begin);
    while (end > 0 && metrics.horizontalAdvance(begin) > width) {
      begin.truncate(end);
      end = lastBreak(begin);
    }
    lines << metrics.elidedText(begin, Qt::ElideMiddle, width);  // one word may be too long
    rest = rest.mid(begin.size() + 1);
  }
  return rest.isEmpty() ? lines : lines << rest;
}

void WholeWordsDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  QStyleOptionViewItem shown = option;
  initStyleOption(&shown, index);
  const int width = textWidth(shown);
  QStringList lines = shown.text.split(QChar::LineSeparator);
  if (!fits(lines, shown.fontMetrics, width)) {
    for (int i = 0; i < lines.size(); ++i) lines[i] = shortened(lines[i], i, shown, width);
    shown.text = lines.join(QChar::LineSeparator);
  }
  shown.textElideMode = Qt::ElideNone;  // the style would cut numbers and what tells names apart
  styleOf(shown).drawControl(QStyle::CE_ItemViewItem, &shown, painter, shown.widget);
}

QString WholeWordsDelegate::shortened(const QString& text, int /*line*/, const QStyleOptionViewItem& option,
                                      int width) const {
  return wholeWords(text, option.fontMetrics, width);
}

NameDelegate::NameDelegate(int column, QAbstractItemView* view)
    : WholeWordsDelegate(view), model_(*view->model()), column_(column) {
  const auto forget = [this] { names_.reset(); };
  connect(&model_, &QAbstractItemModel::dataChanged, this, forget);
  connect(&model_, &QAbstractItemModel::rowsInserted, this, forget);
  connect(&model_, &QAbstractItemModel::rowsRemoved, this, forget);
  connect(&model_, &QAbstractItemModel::modelReset, this, forget);
}

QString NameDelegate::shortened(const QString& text, int line, const QStyleOptionViewItem& option, int width) const {
  if (line > 0) return WholeWordsDelegate::shortened(text, line, option, width);
  if (!names_) {
    QStringList lines;
    addFirstLines(model_, column_, {}, lines);
    names_.emplace(lines);
  }
  return names_->elided(text, option.fontMetrics, width);
}

}  // namespace glissade
