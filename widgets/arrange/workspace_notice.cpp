#include "widgets/arrange/workspace_notice.h"

#include <algorithm>
#include <map>
#include <utility>

#include "widgets/workbench/arranged_item.h"

namespace glissade {

WorkspaceNotice::WorkspaceNotice(const Workbench& bench)
    : QObject(&bench.window),
      bench_(bench),
      bar_(new NoticeBar(bench.actions, bench.scene.widget(), kRoomForViewCube)) {
  connect(&bench.document, &WorkbenchDocument::changed, this, &WorkspaceNotice::followDocument);
  connect(bar_, &NoticeBar::closed, this, [this] { bench_.scene.widget()->setFocus(); });
  addCommands();
}

/// Finds bodies that lie wholly outside of the workspace, and ends of the motion whose reference point is outside.
std::vector<WorkspaceNotice::Outside> WorkspaceNotice::findOutside(const LoadedScenario& scenario) {
  const Box3& workspace = scenario.problem.bounds;
  std::vector<Outside> outside;
  const auto add = [&](const AssemblyItem& item, bool inside) {
    const auto X_WB = poseOf(scenario.scenario, item);
    if (X_WB && !inside) outside.push_back({item, *X_WB});
  };
  std::map<BodyId, bool> inside;  // by body; a body of several parts is inside if one part is
  for (const RigidBody& body : scenario.obstacles) {
    inside[bodyIdOf(body.id)] |= workspace.intersects(boundingBox(*body.mesh, body.X_WB));
  }
  for (const auto& [id, isInside] : inside) add({AssemblyItem::Kind::Body, id}, isInside);
  const Pose* goal = std::get_if<Pose>(&scenario.problem.goal);
  add({AssemblyItem::Kind::Start, {}}, workspace.contains(scenario.problem.start.position));
  add({AssemblyItem::Kind::Goal, {}}, goal == nullptr || workspace.contains(goal->position));
  return outside;
}

void WorkspaceNotice::followDocument(Changes what) {
  if (!(what & (Change::Scenario | Change::Arrangement))) return;
  const std::vector<Outside> before = std::exchange(known_, findOutside(*bench_.document.scenario()));
  const bool stays =
      std::any_of(known_.begin(), known_.end(), [this](const Outside& now) { return now.item == told_; });
  if (!stays || (what & Change::Scenario)) bar_->hide();
  if (what & Change::Scenario) return;
  for (const Outside& now : known_) {
    if (std::find(before.begin(), before.end(), now) == before.end()) tell(now.item);
  }
}

void WorkspaceNotice::tell(const AssemblyItem& item) {
  Notice notice{{}, tr("No run can start there. Undo, or fit the workspace."), {"assembly.fit-workspace", "edit.undo"}};
  switch (item.kind) {
    case AssemblyItem::Kind::Start: notice.title = tr("The start is outside of the workspace now."); break;
    case AssemblyItem::Kind::Goal: notice.title = tr("The goal is outside of the workspace now."); break;
    case AssemblyItem::Kind::Body:
      notice.title = tr("%1 is outside of the workspace now.")
                         .arg(QLatin1Char('\'') + nameOf(item, *bench_.document.scenario()) + QLatin1Char('\''));
      notice.details = tr("The object cannot reach it. Undo, or fit the workspace.");
      break;
  }
  told_ = item;
  bar_->showNotice(notice);
}

void WorkspaceNotice::addCommands() {
  bench_.scripts.add("expect-outside", 1, [this](const ScriptCommands::Words& words) -> Outcome {
    const std::string title = bar_->isVisible() ? bar_->notice().title.toStdString() : "none";
    if (title.find(words[0]) != std::string::npos) return Done{};
    return unmetExpectation("what is outside of the workspace: '" + title + "', not '" + words[0] + "'");
  });
}

}  // namespace glissade
