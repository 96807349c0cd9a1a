#pragma once

#include <optional>

#include "app/window/film_job.h"
#include "app/window/instruction_job.h"
#include "app/window/workbench.h"
#include "engine/sequence/plan_playback.h"
#include "widgets/bridge/sequence_planner.h"
#include "widgets/panels/sequence_panel.h"

namespace glissade {

class PlanGraphView;

/// The assembly plan of the product that is open: planned on a worker, shown and played in the scene, read from files
/// and written into them. It holds for one arrangement; in another one its steps are judged again. Which bodies stay is
/// an attribute of bodies ("stays"), which is undoable and saved with the scenario; where nobody says so, the largest
/// stays.
class SequenceController final : public QObject {
  Q_OBJECT

 public:
  explicit SequenceController(const Workbench& bench);

  SequencePanel* panel() const { return panel_; }
  const ShownPlan& shown() const { return panel_->shown(); }
  /// Plans anew, or goes on. `mostSteps`: stops there.
  void plan(bool resume, std::optional<std::size_t> mostSteps = std::nullopt);
  /// Reads a plan of the product that is open and judges it; nothing on success.
  std::optional<Diagnostic> open(const QString& file);
  /// Plans as JSON, as the command line writes them; steps as CSV, an animation as GLB, a work instruction as HTML or
  /// PDF, a film as MP4, WebM or a series of pictures, by the ending of the file.
  /// `finished` is called when it is done: at once, or later for a work instruction and a film.
  void exportTo(const QString& file, const InstructionJob::Finished& finished);
  /// The name of the scenario, or of its file.
  std::string productName() const;
  /// The scene as the panel's sliders have it.
  void showPanelsScene();
  /// The scene at so many steps of removal, parts moved apart by a share of the exploded view.
  void showScene(double time, double exploded);

 private:
  void connectActions();
  void followDocument(Changes what);
  void takeGrown(const GrownPlan& grown, bool growing);
  void takeJudged(const PlanPtr& plan, const std::vector<bool>& agreed);
  void setPlan(const ShownPlan& shown);
  void showStuck(const QString& bodyId);
  void showGraph();
  /// The graph follows the plan while it is open.
  void updateGraph();
  void toggleStays();
  void chooseFile();
  void chooseExport();
  void film(const QString& file, const FilmJob::Finished& finished);
  void enableActions();

  const Workbench& bench_;
  SequencePanel* panel_;
  SequencePlanner planner_;
  std::size_t knownSteps_ = 0;  ///< of the plan that planning has begun with
  PlanPlayback playback_;
  std::vector<Vector3> offsets_;  ///< of the exploded view
  PlanGraphView* graph_ = nullptr;
  InstructionJob* instruction_;
  FilmJob film_;
};

}  // namespace glissade
