#include "widgets/contacts/fits_controller.h"

#include <algorithm>

#include "engine/files/product_file.h"
#include "engine/fits/fit_edits.h"
#include "widgets/controls/body_id_text.h"

namespace glissade {
namespace {

bool saysNothing(const FitEdit& edit) {
  return !edit.kind && !edit.allowance && !edit.accepted && !edit.pitch && edit.turned.empty();
}

}  // namespace

FitsController::FitsController(const Workbench& bench)
    : QObject(&bench.window), bench_(bench), panel_(new FitsPanel(bench.actions, &bench.window)) {
  bench.onAction("fits.find", this, [this] {
    bench_.actions["panel.fits"]->trigger();
    find();
  });
  bench.onAction("fits.isolate", this, [this] { isolateChosen(); });
  bench.onAction("fits.accept", this,
                 [this] { editChosen(tr("accept a clash"), [](FitEdit& edit) { edit.accepted = true; }); });
  bench.onAction("fits.thread", this,
                 [this] { editChosen(tr("mark a thread"), [](FitEdit& edit) { edit.kind = ContactKind::Thread; }); });
  bench.onAction("fits.require-clearance", this,
                 [this] { editChosen(tr("require clearance"), [](FitEdit& edit) { edit.allowance = 0.0; }); });
  bench.onAction("fits.as-measured", this, [this] {
    editChosen(tr("take a fit as measured"), [](FitEdit& edit) { edit = {edit.a, edit.b, {}, {}, false}; });
  });
  connect(panel_, &FitsPanel::chosenChanged, this, &FitsController::showChosen);
  connect(panel_, &FitsPanel::activated, this, &FitsController::isolateChosen);
  connect(&bench.document, &WorkbenchDocument::changed, this, &FitsController::followDocument);
  connect(&bench.document.semantics(), &SemanticDocument::selectionChanged, this, [this] {
    panel_->showBodies(bench_.document.semantics().selectedBodies());
    enableActions();
  });
  enableActions();
  addCommands();
}

/// Removes the shown fits after an edit of the arrangement, for which they do not hold, and finds them again.
void FitsController::followDocument(Changes what) {
  if (!(what & (Change::Scenario | Change::Arrangement))) return;
  const bool wasShown = panel_->fits() != nullptr;
  panel_->setFits(nullptr);
  enableActions();
  if (wasShown && !(what & Change::Scenario)) find();
}

void FitsController::find() {
  const ScenarioPtr scenario = bench_.document.scenario();
  if (!scenario) return;
  bench_.work.run(tr("Looking for fits"),
                  [this, scenario, finder = bench_.finder](const WorkWatch& watch) -> BackgroundTask::Delivery {
                    ThreadTeam alone(0);
                    return [this, table = finder->fits(productOf(*scenario), alone, watch)] {
                      if (!table) {
                        bench_.messages.showError(tr("The fits cannot be found"), table.error());
                        return;
                      }
                      panel_->setFits({*table, &(*table)->pairs()});
                      enableActions();
                    };
                  });
}

/// Selects both bodies, so that the view marks them.
void FitsController::showChosen() {
  enableActions();
  const PairFit* fit = panel_->chosen();
  if (fit == nullptr) return;
  SemanticSelection selection;
  selection.bodies = {toQString(fit->a), toQString(fit->b)};
  bench_.document.semantics().select(selection);
}

void FitsController::isolateChosen() {
  if (panel_->chosen() == nullptr) return;
  showChosen();
  if (bench_.actions["body.isolate"]->isEnabled()) bench_.actions["body.isolate"]->trigger();
}

void FitsController::editChosen(const QString& text, const std::function<void(FitEdit&)>& change) {
  const PairFit* fit = panel_->chosen();
  if (fit == nullptr) return;
  const auto changeFits = [fit = *fit, change](Scenario& scenario) {
    change(editOf(fit.a, fit.b, scenario.fits));
    auto& pairs = scenario.fits.pairs;
    pairs.erase(std::remove_if(pairs.begin(), pairs.end(), saysNothing), pairs.end());
    return Outcome(Done{});
  };
  if (const Outcome edited = bench_.document.edit(text, changeFits); !edited) {
    bench_.messages.showError(tr("The fit cannot be changed"), edited.error());
  }
}

void FitsController::enableActions() {
  const PairFit* fit = panel_->chosen();
  const bool fitsCount = bench_.document.scenario() != nullptr;
  bench_.enable("fits.find", fitsCount);
  for (const char* id : {"fits.isolate", "fits.thread", "fits.require-clearance", "fits.as-measured"}) {
    bench_.enable(id, fit != nullptr);
  }
  bench_.enable("fits.accept", fit != nullptr && fit->status() == FitStatus::Clash);
}

void FitsController::addCommands() {
  bench_.scripts.add("select-fit", 2, [this](const ScriptCommands::Words& words) -> Outcome {
    if (panel_->choose(QString::fromStdString(words[0]), QString::fromStdString(words[1]))) return Done{};
    return wrongCommand("there is no fit of '" + words[0] + "' and '" + words[1] + "'", "Find the fits first.");
  });
  bench_.scripts.add("expect-fits", 2, [this](const ScriptCommands::Words& words) -> Outcome {
    const auto counts = panel_->fits() ? countsByKind(*panel_->fits()) : std::map<std::string, int>();
    const auto found = counts.find(words[0]);
    const std::string number = std::to_string(found == counts.end() ? 0 : found->second);
    if (number == words[1]) return Done{};
    return unmetExpectation("there are " + number + " fits of the kind " + words[0] + ", not " + words[1]);
  });
}

}  // namespace glissade
