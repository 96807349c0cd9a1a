#include "widgets/panels/scene_panel.h"

#include <QHeaderView>
#include <QLocale>
#include <QPixmap>

namespace glissade {
namespace {

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
}

QTreeWidgetItem* ScenePanel::addGroup(const QString& title) {
  auto* group = new QTreeWidgetItem(this, {title});
  group->setFirstColumnSpanned(true);
  group->setExpanded(true);
  return group;
}

void ScenePanel::addBody(QTreeWidgetItem& group, const RigidBody& body, const QString& kind) {
  const auto triangles = static_cast<qulonglong>(body.mesh->triangles.size());
  auto* item = new QTreeWidgetItem(&group, {QString::fromStdString(body.name), kind, QLocale().toString(triangles)});
  item->setIcon(0, swatch(body.colour));
  item->setTextAlignment(2, Qt::AlignRight | Qt::AlignVCenter);
  item->setToolTip(0, QString::fromStdString(body.id));
}

void ScenePanel::setScenario(const LoadedScenario& scenario) {
  clear();
  QTreeWidgetItem* object = addGroup(tr("Object"));
  addBody(*object, scenario.object, tr("moved"));
  const Pose* goal = std::get_if<Pose>(&scenario.problem.goal);
  for (const QString& text : {tr("start  %1").arg(place(scenario.problem.start)),
                              tr("goal  %1").arg(goal != nullptr ? place(*goal) : tr("out"))}) {
    (new QTreeWidgetItem(object, {text}))->setFirstColumnSpanned(true);
  }
  QTreeWidgetItem* bodies = addGroup(tr("Obstacles"));
  for (const RigidBody& body : scenario.obstacles) {
    addBody(*bodies, body, body.mobility == Mobility::Static ? tr("static") : tr("mobile"));
  }
}

}  // namespace glissade
