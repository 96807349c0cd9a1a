#include "widgets/view/display_controller.h"

#include "widgets/controls/body_id_text.h"

#include <QActionGroup>

#include <array>

namespace glissade {
namespace {

struct ModeActions {
  const char* view;      ///< id of the action for the view
  const char* selected;  ///< id of the action for the selected bodies
  DisplayMode mode;
};

constexpr std::array<ModeActions, 4> kModes{
    {{"display.shaded-edges", "display-selected.shaded-edges", DisplayMode::ShadedWithEdges},
     {"display.shaded", "display-selected.shaded", DisplayMode::Shaded},
     {"display.see-through", "display-selected.see-through", DisplayMode::SeeThrough},
     {"display.wireframe", "display-selected.wireframe", DisplayMode::Wireframe}}};
constexpr const char* kAsView = "display-selected.as-view";

}  // namespace

DisplayController::DisplayController(const Workbench& bench) : QObject(&bench.window), bench_(bench) {
  auto* group = new QActionGroup(this);
  for (const ModeActions& entry : kModes) {
    group->addAction(bench.actions[QLatin1String(entry.view)]);
    bench.onAction(entry.view, this, [this, mode = entry.mode] { setMode(mode); });
    bench.onAction(entry.selected, this, [this, mode = entry.mode] { setModeOfSelected(mode); });
  }
  bench.onAction(kAsView, this, [this] { setModeOfSelected(std::nullopt); });
  QAction* depth = bench.actions["display.depth-shading"];
  depth->setChecked(bench.scene.view().depthShading());
  connect(depth, &QAction::toggled, this, [this](bool shaded) {
    bench_.scene.view().setDepthShading(shaded);
    bench_.scene.refresh();
  });
  connect(bench.actions["view.keep-roadmap"], &QAction::toggled, this, [this](bool kept) {
    bench_.scene.view().setRoadmapKept(kept);
    bench_.scene.refresh();
  });
  connect(&bench.document.semantics(), &SemanticDocument::selectionChanged, this, &DisplayController::enableActions);
  checkAction();
  enableActions();
}

void DisplayController::setMode(DisplayMode mode) {
  bench_.scene.view().setDisplayMode(mode);
  bench_.scene.refresh();
  checkAction();
}

void DisplayController::setModeOfSelected(std::optional<DisplayMode> mode) {
  std::map<BodyId, DisplayMode> modes = bench_.scene.view().bodyDisplayModes();
  for (const QString& id : bench_.document.semantics().selectedBodies()) {
    modes.erase(toBodyId(id));
    if (mode) modes.emplace(toBodyId(id), *mode);
  }
  bench_.scene.view().setBodyDisplayModes(modes);
  bench_.scene.refresh();
}

void DisplayController::checkAction() {
  for (const ModeActions& entry : kModes) {
    if (entry.mode == bench_.scene.view().displayMode()) bench_.actions[QLatin1String(entry.view)]->setChecked(true);
  }
}

void DisplayController::enableActions() {
  const bool some = !bench_.document.semantics().selection().bodies.empty();
  for (const ModeActions& entry : kModes) bench_.enable(entry.selected, some);
  bench_.enable(kAsView, some);
}

}  // namespace glissade
