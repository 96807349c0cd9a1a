#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "engine/base/file_save.h"
#include "engine/documents/instruction/instruction_template.h"
#include "engine/documents/instruction/work_instruction.h"
#include "engine/documents/plan_report.h"
#include "engine/documents/plan_words.h"
#include "engine/sequence/work_times.h"
#include "widgets/document/sequence_planner.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

class SequenceController;

/// The kinds of documents about a plan.
enum class PlanDocument {
  Instruction,  ///< for the line: actions, tools and pictures of the steps
  Report        ///< for engineers: motions, clearances, allowances, checks, times
};

/// Makes a document of the shown plan, as HTML or PDF, in the background. Its pictures are drawn from the product and
/// do not depend on the window's camera, sections and hidden bodies. In scripts the document is made at once.
class InstructionJob final : public QObject {
  Q_OBJECT

 public:
  InstructionJob(const Workbench& bench, SequenceController& sequence);

  using Finished = std::function<void(const SaveResult&)>;
  /// Starts a job and cancels a running one. Errors: those of writing and of the logo; Interrupted if it was cancelled.
  /// A warning says why an instruction as HTML has no 3D view.
  void start(PlanDocument document, const QString& file, Finished finished);

 private:
  /// The input of the document, read by the worker.
  struct Content {
    PlanPtr plan;
    ProductPtr product;
    PlanCheck check;
    SequenceDemands said;
    LineTexts access;  ///< no steps: access was not checked
    InstructionHeading heading;
    double deviation = 0.0;
    MissingShapes missing{};
    WorkTimes times;
    InstructionTemplate look;
    Paper paper = Paper::A4;
    Language language = Language::English;
    QString file;

    PlanWords words() const;
  };

  SaveResult writeInstruction(const Content& content, const WorkWatch& watch) const;
  SaveResult writeReport(Content& content, const WorkWatch& watch) const;

  const Workbench& bench_;
  SequenceController& sequence_;
};

}  // namespace glissade
