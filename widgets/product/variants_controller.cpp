#include "widgets/product/variants_controller.h"

#include <algorithm>

#include "engine/files/assembly_edits.h"
#include "engine/files/scenario_bodies.h"
#include "engine/fits/alternatives.h"
#include "widgets/scene3d/camera_controller.h"

namespace glissade {
namespace {

constexpr QSize kPictureSize(264, 176);
constexpr std::size_t kMostNamed = 3;

}  // namespace

VariantsController::VariantsController(const Workbench& bench)
    : QObject(&bench.window),
      bench_(bench),
      bar_(new NoticeBar(bench.actions, bench.scene.widget(), kRoomForViewCube)) {
  bench.onAction("assembly.variants", this, [this] { ask(); });
  connect(&bench.document, &WorkbenchDocument::changed, this, &VariantsController::followDocument);
  connect(&task_, &BackgroundTask::failed, &bench.work, &WorkController::reportFailure);
  connect(bar_, &NoticeBar::closed, this, [this] { bench_.scene.widget()->setFocus(); });
  bench_.enable("assembly.variants", false);
  addCommands();
}

/// Examines the bodies again, unless they have only moved.
void VariantsController::followDocument(Changes what) {
  if (!(what & (Change::Scenario | Change::Arrangement))) return;
  const std::vector<BodyId> ids = idsOf(rigidBodiesOf(*bench_.document.scenario()));
  if (!(what & Change::Scenario) && ids == known_) return;
  known_ = ids;
  bar_->hide();
  places_.clear();
  bench_.enable("assembly.variants", false);
  find();
}

void VariantsController::find() {
  const ScenarioPtr scenario = bench_.document.scenario();
  const auto work = [this, scenario](const WorkWatch& watch) -> BackgroundTask::Delivery {
    const Places places = variantsOf(findAlternatives(rigidBodiesOf(*scenario), watch.stop));
    return [this, places] { take(places); };
  };
  task_.start(GLISSADE_TEXT("looking for variants"), work, bench_.work.isAtOnce());
}

void VariantsController::take(const Places& places) {
  places_ = places;
  bench_.enable("assembly.variants", !places.empty());
  if (places.empty()) return;
  const LoadedScenario& scenario = *bench_.document.scenario();
  QStringList facts;
  for (std::size_t i = 0; i < std::min(kMostNamed, places.size()); ++i) {
    QStringList names;
    for (const std::size_t body : places[i]) names << QString::fromStdString(rigidBodyAt(body, scenario).shown());
    facts << names.join(QStringLiteral(", "));
  }
  if (places.size() > kMostNamed) facts << tr("and %n more", "", static_cast<int>(places.size() - kMostNamed));
  bar_->showNotice({tr("Bodies fill the same place: are they variants of one part?"),
                    facts.join(QStringLiteral("\n")),
                    {"assembly.variants"}});
}

void VariantsController::ask() {
  const LoadedScenario& scenario = *bench_.document.scenario();
  std::vector<std::vector<Variant>> places;
  for (const std::vector<std::size_t>& place : places_) {
    places.emplace_back();
    for (const std::size_t i : place) {
      const RigidBody& body = rigidBodyAt(i, scenario);
      places.back().push_back(
          {body.id, QString::fromStdString(body.shown()), pictureOf(body.id, boundingBox(*body.mesh, body.X_WB))});
    }
  }
  VariantsDialog dialog(std::move(places), &bench_.window);
  if (dialog.exec() == QDialog::Accepted) leaveOthersOut(dialog.leftOut());
}

void VariantsController::leaveOthersOut(const std::set<BodyId>& rigidIds) {
  if (rigidIds.empty()) return;
  std::set<BodyId> ids;
  for (const BodyId& id : rigidIds) ids.insert(bodyIdOf(id));
  const auto change = [&ids](Scenario& scenario) { return editEach(ids, leaveOut, scenario); };
  const Outcome edited = bench_.document.edit(tr("Exclude variants"), change);
  if (!edited) bench_.messages.showError(tr("The variant cannot be excluded"), edited.error());
}

QImage VariantsController::pictureOf(const BodyId& rigidId, const Box3& box) {
  SceneView& view = bench_.scene.view();
  const std::set<BodyId> hidden = view.hiddenBodies();
  const CameraPose pose = view.camera().pose();
  const SceneLayer shown = isInObject(*bench_.document.scenario(), rigidId) ? SceneLayer::Object : SceneLayer::Bodies;
  std::vector<SceneLayer> layers;  // layers that the picture must not show
  for (int i = 0; i < kSceneLayerCount; ++i) {
    const auto layer = static_cast<SceneLayer>(i);
    if (layer != shown && view.layerVisible(layer)) layers.push_back(layer);
  }
  std::set<BodyId> others(known_.begin(), known_.end());
  others.erase(rigidId);
  view.setHiddenBodies(others);
  for (const SceneLayer layer : layers) view.setLayerVisible(layer, false);
  view.camera().zoomTo(box);
  QImage picture = bench_.scene.picture(kPictureSize);
  view.camera().setPose(pose);
  for (const SceneLayer layer : layers) view.setLayerVisible(layer, true);
  view.setHiddenBodies(hidden);
  bench_.scene.refresh();
  return picture;
}

void VariantsController::addCommands() {
  bench_.scripts.add("choose-variant", 1, [this](const ScriptCommands::Words& words) -> Outcome {
    std::set<BodyId> others;
    for (const std::vector<std::size_t>& place : places_) {
      std::set<BodyId> ids;
      for (const std::size_t body : place) ids.insert(known_[body]);
      if (ids.erase(BodyId(words[0])) > 0) others = ids;
    }
    if (others.empty()) return wrongCommand("'" + words[0] + "' is no variant");
    leaveOthersOut(others);
    return Done{};
  });
  bench_.scripts.add("expect-variants", 1, [this](const ScriptCommands::Words& words) -> Outcome {
    const std::string places = std::to_string(places_.size());
    if (places == words[0]) return Done{};
    return unmetExpectation("bodies fill " + places + " places together, not " + words[0]);
  });
}

}  // namespace glissade
