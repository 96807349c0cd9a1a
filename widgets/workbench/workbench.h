#pragma once

#include <memory>

#include "engine/base/version_text.h"
#include "engine/files/fits_cache.h"
#include "engine/sequence/product_finder.h"
#include "widgets/controls/action_catalogue.h"
#include "widgets/document/session_bridge.h"
#include "widgets/document/workbench_document.h"
#include "widgets/scene3d/scene_widget.h"
#include "widgets/workbench/file_dialogs.h"
#include "widgets/workbench/messages.h"
#include "widgets/workbench/script_commands.h"
#include "widgets/workbench/shown_run.h"
#include "widgets/workbench/work_controller.h"
#include "widgets/workbench/workspace.h"

namespace glissade {

/// Objects that the controllers of the window share. The window owns them; they outlive the controllers.
struct Workbench {
  WorkbenchDocument& document;
  SessionBridge& session;
  ShownRun& run;
  SceneWidget& scene;
  ActionCatalogue& actions;
  WorkController& work;
  Messages& messages;
  ScriptCommands& scripts;
  FileDialogs& dialogs;
  QMainWindow& window;  ///< parent of panels and dialogs
  /// Shared with background work.
  std::shared_ptr<ProductFinder> finder = std::make_shared<ProductFinder>(usersFitsCache(versionText()));

  /// Calls `handler` when the action is triggered, as long as `context` lives.
  template <class Handler>
  void onAction(const char* id, QObject* context, Handler handler) const {
    QObject::connect(actions[QLatin1String(id)], &QAction::triggered, context, handler);
  }
  /// Shows a panel in the workspace of its task; the workspace of studies has all tasks.
  void bringToFront(Workspace task, const char* panel) const {
    if (!actions[kWorkspaceActions.of(Workspace::Study)]->isChecked()) {
      actions[kWorkspaceActions.of(task)]->setChecked(true);
    }
    actions[panel]->trigger();
  }
  void enable(const char* id, bool enabled) const { actions[QLatin1String(id)]->setEnabled(enabled); }
};

}  // namespace glissade
