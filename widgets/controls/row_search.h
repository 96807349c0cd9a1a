#pragma once

#include <QSignalBlocker>
#include <QTreeWidget>

namespace glissade {

/// Makes the first row about something selected elsewhere the current one and scrolls to it; the current row stays
/// current if it is about that, too. The table emits no signal. Returns whether there is such a row.
template <class IsAbout>
bool goToRow(QTreeWidget& table, const IsAbout& isAbout) {
  const auto fits = [&isAbout](const QTreeWidgetItem* row) {
    return row != nullptr && !row->isHidden() && isAbout(*row);
  };
  QTreeWidgetItem* found = fits(table.currentItem()) ? table.currentItem() : nullptr;
  for (int i = 0; found == nullptr && i < table.topLevelItemCount(); ++i) {
    if (fits(table.topLevelItem(i))) found = table.topLevelItem(i);
  }
  if (found == nullptr) return false;
  const QSignalBlocker block(&table);
  if (found != table.currentItem()) table.setCurrentItem(found);
  table.scrollToItem(found);
  return true;
}

}  // namespace glissade
