#include "widgets/product/body_visibility.h"

#include "widgets/controls/body_id_text.h"

#include <algorithm>
#include <iterator>

namespace glissade {

BodyVisibility::BodyVisibility(const Workbench& bench, ScenePanel& panel)
    : QObject(&bench.window), bench_(bench), panel_(panel) {
  bench.onAction("body.hide", this, [this] { hideSelected(); });
  bench.onAction("body.isolate", this, [this] { isolateSelected(); });
  bench.onAction("body.show-all", this, [this] { setHidden({}); });
  connect(&panel, &ScenePanel::bodyChecked, this,
          [this](const QString& id, bool visible) { setVisible(toBodyId(id), visible); });
  connect(&bench.document, &WorkbenchDocument::changed, this, &BodyVisibility::followDocument);
  connect(&bench.document.semantics(), &SemanticDocument::selectionChanged, this, &BodyVisibility::enableActions);
  enableActions();
  bench.scripts.add("show-body", 2, [this](const ScriptCommands::Words& words) -> Outcome {
    if (words[1] != "yes" && words[1] != "no") return wrongCommand("say yes or no");
    if (setVisible(BodyId(words[0]), words[1] == "yes")) return Done{};
    return wrongCommand("there is no body '" + words[0] + "'");
  });
}

void BodyVisibility::followDocument(Changes what) {
  if (!(what & (Change::Scenario | Change::Arrangement))) return;
  if (what & Change::Scenario) hidden_.clear();
  bodies_.clear();
  for (const RigidBody& body : bench_.document.scenario()->obstacles) bodies_.insert(body.id);
  std::set<BodyId> hidden;
  std::set_intersection(hidden_.begin(), hidden_.end(), bodies_.begin(), bodies_.end(),
                        std::inserter(hidden, hidden.end()));
  setHidden(hidden);
}

bool BodyVisibility::setVisible(const BodyId& bodyId, bool visible) {
  if (bodies_.count(bodyId) == 0) return false;
  std::set<BodyId> hidden = hidden_;
  if (visible) {
    hidden.erase(bodyId);
  } else {
    hidden.insert(bodyId);
  }
  setHidden(hidden);
  return true;
}

std::set<BodyId> BodyVisibility::selected() const {
  std::set<BodyId> ids;
  for (const QString& id : bench_.document.semantics().selectedBodies()) {
    if (bodies_.count(toBodyId(id)) != 0) ids.insert(toBodyId(id));
  }
  return ids;
}

void BodyVisibility::hideSelected() {
  std::set<BodyId> hidden = hidden_;
  hidden.merge(selected());
  setHidden(hidden);
}

void BodyVisibility::isolateSelected() {
  const std::set<BodyId> kept = selected();
  std::set<BodyId> hidden;
  std::set_difference(bodies_.begin(), bodies_.end(), kept.begin(), kept.end(), std::inserter(hidden, hidden.end()));
  setHidden(hidden);
}

void BodyVisibility::setHidden(const std::set<BodyId>& hidden) {
  hidden_ = hidden;
  panel_.setHiddenBodies(hidden);
  bench_.scene.view().setHiddenBodies(hidden);
  bench_.scene.refresh();
  enableActions();
}

void BodyVisibility::enableActions() {
  const bool some = !selected().empty();
  bench_.enable("body.hide", some);
  bench_.enable("body.isolate", some);
  bench_.enable("body.show-all", !hidden_.empty());
}

}  // namespace glissade
