#include "widgets/sequence/work_times_editor.h"

#include <QHeaderView>
#include <QKeySequence>
#include <QShortcut>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

#include "engine/files/work_times_json.h"
#include "widgets/controls/diagnostic_text.h"
#include "widgets/controls/flow_layout.h"
#include "widgets/sequence/work_time_texts.h"

namespace glissade {
namespace {

constexpr int kRowMargin = 8;  ///< pixels

enum Column { kName, kValue, kUnit, kDefault, kColumns };

QString keysOf(QKeySequence::StandardKey key) { return QKeySequence(key).toString(QKeySequence::NativeText); }

/// Adds a shortcut besides the mnemonic of the button.
void addShortcut(QKeySequence::StandardKey key, QPushButton& button) {
  auto* shortcut = new QShortcut(QKeySequence(key), button.parentWidget());
  QObject::connect(shortcut, &QShortcut::activated, &button, &QPushButton::click);
}

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

WorkTimesEditor::WorkTimesEditor(QWidget* parent)
    : QWidget(parent), table_(new WorkTimeTable(this)), count_(new QLabel(this)), trouble_(new QLabel(this)) {
  count_->setObjectName(QStringLiteral("times-changed"));
  trouble_->setObjectName(QStringLiteral("times-trouble"));
  trouble_->setForegroundRole(QPalette::BrightText);
  trouble_->setTextFormat(Qt::PlainText);
  trouble_->setWordWrap(true);
  trouble_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  trouble_->hide();
  auto* column = new QVBoxLayout(this);
  column->addWidget(table_, 1);
  column->addWidget(trouble_);
  column->addWidget(count_);
  makeButtons();
  connect(table_, &WorkTimeTable::written, this, &WorkTimesEditor::take);
  connect(table_, &QTableWidget::itemSelectionChanged, this, &WorkTimesEditor::enableButtons);
  setCanUndo(false);
  setCanRedo(false);
  setTimes(times_);
}

QPushButton* WorkTimesEditor::addButton(const char* id, const QString& text, const QString& tip) {
  auto* button = new QPushButton(text, this);
  button->setObjectName(QLatin1String(id));
  button->setToolTip(tip);
  button->setAutoDefault(false);
  return button;
}

void WorkTimesEditor::makeButtons() {
  reset_ = addButton("times-reset", tr("&Reset"), tr("Set the selected values back to their defaults"));
  resetAll_ = addButton("times-reset-all", tr("Reset &all"), tr("Set all values back to their defaults"));
  undo_ =
      addButton("times-undo", tr("&Undo"), tr("Undo the last edit of the table (%1)").arg(keysOf(QKeySequence::Undo)));
  redo_ = addButton("times-redo", tr("Re&do"),
                    tr("Redo the edit of the table that was undone (%1)").arg(keysOf(QKeySequence::Redo)));
  auto* open = addButton("times-open", tr("&Open table..."),
                         tr("Read a table of times, as glissade-cli times --write-table writes it"));
  auto* save = addButton("times-save", tr("Sa&ve table..."),
                         tr("Write the table into a file, which glissade-cli times --table reads"));
  addShortcut(QKeySequence::Undo, *undo_);
  addShortcut(QKeySequence::Redo, *redo_);
  connect(reset_, &QPushButton::clicked, this, &WorkTimesEditor::reset);
  connect(resetAll_, &QPushButton::clicked, this, [this] { emit edited(WorkTimes()); });
  connect(undo_, &QPushButton::clicked, this, &WorkTimesEditor::undoRequested);
  connect(redo_, &QPushButton::clicked, this, &WorkTimesEditor::redoRequested);
  connect(open, &QPushButton::clicked, this, &WorkTimesEditor::openRequested);
  connect(save, &QPushButton::clicked, this, &WorkTimesEditor::saveRequested);
  auto* row = new FlowLayout;
  for (QPushButton* button : {reset_, resetAll_, undo_, redo_, open, save}) row->addWidget(button);
  layout()->addItem(row);
}

void WorkTimesEditor::setTimes(const WorkTimes& times) {
  times_ = times;
  table_->setTimes(times);
  trouble_->hide();
  trouble_->clear();
  enableButtons();
}

void WorkTimesEditor::take(std::size_t row, const QString& text) {
  const WorkTimeRow& time = workTimeRows()[row];
  const auto value = workTimeIn(text);
  const Outcome fits = value ? checkWorkTime(time, *value)
                             : Diagnostic{ErrorKind::MalformedInput, "", "", GLISSADE_TEXT("is not a number"), {}};
  if (!fits) {
    refuse(time, text, fits.error().reason);
    return;
  }
  WorkTimes wanted = times_;
  wanted.*time.value = *value;
  setTimes(times_);
  if (wanted != times_) emit edited(wanted);
}

void WorkTimesEditor::refuse(const WorkTimeRow& row, const QString& text, const Message& reason) {
  setTimes(times_);
  trouble_->setText(tr("%1: '%2' %3. The value stays %4 %5.")
                        .arg(workTimeName(row), text.trimmed(), engineText(reason), workTimeText(times_.*row.value),
                             workTimeUnit(row)));
  trouble_->show();
}

void WorkTimesEditor::reset() {
  WorkTimes wanted = times_;
  for (const std::size_t row : table_->selectedTimes()) {
    const WorkTimeRow& time = workTimeRows()[row];
    wanted.*time.value = WorkTimes().*time.value;
  }
  emit edited(wanted);
}

void WorkTimesEditor::enableButtons() {
  const auto& rows = workTimeRows();
  const auto selected = table_->selectedTimes();
  reset_->setEnabled(
      std::any_of(selected.begin(), selected.end(), [&](std::size_t row) { return isEdited(times_, rows[row]); }));
  resetAll_->setEnabled(times_ != WorkTimes());
  count_->setText(tr("Changed values: %1 of %2").arg(editedCount(times_)).arg(rows.size()));
}

}  // namespace glissade
