#include "app/cli/convert_command.h"

#include <iostream>

#include "engine/base/file.h"
#include "engine/planning/path_certificate.h"
#include "engine/scenario/asset_path.h"
#include "engine/scenario/path_io.h"
#include "engine/scenario/scenario_io.h"

namespace glissade::cli {
namespace {

bool endsWith(const std::string& text, const std::string& ending) {
  return text.size() >= ending.size() && text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

/// Whether a file says of itself that it is a scenario.
bool saysScenario(const std::string& file) {
  constexpr std::size_t kMostBytes = 16U << 20;
  const auto text = readFile(file, kMostBytes);
  return text && text->find("\"glissade-scenario\"") != std::string::npos;
}

int finish(const Outcome& outcome, const ConvertOptions& options) {
  if (!outcome) return reportError(outcome.error(), options.format);
  std::cout << "wrote " << options.output << "\n";
  return 0;
}

int convertPath(const ConvertOptions& options) {
  auto points = readPath(options.input);
  if (!points) return reportError(points.error(), options.format);
  Path path;
  path.points = std::move(*points);
  if (endsWith(options.output, ".path")) return finish(writePathOmpl(path, options.output), options);
  if (options.scenario.empty()) {
    return reportError({ErrorKind::Usage, options.output, "", "this format holds clearances",
                        "Name the scenario with --scenario, or write OMPL's format (.path)."},
                       options.format);
  }
  const auto scenario = loadScenario(options.scenario);
  if (!scenario) return reportError(scenario.error(), options.format);
  const auto query = scenario->problem.world->makeQuery();
  path.certificate = certifyPath(*query, path.points, scenario->parameters);
  if (endsWith(options.output, ".json")) {
    return finish(writePathJson(path, *scenario, {}, options.output), options);
  }
  return finish(writePathCsv(path, *scenario, options.output), options);
}

int convertScenario(const ConvertOptions& options) {
  const auto loaded = loadScenario(options.input);
  if (!loaded) return reportError(loaded.error(), options.format);
  reportWarnings(loaded->warnings);
  return finish(saveScenario(movedTo(options.output, loaded->scenario, options.input), options.output), options);
}

}  // namespace

int runConvert(const ConvertOptions& options) {
  return endsWith(options.input, ".cfg") || saysScenario(options.input) ? convertScenario(options)
                                                                        : convertPath(options);
}

}  // namespace glissade::cli
