#pragma once

#include <optional>

#include "app/window/film_job.h"
#include "app/window/instruction_job.h"
#include "app/window/sequence_edits.h"
#include "app/window/sequence_hand.h"
#include "app/window/work_times_store.h"
#include "app/window/workbench.h"
#include "engine/sequence/exploded_view.h"
#include "engine/sequence/plan_playback.h"
#include "widgets/bridge/sequence_planner.h"
#include "widgets/panels/sequence_panel.h"

namespace glissade {

class InstructionController;
class PlanGraphView;
class WindowMemory;

/// The assembly plan of the product that is open: planned on a worker, shown and played in the scene, read from files
/// and written into them, and kept by the document. It holds for one arrangement; in another one its steps are judged
/// again. Which bodies stay is an attribute of bodies ("stays"), which is undoable and saved with the scenario; where
/// nobody says so, the largest stays.
class SequenceController final : public QObject {
  Q_OBJECT

 public:
  explicit SequenceController(const Workbench& bench);

  SequencePanel* panel() const { return panel_; }
  const ShownPlan& shown() const { return panel_->shown(); }
  /// Of every plan.
  WorkTimesStore& workTimes() { return workTimes_; }
  /// Plans anew, or goes on. `mostSteps`: stops there.
  void plan(bool resume, std::optional<std::size_t> mostSteps = std::nullopt);
  /// A person may change the steps that are shown.
  bool isEditable() const;
  /// The plan of the scenario and the demands as they are, where it is known.
  void showRemembered() { followArrangement(false); }
  /// Keeps the result of the independent check of this plan, and the access of a hand to its steps.
  void note(const PlanPtr& plan, const PlanCheck& check, const PlanAccessPtr& access);
  /// By a person of the product, in the document.
  SequenceDemands saidOf(const AssembledProduct& product) const;
  /// The row of this body becomes the current one when the next plan is there.
  void chooseLater(const std::string& body) { chosenLater_ = body; }
  /// Reads a plan of the product that is open and judges it; nothing on success.
  std::optional<Diagnostic> open(const QString& file);
  /// The table of times and the template of work instructions become those that are remembered, and are remembered.
  void remember(WindowMemory& memory);
  /// The documents that are made of plans.
  InstructionController& instructions() { return *instructions_; }
  /// Plans as JSON, as the command line writes them; steps as CSV, an animation as GLB, a work instruction as HTML or
  /// PDF, a film as MP4, WebM or a series of pictures, by the ending of the file.
  /// `finished` is called when it is done: at once, or later for a work instruction and a film.
  void exportTo(const QString& file, const InstructionJob::Finished& finished);
  /// The same; a message says what came of it.
  void exportAndTell(const QString& file);
  /// Says what has come of a file of the plan.
  void tell(const QString& file, const SaveResult& saved);
  /// For scripts: what a file that `write` writes comes to, at once; on screen a message says so later.
  Outcome written(const std::string& file, const std::function<void(const InstructionJob::Finished&)>& write);
  /// The panel, with a dock that is large enough for the table.
  void bringToFront();
  /// The scene as the panel's sliders have it.
  void showPanelsScene();

 signals:
  /// Another plan, or none.
  void planShown();

 private:
  void connectActions();
  void followDocument(Changes what);
  void followArrangement(bool another);
  /// After a change of the demands: a plan that is known already, or a new one.
  void followDemands();
  bool knowsOtherDemands();
  /// The demands of a plan that is opened become the document's.
  void adoptDemands(const AssemblyPlan& plan);
  /// The product of the scenario; the same object as before where it is the same product.
  ProductPtr presentProduct() const;
  /// A plan of this product and these demands; nothing where there was none.
  std::optional<ShownPlan> rememberedPlan(const ProductPtr& product) const;
  void remember();
  /// As plan(), wherever the panel is.
  void startPlanning(bool resume, std::optional<std::size_t> mostSteps);
  void takeGrown(const GrownPlan& grown, bool growing);
  void setPlan(const ShownPlan& shown);
  /// Shows the plan, and the document has it: it is saved with the scenario.
  void keepPlan(const ShownPlan& shown);
  void showGraph();
  /// The graph follows the plan while it is open.
  void updateGraph();
  void toggleStays();
  void chooseFile();
  void chooseExport();
  void chooseFilm();
  /// The scene at so many steps of removal, parts moved apart by a share of the exploded view.
  SequencePicture pictureAt(double time, double exploded);
  void film(const QString& file, const FilmJob::Finished& finished);
  void enableActions();

  const Workbench& bench_;
  SequencePanel* panel_;
  SequencePlanner planner_;
  WorkTimesStore workTimes_;
  std::size_t knownSteps_ = 0;  ///< of the plan that planning has begun with
  PlanPlayback playback_;
  std::optional<ExplodedView> exploded_;  ///< of the plan that is shown, once it was moved apart
  PlanGraphView* graph_ = nullptr;
  InstructionController* instructions_;
  FilmJob film_;
  std::vector<ShownPlan> memory_;  ///< plans of this scenario, the last ones: for undo
  std::string chosenLater_;        ///< id; empty: the row stays
  bool adopting_ = false;
  std::optional<SequenceDemands> knownDemands_;  ///< with what classes and attributes say; nothing: they are wrong
  SequenceEdits* edits_;
  SequenceHand* hand_;
};

}  // namespace glissade
