#include "widgets/help/command_palette.h"

#include <QApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPixmap>
#include <QVBoxLayout>

#include <algorithm>

#include "widgets/controls/menu_path.h"

namespace glissade {
namespace {

enum PaletteColumn { kFoundCommand, kFoundMenu, kFoundKeys, kFoundColumns };

constexpr int kIconSize = 16;
constexpr int kRowHeight = 24;

/// A transparent icon, so that all names begin in one column.
QIcon noIcon() {
  QPixmap pixmap(kIconSize, kIconSize);
  pixmap.fill(Qt::transparent);
  return QIcon(pixmap);
}

/// Rank of a match: 0 is the best; -1: no match.
int rankOf(const QAction& action, const QString& text) {
  const QString name = commandName(action.text());
  const QString all = name + QLatin1Char(' ') + action.statusTip() + QLatin1Char(' ') + action.objectName();
  for (const QString& word : text.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
    if (!all.contains(word, Qt::CaseInsensitive)) return -1;
  }
  if (name.startsWith(text, Qt::CaseInsensitive)) return 0;
  return name.contains(text, Qt::CaseInsensitive) ? 1 : 2;
}

}  // namespace

std::vector<QAction*> matchingActions(const ActionCatalogue& actions, const QString& text) {
  std::vector<std::pair<int, QAction*>> ranked;
  const auto add = [&](QAction* action) {
    const int rank = rankOf(*action, text.trimmed());
    if (rank >= 0) ranked.emplace_back(rank, action);
  };
  for (const ActionSpec& spec : actions.specs()) add(actions[QLatin1String(spec.id)]);
  for (QAction* action : actions.passing()) add(action);
  std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<QAction*> found;
  found.reserve(ranked.size());
  for (const auto& [rank, action] : ranked) found.push_back(action);
  return found;
}

CommandPalette::CommandPalette(const ActionCatalogue& actions, QWidget* parent)
    : QDialog(parent), actions_(actions), field_(new QLineEdit(this)), list_(new QTreeWidget(this)) {
  setWindowTitle(tr("Find a command"));
  setObjectName(QStringLiteral("command-palette"));
  field_->setPlaceholderText(tr("Part of a command's name"));
  field_->setAccessibleName(tr("Part of a command's name"));
  field_->setClearButtonEnabled(true);
  field_->installEventFilter(this);
  list_->setAccessibleName(tr("Commands"));
  list_->setIconSize(QSize(kIconSize, kIconSize));
  list_->setColumnCount(kFoundColumns);
  list_->setRootIsDecorated(false);
  list_->setAllColumnsShowFocus(true);
  list_->setUniformRowHeights(true);
  list_->header()->hide();
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  list_->header()->setSectionResizeMode(kFoundCommand, QHeaderView::Stretch);
  auto* column = new QVBoxLayout(this);
  column->addWidget(field_);
  column->addWidget(list_, 1);
  resize(640, 420);
  connect(field_, &QLineEdit::textChanged, this, &CommandPalette::showMatches);
  connect(list_, &QTreeWidget::itemActivated, this, &CommandPalette::triggerCurrent);
  showMatches();
}

void CommandPalette::showMatches() {
  list_->clear();
  shown_ = matchingActions(actions_, field_->text());
  for (const QAction* action : shown_) addRow(*action);
  const auto first =
      std::find_if(shown_.begin(), shown_.end(), [](const QAction* action) { return action->isEnabled(); });
  if (first != shown_.end()) list_->setCurrentItem(list_->topLevelItem(static_cast<int>(first - shown_.begin())));
}

void CommandPalette::addRow(const QAction& action) {
  const QString check = action.isCheckable() && action.isChecked() ? QStringLiteral("✓ ") : QString();
  const QStringList texts{check + commandName(action.text()), menuPath(action),
                          action.shortcut().toString(QKeySequence::NativeText)};
  auto* row = new QTreeWidgetItem(list_, texts);
  row->setIcon(kFoundCommand, action.icon().isNull() ? noIcon() : action.icon());
  row->setSizeHint(kFoundCommand, QSize(0, kRowHeight));
  row->setForeground(kFoundMenu, palette().placeholderText());
  for (int column = 0; column < kFoundColumns; ++column) row->setToolTip(column, action.statusTip());
  if (!action.isEnabled()) row->setFlags(Qt::NoItemFlags);
}

void CommandPalette::triggerCurrent() {
  const int row = list_->indexOfTopLevelItem(list_->currentItem());
  if (row < 0) return;
  QAction* action = shown_[static_cast<std::size_t>(row)];
  accept();
  action->trigger();
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress) return QDialog::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  if (key == Qt::Key_Return || key == Qt::Key_Enter) {
    triggerCurrent();
    return true;
  }
  if (key != Qt::Key_Up && key != Qt::Key_Down && key != Qt::Key_PageUp && key != Qt::Key_PageDown) {
    return QDialog::eventFilter(watched, event);
  }
  QCoreApplication::sendEvent(list_, event);
  return true;
}

}  // namespace glissade
