#include "app/cli/commands.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/cli/interrupt.h"
#include "app/cli/text_cells.h"
#include "engine/base/volume_unit.h"
#include "engine/files/path_reader.h"
#include "engine/files/scenario_io.h"
#include "engine/files/swept_volume_file.h"
#include "engine/sweep/swept_bodies.h"

namespace glissade::cli {
namespace {

void report(const SweptVolume& sweep, const std::vector<std::string>& within, const SweepOptions& options) {
  if (options.console.json) {
    printJson({{"file", options.output},
               {"bound_m", sweep.bound},
               {"volume_m3", sweep.volume},
               {"volume_excess_estimate", sweep.excess},
               {"triangles", sweep.surface_W.triangles.size()},
               {"bodies_within", within}});
    return;
  }
  const VolumeUnit unit = volumeUnitFor(sweep.volume);
  const Console& console = options.console;
  console.print({GLISSADE_TEXT("swept volume %1 %2, %3 triangles; it contains the sweep, and its surface is at most %4 "
                               "mm away from it"),
                 {rounded(sweep.volume * unit.perCubicMetre), unit.name, sweep.surface_W.triangles.size(),
                  rounded(sweep.bound * 1e3)}});
  if (std::isfinite(sweep.excess)) {
    console.print({GLISSADE_TEXT("its volume is about %1 % larger than what the object covers"),
                   {rounded(std::ceil(1e2 * sweep.excess))}});
  } else {
    console.print(
        GLISSADE_TEXT("how much larger its volume is than what the object covers is not known: the object is thin"));
  }
  for (const std::string& body : within) console.print({GLISSADE_TEXT("within it or at its surface: %1"), {body}});
  console.print({GLISSADE_TEXT("wrote %1"), {options.output}});
}

}  // namespace

int runSweep(const SweepOptions& options) {
  const Interrupt interrupt;
  const auto loaded = loadScenario(options.scenario);
  if (!loaded) return reportError(loaded.error(), options.console);
  reportWarnings(loaded->warnings, options.console);
  const auto points = readPath(options.path);
  if (!points) return reportError(points.error(), options.console);

  const TriangleMesh& object = *loaded->object.mesh;
  const std::vector<Pose> poses = configurationsOf(*points);
  const auto sweep = options.bound ? sweptVolume(object, poses, *options.bound, interrupt.token())
                                   : usualSweptVolume(object, poses, interrupt.token());
  if (!sweep) return reportError(sweep.error(), options.console);
  std::vector<std::string> within;
  for (const std::size_t body : bodiesWithin(*sweep, loaded->obstacles, interrupt.token())) {
    within.push_back(loaded->obstacles[body].shown());
  }
  if (interrupt.requested()) {
    return reportError({ErrorKind::Interrupted, options.output, "", GLISSADE_TEXT("the swept volume was not written"),
                        GLISSADE_TEXT("Start it again.")},
                       options.console);
  }
  Warnings warnings;
  const Outcome saved = saveSweptVolume(*sweep, "Swept volume of " + loaded->object.name, loaded->object.colour,
                                        options.output, warnings);
  if (!saved) return reportError(saved.error(), options.console);
  reportWarnings(warnings, options.console);
  report(*sweep, within, options);
  return 0;
}

}  // namespace glissade::cli
