#pragma once

#include <QImage>
#include <QString>
#include <QStringList>

#include <vector>

namespace glissade {

/// A scenario that comes with the program.
struct SampleScenario {
  const char* file;     ///< path in the folder of the samples
  const char* name;     ///< English, as in the file; translated in the context "Samples"
  const char* summary;  ///< English, beginning of the file's description; translated in the context "Samples"
};

/// The samples of the welcome page, in its order.
const std::vector<SampleScenario>& sampleScenarios();

/// The folder of the samples, searched from the folder of the program: the installed one, or the one in the source tree
/// above. Empty if there is none.
QString samplesFolder(const QString& programFolder);
/// The folders in which samplesFolder() searches, in its order.
QStringList foldersOfSamples(const QString& programFolder);

/// The sample's picture from the resources, made by packaging/sample-pictures.sh. Null if the program has none.
QImage samplePicture(const SampleScenario& sample, bool dark);

}  // namespace glissade
