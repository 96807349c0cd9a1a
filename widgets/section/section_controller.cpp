#include "widgets/section/section_controller.h"

#include <QApplication>
#include <QMouseEvent>
#include <QToolBar>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/number_text.h"
#include "engine/base/quantity_text.h"
#include "widgets/scene3d/camera_controller.h"
#include "widgets/scene3d/section_layer.h"

namespace glissade {
namespace {

using Words = ScriptCommands::Words;

constexpr std::array<const char*, 3> kAddActions{"section.add-x", "section.add-y", "section.add-z"};
/// Shares of the extent for a new section. The first one without a section across this axis is taken.
constexpr std::array<double, 7> kNewPlaces{0.5, 0.25, 0.75, 0.375, 0.625, 0.125, 0.875};
/// Share of the extent within which two sections are at the same place.
constexpr double kSamePlace = 0.02;

bool isAcross(const SectionPlane& section, const Vector3& direction) {
  return std::abs(section.direction.dot(direction)) > 0.999999;
}

}  // namespace

SectionController::SectionController(const Workbench& bench, const MeasureController& measure)
    : QObject(&bench.window),
      bench_(bench),
      panel_(new SectionPanel(bench.actions, &bench.window)),
      bar_(new QToolBar(tr("Sections"), &bench.window)),
      tool_(bench.scene, this) {
  bar_->setObjectName(QStringLiteral("section"));
  bar_->setMovable(false);
  bar_->addWidget(panel_);
  bench.window.addToolBar(Qt::BottomToolBarArea, bar_);
  connect(panel_, &SectionPanel::changed, this, &SectionController::show);
  connect(&tool_, &SectionTool::dragged, this, [this](std::size_t index, double place) {
    SectionPlane section = panel_->sections()[index];
    section.place = place;
    panel_->set(index, section);
    show();
  });
  connect(&measure, &MeasureController::facePicked, this, &SectionController::addAlong);
  connect(&bench.document, &WorkbenchDocument::changedForView, this, &SectionController::follow);
  connect(&caps_, &BackgroundTask::failed, &bench.work, &WorkController::reportFailure);
  connect(&caps_, &BackgroundTask::ended, this, [this] {
    if (std::exchange(moreCaps_, false)) makeCaps();
  });
  bench.scene.view().onCapsLeft([this] { makeCaps(); });
  connectActions();
  addCommands();
}

void SectionController::connectActions() {
  for (int axis = 0; axis < 3; ++axis) {
    bench_.onAction(kAddActions[static_cast<std::size_t>(axis)], this, [this, axis] { addAcross(axis); });
  }
  bench_.onAction("panel.section", this, [this] {
    bar_->show();
    panel_->focusFirstButton();
  });
  bench_.onAction("section.remove-all", this, [this] {
    panel_->clear();
    show();
  });
  bench_.actions["section.handles"]->setChecked(true);
  connect(bench_.actions["section.handles"], &QAction::toggled, this, &SectionController::show);
  show();
}

void SectionController::follow(Changes what) {
  if (what & Change::Scenario) panel_->clear();
  if (!(what & (Change::Scenario | Change::Arrangement))) return;
  panel_->setExtent(bench_.scene.view().extent());
  show();
}

void SectionController::addAcross(int axis) {
  const Vector3 direction = Vector3::Unit(axis);
  const PlaceRange range = rangeAlong(direction, panel_->extent());
  const std::vector<SectionPlane> sections = panel_->sections();
  const double size = range.greatest - range.least;
  const auto isFree = [&](double share) {
    return std::none_of(sections.begin(), sections.end(), [&](const SectionPlane& section) {
      return isAcross(section, direction) && std::abs(section.place - range.least - share * size) < kSamePlace * size;
    });
  };
  const auto* share = std::find_if(kNewPlaces.begin(), kNewPlaces.end(), isFree);
  add(direction, range.least + (share == kNewPlaces.end() ? 0.5 : *share) * size);
}

/// Adds a section along a plane, or through the axis of a round face, facing the viewer.
void SectionController::addAlong(const MeasureFeature& face) {
  Vector3 direction = face.direction;
  Vector3 through = face.picked;
  if (face.isTurned()) {
    const CameraController& camera = bench_.scene.view().camera();
    const Vector3 sight = camera.eye() - face.axisPoint;
    direction = sight - sight.dot(face.direction) * face.direction;
    if (direction.norm() < 1e-9) direction = face.direction.unitOrthogonal();
    direction.normalize();
    through = face.axisPoint;
  }
  add(direction, direction.dot(through));
}

void SectionController::add(const Vector3& direction, double place) {
  if (panel_->sections().size() >= kMostSections) return;
  const CameraController& camera = bench_.scene.view().camera();
  const bool otherSide = (camera.eye() - camera.focus()).dot(direction) < 0.0;
  panel_->add({direction, place, otherSide, true});
  show();
}

void SectionController::cutByHand(const Vector3& normal, const Vector3& through) {
  const std::vector<SectionPlane> sections = panel_->sections();
  const auto isByHand = [this](const SectionPlane& section) {
    return byHand_ && section.direction == byHand_->direction && section.place == byHand_->place;
  };
  const auto known = std::find_if(sections.begin(), sections.end(), isByHand);
  if (known == sections.end() && sections.size() >= kMostSections) return;
  byHand_ = SectionPlane{normal, normal.dot(through), false, true};
  if (known == sections.end()) {
    panel_->add(*byHand_);
  } else {
    panel_->set(static_cast<std::size_t>(known - sections.begin()), *byHand_);
    panel_->setExtent(panel_->extent());  // the range of its slider changed
  }
  show();
}

void SectionController::show() {
  const std::vector<SectionPlane> sections = panel_->sections();
  std::vector<Plane> planes;
  for (const SectionPlane& section : sections) {
    if (section.on) planes.push_back(planeOf(section));
  }
  bench_.scene.view().setSections(planes);
  const bool handles = bench_.actions["section.handles"]->isChecked();
  if (bar_->isHidden() != sections.empty()) {
    bar_->setVisible(!sections.empty());
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);  // the view has its size before it is drawn
  }
  tool_.setSections(handles ? sections : std::vector<SectionPlane>(), panel_->extent());
  const bool mayAdd = !panel_->extent().isEmpty() && sections.size() < kMostSections;
  for (const char* id : kAddActions) bench_.enable(id, mayAdd);
  bench_.enable("section.pick-face", mayAdd);
  bench_.enable("section.remove-all", !sections.empty());
  bench_.scene.refresh();
}

/// Makes caps, one computation at a time, because each move of a drag would start one.
void SectionController::makeCaps() {
  if (caps_.isBusy()) {
    moreCaps_ = true;
    return;
  }
  const auto work = bench_.scene.view().capsWork();
  if (!work) return;
  const auto make = [this, work](const WorkWatch& watch) -> BackgroundTask::Delivery {
    return [this, deliver = work(watch)] {
      deliver();
      bench_.scene.refresh();
    };
  };
  caps_.start(GLISSADE_TEXT("cutting bodies open"), make, bench_.work.isAtOnce());
}

void SectionController::addCommands() {
  bench_.scripts.add("section", 2, [this](const Words& words) { return setByScript(words); });
  bench_.scripts.add("drag-section", 3, [this](const Words& words) { return dragByScript(words); });
  bench_.scripts.add("expect-sections", 1, [this](const Words& words) -> Outcome {
    const std::string count = std::to_string(panel_->sections().size());
    return count == words[0] ? Outcome(Done{}) : unmetExpectation("there are " + count + " sections, not " + words[0]);
  });
  bench_.scripts.add("expect-section", 2, [this](const Words& words) -> Outcome {
    constexpr double kNear = 1e-5;
    const auto index = toNumber(words[0]);
    const auto place = toMetres(words[1], 1e-3);
    const std::vector<SectionPlane> sections = panel_->sections();
    if (!index || !place || *index < 1 || *index > static_cast<double>(sections.size())) {
      return wrongCommand("there is no such section or place", "Say its number, from 1, and 12mm.");
    }
    const double is = sections[static_cast<std::size_t>(*index) - 1].place;
    if (std::abs(is - *place) < kNear) return Done{};
    return unmetExpectation("the section is at " + std::to_string(1e3 * is) + " mm, not " + words[1]);
  });
}

/// Carries out "section x|y|z SHARE|off" for the first section across this axis.
Outcome SectionController::setByScript(const Words& words) {
  const std::size_t axis = std::string("xyz").find(words[0]);
  if (words[0].size() != 1 || axis == std::string::npos) return wrongCommand("say x, y or z");
  const Vector3 direction = Vector3::Unit(static_cast<int>(axis));
  const std::vector<SectionPlane> sections = panel_->sections();
  const auto known = std::find_if(sections.begin(), sections.end(),
                                  [&](const SectionPlane& section) { return isAcross(section, direction); });
  const auto index = static_cast<std::size_t>(known - sections.begin());
  if (words[1] == "off") {
    if (known != sections.end()) panel_->remove(index);
    show();
    return Done{};
  }
  const auto share = toNumber(words[1]);
  if (!share || *share < 0.0 || *share > 1.0) return wrongCommand("say off, or a share from 0 to 1");
  const PlaceRange range = rangeAlong(direction, panel_->extent());
  const double place = (1.0 - *share) * range.least + *share * range.greatest;
  if (known == sections.end()) {
    add(direction, place);
  } else {
    panel_->set(index, {known->direction, place, known->otherSide, true});
    show();
  }
  return Done{};
}

/// Carries out "drag-section N X Y": number of the section from 1, pixels to the right, pixels down.
Outcome SectionController::dragByScript(const Words& words) {
  const auto index = toNumber(words[0]);
  const auto right = toNumber(words[1]);
  const auto down = toNumber(words[2]);
  if (!index || !right || !down || *index < 1 || *index > static_cast<double>(panel_->sections().size())) {
    return wrongCommand("there is no such section or pixel", "Say its number, from 1, and pixels.");
  }
  const auto from = tool_.overlay().pointOn(static_cast<std::size_t>(*index) - 1);
  if (!from) return wrongCommand("the section has no handle now");
  const QPointF to = *from + QPointF(*right, *down);
  const auto send = [this](QEvent::Type type, const QPointF& at, Qt::MouseButtons buttons) {
    QMouseEvent event(type, at, type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, buttons, Qt::NoModifier);
    QApplication::sendEvent(bench_.scene.widget(), &event);
  };
  send(QEvent::MouseButtonPress, *from, Qt::LeftButton);
  send(QEvent::MouseMove, to, Qt::LeftButton);
  send(QEvent::MouseButtonRelease, to, Qt::NoButton);
  return Done{};
}

}  // namespace glissade
