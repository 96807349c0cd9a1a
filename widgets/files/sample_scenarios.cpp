#include "widgets/files/sample_scenarios.h"

#include <QDir>
#include <QFileInfo>

namespace glissade {
namespace {

/// Folder of the installed samples (packaging/install), relative to the programs.
const QLatin1String kInstalledSamples("../../share/glissade/samples");
/// Levels to search upwards: the program is in build/PRESET/bin of the source tree.
constexpr int kMostLevelsUp = 5;

bool hasSamples(const QString& folder) { return QFileInfo::exists(folder + QStringLiteral("/teaching/scenario.json")); }

}  // namespace

const std::vector<SampleScenario>& sampleScenarios() {
  static const std::vector<SampleScenario> samples{
      {"teaching/scenario.json", QT_TRANSLATE_NOOP("Samples", "Four bodies"),
       QT_TRANSLATE_NOOP("Samples", "A flat world in the manner of Cailhol et al. 2019")},
      {"environment-1/scenario.json", QT_TRANSLATE_NOOP("Samples", "Environment 1"),
       QT_TRANSLATE_NOOP("Samples", "The cluttered environment of Blin et al. 2016 (figure 3)")},
      {"bolted-brackets/scenario.json", QT_TRANSLATE_NOOP("Samples", "Bolted brackets"),
       QT_TRANSLATE_NOOP("Samples", "Ten parts that touch, as CAD systems export them")},
      {"roller-stand/scenario.json", QT_TRANSLATE_NOOP("Samples", "Roller stand"),
       QT_TRANSLATE_NOOP("Samples", "A roller on a shaft between two walls")},
      {"pump/unmount.json", QT_TRANSLATE_NOOP("Samples", "Pump, unmounting"),
       QT_TRANSLATE_NOOP("Samples", "The pump leaves its seat in the power-electronics frame")},
      {"nut-and-bolt/scenario.json", QT_TRANSLATE_NOOP("Samples", "Nut and bolt"),
       QT_TRANSLATE_NOOP("Samples", "A nut on its bolt, with modelled threads")},
      {"shape-game/tight-star.json", QT_TRANSLATE_NOOP("Samples", "Shape game: star, tight"),
       QT_TRANSLATE_NOOP("Samples", "The shape game of Cailhol et al. 2019 (figure 13)")},
      {"environment-2/scenario.json", QT_TRANSLATE_NOOP("Samples", "Environment 2"),
       QT_TRANSLATE_NOOP("Samples", "The very cluttered environment of Blin et al. 2016 (figure 11)")},
      {"interlocked/turn.json", QT_TRANSLATE_NOOP("Samples", "Interlocked: a turn"),
       QT_TRANSLATE_NOOP("Samples", "A key whose bar lies across the slot of the cover")},
      {"sliding-plane/scenario.json", QT_TRANSLATE_NOOP("Samples", "Sliding plane"),
       QT_TRANSLATE_NOOP("Samples", "The L slides on a plane")},
  };
  return samples;
}

QString samplesFolder(const QString& programFolder) {
  for (const QString& folder : foldersOfSamples(programFolder)) {
    if (hasSamples(folder)) return folder;
  }
  return {};
}

QStringList foldersOfSamples(const QString& programFolder) {
  QStringList folders{QDir::cleanPath(programFolder + QLatin1Char('/') + kInstalledSamples)};
  QDir folder(programFolder);
  for (int level = 0; level < kMostLevelsUp && folder.cdUp(); ++level) {
    folders << folder.filePath(QStringLiteral("samples"));
  }
  return folders;
}

QImage samplePicture(const SampleScenario& sample, bool dark) {
  QString name = QLatin1String(sample.file);
  name.replace(QLatin1Char('/'), QLatin1Char('-')).remove(QStringLiteral(".json"));
  return QImage(QStringLiteral(":/welcome/%1-%2.png").arg(name, QLatin1String(dark ? "dark" : "light")));
}

}  // namespace glissade
