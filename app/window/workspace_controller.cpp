#include "app/window/workspace_controller.h"

#include <QActionGroup>
#include <QHBoxLayout>
#include <QMenuBar>
#include <QToolButton>

#include "engine/files/scenario_product.h"

namespace glissade {

WorkspaceController::WorkspaceController(const Workbench& bench, PanelDocks& docks)
    : QObject(&bench.window), bench_(bench), docks_(docks) {
  auto* group = new QActionGroup(this);
  for (const Workspace workspace : kWorkspaces) {
    QAction* action = group->addAction(bench.actions[kWorkspaceActions.of(workspace)]);
    action->setChecked(workspace == docks.workspace());
    connect(action, &QAction::toggled, this, [this, workspace](bool chosen) {
      if (chosen) docks_.show(workspace);
    });
  }
  addSwitch();
  connect(&bench.document, &WorkbenchDocument::changedForView, this, &WorkspaceController::follow);
}

void WorkspaceController::addSwitch() {
  auto* buttons = new QWidget(bench_.window.menuBar());
  buttons->setObjectName(QStringLiteral("workspaces"));
  buttons->setStyleSheet(QStringLiteral("QToolButton { padding: 1px 10px; margin: 0; }"));  // as high as the menus
  auto* row = new QHBoxLayout(buttons);
  row->setContentsMargins(0, 0, 6, 0);
  row->setSpacing(0);
  for (const Workspace workspace : kWorkspaces) {
    auto* button = new QToolButton(buttons);
    button->setDefaultAction(bench_.actions[kWorkspaceActions.of(workspace)]);
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    button->setFocusPolicy(Qt::TabFocus);
    row->addWidget(button);
  }
  bench_.window.menuBar()->setCornerWidget(buttons);
}

/// A study shows its runs in the workspace where it is.
void WorkspaceController::follow(Changes what) {
  if (!(what & Change::Scenario) || bench_.document.isTemporary()) return;
  const bool isProduct = isAboutProduct(bench_.document.scenario()->scenario);
  bench_.actions[kWorkspaceActions.of(isProduct ? Workspace::Assembly : Workspace::Planning)]->setChecked(true);
  if (isProduct) docks_.bringForward("sequence");
}

}  // namespace glissade
