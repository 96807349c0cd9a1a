#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "engine/sequence/sequence_strategy.h"

namespace glissade {

/// Finds whether tools have access to the fasteners of a plan's steps. The bodies that block a tool in one position do
/// not depend on the order of steps, and are found at most once. Refers to the question.
class ToolFacts {
 public:
  ToolFacts(const AssemblyPlan& plan, const SequenceQuestion& question);
  ~ToolFacts();
  ToolFacts(const ToolFacts&) = delete;
  ToolFacts& operator=(const ToolFacts&) = delete;

  /// Tries the tools of the step's body in their order, each with its handle in all positions, against the bodies of
  /// `there` without the turned one. Returns the first tool that nothing blocks; if all are blocked, the preferred one
  /// in the position with the fewest blocking bodies. Nothing after a stop, and if the step needs no tool or its body
  /// has no head. `step`: its index. May be called from several threads at a time, for different steps.
  std::optional<StepTool> toolOf(std::size_t step, const BodySet& there, const StopToken& stop);

 private:
  struct Position;
  struct Tool;
  struct Step;
  /// A mesh that moves along a straight line.
  struct Placing {
    MeshPtr mesh;
    std::pair<Pose, Pose> motion;
  };
  std::vector<std::size_t> blocking(std::optional<std::vector<std::size_t>>& fact, const Placing& placing,
                                    const Tool& tool, const BodySet& there, const StopToken& stop);
  std::vector<std::size_t> blockersAt(std::size_t position, Tool& tool, const BodySet& there, const StopToken& stop);

  const SequenceQuestion& question_;
  std::vector<Step> steps_;
};

/// Sets the tool of the motion, which is step `step` of the facts, and what is held meanwhile; `there`: the bodies that
/// are there without its own. Nothing changes if no tool turns a head.
void setTool(StepMotion& motion, ToolFacts& facts, std::size_t step, const BodySet& there,
             const SequenceQuestion& question, const StopToken& stop);

/// Finds for each step of a fastener whether a tool has access at its beginning, while the bodies that earlier steps
/// have left are there: see ToolFacts::toolOf().
void addTools(AssemblyPlan& plan, const SequenceQuestion& question, SequenceHost& host);

}  // namespace glissade
