#include "widgets/run/difficulty_controller.h"

#include "engine/session/grown_roadmap.h"

namespace glissade {
namespace {

/// The body that a part names; nothing where the part is not there.
std::optional<int> bodyOf(const Difficulty& difficulty, const std::string& part) {
  if (part == "least" && difficulty.leastPenetration) return difficulty.leastPenetration->body;
  if (part == "tightest" && difficulty.tightest) return difficulty.tightest->body;
  if (part == "frontier" && difficulty.frontier) return difficulty.frontier->body;
  return std::nullopt;
}

Outcome expect(const LoadedScenario& scenario, const DifficultyPtr& difficulty, const std::string& part,
               const std::string& body) {
  const auto found = difficulty ? bodyOf(*difficulty, part) : std::nullopt;
  const std::string name = !found || *found < 0 ? "-" : scenario.obstacles[static_cast<std::size_t>(*found)].id.text();
  if (name == body) return Done{};
  return unmetExpectation("'" + part + "' names " + name + ", not " + body);
}

/// Adds the script commands about the reasons why no path was found.
void addDifficultyCommands(const Workbench& bench, DifficultyController& difficulty) {
  using Words = ScriptCommands::Words;
  bench.scripts.add("show-difficulty", 1, [&difficulty](const Words& words) -> Outcome {
    if (difficulty.panel()->showPart(QString::fromStdString(words[0]))) return Done{};
    return wrongCommand("nothing is known of '" + words[0] + "'");
  });
  bench.scripts.add("expect-difficulty", 2, [&bench, &difficulty](const Words& words) -> Outcome {
    if (!bench.document.scenario()) return wrongCommand("no scenario is open");
    return expect(*bench.document.scenario(), difficulty.difficulty(), words[0], words[1]);
  });
}

/// The share of the work that finds the reasons; the rest finds places to help.
constexpr double kReasons = 0.7;

}  // namespace

DifficultyController::DifficultyController(const Workbench& bench)
    : QObject(&bench.window),
      bench_(bench),
      assist_(new AssistController(bench)),
      panel_(new DifficultyPanel(bench.actions, &bench.window)) {
  bench.onAction("difficulty.find", this, [this] { find(); });
  QAction* play = bench.actions["difficulty.play"];
  connect(play, &QAction::toggled, panel_, &DifficultyPanel::setPlaying);
  connect(panel_, &DifficultyPanel::playbackEnded, this, [play] { play->setChecked(false); });
  connect(panel_, &DifficultyPanel::poseShown, this, [this](const std::optional<Pose>& pose) {
    bench_.scene.view().setPlaybackPose(pose);
    bench_.scene.refresh();
  });
  connect(panel_, &DifficultyPanel::helpChosen, assist_, &AssistController::choose);
  connect(assist_, &AssistController::cameraMoved, this, &DifficultyController::cameraMoved);
  connect(&bench.document, &WorkbenchDocument::changed, this, [this](Changes what) {
    if (what & (Change::Scenario | Change::Arrangement)) show(nullptr, nullptr);
  });
  connect(panel_, &DifficultyPanel::lengthUnitChanged, this, [this] {
    if (bench_.document.scenario()) panel_->setDifficulty(difficulty_, help_, *bench_.document.scenario());
  });
  connect(&bench.run, &ShownRun::changed, this, &DifficultyController::followRun);
  for (const char* id : {"difficulty.find", "difficulty.play"}) bench.enable(id, false);
  addDifficultyCommands(bench, *this);
}

void DifficultyController::followRun() {
  const bool failed = bench_.run.isLive() && searchFailed(*bench_.run.snapshot());
  bench_.enable("difficulty.find", failed);
  if (difficulty_ && !failed) show(nullptr, nullptr);
}

void DifficultyController::find() {
  bench_.work.run(
      tr("Looking for the reasons"),
      [this, scenario = bench_.document.scenario(),
       end = bench_.session.snapshot()](const WorkWatch& watch) -> BackgroundTask::Delivery {
        const GrownRoadmap grown = grownRoadmap(*end);
        const auto difficulty = std::make_shared<const Difficulty>(difficultyOf(
            scenario->problem, grown.nodes, grown.edges, end->parameters, end->seed, {}, watch.part(0.0, kReasons)));
        const auto help = std::make_shared<const std::vector<HelpPlace>>(
            helpPlaces(scenario->problem, grown.nodes, grown.edges, end->parameters, end->seed,
                       difficulty->leastPenetration, kHelpGaps, kGapBudget, watch.part(kReasons, 1.0)));
        return [this, difficulty, help, run = end->run] {
          const SnapshotPtr& now = bench_.session.snapshot();
          if (now->run == run && searchFailed(*now)) show(difficulty, help);
        };
      });
}

void DifficultyController::show(const DifficultyPtr& difficulty, const HelpPlacesPtr& help) {
  difficulty_ = difficulty;
  help_ = help;
  if (help) assist_->show(help);
  bench_.scene.view().setDifficulty(difficulty);
  panel_->setDifficulty(difficulty, help, *bench_.document.scenario());
  bench_.enable("difficulty.play", difficulty && difficulty->leastPenetration);
  bench_.scene.refresh();
  if (difficulty) bench_.actions["panel.difficulty"]->trigger();
}

}  // namespace glissade
