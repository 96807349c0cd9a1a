#include "widgets/files/save_controller.h"

#include <QDateTime>
#include <QLocale>

#include <filesystem>
#include <utility>

#include "engine/base/file.h"
#include "engine/base/file_versions.h"
#include "engine/base/limits.h"
#include "engine/files/scenario_file.h"
#include "widgets/files/unsaved_edits_dialog.h"

namespace glissade {
namespace {

std::string absolute(const std::string& file) {
  std::error_code ignored;
  return file.empty() ? "" : std::filesystem::absolute(file, ignored).lexically_normal().string();
}

}  // namespace

EarlierVersionsMenu::EarlierVersionsMenu(std::function<QString()> openFile, QWidget* parent)
    : QMenu(tr("Earlier &versions"), parent), openFile_(std::move(openFile)) {
  setObjectName(QStringLiteral("menu.versions"));
  connect(this, &QMenu::aboutToShow, this, &EarlierVersionsMenu::fill);
}

void EarlierVersionsMenu::fill() {
  clear();
  const QString file = openFile_();
  const auto versions = file.isEmpty() ? std::vector<FileVersion>() : earlierVersions(file.toStdString());
  for (const FileVersion& version : versions) {
    const QString time = QLocale().toString(QDateTime::fromSecsSinceEpoch(version.time), QLocale::ShortFormat);
    QAction* action = addAction(tr("Version %1, saved %2").arg(version.number).arg(time));
    connect(action, &QAction::triggered, this,
            [this, path = QString::fromStdString(version.path)] { emit chosen(path); });
  }
  if (versions.empty()) addAction(tr("No earlier version yet"))->setEnabled(false);
}

SaveController::SaveController(SaveHost host, QWidget* window)
    : QObject(window),
      host_(std::move(host)),
      window_(window),
      versions_(new EarlierVersionsMenu(
          [this] {
            const ScenarioPtr scenario = host_.scenario();
            return scenario ? QString::fromStdString(scenario->file) : QString();
          },
          window)),
      autosave_(new AutosaveController([this] { return unsavedEdits(); }, this)) {
  connect(versions_, &EarlierVersionsMenu::chosen, this, &SaveController::openVersion);
  connect(autosave_, &AutosaveController::failed, this,
          [this](const Diagnostic& why) { host_.showError(tr("Edits are not saved automatically"), why); });
}

void SaveController::noteContent(const std::string& file, const std::string& sha256) {
  seen_.reset();
  if (!file.empty() && !sha256.empty()) seen_ = Seen{absolute(file), sha256};
}

std::optional<std::string> SaveController::seenContent(const std::string& file) const {
  return seen_ && seen_->file == absolute(file) ? std::optional(seen_->sha256) : std::nullopt;
}

SaveResult SaveController::save(const Scenario& scenario, const std::string& file) {
  SaveResult saved = saveScenarioFile(scenario, file, seenContent(file));
  if (saved) noteContent(file, saved.sha256);
  return saved;
}

void SaveController::keepUnsavedEdits(const QString& folder) {
  autosave_->start(folder);
  offerUnsavedEdits(
      folder, [this](const UnsavedEdits& edits) { return openEdits(edits); }, window_);
}

std::optional<UnsavedEdits> SaveController::unsavedEdits() const {
  const ScenarioPtr scenario = host_.scenario();
  if (!scenario || !host_.isModified()) return std::nullopt;
  const std::string file = absolute(scenario->file);
  return UnsavedEdits{file, seenContent(file).value_or(""), host_.contentFor(scenario->file)};
}

bool SaveController::openEdits(const UnsavedEdits& edits) {
  if (!openAs(edits.scenario, edits.file)) return false;
  noteContent(edits.file, edits.sha256);
  autosave_->writeChanges(true);  // before the offered edits are removed
  return true;
}

void SaveController::openVersion(const QString& versionFile) {
  if (!host_.mayDiscard()) return;
  const auto text = readFile(versionFile.toStdString(), limits::kMostScenarioBytes);
  auto scenario = text ? parseScenario(*text, versionFile.toStdString()) : Result<Scenario>(text.error());
  if (!scenario) {
    host_.showError(tr("The earlier version cannot be opened"), scenario.error());
    return;
  }
  (void)openAs(std::move(*scenario), host_.scenario()->file);  // the paths of its assets are relative to the file
}

bool SaveController::openAs(Scenario scenario, const std::string& file) {
  auto loaded = loadGeometry(std::move(scenario), folderOf(file), file);
  if (loaded) {
    host_.openModified(std::make_shared<const LoadedScenario>(std::move(*loaded)));
    return true;
  }
  host_.showError(tr("The edits cannot be opened"), loaded.error());
  return false;
}

}  // namespace glissade
