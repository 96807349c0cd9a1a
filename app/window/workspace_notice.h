#pragma once

#include "app/window/workbench.h"
#include "widgets/panels/notice_bar.h"

namespace glissade {

/// Says over the scene that a body, the start or the goal was put outside of the workspace, and offers to fit the
/// workspace. The message goes when nothing is outside any more.
class WorkspaceNotice final : public QObject {
  Q_OBJECT

 public:
  explicit WorkspaceNotice(const Workbench& bench);

 private:
  void followDocument(Changes what);
  void addCommands();

  const Workbench& bench_;
  NoticeBar* bar_;
  ScenarioPtr before_;
};

}  // namespace glissade
