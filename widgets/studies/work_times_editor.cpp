#include "widgets/studies/work_times_editor.h"

#include <QKeySequence>
#include <QShortcut>
#include <QVBoxLayout>

#include <algorithm>

#include "engine/scenario/work_times_json.h"
#include "widgets/commands/diagnostic_text.h"
#include "widgets/commands/flow_layout.h"
#include "widgets/studies/work_time_texts.h"

namespace glissade {
namespace {

QString keysOf(QKeySequence::StandardKey key) { return QKeySequence(key).toString(QKeySequence::NativeText); }

/// The mnemonic of the button stays.
void addShortcut(QKeySequence::StandardKey key, QPushButton& button) {
  auto* shortcut = new QShortcut(QKeySequence(key), button.parentWidget());
  QObject::connect(shortcut, &QShortcut::activated, &button, &QPushButton::click);
}

}  // namespace

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
  connect(undo_, &QPushButton::clicked, this, &WorkTimesEditor::undoAsked);
  connect(redo_, &QPushButton::clicked, this, &WorkTimesEditor::redoAsked);
  connect(open, &QPushButton::clicked, this, &WorkTimesEditor::openAsked);
  connect(save, &QPushButton::clicked, this, &WorkTimesEditor::saveAsked);
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
  const Outcome fits =
      value ? checkWorkTime(time, *value) : Diagnostic{ErrorKind::MalformedInput, "", "", "is not a number", ""};
  if (!fits) {
    refuse(time, text, fits.error().reason);
    return;
  }
  WorkTimes wanted = times_;
  wanted.*time.value = *value;
  setTimes(times_);
  if (wanted != times_) emit edited(wanted);
}

void WorkTimesEditor::refuse(const WorkTimeRow& row, const QString& text, const std::string& reason) {
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
