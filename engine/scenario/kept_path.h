#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/planning/path.h"

namespace glissade {

struct LoadedScenario;

/// By how much the object was taken thinner against one obstacle, or the obstacle against the object.
struct KeptAllowance {
  std::string body;     ///< id of the obstacle
  double metres = 0;    ///< > 0
  bool yields = false;  ///< the obstacle was taken thinner
  bool hollow = false;  ///< what overlaps was taken away, so deep: an accepted clash

  friend bool operator==(const KeptAllowance&, const KeptAllowance&) = default;
};

/// A path that is kept in a scenario, with what was proved of it when it was kept. The certificate is not kept: who
/// opens the scenario proves the path again (proveAgain()).
struct KeptPath {
  std::string name;  ///< not empty; no two paths of a scenario have the same
  bool pinned = false;
  std::string object;  ///< id of the object that moves
  PathProvenance provenance;
  bool smoothed = false;           ///< shortened after it was planned
  double requiredClearance = 0.0;  ///< metres, > 0
  double clearance = -1.0;         ///< smallest distance to any body, metres; below 0: nothing was near
  double provedClearance = 0.0;    ///< metres
  std::vector<KeptAllowance> allowances;
  std::string problemSha256;      ///< problemSha256() of the scenario that it was proved for
  std::vector<PathPoint> points;  ///< at least one
};
/// Shared by the document, the undo stack and files; never changed.
using KeptPathPtr = std::shared_ptr<const KeptPath>;
using KeptPaths = std::vector<KeptPathPtr>;

/// A certified path of this scenario as it is kept. Precondition: the path is not empty.
KeptPath keptPath(const std::string& name, const Path& path, const PathProvenance& provenance, bool smoothed,
                  const LoadedScenario& scenario);

/// The configurations are the same, bit by bit.
bool hasPoints(const KeptPath& kept, const std::vector<PathPoint>& points);

/// A name that none of the paths has: `stem`, or "stem 2", ...
std::string freePathName(const KeptPaths& paths, const std::string& stem);

}  // namespace glissade
