#include "app/window/section_controller.h"

#include "engine/base/number_text.h"
#include "widgets/scene3d/camera_controller.h"

namespace glissade {

SectionController::SectionController(const Workbench& bench)
    : QObject(&bench.window), bench_(bench), panel_(new SectionPanel(&bench.window)) {
  // What is nearer to the viewer is cut away, so that the cut faces are seen.
  connect(panel_, &SectionPanel::switchedOn, this, [this](int axis) {
    const CameraController& camera = bench_.scene.view().camera();
    panel_->setOtherSide(axis, (camera.eye() - camera.focus())[axis] < 0.0);
  });
  connect(panel_, &SectionPanel::changed, this, [this] {
    bench_.scene.view().setSections(panel_->sections());
    bench_.scene.refresh();
  });
  connect(&bench.document, &WorkbenchDocument::changedForView, this, [this](Changes what) {
    if (what & Change::Scenario) panel_->setExtent(bench_.scene.view().extent());
  });
  bench.scripts.add("section", 2, [this](const ScriptCommands::Words& words) { return setByScript(words); });
}

/// section x|y|z SHARE|off
Outcome SectionController::setByScript(const ScriptCommands::Words& words) {
  const std::size_t axis = std::string("xyz").find(words[0]);
  if (words[0].size() != 1 || axis == std::string::npos) return wrongCommand("say x, y or z");
  if (words[1] == "off") {
    panel_->setSection(static_cast<int>(axis), false, 0.5);
    return Done{};
  }
  const auto share = toNumber(words[1]);
  if (!share || *share < 0.0 || *share > 1.0) return wrongCommand("say off, or a share from 0 to 1");
  panel_->setSection(static_cast<int>(axis), true, *share);
  return Done{};
}

}  // namespace glissade
