// Carries out the recipe "Add a path exporter".
#include <gtest/gtest.h>

#include <sstream>

#include "engine/base/number_text.h"
#include "tests/engine/files/path_exporter_conformance.h"

namespace glissade {
namespace {

/// A line for each configuration: its position.
Result<std::string> pathAsPositions(const Path& path, const LoadedScenario&, const PathProvenance&) {
  std::string text;
  for (const PathPoint& point : path.points) {
    for (const double coordinate : point.q.position) text += toText(coordinate) + ' ';
    text.back() = '\n';
  }
  return text;
}

TEST(PathExporterRecipe, TheContentIsMadeWithoutAFile) {
  Path path;
  path.points = {{Pose::translation({0.1, -2.0, 1.0 / 3.0})}, {Pose::translation({1e-9, 0.0, 5.0})}};
  const PathExporter exporter = *pathExportersUnderTest().registry.find("positions");
  std::istringstream text(*exporter.content(path, {}, {}));
  for (const PathPoint& point : path.points) {
    for (const double coordinate : point.q.position) {
      double written = 0.0;
      text >> written;
      EXPECT_EQ(written, coordinate);
    }
  }
}

}  // namespace

PathExportersUnderTest pathExportersUnderTest() {
  PathExportersUnderTest exporters{makePathExporterRegistry(), {"positions"}};
  exporters.registry.add({"positions", {"xyz"}, GLISSADE_TEXT("Positions"), false, std::nullopt, pathAsPositions});
  return exporters;
}

}  // namespace glissade
