#include "widgets/arrange/arrange_controller.h"

#include <QApplication>
#include <QMouseEvent>

#include <array>
#include <utility>

#include "engine/base/number_text.h"
#include "engine/base/quantity_text.h"
#include "widgets/controls/body_id_text.h"
#include "widgets/scene3d/scale_bar.h"
#include "widgets/workbench/arranged_item.h"
#include "widgets/workbench/workbench.h"

namespace glissade {
namespace {

using Words = ScriptCommands::Words;

/// Names in the order of kGizmoHandles.
constexpr std::array<const char*, 9> kHandleNames{"x", "y", "z", "yz", "zx", "xy", "rx", "ry", "rz"};

std::optional<GizmoHandle> handleNamed(const std::string& name) {
  for (std::size_t i = 0; i < kHandleNames.size(); ++i) {
    if (name == kHandleNames[i]) return kGizmoHandles[i];
  }
  return std::nullopt;
}

/// `words`: handle, pixels to the right, pixels down.
Outcome dragHandle(const GizmoOverlay& gizmo, QWidget* scene, const Words& words, bool release) {
  const auto handle = handleNamed(words[0]);
  const auto right = toNumber(words[1]);
  const auto down = toNumber(words[2]);
  if (!handle || !right || !down)
    return wrongCommand("there is no such handle or pixel", "Say x, yz or rz, and pixels.");
  const auto from = gizmo.pointOn(*handle);
  if (!from) return wrongCommand("the handle '" + words[0] + "' cannot be taken now");
  const auto send = [&](QEvent::Type type, const QPointF& at, Qt::MouseButtons buttons) {
    QMouseEvent event(type, at, type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, buttons, Qt::NoModifier);
    QApplication::sendEvent(scene, &event);
  };
  const QPointF by(*right, *down);
  constexpr int kMoves = 8;
  send(QEvent::MouseMove, *from, Qt::NoButton);
  send(QEvent::MouseButtonPress, *from, Qt::LeftButton);
  for (int i = 1; i <= kMoves; ++i) send(QEvent::MouseMove, *from + by * i / kMoves, Qt::LeftButton);
  if (release) send(QEvent::MouseButtonRelease, *from + by, Qt::NoButton);
  return Done{};
}

Outcome setSteps(ArrangeController& arrange, const Words& words) {
  const auto distance = toMetres(words[0], 1e-3);
  const auto angle = toRadians(words[1], 3.14159265358979323846 / 180.0);
  if (!distance || !angle) return wrongCommand("these are no steps", "Say 10mm and 15deg.");
  arrange.bar().setSteps(*distance, *angle);
  arrange.takeSteps();
  return Done{};
}

Outcome hover(QWidget* scene, const Words& words) {
  const auto x = toNumber(words[0]);
  const auto y = toNumber(words[1]);
  if (!x || !y) return wrongCommand("these are no pixels");
  QMouseEvent event(QEvent::MouseMove, QPointF(*x, *y), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
  QApplication::sendEvent(scene, &event);
  return Done{};
}

Outcome expectText(const QString& is, const std::string& part) {
  const bool found = part == "none" ? is.isEmpty() : is.contains(QString::fromStdString(part));
  return found ? Outcome(Done{}) : unmetExpectation("the text is '" + is.toStdString() + "', without '" + part + "'");
}

/// Adds the script commands about arranging in the view.
void addArrangeCommands(const Workbench& bench, ArrangeController& arrange) {
  ScriptCommands& scripts = bench.scripts;
  scripts.add("drag-handle", 3, [&bench, &arrange](const Words& words) {
    return dragHandle(arrange.tool().gizmo(), bench.scene.widget(), words, true);
  });
  scripts.add("hold-handle", 3, [&bench, &arrange](const Words& words) {
    return dragHandle(arrange.tool().gizmo(), bench.scene.widget(), words, false);
  });
  scripts.add("hover", 2, [&bench](const Words& words) { return hover(bench.scene.widget(), words); });
  scripts.add("expect-hint", 1,
              [&arrange](const Words& words) { return expectText(arrange.align().hint(), words[0]); });
  scripts.add("expect-snap", 1, [&arrange](const Words& words) { return expectText(arrange.bar().snap(), words[0]); });
  scripts.add("set-steps", 2, [&arrange](const Words& words) { return setSteps(arrange, words); });
  scripts.add("expect-arranging", 1, [&arrange](const Words& words) -> Outcome {
    const std::string is = arrange.bar().isVisible() ? "yes" : "no";
    return is == words[0] ? Outcome(Done{}) : unmetExpectation("arranging: '" + is + "', not '" + words[0] + "'");
  });
}

}  // namespace

ArrangeController::ArrangeController(const Workbench& bench, AssemblyController& assembly, MeasureController& measure)
    : QObject(&bench.window),
      bench_(bench),
      assembly_(assembly),
      snapping_(bench.document, bench.scene.view(), measure.features()),
      tool_(bench.document, bench.scene, snapping_, this),
      align_(bench, measure.features()),
      bar_(new ArrangeBar(bench.actions, bench.scene.widget())) {
  connect(bench.actions["assembly.arrange"], &QAction::toggled, this, &ArrangeController::setOn);
  for (const char* id : {"assembly.snap", "assembly.snap-features"}) {
    connect(bench.actions[QLatin1String(id)], &QAction::toggled, this, &ArrangeController::takeSteps);
  }
  connect(bar_, &ArrangeBar::stepsChanged, this, &ArrangeController::takeSteps);
  connect(bar_, &ArrangeBar::left, this, [this] { bench_.actions["assembly.arrange"]->setChecked(false); });
  connect(&assembly, &AssemblyController::placementShown, this, &ArrangeController::showItem);
  connect(&assembly, &AssemblyController::editableChanged, this, [this](bool editable) {
    if (!editable) leaveModes();
    enableActions();
  });
  connect(&bench.document, &WorkbenchDocument::changed, this, &ArrangeController::followDocument);
  bench.onAction("assembly.flip", this, [this] { flip(); });
  if (auto* scale = bench.scene.widget()->findChild<ScaleBar*>()) {
    connect(bar_, &ArrangeBar::covered, scale, &ScaleBar::setRoomBelow);
  }
  connectTool();
  connectAlignments();
  bench.actions["assembly.snap-features"]->setChecked(true);
  takeSteps();
  enableActions();
  addArrangeCommands(bench, *this);
}

void ArrangeController::connectTool() {
  connect(&tool_, &ArrangeTool::gripped, &assembly_, &AssemblyController::choose);
  connect(&tool_, &ArrangeTool::dropped, this,
          [this](const AssemblyItem& item, const Pose& X_WB) { assembly_.place(item, X_WB); });
  connect(&tool_, &ArrangeTool::nudged, this, [this](const AssemblyItem& item, const Pose& X_WB) {
    const QString key = QStringLiteral("nudge %1 %2").arg(static_cast<int>(item.kind));
    assembly_.place(item, X_WB, key.arg(toQString(item.bodyId)));
  });
  connect(&tool_, &ArrangeTool::left, bar_, &ArrangeBar::left);
  connect(&tool_, &ArrangeTool::snapped, bar_, &ArrangeBar::showSnap);
}

void ArrangeController::connectAlignments() {
  connect(&assembly_, &AssemblyController::placementShown, &align_, &AlignTool::setSelected);
  connect(bench_.actions["assembly.align"], &QAction::toggled, this, &ArrangeController::setAligning);
  bench_.onAction("assembly.align", this, [this](bool on) {
    if (!on) resume();
  });
  connect(&align_, &AlignTool::movingPicked, &assembly_, &AssemblyController::choose);
  connect(&align_, &AlignTool::picked, this, &ArrangeController::takeAlignment);
  connect(&align_, &AlignTool::left, this, &ArrangeController::resume);
}

void ArrangeController::setOn(bool on) {
  if (on) bench_.actions["assembly.align"]->setChecked(false);
  tool_.setOn(on);
  bar_->setVisible(on);
  bench_.scene.refresh();
}

void ArrangeController::setAligning(bool on) {
  QAction& arranging = *bench_.actions["assembly.arrange"];
  if (on) {
    interrupted_ = arranging.isChecked();
    arranging.setChecked(false);
  }
  align_.setOn(on);
}

void ArrangeController::resume() {
  bench_.actions["assembly.align"]->setChecked(false);
  if (std::exchange(interrupted_, false) && assembly_.isEditable())
    bench_.actions["assembly.arrange"]->setChecked(true);
}

void ArrangeController::leaveModes() {
  for (const char* mode : {"assembly.arrange", "assembly.align"})
    bench_.actions[QLatin1String(mode)]->setChecked(false);
}

void ArrangeController::takeSteps() {
  snapping_.setOn(bench_.actions["assembly.snap-features"]->isChecked());
  tool_.setSnapping(bench_.actions["assembly.snap"]->isChecked(), {bar_->distanceStep(), bar_->angleStep()});
}

void ArrangeController::followDocument(Changes what) {
  if (what & Change::Scenario) leaveModes();
  if (!(what & (Change::Scenario | Change::Arrangement)) || !aligned_) return;
  const bool stays = poseOf(bench_.document.scenario()->scenario, aligned_->item) == aligned_->after;
  if ((what & Change::Scenario) || (!stays && !bench_.document.isArranging())) aligned_.reset();
  enableActions();
}

void ArrangeController::showItem(const std::optional<AssemblyItem>& item, const PlacementPoints& points) {
  bar_->showItem(item ? nameOf(*item, *bench_.document.scenario()) : QString());
  if (!item) {
    tool_.setSelected(std::nullopt);
  } else if (points.picked) {
    tool_.setSelected(ArrangedItem{*item, *points.picked, true});
  } else {
    tool_.setSelected(ArrangedItem{*item, Pose::translation(points.middle)});
  }
}

void ArrangeController::takeAlignment(const AssemblyItem& item, const MeasureFeature& moving,
                                      const MeasureFeature& fixed) {
  const auto before = poseOf(bench_.document.scenario()->scenario, item);
  if (before) {
    ++alignments_;
    aligned_ = Aligned{item, *before, moving, fixed};
    placeAligned();
    const QString keys = bench_.actions["assembly.flip"]->shortcut().toString(QKeySequence::NativeText);
    const QString text =
        canFlip(moving, fixed) ? tr("%1 is aligned. %2 reverses the direction.") : tr("%1 is aligned.");
    bench_.messages.showStatus(text.arg(nameOf(item, *bench_.document.scenario()), keys));
  }
  resume();
}

void ArrangeController::flip() {
  if (!aligned_) return;
  aligned_->flipped = !aligned_->flipped;
  placeAligned();
}

/// An alignment and its flips are one undoable edit.
void ArrangeController::placeAligned() {
  aligned_->after = alignment(aligned_->moving, aligned_->fixed, aligned_->flipped) * aligned_->before;
  const Aligned aligned = *aligned_;
  assembly_.place(aligned.item, aligned.after, QStringLiteral("align %1").arg(alignments_));
  enableActions();
}

void ArrangeController::enableActions() {
  const bool editable = assembly_.isEditable();
  bench_.enable("assembly.arrange", editable);
  bench_.enable("assembly.snap", editable);
  bench_.enable("assembly.snap-features", editable);
  bench_.enable("assembly.align", editable);
  bench_.enable("assembly.flip", editable && aligned_ && canFlip(aligned_->moving, aligned_->fixed));
}

}  // namespace glissade
