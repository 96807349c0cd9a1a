#pragma once

#include <QObject>
#include <QSet>
#include <QUndoStack>
#include <optional>

#include "engine/files/scenario.h"
#include "engine/planning/coarse/scene_knowledge.h"

namespace glissade {

/// The selection, which the tree and the scene share.
struct SemanticSelection {
  QSet<int> places;      ///< numbers of places
  QSet<QString> bodies;  ///< ids of bodies, and of assemblies if their attributes are edited

  /// Whose attributes are shown and edited: those of places, if places are selected.
  AttributeOwner owner() const {
    return places.isEmpty() && !bodies.isEmpty() ? AttributeOwner::Body : AttributeOwner::Place;
  }
  /// The part of the selection that is shown and edited.
  SemanticSelection shown() const {
    SemanticSelection part;
    if (owner() == AttributeOwner::Place) {
      part.places = places;
    } else {
      part.bodies = bodies;
    }
    return part;
  }

  friend bool operator==(const SemanticSelection&, const SemanticSelection&) = default;
};

/// The semantic attributes of one open scenario: computed values, the user's edits of them, and the selection. Every
/// edit is an undoable command that holds the edits before and after it (a few hundred bytes); edits of one gesture (a
/// drag, the spinning of one box) are merged into a single command.
class SemanticDocument final : public QObject {
  Q_OBJECT

 public:
  /// Commands are pushed on `undo`.
  explicit SemanticDocument(QUndoStack& undo, QObject* parent = nullptr);
  ~SemanticDocument() override;

  /// Takes the bodies, the edits and the rules of another scenario, and clears selection and knowledge.
  void open(const LoadedScenario& scenario);
  /// Takes other bodies of the same scenario, or other poses of them; its edits replace the present ones. Knowledge of
  /// the places stays until newer knowledge is set.
  void rearrange(const LoadedScenario& scenario);
  void setKnowledge(const SceneKnowledgePtr& knowledge);

  const SceneKnowledgePtr& knowledge() const { return knowledge_; }
  const SemanticEdits& edits() const { return edits_; }
  /// The edits with those of assemblies applied to their bodies (heldEdits()).
  const SemanticEdits& heldEdits() const { return held_; }
  /// The tree of the bodies.
  const Product& product() const { return product_; }
  /// Null until the environment model is there.
  const SemanticModel* semantics() const { return semantics_ ? &*semantics_ : nullptr; }
  /// Warnings of edits that have no effect, or another effect than meant; empty until the environment model is there.
  const Warnings& warnings() const { return warnings_; }
  const std::vector<RigidBody>& bodies() const { return bodies_; }
  /// Whether the body of this number is one of the object's.
  bool isMoved(std::size_t body) const { return body >= obstacles_; }
  /// The attributes that exist, also before the environment model is there.
  const AttributeTable& table() const { return table_; }
  /// The value of a body or an assembly: its own edit, else the edit of the nearest assembly above it, else the
  /// computed or initial value.
  ProvenValue bodyValue(const QString& id, const std::string& attribute) const;

  /// Sets an attribute on several places and bodies at once; nothing: resets it to the computed value. Refuses a value
  /// of the wrong type or out of range. `text` names the command.
  Outcome setAttribute(const SemanticSelection& targets, const std::string& attribute,
                       const std::optional<AttributeValue>& value);
  /// Edits from now on are a separate step of the undo stack.
  void endGesture() { ++gesture_; }
  Outcome renamePlace(int place, const QString& name);
  Outcome addDefinition(const AttributeDefinition& definition);
  /// Renaming and removing are refused if a rule of the scenario uses the attribute.
  Outcome renameDefinition(AttributeOwner owner, const std::string& from, const std::string& to);
  Outcome removeDefinition(AttributeOwner owner, const std::string& name);
  /// Whether there are edits that have no effect.
  bool hasStrays() const;
  void removeStrays();
  /// Puts a milestone into a border, or (nothing) removes the user's milestone.
  void setMilestone(int border, const std::optional<Pose>& q);

  const SemanticSelection& selection() const { return selection_; }
  /// Ids of the selected bodies, including the bodies of selected assemblies.
  QSet<QString> selectedBodies() const;
  void select(const SemanticSelection& selection);

 signals:
  void changed();  ///< edits, attributes or places have changed
  void selectionChanged();

 private:
  void push(const QString& text, const SemanticEdits& after, const QString& mergeKey = {});
  void apply(const SemanticEdits& edits);
  void takeScenario(const LoadedScenario& scenario);
  const AttributeValue* said(const std::string& id, const std::string& attribute) const;
  PlaceEdit& editOf(SemanticEdits& edits, int place) const;
  Outcome checkDefinitions(const SemanticEdits& edits, const std::string& attribute) const;

  QUndoStack& undo_;
  std::vector<RigidBody> bodies_;  ///< the obstacles, then the object's bodies
  std::size_t obstacles_ = 0;      ///< how many obstacles there are
  std::optional<StrategyRules> rules_;
  SceneKnowledgePtr knowledge_;
  Product product_;
  SemanticEdits edits_;
  SemanticEdits held_;
  AttributeTable table_;
  std::optional<SemanticModel> semantics_;
  Warnings warnings_;
  SemanticSelection selection_;
  int gesture_ = 0;
};

}  // namespace glissade
