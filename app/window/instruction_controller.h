#pragma once

#include "app/window/instruction_job.h"

namespace glissade {

class WindowMemory;

/// The documents that are made of a plan: the work instruction, and the report for engineers. The template of a company
/// and the paper hold for every product, so the settings of the window keep them, and no scenario does.
class InstructionController final : public QObject {
  Q_OBJECT

 public:
  InstructionController(const Workbench& bench, SequenceController& sequence);

  /// Errors: as of InstructionJob::start(); Usage where there is no plan, or the report has another ending.
  void write(PlanDocument document, const QString& file, const InstructionJob::Finished& finished);
  const InstructionTemplate& look() const { return look_; }
  /// Of the template where it says one, else as chosen.
  Paper paper() const;
  /// The template of this file from now on; without a name: none. Errors: those of readInstructionTemplate(); then it
  /// stays as it was.
  Outcome setTemplate(const QString& file);
  /// The template that is remembered is used, where it can be read. Each later choice is remembered.
  void remember(WindowMemory& memory);
  void enableActions();

 private:
  void addCommands();
  /// Asks for the file and writes the document. `proposed`: what follows the product's name, with the usual ending.
  void choose(PlanDocument document, const QString& title, const QString& proposed);
  void chooseTemplate();

  const Workbench& bench_;
  SequenceController& sequence_;
  InstructionJob* job_;
  InstructionTemplate look_;
  QString file_;                    ///< of the template, absolute; empty: none
  WindowMemory* memory_ = nullptr;  ///< null: nothing is remembered
};

}  // namespace glissade
