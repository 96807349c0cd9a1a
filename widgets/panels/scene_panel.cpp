#include "widgets/panels/scene_panel.h"

#include <QHeaderView>
#include <QLocale>
#include <QPixmap>
#include <QSignalBlocker>

namespace glissade {
namespace {

constexpr int kIdRole = Qt::UserRole;

QIcon swatch(const Colour& colour) {
  QPixmap pixmap(14, 14);
  pixmap.fill(QColor::fromRgbF(colour[0], colour[1], colour[2]));
  return pixmap;
}

QString place(const Pose& pose) {
  const QLocale locale;
  QStringList numbers;
  for (int i = 0; i < 3; ++i) numbers << locale.toString(pose.position[i], 'f', 2);
  return numbers.join(QStringLiteral("  ")) + QStringLiteral(" m");
}

}  // namespace

ScenePanel::ScenePanel(QWidget* parent) : QTreeWidget(parent) {
  setColumnCount(3);
  setHeaderLabels({tr("Body"), tr("Kind"), tr("Triangles")});
  setRootIsDecorated(true);
  setUniformRowHeights(true);
  setAlternatingRowColors(true);
  header()->setStretchLastSection(false);
  header()->setSectionResizeMode(0, QHeaderView::Stretch);
  header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
  connect(this, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item) {
    if (item->parent() != obstacles_ || obstacles_ == nullptr) return;
    emit bodyChecked(item->data(0, kIdRole).toString(), item->checkState(0) == Qt::Checked);
  });
}

QTreeWidgetItem* ScenePanel::addGroup(const QString& title) {
  auto* group = new QTreeWidgetItem(this, {title});
  group->setFirstColumnSpanned(true);
  group->setExpanded(true);
  return group;
}

QTreeWidgetItem* ScenePanel::addBody(QTreeWidgetItem& group, const RigidBody& body, const QString& kind) {
  const auto triangles = static_cast<qulonglong>(body.mesh->triangles.size());
  auto* item = new QTreeWidgetItem(&group, {QString::fromStdString(body.name), kind, QLocale().toString(triangles)});
  item->setIcon(0, swatch(body.colour));
  item->setTextAlignment(2, Qt::AlignRight | Qt::AlignVCenter);
  item->setToolTip(0, QString::fromStdString(body.id));
  item->setData(0, kIdRole, QString::fromStdString(body.id));
  return item;
}

void ScenePanel::setScenario(const LoadedScenario& scenario) {
  const QSignalBlocker block(this);
  clear();
  QTreeWidgetItem* object = addGroup(tr("Object"));
  addBody(*object, scenario.object, tr("moved"));
  const Pose* goal = std::get_if<Pose>(&scenario.problem.goal);
  for (const QString& text : {tr("start  %1").arg(place(scenario.problem.start)),
                              tr("goal  %1").arg(goal != nullptr ? place(*goal) : tr("out"))}) {
    (new QTreeWidgetItem(object, {text}))->setFirstColumnSpanned(true);
  }
  obstacles_ = addGroup(tr("Obstacles"));
  for (const RigidBody& body : scenario.obstacles) {
    QTreeWidgetItem* item = addBody(*obstacles_, body, body.mobility == Mobility::Static ? tr("static") : tr("mobile"));
    item->setCheckState(0, Qt::Checked);
    item->setToolTip(0, tr("%1: drawn while the box is checked").arg(item->toolTip(0)));
  }
}

void ScenePanel::setHiddenBodies(const std::set<std::string>& bodyIds) {
  const QSignalBlocker block(this);
  for (int i = 0; obstacles_ != nullptr && i < obstacles_->childCount(); ++i) {
    QTreeWidgetItem* item = obstacles_->child(i);
    const bool hidden = bodyIds.count(item->data(0, kIdRole).toString().toStdString()) != 0;
    item->setCheckState(0, hidden ? Qt::Unchecked : Qt::Checked);
  }
  viewport()->update();
}

}  // namespace glissade
