#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "engine/sequence/sequence_strategy.h"

namespace glissade {

/// Whether tools can be brought on to the fasteners of a plan's steps, whoever is there: which bodies are in the way of
/// a tool in one position is a fact about the tool and each body, and found at most once. Refers to the question.
class ToolFacts {
 public:
  ToolFacts(const AssemblyPlan& plan, const SequenceQuestion& question);
  ~ToolFacts();
  ToolFacts(const ToolFacts&) = delete;
  ToolFacts& operator=(const ToolFacts&) = delete;

  /// The tools of the body are tried in their order, each with its handle in all positions, against those of `there`,
  /// what is turned excepted. The first that nothing blocks; where all are blocked the preferred one, with the fewest
  /// bodies in its way. Nothing after a stop, and where the step needs no tool or its body has no head. `step`: its
  /// index. May be called from several threads at a time, for different steps.
  std::optional<StepTool> toolOf(std::size_t step, const BodySet& there, const StopToken& stop);

 private:
  struct Position;
  struct Tool;
  struct Step;
  /// A mesh that is moved straight.
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

/// Finds for each step of a fastener whether a tool can be brought on at its beginning, while those are there that the
/// steps before it have left: see ToolFacts::toolOf().
void addTools(AssemblyPlan& plan, const SequenceQuestion& question, SequenceHost& host);

}  // namespace glissade
