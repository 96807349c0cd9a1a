#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "app/window/workbench.h"
#include "engine/base/file_save.h"
#include "engine/sequence/work_times.h"
#include "engine/study/instruction/instruction_template.h"
#include "engine/study/plan_report.h"
#include "engine/study/plan_words.h"
#include "widgets/bridge/sequence_planner.h"

namespace glissade {

class SequenceController;

/// Which document is made of a plan.
enum class PlanDocument {
  Instruction,  ///< for the line: what is done, with what, and how it looks
  Report        ///< for engineers: motions, clearances, allowances, checks, times
};

/// Makes a document of the plan that is shown, as HTML or PDF, in the background. Its pictures are drawn from the
/// product: the camera, sections and hidden bodies of the window have no part in them. In scripts all of it is done at
/// once.
class InstructionJob final : public QObject {
  Q_OBJECT

 public:
  InstructionJob(const Workbench& bench, SequenceController& sequence);

  using Finished = std::function<void(const SaveResult&)>;
  /// A job that is under way ends without its file. Errors: those of writing and of the logo; Interrupted where it was
  /// cancelled. A warning says where an instruction as HTML has no 3D view.
  void start(PlanDocument document, const QString& file, Finished finished);

 private:
  /// What the document is made of; read by the worker.
  struct Content {
    PlanPtr plan;
    ProductPtr product;
    PlanCheck check;
    SequenceDemands said;
    LineTexts access;  ///< without steps: not asked
    std::string title;
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
