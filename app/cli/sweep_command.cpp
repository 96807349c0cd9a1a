#include "app/cli/commands.h"

#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/interrupt.h"
#include "engine/base/volume_unit.h"
#include "engine/scenario/path_reader.h"
#include "engine/scenario/scenario_io.h"
#include "engine/scenario/swept_volume_file.h"
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
  std::cout << "swept volume " << sweep.volume * unit.perCubicMetre << " " << unit.name << ", "
            << sweep.surface_W.triangles.size() << " triangles; it contains the sweep, and its surface is at most "
            << sweep.bound * 1e3 << " mm away from it\n";
  if (std::isfinite(sweep.excess)) {
    std::cout << "its volume is about " << std::ceil(1e2 * sweep.excess) << " % larger than what the object covers\n";
  } else {
    std::cout << "how much larger its volume is than what the object covers is not known: the object is thin\n";
  }
  for (const std::string& body : within) std::cout << "within it or at its surface: " << body << "\n";
  std::cout << "wrote " << options.output << "\n";
}

}  // namespace

int runSweep(const SweepOptions& options) {
  const Interrupt interrupt;
  const auto loaded = loadScenario(options.scenario);
  if (!loaded) return reportError(loaded.error(), options.console);
  reportWarnings(loaded->warnings);
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
  reportWarnings(warnings);
  report(*sweep, within, options);
  return 0;
}

}  // namespace glissade::cli
