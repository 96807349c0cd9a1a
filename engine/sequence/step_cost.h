#pragma once

#include <string>
#include <vector>

#include "engine/base/message.h"
#include "engine/model/body_id.h"
#include "engine/planning/coarse/expression.h"
#include "engine/sequence/order_rules.h"

namespace glissade {

/// Figures of a step from which its cost is computed.
struct StepFigures {
  double length = 0.0;  ///< length of the path, divided by the diagonal of the product's box
  double turns = 0.0;   ///< full turns of the path
  /// The end direction differs from that of the step before, or it is the first step. A fastener stack is one
  /// operation: within it nothing changes, and the step after it is compared with the step that opens it.
  bool directionChange = false;
  bool toolChange = false;      ///< the tool differs from that of the step before, or it is the first step
  double falling = 0.0;         ///< number of bodies that would tip or fall after the step, and do not before it
  double bodies = 1.0;          ///< number of bodies that leave
  double mass = 0.0;            ///< mass of the bodies that leave, kg
  bool fragile = false;         ///< one of the bodies that leave is fragile
  BodyId id;                    ///< id of the first body that leaves, for its attributes
  bool toolBlocked = false;     ///< no tool that turns the fastener has access
  bool taskChange = false;      ///< the step before is of another task, or it is the first step
  double assemblyChange = 0.0;  ///< share of the levels of the file's tree that it does not share with the step before
  double distance = 0.0;  ///< distance from the place of the step before, divided by the diagonal of the product's box
  double size = 0.0;      ///< size of the boxes of the bodies that leave, divided by that of the product's box
  double early = 0.0;     ///< share of the steps that come later
  bool inAir = false;     ///< the bodies that leave touch no body that remains, and no joint joins them to one
  double openStacks = 0.0;    ///< number of fastener stacks of which some bodies have left and others remain
  double unfastened = 0.0;    ///< number of remaining bodies that joints no longer join to the base
  double isolatedLeft = 0.0;  ///< number of bodies that touch nothing and leave later
  double unsupported = 0.0;   ///< number of remaining bodies that would tip or fall after the step
  double turnOver = 0.0;  ///< 1: it ends upwards and the step before downwards, or the reverse; 0.5: one ends sideways
};

/// An expression with a name.
struct StepCostPreset {
  std::string id;
  Message label;
  std::string expression;
};

/// "fitter" (the usual one), "balanced", "steady", "few-tools", "short", "fragile-first", "as-found".
std::vector<StepCostPreset> stepCostPresets();

/// The cost of a step, as an expression that a user can read and change, in the language of the rules of coarse
/// planning (see Expression). Names: length, turns, direction_change, turn_over, tool_change, falling, unsupported,
/// bodies, mass, fragile, tool_blocked, task_change, assembly_change, distance, size, early, in_air, unfastened,
/// open_stacks, isolated_left, and body.<attribute> of the first body that leaves. Costs that are negative or no number
/// count as 0.
class StepCost {
 public:
  /// `demands.cost`: a preset's id, an expression, or empty. Errors, MalformedInput at /sequence/cost: a syntax error,
  /// an unknown name.
  static Result<StepCost> of(const SequenceDemands& demands);

  double of(const StepFigures& figures) const;
  /// True if the expression names this figure.
  bool uses(const std::string& figure) const { return text().find(figure) != std::string::npos; }
  const std::string& text() const { return expression_.text(); }

 private:
  StepCost(Expression expression, std::map<std::string, Attributes> attributes)
      : expression_(std::move(expression)), attributes_(std::move(attributes)) {}

  Expression expression_;
  std::map<std::string, Attributes> attributes_;
};

}  // namespace glissade
