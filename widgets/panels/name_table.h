#pragma once

#include <QTreeWidget>

#include <vector>

namespace glissade {

/// Of a row's column: the number that it is sorted by. Columns without one, and equal numbers, are sorted as texts.
inline constexpr int kSortRole = Qt::UserRole + 1;

/// A row that sorts numbers by their values.
class SortedRow final : public QTreeWidgetItem {
 public:
  using QTreeWidgetItem::QTreeWidgetItem;

  bool operator<(const QTreeWidgetItem& other) const override;
};

/// A table with names of bodies. The names are long: their columns share the width that the other columns leave, and
/// show the ends of the names. Rows can be sorted by every column and filtered by a text.
class NameTable final : public QTreeWidget {
 public:
  struct Names {
    int column;
    double share;  ///< of the width that is left
  };

  NameTable(std::vector<Names> names, QWidget* parent);

  /// Makes the other columns as wide as what they show.
  void fitColumns();
  /// Hides the rows of which no column, and no tool tip of a name, holds the text. They are not selected any more:
  /// nothing is done to what is not seen.
  void filterRows(const QString& text);

 protected:
  /// Also where a scroll bar appears or goes.
  void resizeEvent(QResizeEvent* event) override;

 private:
  bool isName(int column) const;
  void shareWidth();

  std::vector<Names> names_;
};

}  // namespace glissade
