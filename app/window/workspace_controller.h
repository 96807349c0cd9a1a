#pragma once

#include <QWidget>

#include "widgets/workbench/panel_docks.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

/// The switch between the workspaces, at the right of the menus. A product opens in the workspace of assemblies,
/// another scenario in that of path planning.
class WorkspaceController final : public QObject {
  Q_OBJECT

 public:
  WorkspaceController(const Workbench& bench, PanelDocks& docks);

 private:
  void addSwitch();
  void follow(Changes what);

  const Workbench& bench_;
  PanelDocks& docks_;
};

}  // namespace glissade
