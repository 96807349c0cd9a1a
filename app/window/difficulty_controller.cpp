#include "app/window/difficulty_controller.h"

#include "app/window/work_controller.h"
#include "engine/session/grown_roadmap.h"

namespace glissade {

DifficultyController::DifficultyController(const ActionCatalogue& actions, SceneWidget& scene, WorkController& work,
                                           QWidget* window)
    : QObject(window), actions_(actions), scene_(scene), work_(work), panel_(new DifficultyPanel(actions, window)) {
  connect(actions[QStringLiteral("difficulty.find")], &QAction::triggered, this, [this] { find(); });
  QAction* play = actions[QStringLiteral("difficulty.play")];
  connect(play, &QAction::toggled, panel_, &DifficultyPanel::setPlaying);
  connect(panel_, &DifficultyPanel::playbackEnded, this, [play] { play->setChecked(false); });
  connect(panel_, &DifficultyPanel::poseShown, this, [this](const std::optional<Pose>& pose) {
    scene_.view().setPlaybackPose(pose);
    scene_.refresh();
  });
  for (const char* id : {"difficulty.find", "difficulty.play"}) actions[QLatin1String(id)]->setEnabled(false);
}

void DifficultyController::open(const ScenarioPtr& scenario) {
  scenario_ = scenario;
  snapshot_.reset();
  show(nullptr);
}

void DifficultyController::showSnapshot(const SnapshotPtr& snapshot, bool live) {
  const bool inVain = live && searchedInVain(*snapshot);
  actions_[QStringLiteral("difficulty.find")]->setEnabled(inVain);
  if (live) snapshot_ = snapshot;
  if (difficulty_ && !inVain) show(nullptr);
}

void DifficultyController::find() {
  work_.run(tr("Looking for what stands in the way"),
            [this, scenario = scenario_, end = snapshot_](const WorkWatch& watch) -> BackgroundTask::Delivery {
              const GrownRoadmap grown = grownRoadmap(*end);
              const auto difficulty = std::make_shared<const Difficulty>(
                  difficultyOf(scenario->problem, grown.nodes, grown.edges, end->parameters, end->seed, {}, watch));
              return [this, difficulty, run = end->run] {
                if (snapshot_ && snapshot_->run == run && searchedInVain(*snapshot_)) show(difficulty);
              };
            });
}

void DifficultyController::show(const DifficultyPtr& difficulty) {
  difficulty_ = difficulty;
  scene_.view().setDifficulty(difficulty);
  panel_->setDifficulty(difficulty, *scenario_);
  actions_[QStringLiteral("difficulty.play")]->setEnabled(difficulty && difficulty->leastPenetration);
  scene_.refresh();
  if (difficulty) emit found();
}

}  // namespace glissade
