#pragma once

#include <vector>

#include "engine/files/assembly_edits.h"
#include "widgets/controls/notice_bar.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

/// Shows over the scene that a body, the start or the goal was moved out of the workspace, and offers to fit the
/// workspace. The message disappears when its item is inside again.
class WorkspaceNotice final : public QObject {
  Q_OBJECT

 public:
  explicit WorkspaceNotice(const Workbench& bench);

 private:
  /// An item outside of the workspace, and its pose.
  struct Outside {
    AssemblyItem item;
    Pose X_WB;
    friend bool operator==(const Outside&, const Outside&) = default;
  };
  static std::vector<Outside> findOutside(const LoadedScenario& scenario);
  void followDocument(Changes what);
  void tell(const AssemblyItem& item);
  void addCommands();

  const Workbench& bench_;
  NoticeBar* bar_;
  std::vector<Outside> known_;  ///< items that were reported, or that were outside in the file
  AssemblyItem told_;           ///< the item of the message
};

}  // namespace glissade
