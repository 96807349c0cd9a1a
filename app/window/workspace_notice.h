#pragma once

#include <vector>

#include "app/window/workbench.h"
#include "engine/scenario/assembly_edits.h"
#include "widgets/panels/notice_bar.h"

namespace glissade {

/// Says over the scene that a body, the start or the goal was put outside of the workspace, and offers to fit the
/// workspace. The message goes when nothing is outside any more.
class WorkspaceNotice final : public QObject {
  Q_OBJECT

 public:
  explicit WorkspaceNotice(const Workbench& bench);

 private:
  /// Something that is outside, and where.
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
  std::vector<Outside> known_;  ///< it was told, or the file has it there
  AssemblyItem told_;           ///< what the bar says
};

}  // namespace glissade
