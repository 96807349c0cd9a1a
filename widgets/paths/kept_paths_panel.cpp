#include "widgets/paths/kept_paths_panel.h"

#include <QEvent>
#include <QHeaderView>
#include <QLocale>
#include <QPixmap>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <numbers>

#include "engine/planning/planner.h"
#include "widgets/controls/body_id_text.h"
#include "widgets/controls/diagnostic_text.h"
#include "widgets/controls/length_text.h"

namespace glissade {
namespace {

enum KeptColumn { PathName, Proof, Clearance, Length, Turns, Strategy, Seed, Allowances, KeptColumnCount };

constexpr int kNameRole = Qt::UserRole + 1;
constexpr std::array<QRgb, 6> kPathColours{0xff0072b2, 0xffcc79a7, 0xff009e73, 0xffe69f00, 0xff56b4e9, 0xffd55e00};

QString nameOf(const QTreeWidgetItem& item) { return item.data(PathName, kNameRole).toString(); }

Path asPath(const KeptPath& kept) { return {kept.points, {}}; }

QIcon swatch(const QColor& colour) {
  QPixmap pixmap(12, 12);
  pixmap.fill(colour);
  return QIcon(pixmap);
}

QString allowanceTip(const KeptPath& path) {
  QStringList lines;
  for (const auto& allowance : path.allowances) {
    const QString body = toQString(allowance.body);
    const QString length = lengthText(allowance.allowance);
    if (allowance.hollow) {
      lines << KeptPathsPanel::tr("accepted clash with %1, %2 deep").arg(body, length);
      continue;
    }
    lines << (allowance.yields ? KeptPathsPanel::tr("Allowance: %2 on %1, which gives way").arg(body, length)
                               : KeptPathsPanel::tr("Allowance: %1 on %2").arg(length, body));
  }
  return lines.join(QLatin1Char('\n'));
}

QString proofTip(KeptPathState state) {
  switch (state) {
    case KeptPathState::Unknown: return KeptPathsPanel::tr("The path is certified again in the background.");
    case KeptPathState::Holds: return KeptPathsPanel::tr("Certified again in the scenario as it is now.");
    case KeptPathState::Blocked:
      return KeptPathsPanel::tr("Not certified: the scenario was changed, and a body is in the way.");
    case KeptPathState::OtherEnds:
      return KeptPathsPanel::tr("Free of penetration, but it no longer leads from the start pose to the goal pose.");
    case KeptPathState::OtherObject: break;
  }
  return KeptPathsPanel::tr("Not certified: another body is the moving part now.");
}

void fillRow(QTreeWidgetItem& item, const KeptPathRow& row) {
  const KeptPath& path = *row.path;
  const Path way = asPath(path);
  item.setText(PathName, QString::fromStdString(path.name));
  item.setText(Proof, proofText(row.proof));
  item.setToolTip(Proof, proofTip(row.proof.state));
  item.setText(Clearance, path.clearance < 0.0 ? QStringLiteral("–") : columnLengthText(path.clearance));
  item.setToolTip(Clearance, KeptPathsPanel::tr("certified %1, required %2")
                                 .arg(lengthText(path.provedClearance), lengthText(path.requiredClearance)));
  item.setText(Length, lengthText(way.length()));
  item.setText(Turns, QLocale().toString(way.rotation() * 180.0 / std::numbers::pi, 'f', 0) + QStringLiteral("°"));
  item.setText(Strategy, strategyName(path.provenance.planner));
  if (!path.provenance.planner.empty()) item.setText(Seed, QString::number(path.provenance.seed));
  if (!path.allowances.empty()) item.setText(Allowances, QString::number(path.allowances.size()));
  item.setToolTip(Allowances, allowanceTip(path));
  for (const int column : {Clearance, Length, Turns, Seed, Allowances}) {
    item.setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
  }
}

}  // namespace

QColor keptPathColour(std::size_t index) { return QColor(kPathColours[index % kPathColours.size()]); }

QString strategyName(const std::string& plannerId) {
  if (plannerId.empty()) return KeptPathsPanel::tr("unknown");
  const PlannerRegistry planners = makePlannerRegistry();
  const PlannerEntry* entry = planners.find(plannerId);
  if (entry == nullptr) return QString::fromStdString(plannerId);
  return engineText(entry->label);
}

QString proofText(const KeptPathProof& proof) {
  switch (proof.state) {
    case KeptPathState::Unknown: return QStringLiteral("… ") + KeptPathsPanel::tr("not certified yet");
    case KeptPathState::Holds: return QStringLiteral("✓ ") + KeptPathsPanel::tr("certified");
    case KeptPathState::Blocked:
      return QStringLiteral("✗ ") + (proof.blockedBy.empty()
                                         ? KeptPathsPanel::tr("blocked")
                                         : KeptPathsPanel::tr("blocked by %1").arg(toQString(proof.blockedBy)));
    case KeptPathState::OtherEnds: return QStringLiteral("✗ ") + KeptPathsPanel::tr("other ends");
    case KeptPathState::OtherObject: break;
  }
  return QStringLiteral("✗ ") + KeptPathsPanel::tr("other object");
}

KeptPathsPanel::KeptPathsPanel(const ActionCatalogue& actions, QWidget* parent)
    : QWidget(parent), summary_(new QLabel(this)), table_(new QTreeWidget(this)) {
  summary_->setWordWrap(true);
  table_->setObjectName(QStringLiteral("kept-paths"));
  table_->setColumnCount(KeptColumnCount);
  table_->setHeaderLabels({tr("Name"), tr("Certificate"), tr("Clearance"), tr("Length"), tr("Turns"), tr("Strategy"),
                           tr("Seed"), tr("Allowances")});
  table_->setRootIsDecorated(false);
  table_->setUniformRowHeights(true);
  table_->setAlternatingRowColors(true);
  table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setTextElideMode(Qt::ElideMiddle);
  table_->setAccessibleName(tr("Kept paths"));
  table_->header()->setStretchLastSection(false);
  table_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->setContextMenuPolicy(Qt::ActionsContextMenu);
  for (const char* id : {"paths.open", "paths.compare", "paths.rename", "paths.pin", "paths.remove"}) {
    table_->addAction(actions[QLatin1String(id)]);
  }
  auto* row = makeActionRow(
      actions, {"paths.keep", "paths.open", "paths.compare", "paths.rename", "paths.pin", "paths.remove"}, this);
  for (int i = 0; i < row->count(); ++i) {
    auto* button = qobject_cast<QToolButton*>(row->itemAt(i)->widget());
    if (button == nullptr) continue;
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    button->setMinimumWidth(2 * button->iconSize().width());
  }
  auto* column = new QVBoxLayout(this);
  column->addWidget(summary_);
  column->addLayout(row);
  column->addWidget(table_, 1);
  connect(table_, &QTreeWidget::itemSelectionChanged, this, &KeptPathsPanel::selectionChanged);
  connect(table_, &QTreeWidget::itemChanged, this, &KeptPathsPanel::takeChange);
  connect(table_, &QTreeWidget::itemActivated, this,
          [this](QTreeWidgetItem* item) { emit activated(nameOf(*item).toStdString()); });
  setRows({}, false);
}

void KeptPathsPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LocaleChange) emit lengthUnitChanged();
}

void KeptPathsPanel::setRows(const std::vector<KeptPathRow>& rows, bool unkept) {
  const std::vector<std::string> before = selected();
  {
    const QSignalBlocker block(table_);
    table_->clear();
    for (std::size_t i = 0; i < rows.size(); ++i) {
      auto* item = new QTreeWidgetItem(table_);
      item->setFlags(item->flags() | Qt::ItemIsUserCheckable | Qt::ItemIsEditable);
      item->setData(PathName, kNameRole, QString::fromStdString(rows[i].path->name));
      item->setCheckState(PathName, rows[i].shown ? Qt::Checked : Qt::Unchecked);
      item->setToolTip(PathName, tr("Checked: drawn in this colour beside the others"));
      item->setIcon(PathName, swatch(keptPathColour(i)));
      fillRow(*item, rows[i]);
      QFont font = item->font(PathName);
      font.setBold(rows[i].current);
      item->setFont(PathName, font);
      if (rows[i].path->pinned) item->setText(PathName, QStringLiteral("★ ") + item->text(PathName));
      const std::string& name = rows[i].path->name;
      item->setSelected(std::find(before.begin(), before.end(), name) != before.end());
    }
  }
  summary_->setText(unkept         ? tr("The path that was found is not kept yet: Keep (Ctrl+Alt+K) or Save (Ctrl+S).")
                    : rows.empty() ? tr("No path is kept yet. A path that is found can be kept in the scenario.")
                                   : tr("Kept in the scenario: %1").arg(rows.size()));
  emit selectionChanged();
}

std::vector<std::string> KeptPathsPanel::selected() const {
  std::vector<std::string> names;
  for (int i = 0; i < table_->topLevelItemCount(); ++i) {
    const QTreeWidgetItem& item = *table_->topLevelItem(i);
    if (item.isSelected()) names.push_back(nameOf(item).toStdString());
  }
  return names;
}

bool KeptPathsPanel::select(const std::string& name) {
  for (int i = 0; i < table_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = table_->topLevelItem(i);
    if (nameOf(*item).toStdString() != name) continue;
    table_->setCurrentItem(item);
    return true;
  }
  return false;
}

void KeptPathsPanel::editName() {
  const auto items = table_->selectedItems();
  if (items.size() != 1) return;
  {
    const QSignalBlocker block(table_);
    items.front()->setText(PathName, nameOf(*items.front()));  // without the star
  }
  table_->setFocus();
  table_->editItem(items.front(), PathName);
}

/// Takes a check box that was clicked, or a name that was typed.
void KeptPathsPanel::takeChange(QTreeWidgetItem* item, int column) {
  if (column != PathName) return;
  const std::string name = nameOf(*item).toStdString();
  QString typed = item->text(PathName);
  if (typed.startsWith(QStringLiteral("★ "))) typed.remove(0, 2);
  if (typed.toStdString() != name) {
    emit renamed(name, typed.trimmed().toStdString());
  } else {
    emit shownChanged(name, item->checkState(PathName) == Qt::Checked);
  }
}

}  // namespace glissade
