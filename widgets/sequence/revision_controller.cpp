#include "widgets/sequence/revision_controller.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QVBoxLayout>

#include "engine/files/compared_plan.h"
#include "widgets/controls/diagnostic_text.h"
#include "widgets/sequence/sequence_controller.h"

namespace glissade {
namespace {

struct Comparison {
  std::vector<Message> lines;  ///< for people
  bool isSame = false;
  std::size_t holding = 0;  ///< steps that hold
};

/// `plan`: may be null.
Result<Comparison> compare(const AssembledProduct& product, const AssemblyPlan* plan, const std::string& file,
                           const StopToken& stop) {
  auto now = loadProduct(file, stop, plan != nullptr ? plan->deflection : 0.0);
  if (!now) return now.error();
  now->product = withIdsOf(product, std::move(now->product));
  const ProductChanges changes = changesBetween(product, now->product, stop);
  Comparison found{inWords(changes, product, now->product), changes.none()};
  if (plan == nullptr) return found;
  const ComparedPlan compared = comparePlan(*plan, product, *now, changes, stop);
  found.holding = compared.holding();
  for (Message& line : inWords(compared)) found.lines.push_back(std::move(line));
  return found;
}

}  // namespace

RevisionController::RevisionController(const Workbench& bench, SequenceController& sequence)
    : QObject(&bench.window), bench_(bench), sequence_(sequence) {
  bench_.onAction("sequence.compare", this, [this] { chooseFile(); });
  const auto enable = [this] { bench_.enable("sequence.compare", bench_.document.scenario() != nullptr); };
  connect(&bench.document, &WorkbenchDocument::changed, this, enable);
  enable();
  bench_.scripts.add("compare-with", 1, [this](const ScriptCommands::Words& words) {
    compareWith(QString::fromStdString(words[0]));
    return Outcome(Done{});
  });
  bench_.scripts.add("expect-revision", 2, [this](const ScriptCommands::Words& words) { return expect(words); });
}

void RevisionController::chooseFile() {
  const QString file =
      bench_.dialogs.open(FilePurpose::Parts, tr("Compare with another revision"),
                          tr("Products (*.step *.stp *.p21 *.iges *.igs *.brep *.urdf *.json);;All files (*)"));
  if (!file.isEmpty()) compareWith(file);
}

void RevisionController::compareWith(const QString& file) {
  const ScenarioPtr scenario = bench_.document.scenario();
  if (!scenario) return;
  const ShownPlan& shown = sequence_.shown();
  const bool hasPlan = shown.plan && shown.product && !shown.growing;
  const auto work = [this, file, scenario, product = hasPlan ? shown.product : nullptr,
                     plan = hasPlan ? shown.plan : nullptr](const WorkWatch& watch) -> BackgroundTask::Delivery {
    const AssembledProduct open = product ? *product : productOf(*scenario);
    const auto found = std::make_shared<Result<Comparison>>(compare(open, plan.get(), file.toStdString(), watch.stop));
    return [this, file, found] {
      if (!*found) {
        bench_.messages.showError(tr("The revisions were not compared"), found->error());
        return;
      }
      QStringList lines;
      for (const Message& line : (*found)->lines) lines << engineText(line);
      isSame_ = (*found)->isSame;
      holding_ = (*found)->holding;
      show(file, lines);
    };
  };
  bench_.work.run(tr("Comparing revisions"), work);
}

void RevisionController::show(const QString& file, const QStringList& lines) {
  delete dialog_;
  dialog_ = makeRevisionDialog(file, lines, &bench_.window);
  dialog_->show();
}

/// The words: "same" or "other", and the number of steps that hold.
Outcome RevisionController::expect(const ScriptCommands::Words& words) const {
  const std::string found = std::string(isSame_ ? "same" : "other") + " " + std::to_string(holding_);
  if (found == words[0] + " " + words[1]) return Done{};
  return unmetExpectation("the revision is " + found + ", not " + words[0] + " " + words[1]);
}

QDialog* makeRevisionDialog(const QString& file, const QStringList& lines, QWidget* parent) {
  auto* dialog = new QDialog(parent);
  dialog->setObjectName(QStringLiteral("revision"));
  dialog->setWindowTitle(RevisionController::tr("Comparison with %1").arg(QFileInfo(file).fileName()));
  auto* list = new QListWidget(dialog);
  list->setAccessibleName(RevisionController::tr("Differences, and steps that do not hold"));
  list->setWordWrap(true);
  list->addItems(lines);
  list->setCurrentRow(-1);
  auto* about = new QLabel(
      RevisionController::tr("The open product is the earlier revision. Each step of its sequence is judged in the "
                             "other one."),
      dialog);
  about->setWordWrap(true);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
  QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  auto* column = new QVBoxLayout(dialog);
  column->addWidget(about);
  column->addWidget(list, 1);
  column->addWidget(buttons);
  dialog->resize(560, 360);
  return dialog;
}

}  // namespace glissade
