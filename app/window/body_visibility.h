#pragma once

#include <set>
#include <string>

#include "app/window/workbench.h"
#include "widgets/panels/scene_panel.h"

namespace glissade {

/// Which obstacles are drawn: the check boxes of the scene panel, and actions on what is selected. Planning
/// knows nothing of it, and the scenario does not keep it.
class BodyVisibility final : public QObject {
  Q_OBJECT

 public:
  BodyVisibility(const Workbench& bench, ScenePanel& panel);

  /// False: there is no such body.
  bool setVisible(const std::string& bodyId, bool visible);

 private:
  /// In another scenario everything is shown. In another arrangement bodies may have come or gone: what is hidden
  /// stays hidden.
  void followDocument(Changes what);
  void hideSelected();
  void isolateSelected();
  void setHidden(const std::set<std::string>& hidden);
  std::set<std::string> selected() const;
  void enableActions();

  const Workbench& bench_;
  ScenePanel& panel_;
  std::set<std::string> bodies_;
  std::set<std::string> hidden_;
};

}  // namespace glissade
