#pragma once

#include <string>
#include <vector>

#include "engine/base/work_watch.h"
#include "engine/documents/parts_list.h"
#include "engine/documents/plan_words.h"
#include "engine/sequence/step_view.h"

namespace glissade {

/// Equal parts that a person fetches for a panel.
struct FetchedPart {
  std::vector<BodyId> bodies;  ///< ids of the drawn bodies: one part, or all parts of a subassembly
  std::string name;
  std::size_t count = 1;
};

/// A unit of work with one picture: the start of a product or of a subassembly, or a task.
struct InstructionPanel {
  std::string number;               ///< taskNumber(); empty: the start
  std::string subassembly;          ///< number of the step that brings the subassembly; empty: the product
  std::vector<AssemblyStep> steps;  ///< steps in the order of assembly; empty for the start
  std::vector<BodyId> present;      ///< ids of the bodies that are present before
  std::vector<FetchedPart> fetched;
  std::string work;                ///< sentence with one verb: "Screw in 4 × ISO 4762 M3x8."
  std::string tool;                ///< for example "Hex key 2.5"; empty: none
  std::vector<std::string> notes;  ///< for example "Needs support: rod"
  std::string turn;                ///< for example "Turn the product over."; empty: it lies as before
  Viewpoint view;
  double aspect = 1.0;   ///< width divided by height of all that is drawn, from this viewpoint
  bool closeUp = false;  ///< the parts that come are small beside the rest, or partly hidden
};

/// The parts of a plan that a fitter needs, without proofs. The numbers are those of the plan in the order of assembly.
struct WorkInstruction {
  Language language = Language::English;
  std::string title;
  std::size_t steps = 0;   ///< number of steps of the plan
  std::size_t base = 0;    ///< number of parts in the base, which have no step
  std::string incomplete;  ///< names the parts for which the plan has no step; empty: there are none
  /// Statements of the first page: accepted clashes, parts that touch nothing, excluded parts.
  std::vector<std::string> statements;
  std::string imprint;         ///< date, revision and author of the document; empty: none is stated
  std::vector<BodyId> bodies;  ///< ids of the whole product
  std::vector<PartsListRow> parts;
  std::vector<std::string> tools;  ///< without duplicates
  std::vector<InstructionPanel> panels;
  Vector3 up = Vector3::UnitZ();  ///< AssemblyPlan::up
};

/// Title page of an instruction: statements about the product that the plan does not make.
struct InstructionHeading {
  std::string title;                    ///< name of the product
  std::string imprint{};                ///< see WorkInstruction
  std::vector<std::string> excluded{};  ///< names of the parts of the file that are not of the product
};

/// Makes the instruction of a plan. Each step of the plan and of its subassemblies is in one panel; a group is put
/// together before the step that brings it. Ends early after a stop. Precondition: the plan is about the product.
WorkInstruction workInstruction(const AssemblyPlan& plan, const AssembledProduct& product,
                                const InstructionHeading& heading, const PlanWords& words, const WorkWatch& watch = {});

/// "51 parts + base, 40 steps": the parts that steps bring, as the window counts them.
std::string extentText(const WorkInstruction& instruction, const DocumentWords& words);

/// How the product lies in each step of the plan, in the order of removal.
std::vector<Viewpoint> viewsOfSteps(const WorkInstruction& instruction, const AssemblyPlan& plan);

}  // namespace glissade
