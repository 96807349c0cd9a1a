#pragma once

#include <string>
#include <vector>

#include "engine/base/work_watch.h"
#include "engine/sequence/step_view.h"
#include "engine/study/parts_list.h"
#include "engine/study/plan_words.h"

namespace glissade {

/// Alike parts that a person fetches for a panel.
struct FetchedPart {
  std::vector<std::string> bodies;  ///< ids of what is drawn: one part, or all parts of a subassembly
  std::string name;
  std::size_t count = 1;
};

/// What a person does at once, with one picture: the start of a product or of a subassembly, or a task.
struct InstructionPanel {
  std::string number;                ///< taskNumber(); empty: the start
  std::string subassembly;           ///< number of the step that brings what is put together here; empty: the product
  std::vector<AssemblyStep> steps;   ///< in the order of assembly; empty: the start
  std::vector<std::string> present;  ///< ids of what is there before
  std::vector<FetchedPart> fetched;
  std::string work;                ///< one verb: "Screw in 4 × ISO 4762 M3x8."
  std::string tool;                ///< "Hex key 2.5"; empty: none
  std::vector<std::string> notes;  ///< "Needs support: rod"
  std::string turn;                ///< "Turn the product over."; empty: it lies as before
  Viewpoint view;
  double aspect = 1.0;   ///< width by height of all that is drawn, from this viewpoint
  bool closeUp = false;  ///< what comes is small beside the rest, or hidden in part
};

/// What a fitter needs of a plan, without proofs and without how the plan was found. Numbers are those of the plan in
/// the order of assembly.
struct WorkInstruction {
  Language language = Language::English;
  std::string title;
  std::size_t steps = 0;            ///< of the plan
  std::vector<std::string> bodies;  ///< ids of the whole product
  std::vector<PartsListRow> parts;
  std::vector<std::string> tools;  ///< each once
  std::vector<InstructionPanel> panels;
};

/// Each step of the plan and of its subassemblies is in one panel; what a step brings as a group is put together before
/// it. `title`: the name of the product. Ends early where it is asked to stop. Precondition: the plan is about the
/// product.
WorkInstruction workInstruction(const AssemblyPlan& plan, const AssembledProduct& product, const std::string& title,
                                const PlanWords& words, const WorkWatch& watch = {});

}  // namespace glissade
