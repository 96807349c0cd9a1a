#include "widgets/headset/hand_tools.h"

#include "widgets/measure/measure_controller.h"
#include "widgets/section/section_controller.h"
#include "widgets/workbench/scene_target.h"

namespace glissade {
namespace {

constexpr int kHandTick = 16;  ///< ms
constexpr const char* kSection = "headset.section";
constexpr const char* kMeasure = "headset.measure";
constexpr const char* kSelect = "headset.select";

}  // namespace

HandTools::HandTools(const Workbench& bench, const MeasuringTools& tools)
    : QObject(&bench.window), bench_(bench), tools_(tools), hands_(bench.session.hand()) {
  timer_.setInterval(kHandTick);
  connect(&timer_, &QTimer::timeout, this, &HandTools::follow);
  bench.onAction(kSection, this, [this] { cut(); });
  bench.onAction(kMeasure, this, [this] { measurePoint(); });
  bench.onAction(kSelect, this, [this] { selectBody(); });
}

namespace {

Ray rayOf(const ControllerReading& reading) {
  return {reading.X_WA->position, reading.X_WA->orientation * -Vector3::UnitZ()};
}

}  // namespace

/// Cuts, and follows the hand while a button is held. Without a held button it cuts once.
void HandTools::cut() {
  timer_.start();
  const ControllerReading now = reading(kSection);
  if (!now.X_WA || !now.X_WG || !bench_.document.scenario()) return;
  tools_.sections.cutByHand(now.X_WA->orientation * Vector3::UnitZ(), now.X_WG->position);
}

void HandTools::follow() {
  if (holding(kSection)) {
    cut();
  } else {
    timer_.stop();
  }
}

void HandTools::measurePoint() {
  const ControllerReading now = reading(kMeasure);
  if (!now.X_WA || !bench_.document.scenario()) return;
  tools_.measure.measureAlong(rayOf(now));
}

/// Selects the body that the ray meets; none if it meets no body.
void HandTools::selectBody() {
  const ControllerReading now = reading(kSelect);
  if (!now.X_WA || !bench_.document.scenario()) return;
  SemanticSelection selection;
  if (const auto body = targetAlong(bench_, rayOf(now)).body) selection.bodies = {*body};
  bench_.document.semantics().select(selection);
}

std::optional<ControllerSide> HandTools::holding(const char* action) const {
  for (const ControllerSide side : {ControllerSide::Left, ControllerSide::Right}) {
    const ControllerInput& controller = hands_->controller(side);
    const unsigned held = controller.place.reading().held;
    for (std::size_t button = 0; button < kControllerButtons; ++button) {
      if ((held >> button & 1U) != 0U && settings_.action(controller.buttons, button) == QLatin1String(action))
        return side;
    }
  }
  return std::nullopt;
}

ControllerReading HandTools::reading(const char* action) const {
  const ControllerSide other = hands_->mainHand == ControllerSide::Left ? ControllerSide::Right : ControllerSide::Left;
  return hands_->controller(holding(action).value_or(other)).place.reading();
}

}  // namespace glissade
