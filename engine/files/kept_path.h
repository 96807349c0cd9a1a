#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/fits/allowance.h"
#include "engine/planning/path.h"

namespace glissade {

struct LoadedScenario;

/// A path that is kept in a scenario, with what was proved about it when it was kept. The certificate is not kept: the
/// path is proved again when the scenario is opened (proveAgain()).
struct KeptPath {
  std::string name;  ///< not empty; unique among the paths of a scenario
  bool pinned = false;
  std::string object;  ///< id of the object
  PathProvenance provenance;
  bool smoothed = false;              ///< shortened after it was planned
  double requiredClearance = 0.0;     ///< required clearance, metres, > 0
  double clearance = -1.0;            ///< smallest distance to any body, metres; below 0: no body was near
  double provedClearance = 0.0;       ///< proved clearance, metres
  std::vector<Allowance> allowances;  ///< files have bodies, amounts, `yields` and `hollow` of them only
  std::string problemSha256;          ///< of the problem for which it was proved
  std::vector<PathPoint> points;      ///< at least one
};
/// Shared by the document, the undo stack and files; never changed.
using KeptPathPtr = std::shared_ptr<const KeptPath>;
using KeptPaths = std::vector<KeptPathPtr>;

/// The record of a certified path of this scenario. Precondition: the path is not empty.
KeptPath keptPath(const std::string& name, const Path& path, const PathProvenance& provenance, bool smoothed,
                  const LoadedScenario& scenario);

/// True if the configurations are the same, bit by bit.
bool hasPoints(const KeptPath& kept, const std::vector<PathPoint>& points);

/// A name that no path has yet: `stem`, or "stem 2", ...
std::string freePathName(const KeptPaths& paths, const std::string& stem);

}  // namespace glissade
