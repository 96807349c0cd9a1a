#include "widgets/product/scene_panel.h"

#include <QEvent>
#include <QHeaderView>
#include <QLocale>
#include <QSignalBlocker>

#include "engine/files/placement_points.h"
#include "engine/files/scenario_bodies.h"
#include "engine/files/scenario_product.h"
#include "widgets/controls/body_id_text.h"
#include "widgets/controls/cell_delegates.h"
#include "widgets/controls/colour_swatch.h"
#include "widgets/controls/length_text.h"

namespace glissade {
namespace {

constexpr int kBodyRole = Qt::UserRole;     // id of a body
constexpr int kEndRole = Qt::UserRole + 1;  // AssemblyItem::Kind of start or goal
constexpr int kObstacleRole = Qt::UserRole + 2;
constexpr int kLeftOutRole = Qt::UserRole + 3;  // id of a body that is left out
constexpr int kNameRole = Qt::UserRole + 4;     // name of a body, as it is shown

QIcon swatch(const Colour& colour) { return colourSwatch(QColor::fromRgbF(colour[0], colour[1], colour[2])); }

QString place(const Vector3& at) { return lengthsText({at.x(), at.y(), at.z()}, QStringLiteral("  ")); }

bool isObstacle(const QTreeWidgetItem* item) { return item->data(0, kObstacleRole).toBool(); }

/// Hides items without an obstacle of that name; an assembly whose own name matches is shown as a whole.
bool filterUnder(QTreeWidgetItem& item, const QString& text, bool matched) {
  const bool matches = matched || item.text(0).contains(text, Qt::CaseInsensitive);
  bool any = item.childCount() == 0 && matches;
  for (int i = 0; i < item.childCount(); ++i) any = filterUnder(*item.child(i), text, matches) || any;
  item.setHidden(!any);
  return any;
}

/// Lets a person edit the name of a body of the scenario. A link of a URDF file has the name that the file gives it.
void allowRenaming(QTreeWidgetItem& item) {
  const BodyId id = toBodyId(item.data(0, kBodyRole).toString());
  if (bodyIdOf(id) != id) return;
  item.setData(0, kNameRole, item.text(0));
  item.setFlags(item.flags() | Qt::ItemIsEditable);
}

/// Collects the body of an item, or all bodies under an assembly.
void collectBodies(const QTreeWidgetItem& item, QSet<QString>& bodies) {
  const QVariant id = item.data(0, kBodyRole);
  if (id.isValid()) bodies.insert(id.toString());
  for (int i = 0; i < item.childCount(); ++i) collectBodies(*item.child(i), bodies);
}

}  // namespace

ScenePanel::ScenePanel(QWidget* parent) : QTreeWidget(parent) {
  setObjectName(QStringLiteral("bodies"));
  setAccessibleName(tr("Bodies"));
  setColumnCount(3);
  setHeaderLabels({tr("Body"), tr("Kind"), tr("Triangles")});
  setRootIsDecorated(true);
  setUniformRowHeights(true);
  setAlternatingRowColors(true);
  setTextElideMode(Qt::ElideMiddle);
  setItemDelegateForColumn(0, new NameDelegate(0, this));
  setSelectionMode(QAbstractItemView::ExtendedSelection);
  header()->setStretchLastSection(false);
  header()->setSectionResizeMode(0, QHeaderView::Stretch);
  header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
  setEditTriggers(QAbstractItemView::EditKeyPressed);
  connect(this, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item) {
    if (item->data(0, kNameRole).isValid() && item->text(0) != item->data(0, kNameRole)) {
      const QString name = item->text(0);
      {
        const QSignalBlocker block(this);
        item->setText(0, item->data(0, kNameRole).toString());  // until the scenario has the other name
      }
      emit bodyRenamed(item->data(0, kBodyRole).toString(), name.trimmed());
      return;
    }
    if (!isObstacle(item)) return;
    emit bodyChecked(item->data(0, kBodyRole).toString(), item->checkState(0) == Qt::Checked);
  });
  connect(this, &QTreeWidget::itemSelectionChanged, this, &ScenePanel::takeSelection);
}

void ScenePanel::resizeEvent(QResizeEvent* event) {
  constexpr int kWideInLetters = 55;
  constexpr int kTriangles = 2;
  setColumnHidden(kTriangles, width() < kWideInLetters * fontMetrics().averageCharWidth());
  QTreeWidget::resizeEvent(event);
}

QTreeWidgetItem* ScenePanel::addGroup(const QString& title) {
  auto* group = new QTreeWidgetItem(this, {title});
  group->setFirstColumnSpanned(true);
  group->setExpanded(true);
  group->setFlags(Qt::ItemIsEnabled);
  return group;
}

QTreeWidgetItem* ScenePanel::addEnd(QTreeWidgetItem& group, const QString& text, AssemblyItem::Kind end) {
  auto* item = new QTreeWidgetItem(&group, {text});
  item->setFirstColumnSpanned(true);
  item->setToolTip(0, tr("Where the origin of the object's file is then"));
  item->setData(0, kEndRole, static_cast<int>(end));
  return item;
}

QTreeWidgetItem* ScenePanel::addBody(QTreeWidgetItem& group, const RigidBody& body, const QString& kind) {
  const auto triangles = static_cast<qulonglong>(body.mesh->triangles.size());
  auto* item = new QTreeWidgetItem(&group, {QString::fromStdString(body.shown()), kind, QLocale().toString(triangles)});
  item->setIcon(0, swatch(body.colour));
  item->setTextAlignment(2, Qt::AlignRight | Qt::AlignVCenter);
  item->setToolTip(0, toQString(body.id));
  item->setData(0, kBodyRole, toQString(body.id));
  allowRenaming(*item);
  return item;
}

void ScenePanel::setScenario(const LoadedScenario& scenario) {
  const QSignalBlocker block(this);
  clear();
  const bool isProduct = isAboutProduct(scenario.scenario);
  QTreeWidgetItem* object = addGroup(isProduct ? tr("Moving part of Find path") : tr("Object"));
  for (const RigidBody& body : scenario.objectBodies) addBody(*object, body, tr("moving part"));
  // The point is the one that the placement shows unless a person chooses another.
  const Vector3 point = placementPoints(scenario, {AssemblyItem::Kind::Start, {}}).fileOrigin;
  const Pose* goal = std::get_if<Pose>(&scenario.problem.goal);
  addEnd(*object, tr("start  %1").arg(place(scenario.problem.start * point)), AssemblyItem::Kind::Start);
  addEnd(*object, tr("goal  %1").arg(goal != nullptr ? place(*goal * point) : tr("removed")), AssemblyItem::Kind::Goal);
  obstacles_ = addGroup(isProduct ? tr("Other parts") : tr("Obstacles"));
  addObstacles(scenario);
  addLeftOut(scenario.scenario);
  showDeflections(scenario);
}

void ScenePanel::addLeftOut(const Scenario& scenario) {
  if (scenario.leftOut.empty()) return;
  QTreeWidgetItem* group = addGroup(tr("Excluded"));
  const std::vector<std::string> shown = shownLeftOut(scenario);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const BodyDescription& body = scenario.leftOut[i];
    auto* item = new QTreeWidgetItem(group, {QString::fromStdString(shown[i]), tr("excluded")});
    item->setToolTip(
        0, tr("%1: part of the product's file, and not of this product").arg(QString::fromStdString(body.name)));
    item->setData(0, kLeftOutRole, toQString(body.id));
  }
}

bool ScenePanel::chooseLeftOut(const BodyId& bodyId) {
  for (QTreeWidgetItemIterator item(this); *item != nullptr; ++item) {
    if (toBodyId((*item)->data(0, kLeftOutRole).toString()) != bodyId) continue;
    clearSelection();
    (*item)->setSelected(true);
    return true;
  }
  return false;
}

void ScenePanel::editName() {
  const QList<QTreeWidgetItem*> selected = selectedItems();
  if (!selected.isEmpty()) editItem(selected.front(), 0);
}

std::vector<BodyId> ScenePanel::chosenLeftOut() const {
  std::vector<BodyId> ids;
  for (const QTreeWidgetItem* item : selectedItems()) {
    const QVariant id = item->data(0, kLeftOutRole);
    if (id.isValid()) ids.push_back(toBodyId(id.toString()));
  }
  return ids;
}

/// Adds the obstacles under the nodes of the product that contain them. A body that is no node is at the top.
void ScenePanel::addObstacles(const LoadedScenario& scenario) {
  const std::vector<Product::Node>& nodes = scenario.product.nodes();
  const std::vector<std::string> names = scenario.product.shownNames();
  std::vector<const RigidBody*> bodies(nodes.size(), nullptr);
  std::vector<bool> shown(nodes.size(), false);
  for (const RigidBody& body : scenario.obstacles) {
    auto node = scenario.product.find(body.id.text());
    if (node) bodies[*node] = &body;
    for (; node && !shown[*node]; node = nodes[*node].parent) shown[*node] = true;
  }
  std::vector<QTreeWidgetItem*> items(nodes.size(), nullptr);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!shown[i]) continue;
    QTreeWidgetItem& parent = nodes[i].parent ? *items[*nodes[i].parent] : *obstacles_;
    const QString name = QString::fromStdString(names[i]);
    items[i] = bodies[i] != nullptr ? addObstacle(parent, *bodies[i], name)
                                    : addAssembly(parent, name, QString::fromStdString(nodes[i].path));
  }
  for (const RigidBody& body : scenario.obstacles) {
    if (!scenario.product.find(body.id.text())) addObstacle(*obstacles_, body, {});
  }
}

QTreeWidgetItem* ScenePanel::addObstacle(QTreeWidgetItem& parent, const RigidBody& body, const QString& name) {
  QTreeWidgetItem* item = addBody(parent, body, body.mobility == Mobility::Static ? tr("static") : tr("mobile"));
  if (!name.isEmpty()) item->setText(0, name);
  allowRenaming(*item);
  item->setData(0, kObstacleRole, true);
  item->setCheckState(0, Qt::Checked);
  item->setToolTip(0, tr("%1: drawn while the box is checked").arg(item->toolTip(0)));
  return item;
}

QTreeWidgetItem* ScenePanel::addAssembly(QTreeWidgetItem& parent, const QString& name, const QString& path) {
  auto* assembly = new QTreeWidgetItem(&parent, {name});
  assembly->setFlags(assembly->flags() | Qt::ItemIsAutoTristate | Qt::ItemIsUserCheckable);
  assembly->setToolTip(0, path);
  assembly->setExpanded(true);
  return assembly;
}

std::vector<QTreeWidgetItem*> ScenePanel::obstacleItems() const {
  std::vector<QTreeWidgetItem*> items;
  for (QTreeWidgetItemIterator item(obstacles_); obstacles_ != nullptr && *item != nullptr; ++item) {
    if (isObstacle(*item)) items.push_back(*item);
  }
  return items;
}

void ScenePanel::changeEvent(QEvent* event) {
  QTreeWidget::changeEvent(event);
  if (event->type() == QEvent::LocaleChange) emit lengthUnitChanged();
}

void ScenePanel::setFilter(const QString& text) {
  for (int i = 0; obstacles_ != nullptr && i < obstacles_->childCount(); ++i) {
    filterUnder(*obstacles_->child(i), text, false);
  }
}

/// Shows the distance of the triangles of STEP parts from their surfaces.
void ScenePanel::showDeflections(const LoadedScenario& scenario) {
  for (QTreeWidgetItemIterator item(this); *item != nullptr; ++item) {
    const auto known = scenario.deflections.find(toBodyId((*item)->data(0, kBodyRole).toString()));
    if (known == scenario.deflections.end()) continue;
    (*item)->setToolTip(2, tr("CAD accuracy ± %1").arg(lengthText(known->second)));
  }
}

void ScenePanel::setHiddenBodies(const std::set<BodyId>& bodyIds) {
  const QSignalBlocker block(this);
  for (QTreeWidgetItem* item : obstacleItems()) {
    const bool hidden = bodyIds.count(toBodyId(item->data(0, kBodyRole).toString())) != 0;
    item->setCheckState(0, hidden ? Qt::Unchecked : Qt::Checked);
  }
  viewport()->update();
}

void ScenePanel::showSelection(const QSet<QString>& bodyIds, const std::optional<AssemblyItem>& chosen) {
  const QSignalBlocker block(this);
  for (QTreeWidgetItemIterator item(this); *item != nullptr; ++item) {
    if ((*item)->data(0, kLeftOutRole).isValid()) continue;
    const QVariant id = (*item)->data(0, kBodyRole);
    const QVariant end = (*item)->data(0, kEndRole);
    const bool isChosenEnd = end.isValid() && chosen && static_cast<int>(chosen->kind) == end.toInt();
    (*item)->setSelected(isChosenEnd || (id.isValid() && bodyIds.contains(id.toString())));
    // An assembly counts as selected if all of its bodies are.
    if (id.isValid() || end.isValid() || (*item)->parent() == nullptr) continue;
    QSet<QString> bodies;
    collectBodies(**item, bodies);
    (*item)->setSelected(bodyIds.contains(bodies));
  }
  const QList<QTreeWidgetItem*> selected = selectedItems();
  const auto isSeen = [this](const QTreeWidgetItem* item) {
    return visualItemRect(item).intersects(viewport()->rect());
  };
  if (!selected.isEmpty() && std::none_of(selected.begin(), selected.end(), isSeen)) scrollToItem(selected.front());
  viewport()->update();
}

/// Takes the selection. A start or goal counts without bodies only: the row of the start is selected with the moving
/// part.
void ScenePanel::takeSelection() {
  QSet<QString> bodies;
  QVariant end;
  for (const QTreeWidgetItem* item : selectedItems()) {
    if (item->data(0, kEndRole).isValid()) end = item->data(0, kEndRole);
    collectBodies(*item, bodies);
  }
  if (bodies.isEmpty() && end.isValid()) {
    emit endChosen(static_cast<AssemblyItem::Kind>(end.toInt()));
  } else {
    emit bodiesChosen(bodies);
  }
}

}  // namespace glissade
