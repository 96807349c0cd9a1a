#include "widgets/run/research_box.h"

#include <QAbstractItemView>
#include <QSignalBlocker>
#include <QStandardItemModel>

#include <algorithm>

namespace glissade {
namespace {

constexpr int kLeastLetters = 12;

}  // namespace

ResearchBox::ResearchBox(std::vector<Entry> entries, QWidget* parent)
    : QComboBox(parent), entries_(std::move(entries)) {
  setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  setMinimumContentsLength(kLeastLetters);
  for (const Entry& entry : entries_) {
    if (!entry.research) add(entry);
  }
  insertSeparator(count());
  researchRow_ = count();
  addItem(tr("Research…"));
  setItemData(researchRow_, tr("Shows what studies compare, by the names of the literature"), Qt::ToolTipRole);
  connect(this, QOverload<int>::of(&QComboBox::activated), this, [this](int row) {
    if (row != researchRow_) {
      emit entryChosen(chosen());
      return;
    }
    listResearch();
    setChosen(shown_);
    showPopup();
  });
}

void ResearchBox::add(const Entry& entry) {
  addItem(entry.label, entry.id);
  setItemData(count() - 1, entry.tip, Qt::ToolTipRole);
  setMaxVisibleItems(count() + 1);
}

void ResearchBox::listResearch() {
  if (listsResearch()) return;
  setItemText(researchRow_, tr("Research"));
  setItemData(researchRow_, {}, Qt::ToolTipRole);
  static_cast<QStandardItemModel*>(model())->item(researchRow_)->setFlags(Qt::NoItemFlags);
  for (const Entry& entry : entries_) {
    if (entry.research) add(entry);
  }
}

void ResearchBox::setChosen(const QString& id) {
  shown_ = id;
  const QSignalBlocker block(this);
  if (findData(id) < 0) listResearch();
  setCurrentIndex(findData(id));
  // The box counts letters as wide as an X. The chosen name is never cut.
  const int letters = fontMetrics().horizontalAdvance(currentText()) / fontMetrics().horizontalAdvance('X') + 1;
  setMinimumContentsLength(std::max(kLeastLetters, letters));
}

void ResearchBox::setReason(const QString& id, const QString& reason) {
  const int row = findData(id);
  const auto entry = std::find_if(entries_.begin(), entries_.end(), [&id](const Entry& one) { return one.id == id; });
  if (row < 0 || entry == entries_.end()) return;
  const QString text = reason.isEmpty() ? entry->label : tr("%1: %2").arg(entry->label, reason);
  if (itemText(row) != text) setItemText(row, text);
  static_cast<QStandardItemModel*>(model())->item(row)->setEnabled(reason.isEmpty());
}

void ResearchBox::showPopup() {
  emit popupDue();
  view()->setMinimumWidth(view()->sizeHintForColumn(0) + 24);
  QComboBox::showPopup();
}

}  // namespace glissade
