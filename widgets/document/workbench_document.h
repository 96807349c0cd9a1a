#pragma once

#include <QFlags>
#include <QObject>
#include <QUndoStack>

#include <functional>
#include <optional>

#include "engine/files/assembly_edits.h"
#include "engine/files/scenario_ptr.h"
#include "engine/planning/path_examination.h"
#include "widgets/document/arrangement_queue.h"
#include "widgets/document/path_shelf.h"
#include "widgets/document/semantic_document.h"

namespace glissade {

/// Parts of the document that have changed. Opening another scenario changes every part.
enum class Change {
  Scenario = 0x01,     ///< another scenario was opened
  Arrangement = 0x02,  ///< its bodies, its object, start, goal, workspace or rules
  Semantics = 0x04,    ///< the user's semantic edits
  Knowledge = 0x08,    ///< the environment model
  Options = 0x10,      ///< how the environment is modelled
  Settings = 0x20,     ///< planner, seed and parameters of the next run
  Results = 0x40,      ///< the path
  File = 0x80,         ///< the file, and whether it holds all edits
  Paths = 0x100,       ///< the paths that are kept
  Sequence = 0x200,    ///< the demands on assembly plans
  Joints = 0x400       ///< a person's edits of joints
};

Q_DECLARE_FLAGS(Changes, Change)
Q_DECLARE_OPERATORS_FOR_FLAGS(Changes)

inline constexpr int kEveryChange = 0x7ff;

/// The settings of the next run, as the session has them.
struct RunSettings {
  std::string strategy;
  std::uint64_t seed = 1;
  ParameterValues parameters{1.0};

  friend bool operator==(const RunSettings&, const RunSettings&) = default;
};

/// The present path: found by the run, or given and examined.
struct RunResults {
  std::shared_ptr<const Path> path;                ///< certified; null: none
  std::shared_ptr<const PathExamination> refused;  ///< a path that is not valid here; null: none
  PathProvenance provenance;                       ///< of the path or the refused path
  bool smoothed = false;                           ///< `path` was shortened after it was planned

  friend bool operator==(const RunResults& a, const RunResults& b) {
    return a.path == b.path && a.refused == b.refused && a.smoothed == b.smoothed;
  }
};

/// The user's document: the scenario with its arrangement, semantic edits, rules and environment options, the undo
/// stack, the environment model, the results, the file. Everything else in the window observes it and posts edits to it
/// (README.md). Used on the GUI thread only.
///
/// A change is announced in a round of three signals: changedForView(), changedForSession(), changed(). The order of
/// the observers of one signal does not matter. A change by an observer is announced in a separate round, after the
/// present one.
class WorkbenchDocument final : public QObject {
  Q_OBJECT

 public:
  explicit WorkbenchDocument(QObject* parent = nullptr);
  ~WorkbenchDocument() override;

  /// Null until a scenario was opened; never null again.
  const ScenarioPtr& scenario() const { return scenario_; }
  /// The scenario with the present semantic edits, which is the basis of an edit.
  Scenario current() const;
  SemanticDocument& semantics() { return semantics_; }
  const SemanticDocument& semantics() const { return semantics_; }
  /// The semantic edits that take effect, shared with the session.
  const SemanticEditsPtr& edits() const { return edits_; }
  const SceneKnowledgePtr& knowledge() const { return semantics_.knowledge(); }
  const EnvironmentOptions& options() const { return options_; }
  const RunSettings& settings() const { return settings_; }
  const RunResults& results() const { return results_; }
  /// The paths that are kept in the scenario.
  PathShelf& paths() { return paths_; }
  const PathShelf& paths() const { return paths_; }
  /// The demands on assembly plans, besides attributes of bodies.
  const SequenceDemands& demands() const { return demands_; }
  /// Sets the demands; undoable.
  void setDemands(const QString& text, const SequenceDemands& demands);
  /// Sets a person's edits of the joints; undoable. No body moves, so a run and proofs of paths stay.
  void setJoints(const QString& text, const std::vector<JointEdit>& joints);
  /// The assembly plan that was found or opened last; null: none. The arrangement may have changed since.
  const std::shared_ptr<const AssemblyPlan>& plan() const { return plan_; }
  /// Sets the plan. A plan is a result: it is saved with the scenario, and is no step of the undo stack.
  void setPlan(const std::shared_ptr<const AssemblyPlan>& plan);
  /// The undo stack, for observers; its own undo() and redo() do not wait for geometry.
  QUndoStack& undoStack() { return undo_; }

  /// Replaces the whole document. Nothing is modified then. Work that loading has
  /// left for later (fits, the world's preparation) is done in the background and announced as a change of the
  /// arrangement; if edits are done at once, it is done when whenArranged() needs it.
  void open(const ScenarioPtr& scenario);
  /// A change of a scenario; an error refuses it.
  using ScenarioChange = std::function<Outcome(Scenario&)>;
  /// Changes the scenario, as an undoable command. Its geometry is loaded in the background (setAtOnce()); edits are
  /// made one after the other, each on the result of the edit before. An edit is refused if its geometry cannot be
  /// loaded: the error is returned if edits are made at once, else announced by editFailed(). Edits with the same
  /// `mergeKey` become one.
  Outcome edit(const QString& text, ScenarioChange change, const QString& mergeKey = {});
  /// Changes the scenario temporarily. Until this is undone, the document saves the scenario of before, and
  /// isModified() is about that scenario. Edits of bodies that are made meanwhile are undone with it, and not done
  /// again.
  Outcome editTemporarily(const QString& text, ScenarioChange change);
  /// Whether the present scenario is a temporary one.
  bool isTemporary() const { return aside_.has_value(); }
  /// Undoes the temporary scenario and all edits that were made in it.
  void endTemporary();
  /// Sets the pose of a body, or of an end of the motion; undoable.
  Outcome place(const AssemblyItem& item, const Pose& X_WB, const QString& mergeKey = {});
  void undo() { stepBack(false); }
  void redo() { stepBack(true); }
  /// Edits are done before edit() returns, if set, which is the default.
  void setAtOnce(bool atOnce) { queue_.setAtOnce(atOnce); }
  /// Whether edits are under way.
  bool isArranging() const { return !queue_.isEmpty(); }
  /// Calls `then` once no edit is under way and the fits are known: at once if both hold. If the fits cannot be found,
  /// `then` is not called, and editFailed() announces the reason.
  void whenArranged(const std::function<void()>& then);
  /// Forgets the edits that are under way.
  void cancelEdits();
  const BackgroundTask& arranging() const { return queue_.task(); }
  /// Whether an edit of bodies is under way, not only the preparation of a scenario that was opened.
  bool isEditing() const { return queue_.hasEdits(); }
  /// Sets the environment model of the present arrangement. Setting the present model again states that it is valid for
  /// this arrangement, too.
  void setKnowledge(const SceneKnowledgePtr& knowledge);
  void setOptions(const EnvironmentOptions& options);
  void setSettings(const RunSettings& settings);
  void setResults(const RunResults& results);

  /// Whether a run found the present path, and it is neither kept nor exported.
  bool hasUnkeptPath() const { return unkept_; }
  /// Keeps the present path as "Path 1", ..., undoable; does nothing if there is no path, or it is kept already.
  void keepResult();
  /// Notes that the path was written to a file of its own.
  void noteExported(const std::shared_ptr<const Path>& path);

  /// The scenario to write into this file, with assets named relative to it. A path that is not kept yet is among the
  /// kept ones. While a temporary scenario is open, this is the scenario of before.
  Scenario contentFor(const std::string& file) const;
  /// contentFor() with the regions of its forbidden places. It takes as long as building the environment model.
  Scenario savedContentFor(const std::string& file) const;
  /// Notes that `content` was written into the file, which is the document's from now on.
  void noteSaved(const std::string& file, const Scenario& content);
  /// Whether there are changes to save. Seed, parameters and a path that is not kept are tried out, and do not count.
  bool isModified() const;
  /// Whether the plan differs from the file's.
  bool hasUnsavedPlan() const;
  /// Whether there are unsaved changes apart from the plan.
  bool hasUnsavedEdits() const;
  /// Whether the file has the present bodies, ends and geometry: a recording that names the file can be replayed then.
  bool isProblemSaved() const;

  /// Takes geometry that was read meanwhile, which then need not be read again.
  void addGeometry(const GeometryCache& read) { geometry_.insert(read.begin(), read.end()); }
  const GeometryCache& geometry() const { return geometry_; }

 signals:
  /// The first signal of a round, for the 3D view: it knows the scenario before a session publishes a snapshot of it.
  void changedForView(glissade::Changes what);
  /// The second signal, for everything that runs: the session and background work.
  void changedForSession(glissade::Changes what);
  /// The third signal, for panels and controllers.
  void changed(glissade::Changes what);
  /// An edit could not be made, undone or redone, or it was cancelled (then there is no reason).
  void editFailed(const std::optional<glissade::Diagnostic>& why);

 private:
  friend class ArrangementCommand;
  /// The scenario that a temporary one has replaced.
  struct SetAside {
    ScenarioPtr loaded;
    Scenario scenario;
    bool saved = false;  ///< its edits are saved
    int index = 0;       ///< index of the undo stack before the temporary edit
  };

  Outcome addEdit(const QString& text, ScenarioChange change, const QString& mergeKey, bool temporary);
  void followUndo();
  void takeDemands(const SequenceDemands& demands);
  void takeJoints(const std::vector<JointEdit>& joints);
  void announce(Changes what);
  /// Announces all changes by `change` in one round.
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
  std::optional<SetAside> aside_;       ///< nothing: the present scenario is not temporary
  std::weak_ptr<const Path> exported_;  ///< the path that was exported last
  bool unkept_ = false;                 ///< the value of hasUnkeptPath()
  std::string savedProblem_;            ///< hash of the problem as it was opened or saved; empty: it never was
  GeometryCache geometry_;              ///< all geometry that this scenario had since it was opened
  Changes pending_;
  bool collecting_ = false;  ///< changes are announced later, in one round
  bool announcing_ = false;
  std::uint64_t version_ = 0;  ///< grows with each change of the basis of edits
  ScenarioPtr prepared_;       ///< scenario for the command of the undo stack that is done now; null: not loaded yet
  ArrangementQueue queue_;
};

}  // namespace glissade
