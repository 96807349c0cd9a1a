#pragma once

#include <set>
#include <string>

#include "widgets/product/scene_panel.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

/// Decides which obstacles are drawn, by the check boxes of the scene panel and by actions on the selection. Planning
/// ignores it, and the scenario does not keep it.
class BodyVisibility final : public QObject {
  Q_OBJECT

 public:
  BodyVisibility(const Workbench& bench, ScenePanel& panel);

  /// False if there is no such body.
  bool setVisible(const BodyId& bodyId, bool visible);

 private:
  /// Shows all bodies of a new scenario. After an edit of the arrangement, hidden bodies stay hidden.
  void followDocument(Changes what);
  void hideSelected();
  void isolateSelected();
  void setHidden(const std::set<BodyId>& hidden);
  std::set<BodyId> selected() const;
  void enableActions();

  const Workbench& bench_;
  ScenePanel& panel_;
  std::set<BodyId> bodies_;
  std::set<BodyId> hidden_;
};

}  // namespace glissade
