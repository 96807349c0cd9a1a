#include "widgets/studies/work_time_table.h"

#include <QHeaderView>
#include <QSignalBlocker>

#include "widgets/studies/work_time_texts.h"

namespace glissade {
namespace {

constexpr int kRowMargin = 8;  ///< pixels

enum Column { kName, kValue, kUnit, kDefault, kColumns };

}  // namespace

WorkTimeTable::WorkTimeTable(QWidget* parent)
    : QTableWidget(static_cast<int>(workTimeRows().size()), kColumns, parent) {
  setObjectName(QStringLiteral("times-table"));
  setAccessibleName(tr("Table of times"));
  setHorizontalHeaderLabels({tr("Entry"), tr("Value"), tr("Unit"), tr("Default")});
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  horizontalHeader()->setSectionResizeMode(kName, QHeaderView::Stretch);
  horizontalHeader()->setHighlightSections(false);
  horizontalHeaderItem(kName)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + kRowMargin);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setEditTriggers(DoubleClicked | SelectedClicked | EditKeyPressed | AnyKeyPressed);
  setTabKeyNavigation(false);
  for (int row = 0; row < rowCount(); ++row) addRow(row, workTimeRows()[static_cast<std::size_t>(row)]);
  setCurrentCell(0, kValue);
  connect(this, &QTableWidget::itemChanged, this, [this](const QTableWidgetItem* item) {
    if (item->column() == kValue) emit written(static_cast<std::size_t>(item->row()), item->text());
  });
}

void WorkTimeTable::addRow(int row, const WorkTimeRow& time) {
  const QString standard = workTimeText(WorkTimes().*time.value);
  const QString texts[] = {workTimeName(time), standard, workTimeUnit(time), standard};
  for (int column = 0; column < kColumns; ++column) {
    auto* item = new QTableWidgetItem(texts[column]);
    item->setToolTip(workTimeHelp(time));
    if (column != kValue) item->setFlags(item->flags() & ~Qt::ItemIsEditable);
    if (column == kValue || column == kDefault) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setItem(row, column, item);
  }
}

void WorkTimeTable::setTimes(const WorkTimes& times) {
  const QSignalBlocker block(this);
  for (int row = 0; row < rowCount(); ++row) {
    const WorkTimeRow& time = workTimeRows()[static_cast<std::size_t>(row)];
    const QString text = workTimeText(times.*time.value);
    const bool isChanged = isEdited(times, time);
    QFont font = this->font();
    font.setBold(isChanged);
    for (const int column : {kName, kValue}) item(row, column)->setData(Qt::FontRole, isChanged ? font : QVariant());
    item(row, kValue)->setText(text);
    item(row, kValue)->setData(Qt::AccessibleTextRole, isChanged ? tr("%1, changed").arg(text) : text);
  }
  viewport()->update();
}

std::vector<std::size_t> WorkTimeTable::selectedTimes() const {
  std::vector<std::size_t> rows;
  for (int row = 0; row < rowCount(); ++row) {
    if (selectionModel()->isRowSelected(row, {})) rows.push_back(static_cast<std::size_t>(row));
  }
  return rows;
}

void WorkTimeTable::write(std::size_t row, const QString& text) { item(static_cast<int>(row), kValue)->setText(text); }

}  // namespace glissade
