#pragma once

#include "widgets/sequence/instruction_job.h"

namespace glissade {

class WindowMemory;

/// Writes the documents about a plan: the work instruction, and the report for engineers. The window's settings keep
/// the company's template and the paper, because they hold for every product.
class InstructionController final : public QObject {
  Q_OBJECT

 public:
  InstructionController(const Workbench& bench, SequenceController& sequence);

  /// Writes a document. Errors: those of InstructionJob::start(); Usage if there is no plan, or for a wrong ending of a
  /// report.
  void write(PlanDocument document, const QString& file, const InstructionJob::Finished& finished);
  const InstructionTemplate& look() const { return look_; }
  /// The template's paper, or the chosen one if the template states none.
  Paper paper() const;
  /// Loads the template of this file; an empty name removes it. Errors: those of readInstructionTemplate(), which keep
  /// the earlier template.
  Outcome setTemplate(const QString& file);
  /// Uses the remembered template if it can be read, and remembers each later choice.
  void remember(WindowMemory& memory);
  void enableActions();

 private:
  void addCommands();
  /// Asks for the file and writes the document. `proposed`: the end of the proposed file name, after the product's
  /// name.
  void choose(PlanDocument document, const QString& title, const QString& proposed);
  void chooseTemplate();

  const Workbench& bench_;
  SequenceController& sequence_;
  InstructionJob* job_;
  InstructionTemplate look_;
  QString file_;                    ///< absolute name of the template; empty: none
  WindowMemory* memory_ = nullptr;  ///< null: choices are not remembered
};

}  // namespace glissade
