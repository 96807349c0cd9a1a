#include "widgets/files/welcome_controller.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <QVBoxLayout>

#include "engine/files/scenario_bodies.h"
#include "widgets/controls/picture_file.h"
#include "widgets/files/sample_scenarios.h"
#include "widgets/scene3d/camera_controller.h"

namespace glissade {
namespace {

/// Maximum number of cards of recent files; the menu lists more.
constexpr int kMostCards = 5;

QString pictureFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/pictures");
}

QString sampleText(const char* text) { return QCoreApplication::translate("Samples", text); }

std::vector<WelcomeEntry> sampleEntries(const QString& folder) {
  std::vector<WelcomeEntry> entries;
  if (folder.isEmpty()) return entries;
  for (const SampleScenario& sample : sampleScenarios()) {
    WelcomeEntry entry;
    entry.file = folder + QLatin1Char('/') + QLatin1String(sample.file);
    entry.name = sampleText(sample.name);
    entry.text = sampleText(sample.summary);
    entry.light = samplePicture(sample, false);
    entry.dark = samplePicture(sample, true);
    entries.push_back(entry);
  }
  return entries;
}

/// Moves the camera near to the bodies, because the workspace of a small product is much larger than its bodies.
void bringBodiesNear(const Workbench& bench) {
  const ScenarioPtr& scenario = bench.document.scenario();
  std::set<BodyId> ids;
  for (const RigidBody& body : rigidBodiesOf(*scenario)) ids.insert(body.id);
  bench.scene.view().camera().zoomTo(bench.scene.view().extentOf(ids));
  bench.scene.refresh();
}

WelcomeEntry recentEntry(const QString& path, const ScenarioPictures& pictures) {
  const QFileInfo file(path);
  WelcomeEntry entry;
  entry.file = path;
  entry.name = file.fileName();
  entry.isThere = file.exists();
  entry.isOneLine = true;
  entry.whole = QDir::toNativeSeparators(path);
  entry.text = entry.isThere ? QDir::toNativeSeparators(file.path()) : WelcomeController::tr("Not there");
  entry.light = entry.dark = pictures.find(path);
  return entry;
}

}  // namespace

WelcomeController::WelcomeController(const Workbench& bench, FileController& files)
    : QObject(&bench.window),
      bench_(bench),
      files_(files),
      page_(new WelcomePage(bench.actions, bench.scene.widget())),
      samples_(samplesFolder(QCoreApplication::applicationDirPath())),
      pictures_(pictureFolder()) {
  auto* over = new QVBoxLayout(bench.scene.widget());
  over->setContentsMargins(0, 0, 0, 0);
  over->addWidget(page_);
  page_->setSamples(sampleEntries(samples_));
  if (samples_.isEmpty()) {
    const QStringList folders = foldersOfSamples(QCoreApplication::applicationDirPath());
    page_->setWhyNoSamples(tr("The samples were not found. They were searched in:") + QLatin1Char('\n') +
                           folders.join(QLatin1Char('\n')));
  }
  showRecent();
  page_->setFocus();
  connect(page_, &WelcomePage::chosen, &files_, &FileController::openInBackground);
  connect(&files_, &FileController::recentFilesChanged, this, &WelcomeController::showRecent);
  connect(&files_, &FileController::pictureDue, this, &WelcomeController::takePicture);
  connect(&bench.document, &WorkbenchDocument::changed, page_, [this](Changes what) {
    if (what & Change::Scenario) page_->hide();
  });
  addCommands();
}

void WelcomeController::showRecent() {
  const QStringList files = files_.recentFiles();
  if (files.isEmpty() && files_.remembers()) pictures_.removeAll();
  if (bench_.document.scenario()) return;
  std::vector<WelcomeEntry> entries;
  for (const QString& file : files.mid(0, kMostCards)) entries.push_back(recentEntry(file, pictures_));
  page_->setRecent(entries);
}

void WelcomeController::takePicture(const QString& file) {
  if (files_.remembers()) pictures_.keep(file, smallScenePicture(bench_.scene));
}

Outcome WelcomeController::openSample(const std::string& name) {
  if (samples_.isEmpty()) return wrongCommand("the samples are not installed");
  const QString file = samples_ + QLatin1Char('/') + QString::fromStdString(name);
  if (!QFileInfo::exists(file)) return wrongCommand("there is no sample '" + name + "'");
  files_.openInBackground(file);
  return Done{};
}

void WelcomeController::addCommands() {
  using Words = ScriptCommands::Words;
  bench_.scripts.add("open-sample", 1, [this](const Words& words) { return openSample(words[0]); });
  bench_.scripts.add("scene-screenshot", 1, [this](const Words& words) -> Outcome {
    if (!bench_.document.scenario()) return wrongCommand("no scenario is open");
    bringBodiesNear(bench_);
    return outcomeOf(savePicture(smallScenePicture(bench_.scene), QString::fromStdString(words[0])));
  });
}

}  // namespace glissade
