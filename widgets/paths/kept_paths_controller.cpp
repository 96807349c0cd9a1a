#include "widgets/paths/kept_paths_controller.h"

#include <algorithm>
#include <utility>

#include "engine/base/enum_names.h"
#include "engine/base/number_text.h"
#include "engine/files/scenario_bodies.h"
#include "engine/planning/path_examination.h"
#include "widgets/controls/picture_file.h"

namespace glissade {
namespace {

/// Number of samples of a path's clearance for the compared curves.
constexpr std::size_t kComparedSamples = 200;

constexpr EnumNames<KeptPathState, 5> kProofNames{{"unknown", "proved", "blocked", "other-ends", "other-object"}};

}  // namespace

KeptPathsController::KeptPathsController(const Workbench& bench)
    : QObject(&bench.window), bench_(bench), panel_(new KeptPathsPanel(bench.actions, &bench.window)) {
  connect(&proving_, &BackgroundTask::failed, &bench.work, &WorkController::reportFailure);
  connect(&proving_, &BackgroundTask::ended, this, &KeptPathsController::proveNext, Qt::QueuedConnection);
  connect(&bench.document, &WorkbenchDocument::changed, this, &KeptPathsController::followDocument);
  connect(panel_, &KeptPathsPanel::lengthUnitChanged, this, &KeptPathsController::showRows);
  connect(&bench.run, &ShownRun::changed, this, &KeptPathsController::enableActions);
  connect(panel_, &KeptPathsPanel::selectionChanged, this, &KeptPathsController::enableActions);
  connect(panel_, &KeptPathsPanel::shownChanged, this, [this](const std::string& name, bool shown) {
    shown ? (void)shown_.insert(name) : (void)shown_.erase(name);
    showRows();
  });
  connect(
      panel_, &KeptPathsPanel::renamed, this,
      [this](const std::string& name, const std::string& newName) {
        const Outcome renamed = bench_.document.paths().rename(name, newName);
        if (renamed && shown_.erase(name) > 0) shown_.insert(newName);
        showRows();
        showFailure(renamed);
      },
      Qt::QueuedConnection);  // queued, because the table is changing
  connect(panel_, &KeptPathsPanel::activated, this, [this](const std::string& name) { showFailure(openPath(name)); });
  connectActions();
  enableActions();
  addCommands();
}

void KeptPathsController::connectActions() {
  bench_.onAction("paths.keep", this, [this] {
    bench_.document.keepResult();
    bench_.actions["panel.paths"]->trigger();
  });
  bench_.onAction("paths.open", this, [this] { showFailure(openPath(panel_->selected().front())); });
  bench_.onAction("paths.compare", this, [this] { compareSelected(); });
  bench_.onAction("paths.rename", this, [this] { panel_->editName(); });
  bench_.onAction("paths.pin", this, [this] {
    for (const std::string& name : panel_->selected()) {
      const KeptPathPtr path = bench_.document.paths().find(name);
      if (path) showFailure(bench_.document.paths().pin(name, !path->pinned));
    }
  });
  bench_.onAction("paths.remove", this, [this] {
    for (const std::string& name : panel_->selected()) showFailure(bench_.document.paths().remove(name));
  });
}

void KeptPathsController::followDocument(Changes what) {
  if (what & Change::Scenario) {
    shown_.clear();
    opening_ = true;
  }
  // An edit may have forbidden places or allowed them again.
  const std::vector<PlaceEdit> places = bench_.document.semantics().edits().places;
  const bool otherPlaces = std::exchange(places_, places) != places;
  const bool otherProblem = otherPlaces || (what & (Change::Scenario | Change::Arrangement));
  if (otherProblem) {
    proving_.cancel();
    proofs_.clear();
  }
  const bool shown = otherProblem || (what & (Change::Paths | Change::Results | Change::File));
  if (!shown || !bench_.document.scenario()) return;
  showRows();
  if (otherProblem || (what & Change::Paths)) proveNext();
}

KeptPathsController::Proofs::iterator KeptPathsController::findProof(const KeptPath& path) {
  return std::find_if(proofs_.begin(), proofs_.end(), [&path](const auto& proved) {
    return proved.first->object == path.object && hasPoints(*proved.first, path.points);
  });
}

KeptPathProof KeptPathsController::proofOf(const KeptPath& path) {
  const auto found = findProof(path);
  return found == proofs_.end() ? KeptPathProof() : found->second;
}

/// Starts the next proof. A path that a run just found has its certificate already.
void KeptPathsController::proveNext() {
  if (bench_.document.scenario()->fitsPending) return;  // without fits, no proof is possible yet
  const KeptPaths& paths = bench_.document.paths().paths();
  while (!proving_.isBusy()) {
    const auto next = std::find_if(paths.begin(), paths.end(),
                                   [this](const KeptPathPtr& path) { return findProof(*path) == proofs_.end(); });
    if (next == paths.end()) return openHeldPath();
    proofs_.emplace_back(*next, KeptPathProof());  // each path is examined only once
    const std::shared_ptr<const Path>& found = bench_.document.results().path;
    if (found && hasPoints(**next, found->points)) {
      takeProof(**next, {KeptPathState::Holds, found, {}});
    } else {
      startProof(*next);
    }
  }
}

void KeptPathsController::startProof(const KeptPathPtr& path) {
  const auto edits = std::make_shared<const SemanticEdits>(bench_.document.semantics().heldEdits());
  const auto prove = [this, path, edits,
                      scenario = bench_.document.scenario()](const WorkWatch& watch) -> BackgroundTask::Delivery {
    LoadedScenario edited = *scenario;
    edited.problem.scene.edits = edits;
    const KeptPathProof proof = proveAgain(*path, edited, watch);
    return [this, path, proof] { takeProof(*path, proof); };
  };
  proving_.start(GLISSADE_TEXT("certifying a kept path"), prove, bench_.work.isAtOnce());
}

void KeptPathsController::takeProof(const KeptPath& path, const KeptPathProof& proof) {
  const auto found = findProof(path);
  if (found != proofs_.end()) found->second = proof;
  showRows();
}

void KeptPathsController::openHeldPath() {
  if (!std::exchange(opening_, false)) return;
  const RunResults& results = bench_.document.results();
  const SnapshotPtr& live = bench_.session.snapshot();
  if (results.path || results.refused || !live || live->run > 0 || !bench_.run.isLive()) return;
  const double required = live->parameters[ParameterId::RequiredClearance];
  KeptPathPtr held;
  for (const KeptPathPtr& path : bench_.document.paths().paths()) {
    const bool holds = proofOf(*path).state == KeptPathState::Holds && path->requiredClearance >= required;
    if (holds && (!held || path->pinned || !held->pinned)) held = path;
  }
  if (held) give(*held);
}

void KeptPathsController::give(const KeptPath& path) {
  bench_.session.givePath({withUnitRotations(path.points), path.provenance});
}

KeptPathRow KeptPathsController::rowOf(const KeptPathPtr& path) {
  const std::shared_ptr<const Path>& current = bench_.document.results().path;
  return {path, proofOf(*path), shown_.count(path->name) != 0, current && hasPoints(*path, current->points)};
}

void KeptPathsController::showRows() {
  if (!bench_.document.scenario()) return;
  std::vector<KeptPathRow> rows;
  std::vector<KeptPathPicture> pictures;
  for (const KeptPathPtr& path : bench_.document.paths().paths()) {
    rows.push_back(rowOf(path));
    if (!rows.back().shown) continue;
    const QColor colour = keptPathColour(rows.size() - 1);
    KeptPathPicture picture{{}, {colour.redF(), colour.greenF(), colour.blueF()}, path->name};
    for (const PathPoint& point : path->points) picture.way.push_back(point.q.position);
    pictures.push_back(std::move(picture));
  }
  panel_->setRows(rows, bench_.document.hasUnkeptPath());
  bench_.scene.view().setKeptPaths(std::move(pictures));
  bench_.scene.refresh();
  enableActions();
}

void KeptPathsController::enableActions() {
  const std::size_t selected = panel_->selected().size();
  const SnapshotPtr& snapshot = bench_.run.snapshot();
  const bool idle = snapshot && bench_.run.isLive() && !isRunning(*snapshot);
  const std::shared_ptr<const Path>& path = bench_.document.results().path;
  bench_.enable("paths.keep", path && !bench_.document.paths().holds(path->points));
  bench_.enable("paths.open", idle && selected == 1);
  bench_.enable("paths.compare", bench_.document.paths().paths().size() >= 2);
  bench_.enable("paths.rename", selected == 1);
  bench_.enable("paths.pin", selected > 0);
  bench_.enable("paths.remove", selected > 0);
}

Outcome KeptPathsController::openPath(const std::string& name) {
  const KeptPathPtr path = bench_.document.paths().find(name);
  if (!path) return wrongCommand("there is no kept path '" + name + "'");
  if (path->object != idOf(bench_.document.scenario()->scenario.object)) {
    return Diagnostic{ErrorKind::Usage,
                      "",
                      name,
                      GLISSADE_TEXT("another body is the moving part now"),
                      {GLISSADE_TEXT("Make '%1' the object first."), {path->object}}};
  }
  if (isRunning(*bench_.session.snapshot())) {
    return Diagnostic{ErrorKind::Usage, "", name, GLISSADE_TEXT("a run is going on"),
                      GLISSADE_TEXT("Stop the run first.")};
  }
  bench_.document.whenArranged([this, path] {
    give(*path);
    bench_.actions["panel.path"]->trigger();
  });
  return Done{};
}

/// Compares the selected paths, or all if fewer than two are selected.
void KeptPathsController::compareSelected() {
  std::vector<KeptPathRow> rows;
  std::vector<std::string> names = panel_->selected();
  const KeptPaths& all = bench_.document.paths().paths();
  for (const KeptPathPtr& path : all) {
    const bool chosen = names.size() < 2 || std::find(names.begin(), names.end(), path->name) != names.end();
    if (chosen) rows.push_back(rowOf(path));
  }
  const auto measure = [this, rows,
                        scenario = bench_.document.scenario()](const WorkWatch& watch) -> BackgroundTask::Delivery {
    std::vector<ComparedPath> compared;
    const auto query = scenario->problem.world->makeQuery();
    for (const KeptPathRow& row : rows) {
      compared.push_back({row, nullptr});
      if (!row.proof.path) continue;
      compared.back().profile = std::make_shared<const ClearanceProfile>(clearanceProfile(
          *query, row.proof.path->configurations(), scenario->problem.metric(), kComparedSamples, watch));
    }
    return [this, scenario, compared] {
      auto* dialog = new ComparePathsDialog(compared, *scenario, &bench_.window);
      dialog->setAttribute(Qt::WA_DeleteOnClose);
      connect(&bench_.document, &WorkbenchDocument::changed, dialog, [dialog](Changes what) {
        if (what & (Change::Scenario | Change::Arrangement))
          dialog->close();  // its scenario or arrangement has changed
      });
      dialog->show();
    };
  };
  bench_.work.run(tr("Comparing paths"), measure);
}

void KeptPathsController::showFailure(const Outcome& outcome) {
  if (!outcome) bench_.messages.showError(tr("Not possible with this path"), outcome.error());
}

/// The path that a script names: by its name, or by @1 for the first of the list.
Result<KeptPathPtr> KeptPathsController::named(const std::string& word) const {
  const KeptPaths& paths = bench_.document.paths().paths();
  if (!word.empty() && word.front() == '@') {
    const auto number = toNumber(word.substr(1));
    const bool inList = number && *number >= 1.0 && *number <= static_cast<double>(paths.size());
    if (inList) return paths[static_cast<std::size_t>(*number) - 1];
  } else if (KeptPathPtr path = bench_.document.paths().find(word)) {
    return path;
  }
  return wrongCommand("there is no kept path '" + word + "'");
}

void KeptPathsController::addCommands() {
  using Words = ScriptCommands::Words;
  const auto add = [this](const char* name, std::size_t words, auto what) {
    bench_.scripts.add(name, words, [this, what](const Words& given) -> Outcome {
      const auto path = named(given[0]);
      return path ? what(**path, given) : Outcome(path.error());
    });
  };
  add("select-path", 1, [this](const KeptPath& path, const Words&) -> Outcome {
    panel_->select(path.name);
    return Done{};
  });
  add("rename-path", 2,
      [this](const KeptPath& path, const Words& words) { return bench_.document.paths().rename(path.name, words[1]); });
  add("show-path", 2, [this](const KeptPath& path, const Words& words) -> Outcome {
    if (words[1] != "yes" && words[1] != "no") return wrongCommand("say yes or no");
    words[1] == "yes" ? (void)shown_.insert(path.name) : (void)shown_.erase(path.name);
    showRows();
    return Done{};
  });
  add("open-kept-path", 1, [this](const KeptPath& path, const Words&) { return openPath(path.name); });
  add("expect-kept-path", 2, [this](const KeptPath& path, const Words& words) -> Outcome {
    const std::string found = kProofNames.of(proofOf(path).state);
    if (found == words[1]) return Done{};
    return unmetExpectation("the kept path '" + path.name + "' is '" + found + "', not '" + words[1] + "'");
  });
  bench_.scripts.add("expect-kept-paths", 1, [this](const Words& words) -> Outcome {
    const std::string number = std::to_string(bench_.document.paths().paths().size());
    if (number == words[0]) return Done{};
    return unmetExpectation("there are " + number + " kept paths, not " + words[0]);
  });
  bench_.scripts.add("compare-screenshot", 1, [this](const Words& words) -> Outcome {
    auto* dialog = bench_.window.findChild<QDialog*>(QStringLiteral("compare-paths"));
    if (dialog == nullptr) return wrongCommand("no paths are compared");
    const SaveResult saved = savePicture(dialog->grab().toImage(), QString::fromStdString(words[0]));
    return saved ? Outcome(Done{}) : Outcome(saved.why);
  });
}

}  // namespace glissade
