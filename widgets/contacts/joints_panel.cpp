#include "widgets/contacts/joints_panel.h"

#include <QEvent>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

#include "widgets/contacts/joint_texts.h"
#include "widgets/controls/body_id_text.h"
#include "widgets/controls/row_search.h"

namespace glissade {
namespace {

enum JointColumn { JointType, JointBody, JointWith, JointSize, JointWho, JointColumns };

constexpr double kBodyShare = 0.4;  // share of the names' width; the column of joined bodies holds several names

constexpr int kJointIndexRole = Qt::UserRole;  // index of the row

QString idsText(const JointRow& row, const JointTable& table) {
  QStringList ids;
  for (const BodyId& id : row.key.others) ids << toQString(id);
  for (const std::size_t body : row.joint.clamped) {
    ids << JointsPanel::tr("clamps %1").arg(toQString(table.product().bodies[body].id));
  }
  return ids.join(QLatin1Char('\n'));
}

QString stateText(const JointRow& row) {
  const QString state = jointStateText(row.state);
  return row.joint.isDoubtful && row.counts() ? JointsPanel::tr("%1 (?)").arg(state) : state;
}

}  // namespace

JointsPanel::JointsPanel(const ActionCatalogue& actions, QWidget* parent)
    : QWidget(parent),
      filter_(new QLineEdit(this)),
      rows_(new NameTable({{JointBody, kBodyShare}, {JointWith, 1.0 - kBodyShare}}, this)),
      details_(new QLabel(this)) {
  filter_->setPlaceholderText(tr("Filter"));
  filter_->setToolTip(tr("Filter by kind, body, thread or state"));
  filter_->setAccessibleName(filter_->toolTip());
  filter_->setClearButtonEnabled(true);
  rows_->setObjectName(QStringLiteral("joints-table"));
  rows_->setColumnCount(JointColumns);
  rows_->setHeaderLabels({tr("Kind"), tr("Body"), tr("With"), tr("Size"), tr("State")});
  rows_->headerItem()->setToolTip(JointSize, tr("The thread, or the bend of a hook"));
  rows_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  rows_->setAccessibleName(tr("Joints"));
  rows_->sortByColumn(JointType, Qt::AscendingOrder);
  details_->setObjectName(QStringLiteral("joint-details"));
  details_->setWordWrap(true);
  details_->setTextFormat(Qt::PlainText);
  details_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  layOut(actions);
  connect(filter_, &QLineEdit::textChanged, rows_, &NameTable::filterRows);
  connect(rows_, &QTreeWidget::itemSelectionChanged, this, [this] {
    showDetails();
    emit chosenChanged();
  });
  connect(rows_, &QTreeWidget::itemActivated, this, &JointsPanel::activated);
  setTable(nullptr);
}

/// The filter is beside the first buttons, because small screens leave little room for the table.
void JointsPanel::layOut(const ActionCatalogue& actions) {
  for (const char* id : {"joints.isolate", "joints.confirm", "joints.dissolve", "joints.change", "joints.press-out",
                         "joints.open", "joints.as-found"}) {
    rows_->addAction(actions[QLatin1String(id)]);
  }
  QHBoxLayout* top = makeActionRow(actions, {"joints.find"}, this);
  top->addWidget(filter_, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(top);
  layout->addWidget(rows_, 1);
  layout->addWidget(details_);
  layout->addLayout(
      makeActionFlow(actions, {"joints.confirm", "joints.dissolve", "joints.confirm-all", "joints.make"}, this));
}

void JointsPanel::setTable(const JointTablePtr& table) {
  std::vector<JointKey> keys;
  for (const JointRow* row : chosen()) keys.push_back(row->key);
  {
    const QSignalBlocker block(rows_);
    table_ = table;
    rows_->setSortingEnabled(false);
    rows_->clear();
    for (std::size_t i = 0; table_ && i < table_->rows().size(); ++i) addRow(i);
    rows_->setSortingEnabled(true);
    chooseKeys(keys);
  }
  rows_->fitColumns();
  rows_->filterRows(filter_->text());
  showDetails();
  if (!keys.empty()) emit chosenChanged();
}

void JointsPanel::addRow(std::size_t index) {
  const JointRow& row = table_->rows()[index];
  auto* item = new SortedRow(rows_);
  item->setData(JointType, kJointIndexRole, static_cast<qulonglong>(index));
  item->setText(JointType, jointKindText(row.key.kind));
  item->setText(JointBody, table_->shown(row.key.body));
  item->setToolTip(JointBody, toQString(row.key.body));
  item->setText(JointWith, joinedWithText(row, *table_));
  item->setToolTip(JointWith, idsText(row, *table_));
  item->setText(JointSize, jointSizeText(row.joint));
  item->setData(JointSize, kSortRole, row.joint.thread ? row.joint.thread->diameter : 0.0);
  item->setToolTip(JointSize, driveText(row.joint));
  item->setText(JointWho, stateText(row));
  for (const int column : {JointType, JointWho}) item->setToolTip(column, jointEvidence(row).join(QLatin1Char('\n')));
  markRow(*item, row);
}

/// Doubtful and refused joints are bold; dissolved joints are grey and struck out.
void JointsPanel::markRow(QTreeWidgetItem& item, const JointRow& row) const {
  QFont font = rows_->font();
  if (row.state == JointRowState::Refused || (row.counts() && row.joint.isDoubtful)) {
    font.setBold(true);
    for (const int column : {JointType, JointWho}) item.setFont(column, font);
  } else if (!row.counts()) {
    font.setStrikeOut(true);
    const QBrush grey = palette().brush(QPalette::Disabled, QPalette::Text);
    for (int column = 0; column < JointColumns; ++column) item.setForeground(column, grey);
    for (const int column : {JointType, JointBody, JointWith, JointSize}) item.setFont(column, font);
  }
}

const JointRow& JointsPanel::rowOf(const QTreeWidgetItem& item) const {
  return table_->rows()[static_cast<std::size_t>(item.data(JointType, kJointIndexRole).toULongLong())];
}

std::vector<const JointRow*> JointsPanel::chosen() const {
  std::vector<const JointRow*> rows;
  for (int i = 0; table_ && i < rows_->topLevelItemCount(); ++i) {
    const QTreeWidgetItem* item = rows_->topLevelItem(i);
    if (item->isSelected()) rows.push_back(&rowOf(*item));
  }
  return rows;
}

void JointsPanel::chooseKeys(const std::vector<JointKey>& keys) {
  for (int i = 0; i < rows_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = rows_->topLevelItem(i);
    const JointKey& key = rowOf(*item).key;
    const bool isChosen = std::any_of(keys.begin(), keys.end(), [&](const JointKey& k) { return isSameJoint(k, key); });
    if (!isChosen) continue;
    if (rows_->selectedItems().isEmpty()) rows_->setCurrentItem(item);
    item->setSelected(true);
  }
}

void JointsPanel::showBodies(const QSet<QString>& ids) {
  if (!table_) return;
  const auto isAbout = [&](const QTreeWidgetItem& item) {
    const JointKey& key = rowOf(item).key;
    return ids.contains(toQString(key.body)) ||
           std::any_of(key.others.begin(), key.others.end(),
                       [&ids](const BodyId& id) { return ids.contains(toQString(id)); });
  };
  if (goToRow(*rows_, isAbout)) showDetails();
}

bool JointsPanel::choose(JointKind kind, const BodyId& body) {
  for (int i = 0; table_ && i < rows_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = rows_->topLevelItem(i);
    const JointRow& row = rowOf(*item);
    if (row.key.kind != kind || row.key.body != body) continue;
    rows_->setCurrentItem(item);
    return true;
  }
  return false;
}

void JointsPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LocaleChange || event->type() == QEvent::PaletteChange) setTable(table_);
}

/// Shows the evidence of the only selected row, or else the number of joints.
void JointsPanel::showDetails() {
  const std::vector<const JointRow*> rows = chosen();
  if (!table_) {
    details_->setText(tr("Not looked for yet."));
  } else if (rows.size() != 1) {
    details_->setText(jointsSummary(*table_));
  } else {
    QStringList facts = jointEvidence(*rows.front());
    const QString drive = driveText(rows.front()->joint);
    if (!drive.isEmpty()) facts << tr("drive: %1").arg(drive);
    details_->setText(facts.join(tr("; ")));
  }
}

}  // namespace glissade
