#pragma once

#include <QImage>
#include <QString>

#include <vector>

namespace glissade {

/// A scenario that comes with the program.
struct SampleScenario {
  const char* file;     ///< below the folder of the samples
  const char* name;     ///< English, as in the file; translated in the context "Samples"
  const char* summary;  ///< English, how the file's description begins; translated there, too
};

/// Those that the welcome page offers, in its order.
const std::vector<SampleScenario>& sampleScenarios();

/// The folder of the samples, from the folder of the program: installed, or above it in the tree of the sources. Empty
/// where there is none.
QString samplesFolder(const QString& programFolder);

/// Of the resources, made by packaging/sample-pictures.sh. Null where the program has none.
QImage samplePicture(const SampleScenario& sample, bool dark);

}  // namespace glissade
