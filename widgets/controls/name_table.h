#pragma once

#include <QTreeWidget>

#include <vector>

namespace glissade {

/// Role of the number by which a row's column is sorted. Columns without such a number, and equal numbers, are sorted
/// as texts.
inline constexpr int kSortRole = Qt::UserRole + 1;

/// A row that sorts numbers by their values.
class SortedRow final : public QTreeWidgetItem {
 public:
  using QTreeWidgetItem::QTreeWidgetItem;

  bool operator<(const QTreeWidgetItem& other) const override;
};

/// A table with names of bodies. The columns of the long names share the width that the other columns leave, and show
/// the ends of the names. They have room for a readable part of the names; where the table is narrower it is scrolled.
/// Rows can be sorted by every column and filtered by a text.
class NameTable final : public QTreeWidget {
 public:
  struct Names {
    int column;
    double share;  ///< share of the width that the other columns leave
  };

  NameTable(std::vector<Names> names, QWidget* parent);

  /// Makes the other columns as wide as their contents.
  void fitColumns();
  /// Hides and deselects the rows in which no column, and no tool tip of a name, contains the text, so that nobody
  /// edits hidden rows.
  void filterRows(const QString& text);

 protected:
  /// Called also when a scroll bar appears or disappears.
  void resizeEvent(QResizeEvent* event) override;

 private:
  bool isName(int column) const;
  void shareWidth();

  std::vector<Names> names_;
};

}  // namespace glissade
