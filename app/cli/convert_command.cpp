#include "app/cli/commands.h"

#include <filesystem>

#include "engine/base/file.h"
#include "engine/files/asset_path.h"
#include "engine/files/path_exporter.h"
#include "engine/files/path_reader.h"
#include "engine/files/scenario_file.h"
#include "engine/planning/coarse/prohibitions.h"
#include "engine/planning/path_certificate.h"

namespace glissade::cli {
namespace {

/// Whether a file states that it is a scenario.
bool saysScenario(const std::string& file) {
  constexpr std::size_t kMostBytes = 16U << 20;
  const auto text = readFile(file, kMostBytes);
  return text && text->find("\"glissade-scenario\"") != std::string::npos;
}

int finish(const SaveResult& saved, const ConvertOptions& options) {
  if (!saved) return reportError(saved.why, options.console);
  reportWarnings(saved.warnings, options.console);
  options.console.print({GLISSADE_TEXT("wrote %1"), {options.output}});
  return 0;
}

int convertPath(const ConvertOptions& options) {
  const auto exporter = pathExporterFor(options.output);
  if (!exporter) return reportError(exporter.error(), options.console);
  auto points = readPath(options.input);
  if (!points) return reportError(points.error(), options.console);
  Path path;
  path.points = std::move(*points);
  if (!exporter->needsScenario) {
    const LoadedScenario none;
    return finish(exporter->write(path, none, {}, options.output), options);
  }
  if (options.scenario.empty()) {
    return reportError({ErrorKind::Usage, options.output, "", GLISSADE_TEXT("this format holds more than the path"),
                        GLISSADE_TEXT("Name the scenario with --scenario, or write OMPL's format (.path).")},
                       options.console);
  }
  const auto scenario = loadScenario(options.scenario);
  if (!scenario) return reportError(scenario.error(), options.console);
  const auto kept = keepingOut(scenario->problem);
  if (!kept) return reportError(kept.error(), options.console);
  const auto query = kept->world->makeQuery();
  path.certificate = certifyPath(*query, path.points, scenario->parameters);
  return finish(exporter->write(path, *scenario, {}, options.output), options);
}

int convertScenario(const ConvertOptions& options) {
  const auto opened = openScenarioFile(options.input);
  if (!opened) return reportError(opened.error(), options.console);
  const LoadedScenario& loaded = opened->scenario;
  reportWarnings(loaded.warnings, options.console);
  std::error_code notThere;
  const bool inPlace = std::filesystem::equivalent(options.input, options.output, notThere);
  const SaveResult saved = saveScenarioFile(movedTo(options.output, loaded.scenario, options.input), options.output,
                                            inPlace ? std::optional(opened->sha256) : std::nullopt);
  return finish(saved, options);
}

}  // namespace

int runConvert(const ConvertOptions& options) {
  return endingOf(options.input) == "cfg" || saysScenario(options.input) ? convertScenario(options)
                                                                         : convertPath(options);
}

}  // namespace glissade::cli
