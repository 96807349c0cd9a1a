#pragma once

#include <QStyledItemDelegate>

#include <optional>

#include "widgets/controls/name_elision.h"

class QAbstractItemView;

namespace glissade {

/// The first words of the line that have room, and an ellipsis; a number keeps its unit.
QString wholeWords(const QString& line, const QFontMetrics& metrics, int width);

/// The line as lines of at most `width` pixels, broken between words; the last one of `most` lines has the rest. A
/// number keeps its unit. A longer word is elided.
QStringList wrappedLines(const QString& line, const QFontMetrics& metrics, int width, int most);

/// Shows whole words of lines that are too long, because a number that is cut reads as another number.
class WholeWordsDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  /// Shortens what is painted. The size hint is that of the whole text, so that columns can be fitted to it.
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 protected:
  /// The text of a line in at most `width` pixels if it fits. `line`: its number in the cell.
  virtual QString shortened(const QString& text, int line, const QStyleOptionViewItem& option, int width) const;
};

/// Shows the first line of each cell as a name that is told apart from the other names of its column.
class NameDelegate final : public WholeWordsDelegate {
 public:
  /// A delegate of one column of the view, whose model stays.
  NameDelegate(int column, QAbstractItemView* view);

 protected:
  QString shortened(const QString& text, int line, const QStyleOptionViewItem& option, int width) const override;

 private:
  const QAbstractItemModel& model_;
  int column_;
  mutable std::optional<NameElision> names_;  ///< those of the model, made when they are needed
};

}  // namespace glissade
