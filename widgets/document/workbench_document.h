#pragma once

#include <QFlags>
#include <QObject>
#include <QUndoStack>

#include <functional>
#include <optional>

#include "engine/planning/path_examination.h"
#include "engine/scenario/assembly_edits.h"
#include "engine/scenario/scenario_ptr.h"
#include "widgets/document/arrangement_queue.h"
#include "widgets/document/path_shelf.h"
#include "widgets/document/semantic_document.h"

namespace glissade {

/// What of the document has changed. Opening another scenario changes everything.
enum class Change {
  Scenario = 0x01,     ///< another scenario was opened
  Arrangement = 0x02,  ///< its bodies, its object, start, goal, workspace or rules
  Semantics = 0x04,    ///< the user's semantic edits
  Knowledge = 0x08,    ///< the environment model
  Options = 0x10,      ///< how the environment is modelled
  Settings = 0x20,     ///< strategy, seed and parameters of the next run
  Results = 0x40,      ///< the path
  File = 0x80,         ///< the file, and whether it has all edits
  Paths = 0x100,       ///< the paths that are kept
  Sequence = 0x200     ///< what is demanded of assembly plans
};

Q_DECLARE_FLAGS(Changes, Change)
Q_DECLARE_OPERATORS_FOR_FLAGS(Changes)

inline constexpr int kEveryChange = 0x3ff;

/// What the next run begins with, as the session has it.
struct RunSettings {
  std::string strategy;
  std::uint64_t seed = 1;
  ParameterValues parameters{1.0};

  friend bool operator==(const RunSettings&, const RunSettings&) = default;
};

/// The path that is there: found by the run, or given and examined.
struct RunResults {
  std::shared_ptr<const Path> path;                ///< certified; null: none
  std::shared_ptr<const PathExamination> refused;  ///< a path that does not hold here; null: none
  PathProvenance provenance;                       ///< of either
  bool smoothed = false;                           ///< `path` was shortened after it was planned

  friend bool operator==(const RunResults& a, const RunResults& b) {
    return a.path == b.path && a.refused == b.refused && a.smoothed == b.smoothed;
  }
};

/// What the user edits and shares: the scenario with its arrangement, semantic edits, rules and environment options,
/// the undo stack, the environment model, the results, the file. Everything else in the window observes it and posts
/// edits to it (README.md). Used on the GUI thread only.
///
/// A change is announced in a round of three signals: changedForView(), changedForSession(), changed(). The order of
/// the observers of one signal does not matter. A change that an observer makes is announced in a round of its own,
/// after the present one.
class WorkbenchDocument final : public QObject {
  Q_OBJECT

 public:
  explicit WorkbenchDocument(QObject* parent = nullptr);
  ~WorkbenchDocument() override;

  /// Null until a scenario was opened; never null again.
  const ScenarioPtr& scenario() const { return scenario_; }
  /// The scenario with the semantic edits as they are: what an edit begins with.
  Scenario current() const;
  SemanticDocument& semantics() { return semantics_; }
  const SemanticDocument& semantics() const { return semantics_; }
  /// The semantic edits as they count, shared with the session.
  const SemanticEditsPtr& edits() const { return edits_; }
  const SceneKnowledgePtr& knowledge() const { return semantics_.knowledge(); }
  const EnvironmentOptions& options() const { return options_; }
  const RunSettings& settings() const { return settings_; }
  const RunResults& results() const { return results_; }
  /// The paths that are kept in the scenario.
  PathShelf& paths() { return paths_; }
  const PathShelf& paths() const { return paths_; }
  /// What is demanded of assembly plans, beside what attributes of bodies say.
  const SequenceDemands& demands() const { return demands_; }
  /// Undoable.
  void setDemands(const QString& text, const SequenceDemands& demands);
  /// The assembly plan that was found or opened last; null: none. It may not hold for the arrangement any more.
  const std::shared_ptr<const AssemblyPlan>& plan() const { return plan_; }
  /// A plan is a result: it is saved with the scenario, and no step of the undo stack.
  void setPlan(const std::shared_ptr<const AssemblyPlan>& plan);
  /// For observers; undo() and redo() do not wait for geometry.
  QUndoStack& undoStack() { return undo_; }

  /// Replaces everything. One without a file counts as modified until it is saved. What was left for later when it was
  /// loaded (fits, the world's preparation) is done in the background, announced as a change of the arrangement; where
  /// edits are done at once, when whenArranged() needs it.
  void open(const ScenarioPtr& scenario);
  /// Changes a scenario; refused with an error.
  using ScenarioChange = std::function<Outcome(Scenario&)>;
  /// Changes the scenario, as an undoable command. Its geometry is loaded in the background (setAtOnce()); edits are
  /// made one after the other, each of the scenario that the one before has left. Refused where its geometry cannot be
  /// loaded: the error is returned where edits are made at once, else announced by editFailed(). Edits with one
  /// `mergeKey` become one.
  Outcome edit(const QString& text, ScenarioChange change, const QString& mergeKey = {});
  /// The same, for a while: until it is undone, what is saved is the scenario of before, and isModified() is about that
  /// one. Edits of bodies that are made meanwhile go with it: once undone, they are not done again.
  Outcome editTemporarily(const QString& text, ScenarioChange change);
  /// The scenario is a temporary one.
  bool isTemporary() const { return aside_.has_value(); }
  /// Undoes the temporary scenario and all edits that were made in it.
  void endTemporary();
  /// Puts a body, or an end of the motion, somewhere; undoable.
  Outcome place(const AssemblyItem& item, const Pose& X_WB, const QString& mergeKey = {});
  void undo() { stepBack(false); }
  void redo() { stepBack(true); }
  /// Edits are done before edit() returns. At first they are.
  void setAtOnce(bool atOnce) { queue_.setAtOnce(atOnce); }
  /// Edits are under way.
  bool isArranging() const { return !queue_.isEmpty(); }
  /// Calls `then` once no edit is under way and the fits are known: at once where that is so. Not at all where the fits
  /// cannot be found, which editFailed() announces.
  void whenArranged(const std::function<void()>& then);
  /// Forgets the edits that are under way.
  void cancelEdits();
  const BackgroundTask& arranging() const { return queue_.task(); }
  /// An edit of bodies is under way, not only the preparation of a scenario that was opened.
  bool isEditing() const { return queue_.hasEdits(); }
  /// The environment model of the arrangement as it is. The same again: it holds for this arrangement, too.
  void setKnowledge(const SceneKnowledgePtr& knowledge);
  void setOptions(const EnvironmentOptions& options);
  void setSettings(const RunSettings& settings);
  void setResults(const RunResults& results);

  /// A run found the path that is there, and it is neither kept nor exported.
  bool hasUnkeptPath() const { return unkept_; }
  /// Keeps the path that is there as "Path 1", ..., undoable; nothing where there is none, or it is kept already.
  void keepResult();
  /// The path was written to a file of its own.
  void noteExported(const std::shared_ptr<const Path>& path);

  /// What is written into this file: assets are named as seen from there. A path that is not kept yet is among the
  /// kept ones. While the scenario is a temporary one, the scenario of before.
  Scenario contentFor(const std::string& file) const;
  /// The same with where its forbidden places are. It takes as long as building the environment model.
  Scenario savedContentFor(const std::string& file) const;
  /// `content` was written into the file, which is the document's from now on.
  void noteSaved(const std::string& file, const Scenario& content);
  /// What Save would write is not what the file holds. Seed and parameters do not count: they are tried out.
  bool isModified() const;
  /// The plan is not what the file holds.
  bool hasUnsavedPlan() const;
  /// The same, a path that a run found and the plan left aside.
  bool hasUnsavedEdits() const;
  /// The file has the same bodies, ends and geometry: a recording that names the file can be replayed.
  bool isProblemSaved() const;

  /// Geometry that was read meanwhile, and need not be read again.
  void addGeometry(const GeometryCache& read) { geometry_.insert(read.begin(), read.end()); }
  const GeometryCache& geometry() const { return geometry_; }

 signals:
  /// First, for the 3D view: it knows the scenario before a session publishes a snapshot of it.
  void changedForView(glissade::Changes what);
  /// Second, for what runs: the session, background work.
  void changedForSession(glissade::Changes what);
  /// Third, for panels and controllers.
  void changed(glissade::Changes what);
  /// An edit could not be made, undone or done again, or it was cancelled (then there is no reason).
  void editFailed(const std::optional<glissade::Diagnostic>& why);

 private:
  friend class ArrangementCommand;
  /// What a temporary scenario has taken the place of.
  struct SetAside {
    ScenarioPtr loaded;
    Scenario scenario;
    bool saved = false;  ///< its edits are
    int index = 0;       ///< of the undo stack
  };

  Outcome addEdit(const QString& text, ScenarioChange change, const QString& mergeKey, bool temporary);
  void followUndo();
  void takeDemands(const SequenceDemands& demands);
  void announce(Changes what);
  /// Announces all that `change` does in one round.
  void changeInOneRound(const std::function<void()>& change);
  Scenario assembled(const Scenario& assembly, const std::string& file) const;
  ArrangementQueue::Load loader() const;
  void stepBack(bool forth);
  void finishOpening();
  void takeArrangement(const ScenarioPtr& scenario);
  void applyArrangement(const Scenario& assembly, const std::string& file);
  KeptPath resultAsKept() const;
  void noteUnkept();

  QUndoStack undo_;
  SemanticDocument semantics_;
  PathShelf paths_;
  ScenarioPtr scenario_;
  SequenceDemands demands_;
  std::shared_ptr<const AssemblyPlan> plan_;
  SemanticEditsPtr edits_ = std::make_shared<const SemanticEdits>();
  EnvironmentOptions options_;
  RunSettings settings_;
  RunResults results_;
  std::optional<SetAside> aside_;       ///< nothing: the scenario is the person's
  std::weak_ptr<const Path> exported_;  ///< the path that was exported last
  bool unkept_ = false;                 ///< as of hasUnkeptPath()
  std::string savedProblem_;            ///< hash of the problem as it was opened or saved; empty: it never was
  GeometryCache geometry_;              ///< all geometry that this scenario had since it was opened
  Changes pending_;
  bool collecting_ = false;  ///< changes are announced later, in one round
  bool announcing_ = false;
  std::uint64_t version_ = 0;  ///< grows with what an edit is based on
  ScenarioPtr prepared_;  ///< what the command of the undo stack that is done now has to take; null: not loaded yet
  ArrangementQueue queue_;
};

}  // namespace glissade
