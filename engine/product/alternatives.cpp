#include "engine/product/alternatives.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>

#include "engine/geometry/mesh_audit.h"
#include "engine/geometry/solid_interior.h"

namespace glissade {
namespace {

constexpr double kInCommon = 0.5;

/// A closed body, for asking whether points are inside.
struct FilledBody {
  SolidInterior interior;
  double volume;
};

class FilledBodies {
 public:
  /// Null where the mesh is not closed.
  const FilledBody* of(const MeshPtr& mesh) {
    auto [entry, isNew] = known_.try_emplace(mesh);
    if (isNew) {
      const MeshAudit facts = audit(*mesh);
      if (facts.closed())
        entry->second.emplace(FilledBody{SolidInterior(*mesh, facts.consistentlyOriented), facts.volume});
    }
    return entry->second ? &*entry->second : nullptr;
  }

 private:
  std::map<MeshPtr, std::optional<FilledBody>> known_;
};

/// The fractional part of i times an irrational number: points that fill a box evenly.
double spread(int i, double step) {
  const double value = i * step;
  return value - std::floor(value);
}

/// Of the volume that both fill, cubic metres, by points in the box that they have in common.
double commonVolume(const RigidBody& a, const FilledBody& inA, const RigidBody& b, const FilledBody& inB) {
  constexpr int kPoints = 4000;
  // Powers of the root of x^4 = x + 1: evenly spread in three dimensions (Roberts 2018, sequence R3).
  constexpr double kSteps[3] = {0.8191725133961645, 0.6710436067037893, 0.5497004779019703};
  const Box3 common = boundingBox(*a.mesh, a.X_WB).intersection(boundingBox(*b.mesh, b.X_WB));
  if (common.isEmpty()) return 0.0;
  const Pose X_AW = inverse(a.X_WB);
  const Pose X_BW = inverse(b.X_WB);
  int inBoth = 0;
  for (int i = 1; i <= kPoints; ++i) {
    const Vector3 share(spread(i, kSteps[0]), spread(i, kSteps[1]), spread(i, kSteps[2]));
    const Vector3 p = common.min() + common.sizes().cwiseProduct(share);
    if (inA.interior.contains(X_AW * p) && inB.interior.contains(X_BW * p)) ++inBoth;
  }
  return common.sizes().prod() * inBoth / kPoints;
}

}  // namespace

std::vector<Alternative> findAlternatives(const std::vector<RigidBody>& bodies, const std::vector<Contact>& contacts,
                                          const StopToken& stop) {
  FilledBodies solids;
  std::vector<Alternative> alternatives;
  for (const Contact& contact : contacts) {
    if (stop.stopRequested()) break;
    if (contact.overlap <= 0.0) continue;
    const RigidBody& a = bodies[contact.a];
    const RigidBody& b = bodies[contact.b];
    const FilledBody* inA = solids.of(a.mesh);
    const FilledBody* inB = solids.of(b.mesh);
    if (inA == nullptr || inB == nullptr) continue;
    const double larger = std::max(std::abs(inA->volume), std::abs(inB->volume));
    const double smaller = std::min(std::abs(inA->volume), std::abs(inB->volume));
    if (smaller < kInCommon * larger) continue;
    const double share = commonVolume(a, *inA, b, *inB) / larger;
    if (share >= kInCommon) alternatives.push_back({contact.a, contact.b, std::min(share, 1.0)});
  }
  return alternatives;
}

Warnings warningsOf(const std::vector<Alternative>& alternatives, const std::vector<RigidBody>& bodies) {
  Warnings warnings;
  for (const Alternative& each : alternatives) {
    const std::string& a = bodies[each.a].shown();
    const std::string& b = bodies[each.b].shown();
    const auto percent = static_cast<int>(std::round(100.0 * each.share));
    warnings.push_back(
        {ErrorKind::InCollision, "", "'" + a + "' and '" + b + "'",
         "fill the same place (" + std::to_string(percent) + " % of the larger one): they may be variants of one part",
         "Leave one out (--without " + a + ")."});
  }
  return warnings;
}

}  // namespace glissade
