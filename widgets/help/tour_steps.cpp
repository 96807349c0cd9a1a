#include "widgets/help/tour_steps.h"

#include <QTreeWidget>

namespace glissade {
namespace {

bool isOpen(const Workbench& bench, const char* sample) {
  const ScenarioPtr& scenario = bench.document.scenario();
  return scenario && QString::fromStdString(scenario->file).endsWith(QLatin1String(sample));
}

/// Whether a run of this strategy has ended.
bool hasRun(const Workbench& bench, const char* strategy) {
  const SnapshotPtr& snapshot = bench.run.snapshot();
  return snapshot && snapshot->plannerId == strategy && snapshot->run > 0 && !isRunning(*snapshot) &&
         snapshot->state != SessionState::Idle;
}

bool hasSelectedRow(const Workbench& bench, const char* table) {
  const auto* rows = bench.window.findChild<QTreeWidget*>(QLatin1String(table));
  return rows != nullptr && !rows->selectedItems().isEmpty();
}

bool isTeachingOpen(const Workbench& bench) { return isOpen(bench, "teaching/scenario.json"); }
bool arePlacesShown(const Workbench& bench) { return bench.scene.view().layerVisible(SceneLayer::Places); }
bool hasRunGt(const Workbench& bench) { return hasRun(bench, "gt"); }
bool hasSolvedByGts(const Workbench& bench) {
  return hasRun(bench, "gts") && bench.run.snapshot()->state == SessionState::Solved;
}
bool isStepChosen(const Workbench& bench) { return hasSelectedRow(bench, "steps"); }
bool areBracketsOpen(const Workbench& bench) { return isOpen(bench, "bolted-brackets/scenario.json"); }
bool hasNutPath(const Workbench& bench) { return areBracketsOpen(bench) && bench.document.results().path != nullptr; }
bool isCutOpen(const Workbench& bench) { return bench.actions["section.remove-all"]->isEnabled(); }
bool hasSequence(const Workbench& bench) { return bench.actions["sequence.export"]->isEnabled(); }

}  // namespace

bool isOfTour(const Workbench& bench) {
  return (isTeachingOpen(bench) || areBracketsOpen(bench)) && bench.document.undoStack().isClean();
}

const std::vector<TourStep>& tourSteps() {
  static const std::vector<TourStep> steps{
      {QT_TRANSLATE_NOOP("Tour", "Open a scenario"),
       QT_TRANSLATE_NOOP("Tour",
                         "Open the sample \"Four bodies\": its card on the welcome page, or Open (Ctrl+O) and "
                         "samples/teaching/scenario.json. The red box is to reach the ghost. A scenario holds bodies, "
                         "the moving part, its start and its goal."),
       "file.open",
       {"open-sample teaching/scenario.json"},
       isTeachingOpen},
      {QT_TRANSLATE_NOOP("Tour", "See the places"),
       QT_TRANSLATE_NOOP(
           "Tour",
           "Press F8 (View > Layers of places > Places). The free space is divided into places: the redder, "
           "the narrower; green ones are easy, yellow ones are cluttered by a mobile body. The blue line is the "
           "coarse path: the sequence of places that costs least."),
       "layer.places",
       {"action layer.places"},
       arePlacesShown},
      {QT_TRANSLATE_NOOP("Tour", "Plan with topology"),
       QT_TRANSLATE_NOOP("Tour",
                         "In the list of strategies (panel Interaction), choose Research, then GT, "
                         "and press Find path (F5). The path leads through the slot P6, which is too "
                         "narrow, and the run ends there: the panel Run > Coarse plan says where and why."),
       "strategy",
       {"select-strategy gt", "action run.start"},
       hasRunGt},
      {QT_TRANSLATE_NOOP("Tour", "Plan with semantics"),
       QT_TRANSLATE_NOOP(
           "Tour",
           "Choose the strategy Layers and press Find path (F5). It knows that the object does not fit through the "
           "slot and goes through P5. The path that it finds is certified free of penetration."),
       "strategy",
       {"select-strategy gts", "action run.start"},
       hasSolvedByGts},
      {QT_TRANSLATE_NOOP("Tour", "Look at a step"),
       QT_TRANSLATE_NOOP(
           "Tour",
           "Click a row of the table in the panel Run > Coarse plan (Alt+4). Each row is a step through one place, "
           "with the planner that found it. The scene marks the place of the step, and its attributes "
           "can be changed in the panel Product > Places (Alt+2)."),
       "steps",
       {"select step 2"},
       isStepChosen},
      {QT_TRANSLATE_NOOP("Tour", "Open parts"),
       QT_TRANSLATE_NOOP(
           "Tour",
           "Now parts. Press Do it for me: it opens the sample \"Bolted brackets\" in place of the one that "
           "is open. It has two brackets on a plate, with bolts, a rod and nuts. With parts of your own, "
           "begin with File > New from parts (Ctrl+N): STEP, mesh or URDF files."),
       "file.open",
       {"open-sample bolted-brackets/scenario.json"},
       areBracketsOpen},
      {QT_TRANSLATE_NOOP("Tour", "See the fits"),
       QT_TRANSLATE_NOOP(
           "Tour",
           "Choose Assembly > Find fits (Ctrl+I). The parts touch, as most CAD parts do. The panel Contacts > Fits "
           "lists the pairs, with gap and allowance: the moving part is that much thinner against the "
           "other one. A click on a row marks the two parts."),
       "fits.find",
       {"action fits.find"},
       nullptr},
      {QT_TRANSLATE_NOOP("Tour", "Remove a part"),
       QT_TRANSLATE_NOOP("Tour",
                         "Press Find path (F5): the planner searches the removal path of the nut. The panel Path shows "
                         "the clearance along the motion, the allowances, and plays it (Ctrl+P)."),
       "run.start",
       {"action run.start"},
       hasNutPath},
      {QT_TRANSLATE_NOOP("Tour", "Cut it open"),
       QT_TRANSLATE_NOOP(
           "Tour",
           "Choose View > Sections > Section across Y (Ctrl+Alt+Y): the plane cuts the bodies open, so that "
           "bolts, rod and holes are seen. The arrow in the scene moves the plane."),
       "section.add-y",
       {"action section.add-y"},
       isCutOpen},
      {QT_TRANSLATE_NOOP("Tour", "Plan the sequence"),
       QT_TRANSLATE_NOOP("Tour",
                         "Choose Assembly > Plan the sequence (Ctrl+J): in which order are the parts removed? Each "
                         "step has a certified motion. The rod is removed before the bolts, which have no room below "
                         "it. A click on a row shows the step."),
       "sequence.plan",
       {"section y off", "action sequence.plan"},
       hasSequence},
      {QT_TRANSLATE_NOOP("Tour", "Write the instruction"),
       QT_TRANSLATE_NOOP(
           "Tour",
           "The slider Explode in the panel Sequence moves the parts apart, in the order of removal. Choose Assembly > "
           "Sequence > Save the sequence (Ctrl+Alt+E) and a name that ends in .html or .pdf: a work instruction with a "
           "picture of each step. Shift+F1 explains anything in the window; Ctrl+K finds any command."),
       "sequence.export",
       {"explode 1", "export-sequence {report}"},
       nullptr},
  };
  return steps;
}

}  // namespace glissade
