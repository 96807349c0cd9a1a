#include "app/window/workspace_notice.h"

#include <algorithm>

#include "app/window/arranged_item.h"

namespace glissade {
namespace {

/// Room for the view cube.
constexpr int kCubeWidth = 104;

/// Bodies of which nothing lies in the workspace, and ends of the motion whose reference point does not.
std::vector<AssemblyItem> itemsOutside(const LoadedScenario& scenario) {
  const Box3& workspace = scenario.problem.bounds;
  std::vector<AssemblyItem> outside;
  for (const RigidBody& body : scenario.obstacles) {
    const AssemblyItem item{AssemblyItem::Kind::Body, bodyIdOf(body.id)};
    if (workspace.intersects(boundingBox(*body.mesh, body.X_WB))) continue;
    if (std::find(outside.begin(), outside.end(), item) == outside.end()) outside.push_back(item);
  }
  for (const auto kind : {AssemblyItem::Kind::Start, AssemblyItem::Kind::Goal}) {
    const auto X_WB = poseOf(scenario.scenario, {kind, {}});
    if (X_WB && !workspace.contains(X_WB->position)) outside.push_back({kind, {}});
  }
  return outside;
}

}  // namespace

WorkspaceNotice::WorkspaceNotice(const Workbench& bench)
    : QObject(&bench.window), bench_(bench), bar_(new NoticeBar(bench.actions, bench.scene.widget(), kCubeWidth)) {
  connect(&bench.document, &WorkbenchDocument::changed, this, &WorkspaceNotice::followDocument);
  connect(bar_, &NoticeBar::closed, this, [this] { bench_.scene.widget()->setFocus(); });
  addCommands();
}

/// What was outside already, and was not moved, is not told again.
void WorkspaceNotice::followDocument(Changes what) {
  if (!(what & (Change::Scenario | Change::Arrangement))) return;
  const ScenarioPtr before = std::exchange(before_, bench_.document.scenario());
  if (what & Change::Scenario) {
    bar_->hide();
    return;
  }
  const std::vector<AssemblyItem> outside = itemsOutside(*before_);
  if (outside.empty()) bar_->hide();
  for (const AssemblyItem& item : outside) {
    if (poseOf(before->scenario, item) == poseOf(before_->scenario, item)) continue;
    bar_->showNotice(
        {item.kind == AssemblyItem::Kind::Body
             ? tr("%1 is outside of the workspace now.").arg(QLatin1Char('\'') + nameOf(item) + QLatin1Char('\''))
             : (item.kind == AssemblyItem::Kind::Start ? tr("The start is outside of the workspace now.")
                                                       : tr("The goal is outside of the workspace now.")),
         item.kind == AssemblyItem::Kind::Body ? tr("The object does not get there. Undo, or fit the workspace.")
                                               : tr("A run is refused there. Undo, or fit the workspace."),
         {"assembly.fit-workspace", "edit.undo"}});
  }
}

void WorkspaceNotice::addCommands() {
  bench_.scripts.add("expect-outside", 1, [this](const ScriptCommands::Words& words) -> Outcome {
    const std::string title = bar_->isVisible() ? bar_->notice().title.toStdString() : "none";
    if (title.find(words[0]) != std::string::npos) return Done{};
    return unmetExpectation("what is outside of the workspace: '" + title + "', not '" + words[0] + "'");
  });
}

}  // namespace glissade
