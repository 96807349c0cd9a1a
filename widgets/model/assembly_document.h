#pragma once

#include "engine/scenario/assembly_edits.h"
#include "widgets/model/semantic_document.h"

namespace glissade {

/// The bodies of one open scenario, its object and its ends, as the user arranges them, and its rules. Every edit is an
/// undoable command on the stack of the semantic document, with the scenario before and after it as values;
/// geometry that was read once is not read again.
class AssemblyDocument final : public QObject {
  Q_OBJECT

 public:
  explicit AssemblyDocument(SemanticDocument& semantics, QObject* parent = nullptr);

  /// Another scenario, or the same under another name; `semantics` has it already.
  void open(const std::shared_ptr<const LoadedScenario>& scenario);
  const std::shared_ptr<const LoadedScenario>& scenario() const { return scenario_; }
  /// The scenario with the semantic edits as they are: what an edit begins with.
  Scenario current() const;

  /// The file says of the problem what the window does: a recording that names it can be replayed.
  bool isSaved() const;
  /// Geometry that was read meanwhile, and need not be read again.
  void learn(const GeometryCache& read) { read_.insert(read.begin(), read.end()); }
  const GeometryCache& read() const { return read_; }

  /// Makes the scenario so. Refused where its geometry cannot be loaded. Edits with one `mergeKey` become one.
  Outcome edit(const QString& text, Scenario after, const QString& mergeKey = {});
  /// Puts a body, or an end of the motion, somewhere.
  Outcome place(const AssemblyItem& item, const Pose& X_WB, const QString& mergeKey = {});

 signals:
  void rearranged(const std::shared_ptr<const glissade::LoadedScenario>& scenario);
  /// An edit could not be undone or done again.
  void failed(const glissade::Diagnostic& why);

 private:
  friend class ChangeAssembly;
  Result<std::shared_ptr<const LoadedScenario>> realise(const Scenario& assembly, const std::string& file);
  void take(const std::shared_ptr<const LoadedScenario>& scenario);
  void apply(const Scenario& assembly, const std::string& file);

  SemanticDocument& semantics_;
  std::shared_ptr<const LoadedScenario> scenario_;
  std::string savedProblem_;  ///< hash of the problem as it was opened or saved; empty: it never was
  GeometryCache read_;  ///< all geometry that this scenario had since it was opened
};

}  // namespace glissade
