#pragma once

#include <QObject>
#include <set>
#include <string>

#include "widgets/commands/action_catalogue.h"
#include "widgets/model/semantic_document.h"
#include "widgets/panels/scene_panel.h"
#include "widgets/scene3d/scene_widget.h"

namespace glissade {

/// Which obstacles are drawn: the check boxes of the scene panel, and actions on what is selected. Planning
/// knows nothing of it, and the scenario does not keep it: it is a way of looking. Part of the main window.
class BodyVisibility final : public QObject {
  Q_OBJECT

 public:
  BodyVisibility(const ActionCatalogue& actions, SceneWidget& scene, ScenePanel& panel, SemanticDocument& document,
                 QWidget* window);

  /// Everything is shown.
  void open(const LoadedScenario& scenario);
  /// Bodies may have come or gone: what is hidden stays hidden.
  void rearrange(const LoadedScenario& scenario);
  /// False: there is no such body.
  bool setVisible(const std::string& bodyId, bool visible);

 private:
  void hideSelected();
  void isolateSelected();
  void setHidden(const std::set<std::string>& hidden);
  std::set<std::string> selected() const;
  void enableActions();

  const ActionCatalogue& actions_;
  SceneWidget& scene_;
  ScenePanel& panel_;
  SemanticDocument& document_;
  std::set<std::string> bodies_;
  std::set<std::string> hidden_;
};

}  // namespace glissade
