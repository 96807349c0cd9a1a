#include "widgets/controls/name_table.h"

#include <QHeaderView>

#include <algorithm>
#include <utility>

#include "widgets/controls/cell_delegates.h"
#include "widgets/controls/quiet_focus.h"

namespace glissade {
namespace {

constexpr int kReadableLetters = 22;  ///< letters of a name that have room in any table

}  // namespace

bool SortedRow::operator<(const QTreeWidgetItem& other) const {
  const int column = treeWidget()->sortColumn();
  const double mine = data(column, kSortRole).toDouble();
  const double others = other.data(column, kSortRole).toDouble();
  if (mine != others) return mine < others;
  return text(column).localeAwareCompare(other.text(column)) < 0;
}

NameTable::NameTable(std::vector<Names> names, QWidget* parent) : QTreeWidget(parent), names_(std::move(names)) {
  keepUnchosen(*this);
  setRootIsDecorated(false);
  setUniformRowHeights(true);
  setAlternatingRowColors(true);
  setTextElideMode(Qt::ElideMiddle);
  setItemDelegate(new WholeWordsDelegate(this));
  for (const Names& each : names_) setItemDelegateForColumn(each.column, new NameDelegate(each.column, this));
  setContextMenuPolicy(Qt::ActionsContextMenu);
  header()->setSectionResizeMode(QHeaderView::Interactive);
  header()->setStretchLastSection(false);
}

bool NameTable::isName(int column) const {
  return std::any_of(names_.begin(), names_.end(), [column](const Names& each) { return each.column == column; });
}

void NameTable::fitColumns() {
  for (int column = 0; column < columnCount(); ++column) {
    if (!isName(column)) resizeColumnToContents(column);
  }
  shareWidth();
}

void NameTable::shareWidth() {
  int rest = viewport()->width();
  for (int column = 0; column < columnCount(); ++column) {
    if (!isName(column)) rest -= columnWidth(column);
  }
  const int readable = kReadableLetters * fontMetrics().averageCharWidth();
  for (const Names& each : names_) {
    const int ofContents = std::max(sizeHintForColumn(each.column), header()->sectionSizeHint(each.column));
    setColumnWidth(each.column, std::max(std::min(readable, ofContents), static_cast<int>(each.share * rest)));
  }
}

void NameTable::resizeEvent(QResizeEvent* event) {
  QTreeWidget::resizeEvent(event);
  shareWidth();
}

void NameTable::filterRows(const QString& text) {
  for (int i = 0; i < topLevelItemCount(); ++i) {
    QTreeWidgetItem* row = topLevelItem(i);
    bool matches = text.isEmpty();
    for (int column = 0; column < columnCount(); ++column) {
      matches = matches || row->text(column).contains(text, Qt::CaseInsensitive) ||
                (isName(column) && row->toolTip(column).contains(text, Qt::CaseInsensitive));
    }
    row->setHidden(!matches);
    if (!matches) row->setSelected(false);
  }
}

}  // namespace glissade
