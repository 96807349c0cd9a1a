#include "widgets/files/unsaved_edits_dialog.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QLocale>
#include <QPushButton>

#include "engine/base/file.h"
#include "engine/base/limits.h"
#include "engine/files/product_name.h"
#include "engine/files/scenario_file.h"
#include "widgets/controls/diagnostic_text.h"
#include "widgets/controls/plain_message_box.h"

namespace glissade {
namespace {

enum class Answer { Open, Discard, Later };

/// Context of the translations.
struct UnsavedEditsDialog {
  Q_DECLARE_TR_FUNCTIONS(UnsavedEditsDialog)
};

/// The text of a scenario without the fields that a save fills in.
std::string comparable(Scenario scenario) {
  for (Asset& asset : scenario.assets) asset.sha256.clear();
  return scenarioText(scenario);
}

/// The present content of the scenario's file; nothing if it cannot be read.
std::optional<std::string> contentNow(const UnsavedEdits& edits) {
  const auto text =
      edits.file.empty() ? Result<std::string>(Diagnostic()) : readFile(edits.file, limits::kMostScenarioBytes);
  return text ? std::optional<std::string>(*text) : std::nullopt;
}

bool isSaved(const UnsavedEdits& edits) {
  const auto now = contentNow(edits);
  const auto saved = now ? parseScenario(*now, edits.file) : Result<Scenario>(Diagnostic());
  return saved && comparable(*saved) == comparable(edits.scenario);
}

QString stateOfFile(const UnsavedEdits& edits) {
  if (edits.file.empty()) return UnsavedEditsDialog::tr("The scenario was never saved.");
  const QString file = QDir::toNativeSeparators(QString::fromStdString(edits.file));
  const auto now = contentNow(edits);
  if (!now) return UnsavedEditsDialog::tr("%1: the file is not there any more.").arg(file);
  if (sha256(*now) == edits.sha256)
    return UnsavedEditsDialog::tr("%1: the file is as it was before these edits.").arg(file);
  return UnsavedEditsDialog::tr("%1: the file has changed since. You will be asked before it is overwritten.")
      .arg(file);
}

Answer ask(const QString& text, const QString& details, bool readable, QWidget* parent) {
  PlainMessageBox box(readable ? QMessageBox::Question : QMessageBox::Warning,
                      UnsavedEditsDialog::tr("Unsaved edits were left"), text, details, parent);
  QPushButton* opened =
      readable ? box.addButton(UnsavedEditsDialog::tr("&Open them"), QMessageBox::AcceptRole) : nullptr;
  const QPushButton* discarded = box.addButton(UnsavedEditsDialog::tr("&Discard them"), QMessageBox::DestructiveRole);
  QPushButton* later = box.addButton(UnsavedEditsDialog::tr("Ask &later"), QMessageBox::RejectRole);
  box.setDefaultButton(readable ? opened : later);
  box.exec();
  if (box.clickedButton() == discarded) return Answer::Discard;
  return readable && box.clickedButton() == opened ? Answer::Open : Answer::Later;
}

}  // namespace

void offerUnsavedEdits(const QString& folder, const OpenEdits& open, QWidget* parent) {
  for (AbandonedEdits& left : findAbandonedEdits(folder.toStdString())) {
    const QString time = QLocale().toString(QDateTime::fromSecsSinceEpoch(left.time()), QLocale::ShortFormat);
    const auto edits = left.read();
    if (edits && isSaved(*edits)) {
      left.remove();
      continue;
    }
    const Answer answer =
        edits ? ask(UnsavedEditsDialog::tr(
                        "Glissade ended unexpectedly. Edits of the scenario \"%1\" from %2 are still there.")
                        .arg(QString::fromStdString(nameOfProduct(edits->scenario, edits->file)), time),
                    stateOfFile(*edits), true, parent)
              : ask(UnsavedEditsDialog::tr(
                        "Glissade ended unexpectedly. The edits from %1 are damaged and cannot be opened.")
                        .arg(time),
                    diagnosticLine(edits.error()), false, parent);
    if (answer == Answer::Discard) left.remove();
    if (answer != Answer::Open || !open(*edits)) continue;
    left.remove();
    return;  // opening others would replace the opened edits
  }
}

}  // namespace glissade
