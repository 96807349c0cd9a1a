#pragma once

#include "engine/base/quantity_text.h"
#include "engine/documents/instruction/work_instruction.h"
#include "tests/engine/sequence/products.h"

namespace glissade::test {

inline AssemblyStep stepAlong(const BodyId& body, const Vector3& way) {
  AssemblyStep step{{StepMotion()}};
  step.only().body = body;
  step.only().path = {{Pose::identity(), Author::Computer}, {Pose::translation(way), Author::Computer}};
  step.only().method = "straight";
  step.only().proof = {0, 1e-6, 2e-6, 3e-4, "base"};
  return step;
}

/// A base with blocks on it, each put on from above in its own step; the last step of the plan is that of the first
/// block.
struct InstructedProduct {
  AssembledProduct product;
  AssemblyPlan plan;
};
inline InstructedProduct blocksOnABase(std::size_t blocks) {
  InstructedProduct made;
  std::vector<RigidBody> bodies{boxBody("base", {1.0 + 0.2 * static_cast<double>(blocks), 1.0, 0.1}, Pose::identity())};
  for (std::size_t i = 0; i < blocks; ++i) {
    const double x = 0.2 * (static_cast<double>(i) - 0.5 * static_cast<double>(blocks));
    bodies.push_back(boxBody("block" + std::to_string(i), {0.15, 0.15, 0.15}, Pose::translation({x, 0.0, 0.125})));
  }
  made.product = productOf(std::move(bodies));
  for (const RigidBody& body : made.product.bodies) made.plan.bodies.push_back(body.id);
  made.plan.staying = {"base"};
  for (std::size_t i = blocks; i > 0; --i) {
    made.plan.steps.push_back(stepAlong(BodyId("block" + std::to_string(i - 1)), Vector3::UnitZ()));
    made.plan.steps.back().only().allowances.push_back({"base", ContactKind::Planar, 4e-4, 4.1e-4, Message("text")});
  }
  return made;
}

inline PlanWords wordsIn(Language language) { return {language, inMillimetres}; }

inline WorkInstruction instructed(const InstructedProduct& made, Language language = Language::English) {
  return workInstruction(made.plan, made.product, {"stand"}, wordsIn(language));
}

/// All texts of an instruction.
inline std::vector<std::string> textsOf(const WorkInstruction& instruction) {
  std::vector<std::string> texts{instruction.title};
  for (const std::string& tool : instruction.tools) texts.push_back(tool);
  for (const InstructionPanel& panel : instruction.panels) {
    texts.insert(texts.end(), {panel.number, panel.work, panel.tool, panel.turn});
    texts.insert(texts.end(), panel.notes.begin(), panel.notes.end());
    for (const FetchedPart& part : panel.fetched) texts.push_back(part.name);
  }
  return texts;
}

}  // namespace glissade::test
