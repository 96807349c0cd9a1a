#pragma once

#include <QObject>
#include <QSet>
#include <QUndoStack>
#include <optional>

#include "engine/planning/coarse/scene_knowledge.h"
#include "engine/scenario/scenario.h"

namespace glissade {

/// What is selected, in the tree and in the scene alike.
struct SemanticSelection {
  QSet<int> places;      ///< numbers of places
  QSet<QString> bodies;  ///< ids; of assemblies, too, where their attributes are edited

  /// Whose attributes are shown and edited: the places', where there are any.
  AttributeOwner owner() const {
    return places.isEmpty() && !bodies.isEmpty() ? AttributeOwner::Body : AttributeOwner::Place;
  }
  /// The part of it that is shown and edited.
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

/// The semantic attributes of one open scenario: what was computed, the user's edits over it, and the
/// selection. Every edit is an undoable command that holds the edits before and after it (a few
/// hundred bytes); edits of one gesture (a drag, the spinning of one box) are merged into a single command.
class SemanticDocument final : public QObject {
  Q_OBJECT

 public:
  /// Its commands are pushed on `undo`.
  explicit SemanticDocument(QUndoStack& undo, QObject* parent = nullptr);
  ~SemanticDocument() override;

  /// Takes the bodies, the edits and the rules of another scenario. Selection and knowledge are empty then.
  void open(const LoadedScenario& scenario);
  /// The same scenario with its bodies elsewhere, or others; its edits count from now on. What is known of the
  /// places stays until there is something newer.
  void rearrange(const LoadedScenario& scenario);
  void setKnowledge(const SceneKnowledgePtr& knowledge);

  const SceneKnowledgePtr& knowledge() const { return knowledge_; }
  const SemanticEdits& edits() const { return edits_; }
  /// The edits as they count: those of assemblies are said of their bodies (heldEdits()).
  const SemanticEdits& heldEdits() const { return held_; }
  /// The tree of the bodies.
  const Product& product() const { return product_; }
  /// Null until the environment model is there.
  const SemanticModel* semantics() const { return semantics_ ? &*semantics_ : nullptr; }
  /// Which edits count nowhere, or not as they are meant; empty until the environment model is there.
  const Warnings& warnings() const { return warnings_; }
  const std::vector<RigidBody>& bodies() const { return bodies_; }
  /// The body, by its number, is one of the object.
  bool isMoved(std::size_t body) const { return body >= obstacles_; }
  /// The attributes that there are, also before the environment model is there.
  const AttributeTable& table() const { return table_; }
  /// Of a body or an assembly. What neither says is what the assemblies that it is in say.
  ProvenValue bodyValue(const QString& id, const std::string& attribute) const;

  /// Sets an attribute on several places and bodies at once; nothing: resets it to what is computed.
  /// Refuses a value of the wrong type or out of range. `text` names the command.
  Outcome setAttribute(const SemanticSelection& targets, const std::string& attribute,
                       const std::optional<AttributeValue>& value);
  /// What is set from now on is a step of its own to undo.
  void endGesture() { ++gesture_; }
  Outcome renamePlace(int place, const QString& name);
  Outcome addDefinition(const AttributeDefinition& definition);
  /// Both refuse where a rule of the scenario uses the attribute.
  Outcome renameDefinition(AttributeOwner owner, const std::string& from, const std::string& to);
  Outcome removeDefinition(AttributeOwner owner, const std::string& name);
  /// There are edits that count nowhere.
  bool hasStrays() const;
  void removeStrays();
  /// Puts a milestone into a border, or (nothing) takes the user's away.
  void setMilestone(int border, const std::optional<Pose>& q);

  const SemanticSelection& selection() const { return selection_; }
  /// Ids of the bodies that are selected, those below selected assemblies among them.
  QSet<QString> selectedBodies() const;
  void select(const SemanticSelection& selection);

 signals:
  void changed();  ///< edits, attributes or places are not what they were
  void selectionChanged();

 private:
  void push(const QString& text, const SemanticEdits& after, const QString& mergeKey = {});
  void apply(const SemanticEdits& edits);
  void takeScenario(const LoadedScenario& scenario);
  const AttributeValue* said(const std::string& id, const std::string& attribute) const;
  PlaceEdit& editOf(SemanticEdits& edits, int place) const;
  Outcome checkDefinitions(const SemanticEdits& edits, const std::string& attribute) const;

  QUndoStack& undo_;
  std::vector<RigidBody> bodies_;  ///< the obstacles, then those of the object
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
