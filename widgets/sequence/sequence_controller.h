#pragma once

#include <optional>

#include "engine/sequence/exploded_view.h"
#include "engine/sequence/plan_playback.h"
#include "widgets/document/sequence_planner.h"
#include "widgets/film/film_job.h"
#include "widgets/sequence/instruction_job.h"
#include "widgets/sequence/sequence_edits.h"
#include "widgets/sequence/sequence_hand.h"
#include "widgets/sequence/sequence_panel.h"
#include "widgets/sequence/work_times_store.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

class InstructionController;
class PlanGraphView;
class WindowMemory;

/// The assembly plan of the open product: plans it on a worker, shows and plays it in the scene, reads and writes it;
/// the document keeps it. It holds for one arrangement; in another one its steps are judged again. The attribute
/// "stays" of bodies determines which bodies stay; it is undoable and saved with the scenario. Without it the largest
/// body stays.
class SequenceController final : public QObject {
  Q_OBJECT

 public:
  explicit SequenceController(const Workbench& bench);

  SequencePanel* panel() const { return panel_; }
  const ShownPlan& shown() const { return panel_->shown(); }
  /// Work times for all plans.
  WorkTimesStore& workTimes() { return workTimes_; }
  /// Plans from the start, or resumes. `mostSteps`: the number of steps after which planning stops.
  void plan(bool resume, std::optional<std::size_t> mostSteps = std::nullopt);
  /// Steps that a person moves or locks: the demands with their places, the order, and the text of the edit.
  struct StepMove {
    QString text;
    SequenceDemands demands;
    std::vector<std::size_t> order;
    BodyId body;  ///< a body of the step
  };
  /// Puts the steps into the order if their motions are free in it; else it names the steps that keep their order, and
  /// nothing changes unless the person has the other steps planned anew.
  void moveStep(StepMove move);
  /// Whether a person may change the shown steps.
  bool isEditable() const;
  /// Shows the plan of the present scenario and demands if it is known.
  void showRemembered() { followArrangement(false); }
  /// Keeps the result of the independent check of this plan, and of the access check.
  void note(const PlanPtr& plan, const PlanCheck& check, const PlanAccessPtr& access);
  /// Keeps how the product lies in each step of this plan.
  void noteViews(const PlanPtr& plan, const std::vector<Viewpoint>& views);
  /// The demands that the document holds about the product.
  SequenceDemands statedDemands(const AssembledProduct& product) const;
  /// Chooses the row of this body when the next plan is shown.
  void chooseLater(const BodyId& body) { chosenLater_ = body; }
  /// Reads a plan of the open product and judges it; returns nothing on success.
  std::optional<Diagnostic> open(const QString& file);
  /// Restores the remembered table of times and template of work instructions, and remembers later changes.
  void remember(WindowMemory& memory);
  /// The documents about plans.
  InstructionController& instructions() { return *instructions_; }
  /// Exports the plan in the format of the file's ending: JSON as the command line writes it, steps as CSV, an
  /// animation as GLB, a work instruction as HTML or PDF, a film as MP4, WebM or a series of pictures. `finished` is
  /// called at once, or later for a work instruction and a film.
  void exportTo(const QString& file, const InstructionJob::Finished& finished);
  /// Exports as exportTo(), and a message shows the result.
  void exportAndReport(const QString& file);
  /// Shows the result of writing a file of the plan.
  void tell(const QString& file, const SaveResult& saved);
  /// For scripts: calls `write` and returns the result if it is known at once; on screen a message shows it later.
  Outcome written(const std::string& file, const std::function<void(const InstructionJob::Finished&)>& write);
  /// Raises the panel and makes its dock large enough for the table.
  void bringToFront();
  /// Shows the scene at the positions of the panel's sliders.
  void showPanelsScene();

 signals:
  /// Another plan, or none, is shown.
  void planShown();

 private:
  void connectActions();
  void followDocument(Changes what);
  void followArrangement(bool another);
  /// Whether planning begins at once, or when no further edit has come for some seconds.
  enum class Settling { AtOnce, Later };
  void followDemands(Settling settling);
  bool knowsOtherDemands();
  /// Makes the demands of an opened plan the document's.
  void adoptDemands(const AssemblyPlan& plan);
  /// The product of the scenario; the known object if the product has not changed.
  ProductPtr presentProduct() const;
  /// The last plan for this product and these demands; nothing if there is none.
  std::optional<ShownPlan> rememberedPlan(const ProductPtr& product) const;
  void remember();
  PlanPtr earlierPlan() const;
  /// Plans as plan(), but does not raise the panel.
  void startPlanning(bool resume, std::optional<std::size_t> mostSteps);
  /// A job for the present product with the places and motions of these demands; says why there is none.
  std::optional<SequenceJob> jobWith(const SequenceDemands& demands);
  void takeMoved(const PlanPtr& plan);
  void refuseMove(const OrderConflict& why);
  void takeGrown(const GrownPlan& grown, bool growing);
  void setPlan(const ShownPlan& shown);
  /// Shows the plan and gives it to the document, which saves it with the scenario.
  void keepPlan(const ShownPlan& shown);
  void showGraph();
  /// Updates the graph if it is open.
  void updateGraph();
  void toggleStays();
  void chooseFile();
  void chooseExport();
  void chooseFilm();
  /// The scene at a time of the removal in steps. `exploded`: share by which parts are moved apart.
  void fitExploded();
  SequencePicture pictureAt(double time, double exploded);
  void film(const QString& file, const FilmJob::Finished& finished);
  void enableActions();

  const Workbench& bench_;
  SequencePanel* panel_;
  SequencePlanner planner_;
  WorkTimesStore workTimes_;
  PlanPlayback playback_;
  bool isExploded_ = false;               ///< the exploded view is shown
  std::optional<ExplodedView> exploded_;  ///< of the shown plan, after it was exploded first
  PlanGraphView* graph_ = nullptr;
  InstructionController* instructions_;
  FilmJob film_;
  std::vector<ShownPlan> memory_;  ///< the last plans of this scenario, for undo
  StepMove move_;                  ///< the step that is moved now, or was moved last
  BodyId chosenLater_;             ///< empty: the chosen row stays
  QTimer settling_;                ///< runs after edits that others may follow; planning begins at its end
  bool adopting_ = false;
  std::optional<SequenceDemands>
      knownDemands_;  ///< with those from classes and attributes; nothing: they are contradictory
  SequenceEdits* edits_;
  SequenceHand* hand_;
};

}  // namespace glissade
