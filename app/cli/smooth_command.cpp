#include "app/cli/commands.h"

#include <nlohmann/json.hpp>

#include "app/cli/interrupt.h"
#include "app/cli/text_cells.h"
#include "engine/files/path_exporter.h"
#include "engine/files/path_reader.h"
#include "engine/files/scenario_io.h"
#include "engine/planning/coarse/prohibitions.h"
#include "engine/planning/path_certificate.h"

namespace glissade::cli {
namespace {

double metricLength(const Path& path, const Problem& problem) {
  double sum = 0.0;
  for (const double part : path.lengthByAuthor(problem.metric())) sum += part;
  return sum;
}

}  // namespace

int runSmooth(const SmoothOptions& options) {
  const auto exporter = pathExporterFor(options.output);
  if (!exporter) return reportError(exporter.error(), options.console);
  const Interrupt interrupt;
  const auto loaded = loadScenario(options.scenario);
  if (!loaded) return reportError(loaded.error(), options.console);
  reportWarnings(loaded->warnings, options.console);
  auto points = readPath(options.input);
  if (!points) return reportError(points.error(), options.console);
  const auto kept = keepingOut(loaded->problem, interrupt.token());
  if (!kept) return reportError(kept.error(), options.console);
  const Problem& problem = *kept;

  Path path;
  path.points = std::move(*points);
  for (PathPoint& point : path.points) point.q.orientation.normalize();
  path.certificate = certifyPath(*problem.world->makeQuery(), path.points, loaded->parameters, interrupt.token());
  if (path.certificate.status != CertificateStatus::Certified) {
    return reportError(
        {ErrorKind::NoPath,
         options.input,
         {GLISSADE_TEXT("edge %1"), {path.certificate.edge}},
         inWords(path.certificate, *problem.world),
         GLISSADE_TEXT("Only certified paths are smoothed. glissade-cli check says more about the path.")},
        options.console);
  }
  const Path shorter =
      withShortcuts(path, problem, loaded->parameters, options.seed, options.attempts, interrupt.token());
  const SaveResult saved = exporter->write(shorter, *loaded, {"smooth", options.seed}, options.output);
  if (!saved) return reportError(saved.why, options.console);
  reportWarnings(saved.warnings, options.console);

  const double before = metricLength(path, problem);
  const double after = metricLength(shorter, problem);
  if (options.console.json) {
    nlohmann::ordered_json report{{"metric_length_before_m", before},
                                  {"metric_length_m", after},
                                  {"configurations_before", path.points.size()},
                                  {"configurations", shorter.points.size()},
                                  {"certificate", toJson(shorter.certificate, *problem.world)}};
    addUncertainties(*loaded, shorter.points, report["certificate"]);
    printJson(report);
  } else {
    options.console.print({GLISSADE_TEXT("from %1 m to %2 m in the metric, from %3 to %4 configurations, %5"),
                           {rounded(before), rounded(after), path.points.size(), shorter.points.size(),
                            inWords(shorter.certificate, *problem.world)}});
    for (const Message& line : uncertaintiesInWords(*loaded, shorter.points)) options.console.print(line);
  }
  return exitCodeWithout(loaded->missing);
}

}  // namespace glissade::cli
