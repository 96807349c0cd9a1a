#include "widgets/help/shortcuts_dialog.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

#include "widgets/controls/menu_path.h"

namespace glissade {
namespace {

enum ShortcutColumn { kCommand, kMenu, kShortcut, kColumns };

constexpr int kRowSpace = 8;

/// Whether the keys are a letter, a digit or a sign alone, which steers or writes text.
bool isPlainKey(const QKeySequence& keys) {
  if (keys.isEmpty()) return false;
  const int modifiers = keys[0] & static_cast<int>(Qt::KeyboardModifierMask);
  const int key = keys[0] & ~static_cast<int>(Qt::KeyboardModifierMask);
  const bool command = (modifiers & static_cast<int>(Qt::CTRL | Qt::ALT | Qt::META)) != 0;
  return !command && key < Qt::Key_Escape;
}

QString native(const QKeySequence& keys) { return keys.toString(QKeySequence::NativeText); }

}  // namespace

ShortcutsDialog::ShortcutsDialog(const ActionCatalogue& actions, QWidget* parent)
    : QDialog(parent),
      actions_(actions),
      filter_(new QLineEdit(this)),
      table_(new QTableWidget(0, kColumns, this)),
      keys_(new QKeySequenceEdit(this)),
      assign_(new QPushButton(tr("&Assign"), this)),
      remove_(new QPushButton(tr("&Remove"), this)),
      usual_(new QPushButton(tr("&Default"), this)),
      note_(new QLabel(this)) {
  setWindowTitle(tr("Keyboard shortcuts"));
  setObjectName(QStringLiteral("shortcuts"));
  filter_->setPlaceholderText(tr("Part of a command, a menu or a shortcut"));
  filter_->setAccessibleName(filter_->placeholderText());
  filter_->setClearButtonEnabled(true);
  table_->setAccessibleName(tr("Commands"));
  table_->setHorizontalHeaderLabels({tr("Command"), tr("Menu"), tr("Shortcut")});
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(kCommand, QHeaderView::Stretch);
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + kRowSpace);
  table_->setShowGrid(false);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setTabKeyNavigation(false);
  for (const ActionSpec& spec : actions_.specs()) addRow(spec);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  auto* column = new QVBoxLayout(this);
  column->addWidget(filter_);
  column->addWidget(table_, 1);
  column->addLayout(makeEditor());
  column->addWidget(note_);
  column->addWidget(buttons);
  resize(720, 520);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(filter_, &QLineEdit::textChanged, this, &ShortcutsDialog::filter);
  connect(table_, &QTableWidget::itemSelectionChanged, this, &ShortcutsDialog::showChosen);
  showKeys();
  showChosen();
}

QLayout* ShortcutsDialog::makeEditor() {
  keys_->setAccessibleName(tr("New shortcut"));
  for (QPushButton* button : {assign_, remove_, usual_}) button->setAutoDefault(false);
  note_->setWordWrap(true);
  auto* row = new QHBoxLayout;
  auto* label = new QLabel(tr("&New shortcut"), this);
  label->setBuddy(keys_);
  row->addWidget(label);
  row->addWidget(keys_, 1);
  row->addWidget(assign_);
  row->addWidget(remove_);
  row->addWidget(usual_);
  connect(keys_, &QKeySequenceEdit::keySequenceChanged, this, &ShortcutsDialog::explain);
  connect(assign_, &QPushButton::clicked, this, [this] { assign(keys_->keySequence()); });
  connect(remove_, &QPushButton::clicked, this, [this] { assign({}); });
  connect(usual_, &QPushButton::clicked, this, [this] { assign(actions_.usualShortcut(chosenId())); });
  return row;
}

void ShortcutsDialog::addRow(const ActionSpec& spec) {
  const QAction& action = *actions_[QLatin1String(spec.id)];
  const int row = table_->rowCount();
  table_->insertRow(row);
  auto* name = new QTableWidgetItem(withoutMnemonic(action.text()));
  name->setData(Qt::UserRole, QLatin1String(spec.id));
  name->setToolTip(action.statusTip());
  table_->setItem(row, kCommand, name);
  table_->setItem(row, kMenu, new QTableWidgetItem(menuPath(action)));
  table_->setItem(row, kShortcut, new QTableWidgetItem);
  shortcuts_.insert(QLatin1String(spec.id), action.shortcut());
}

void ShortcutsDialog::showKeys() {
  for (int row = 0; row < table_->rowCount(); ++row) {
    const QString id = table_->item(row, kCommand)->data(Qt::UserRole).toString();
    QTableWidgetItem* item = table_->item(row, kShortcut);
    item->setText(native(shortcuts_.value(id)));
    QFont font = table_->font();
    font.setBold(shortcuts_.value(id) != actions_.usualShortcut(id));
    item->setFont(font);
  }
}

void ShortcutsDialog::filter(const QString& text) {
  for (int row = 0; row < table_->rowCount(); ++row) {
    bool fits = false;
    for (int column = 0; column < kColumns; ++column) {
      fits = fits || table_->item(row, column)->text().contains(text, Qt::CaseInsensitive);
    }
    table_->setRowHidden(row, !fits);
  }
}

QString ShortcutsDialog::chosenId() const {
  const auto chosen = table_->selectionModel()->selectedRows(kCommand);
  return chosen.isEmpty() ? QString() : chosen.front().data(Qt::UserRole).toString();
}

void ShortcutsDialog::showChosen() {
  keys_->setKeySequence(shortcuts_.value(chosenId()));
  explain();
}

void ShortcutsDialog::assign(const QKeySequence& keys) {
  for (QKeySequence& other : shortcuts_) {
    if (!keys.isEmpty() && other == keys) other = QKeySequence();
  }
  shortcuts_[chosenId()] = keys;
  showKeys();
  showChosen();
}

void ShortcutsDialog::explain() {
  const QString id = chosenId();
  const QKeySequence keys = keys_->keySequence();
  const bool plain = isPlainKey(keys);
  const QString taken = keys.isEmpty() ? QString() : shortcuts_.key(keys);
  QString note = id.isEmpty() ? tr("Choose a command.") : tr("Bold shortcuts differ from the default.");
  if (plain) {
    note = tr("Keys without Ctrl or Alt steer the object and write text.");
  } else if (!taken.isEmpty() && taken != id) {
    note = tr("It is taken from \"%1\".").arg(withoutMnemonic(actions_[taken]->text()));
  }
  note_->setText(note);
  keys_->setEnabled(!id.isEmpty());
  assign_->setEnabled(!id.isEmpty() && !plain && !keys.isEmpty() && keys != shortcuts_.value(id));
  remove_->setEnabled(!id.isEmpty() && !shortcuts_.value(id).isEmpty());
  usual_->setEnabled(!id.isEmpty() && shortcuts_.value(id) != actions_.usualShortcut(id));
}

}  // namespace glissade
