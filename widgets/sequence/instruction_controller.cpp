#include "widgets/sequence/instruction_controller.h"

#include <QFileInfo>

#include "widgets/sequence/sequence_controller.h"
#include "widgets/sequence/sequence_output.h"
#include "widgets/workbench/proposed_file.h"
#include "widgets/workbench/window_memory.h"

namespace glissade {

InstructionController::InstructionController(const Workbench& bench, SequenceController& sequence)
    : QObject(&sequence), bench_(bench), sequence_(sequence), job_(new InstructionJob(bench, sequence)) {
  bench.onAction("sequence.instruction", this, [this] {
    choose(PlanDocument::Instruction, tr("Save the work instruction"), QStringLiteral("instruction.pdf"));
  });
  bench.onAction("sequence.report", this, [this] {
    choose(PlanDocument::Report, tr("Save the report of the sequence"), QStringLiteral("sequence-report.html"));
  });
  bench.onAction("instruction.template", this, [this] { chooseTemplate(); });
  bench.onAction("instruction.no-template", this, [this] { (void)setTemplate({}); });
  addCommands();
}

void InstructionController::addCommands() {
  using Words = ScriptCommands::Words;
  bench_.scripts.add("report-sequence", 1, [this](const Words& words) {
    return sequence_.written(words[0], [&](const InstructionJob::Finished& finished) {
      write(PlanDocument::Report, QString::fromStdString(words[0]), finished);
    });
  });
  bench_.scripts.add("instruction-template", 1, [this](const Words& words) {
    return setTemplate(words[0] == "none" ? QString() : QString::fromStdString(words[0]));
  });
  bench_.scripts.add("instruction-paper", 1, [this](const Words& words) -> Outcome {
    const auto paper = paperNamed(words[0]);
    if (!paper) return wrongCommand("'" + words[0] + "' is no paper of the instructions", "Say A4 or Letter.");
    bench_.actions["instruction.letter"]->setChecked(*paper == Paper::Letter);
    return Done{};
  });
}

void InstructionController::write(PlanDocument document, const QString& file,
                                  const InstructionJob::Finished& finished) {
  const ShownPlan& shown = sequence_.shown();
  if (!shown.plan || shown.plan->steps.empty()) {
    finished(notSaved({ErrorKind::Usage, file.toStdString(), "", GLISSADE_TEXT("there is no plan to write"),
                       GLISSADE_TEXT("Plan the sequence first.")}));
  } else if (!isDocument(file)) {
    finished(
        notSaved({ErrorKind::Usage, file.toStdString(), "", GLISSADE_TEXT("documents are not written in this format"),
                  GLISSADE_TEXT("Choose .html or .pdf.")}));
  } else {
    job_->start(document, file, finished);
  }
}

Paper InstructionController::paper() const {
  const bool isLetter = bench_.actions["instruction.letter"]->isChecked();
  return look_.paper.value_or(isLetter ? Paper::Letter : Paper::A4);
}

Outcome InstructionController::setTemplate(const QString& file) {
  InstructionTemplate look;
  if (!file.isEmpty()) {
    const auto read = readInstructionTemplate(file.toStdString());
    if (!read) return read.error();
    look = *read;
  }
  look_ = look;
  file_ = file.isEmpty() ? QString() : QFileInfo(file).absoluteFilePath();
  if (memory_ != nullptr) memory_->saveInstructionTemplate(file_);
  bench_.messages.showStatus(file_.isEmpty() ? tr("Work instructions have no template")
                                             : tr("Work instructions follow the template %1").arg(file_));
  enableActions();
  return Done{};
}

void InstructionController::remember(WindowMemory& memory) {
  const QString file = memory.instructionTemplate();
  memory_ = &memory;
  if (file.isEmpty()) return;
  if (const Outcome set = setTemplate(file); !set) {
    bench_.messages.showError(tr("The template of work instructions cannot be used"), set.error());
  }
}

void InstructionController::enableActions() {
  for (const char* action : {"sequence.instruction", "sequence.report"}) {
    bench_.enable(action, bench_.actions["sequence.export"]->isEnabled());
  }
  bench_.enable("instruction.no-template", !file_.isEmpty());
}

void InstructionController::choose(PlanDocument document, const QString& title, const QString& proposed) {
  const bool webFirst = proposed.endsWith(QLatin1String(".html"));
  const QString types = webFirst ? tr("Web page (*.html);;PDF (*.pdf)") : tr("PDF (*.pdf);;Web page (*.html)");
  const QString file =
      bench_.dialogs.save(FilePurpose::Report, title, proposedFile(*bench_.document.scenario(), proposed), types);
  if (file.isEmpty()) return;
  write(document, file, [this, file](const SaveResult& saved) { sequence_.tell(file, saved); });
}

void InstructionController::chooseTemplate() {
  const QString file = bench_.dialogs.open(FilePurpose::Report, tr("Choose the template of work instructions"),
                                           tr("Templates (*.json);;All files (*)"));
  if (file.isEmpty()) return;
  if (const Outcome set = setTemplate(file); !set) {
    bench_.messages.showError(tr("The template of work instructions cannot be used"), set.error());
  }
}

}  // namespace glissade
