#pragma once

#include <string>
#include <vector>

#include "engine/planning/coarse/expression.h"
#include "engine/sequence/order_rules.h"

namespace glissade {

/// What is known of a step that costs are asked of.
struct StepFigures {
  double length = 0.0;           ///< of the path, by the diagonal of the product's box
  double turns = 0.0;            ///< full turns of the path
  bool directionChange = false;  ///< it ends in another direction than the step before, or is the first one
  bool toolChange = false;       ///< another tool than in the step before, or it is the first one
  double falling = 0.0;          ///< bodies that would tip or fall: without support
  double bodies = 1.0;           ///< that leave
  double mass = 0.0;             ///< of all of them, kg
  bool fragile = false;          ///< one of them is
  std::string id;                ///< of the first one, for its attributes
  bool toolBlocked = false;      ///< no tool that turns the fastener can be brought on
  bool taskChange = false;       ///< the step before is of another task, or it is the first one
  double assemblyChange = 0.0;   ///< levels of the file's tree that it does not share with the step before, as a share
  double distance = 0.0;         ///< from where the step before was, by the diagonal of the product's box
  double size = 0.0;             ///< of the boxes of the bodies that leave, by that of the product
  double early = 0.0;            ///< share of the steps that are still to come
  double turnOver = 0.0;         ///< 1: it ends upwards and the step before downwards, or the reverse; 0.5: to a side
};

/// An expression with a name.
struct StepCostPreset {
  std::string id;
  std::string label;
  std::string expression;
};

/// "fitter" (the usual one), "balanced", "steady", "few-tools", "short", "fragile-first", "as-found".
std::vector<StepCostPreset> stepCostPresets();

/// What a step costs, as an expression that a user can read and change, in the language of the rules of coarse
/// planning (see Expression). Names: length, turns, direction_change, turn_over, tool_change, falling, bodies, mass,
/// fragile, tool_blocked, task_change, assembly_change, distance, size, early, and body.<attribute> of the first body
/// that leaves. Costs below zero, and those that are no number, count as 0.
class StepCost {
 public:
  /// `demands.cost`: a preset's id, an expression, or empty. Errors, MalformedInput at /sequence/cost: what does not
  /// parse, an unknown name.
  static Result<StepCost> of(const SequenceDemands& demands);

  double of(const StepFigures& figures) const;
  /// The expression names this figure.
  bool uses(const std::string& figure) const { return text().find(figure) != std::string::npos; }
  const std::string& text() const { return expression_.text(); }

 private:
  StepCost(Expression expression, std::map<std::string, Attributes> attributes)
      : expression_(std::move(expression)), attributes_(std::move(attributes)) {}

  Expression expression_;
  std::map<std::string, Attributes> attributes_;
};

}  // namespace glissade
