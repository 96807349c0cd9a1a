#include "app/window/body_visibility.h"

#include <algorithm>
#include <iterator>

namespace glissade {

BodyVisibility::BodyVisibility(const ActionCatalogue& actions, SceneWidget& scene, ScenePanel& panel,
                               SemanticDocument& document, QWidget* window)
    : QObject(window), actions_(actions), scene_(scene), panel_(panel), document_(document) {
  const auto on = [&](const char* id, auto handler) {
    connect(actions[QLatin1String(id)], &QAction::triggered, this, handler);
  };
  on("body.hide", [this] { hideSelected(); });
  on("body.isolate", [this] { isolateSelected(); });
  on("body.show-all", [this] { setHidden({}); });
  connect(&panel, &ScenePanel::bodyChecked, this,
          [this](const QString& id, bool visible) { setVisible(id.toStdString(), visible); });
  connect(&document, &SemanticDocument::selectionChanged, this, &BodyVisibility::enableActions);
  enableActions();
}

void BodyVisibility::open(const LoadedScenario& scenario) {
  hidden_.clear();
  rearrange(scenario);
}

void BodyVisibility::rearrange(const LoadedScenario& scenario) {
  bodies_.clear();
  for (const RigidBody& body : scenario.obstacles) bodies_.insert(body.id);
  std::set<std::string> hidden;
  std::set_intersection(hidden_.begin(), hidden_.end(), bodies_.begin(), bodies_.end(),
                        std::inserter(hidden, hidden.end()));
  setHidden(hidden);
}

bool BodyVisibility::setVisible(const std::string& bodyId, bool visible) {
  if (bodies_.count(bodyId) == 0) return false;
  std::set<std::string> hidden = hidden_;
  if (visible) {
    hidden.erase(bodyId);
  } else {
    hidden.insert(bodyId);
  }
  setHidden(hidden);
  return true;
}

std::set<std::string> BodyVisibility::selected() const {
  std::set<std::string> ids;
  for (const QString& id : document_.selection().bodies) {
    if (bodies_.count(id.toStdString()) != 0) ids.insert(id.toStdString());
  }
  return ids;
}

void BodyVisibility::hideSelected() {
  std::set<std::string> hidden = hidden_;
  hidden.merge(selected());
  setHidden(hidden);
}

void BodyVisibility::isolateSelected() {
  const std::set<std::string> kept = selected();
  std::set<std::string> hidden;
  std::set_difference(bodies_.begin(), bodies_.end(), kept.begin(), kept.end(), std::inserter(hidden, hidden.end()));
  setHidden(hidden);
}

void BodyVisibility::setHidden(const std::set<std::string>& hidden) {
  hidden_ = hidden;
  panel_.setHiddenBodies(hidden);
  scene_.view().setHiddenBodies(hidden);
  scene_.refresh();
  enableActions();
}

void BodyVisibility::enableActions() {
  const bool some = !selected().empty();
  actions_[QStringLiteral("body.hide")]->setEnabled(some);
  actions_[QStringLiteral("body.isolate")]->setEnabled(some);
  actions_[QStringLiteral("body.show-all")]->setEnabled(!hidden_.empty());
}

}  // namespace glissade
