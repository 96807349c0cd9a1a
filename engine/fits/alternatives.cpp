#include "engine/fits/alternatives.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "engine/geometry/mesh_audit.h"
#include "engine/geometry/solid_interior.h"

namespace glissade {
namespace {

constexpr double kInCommon = 0.5;

/// A closed body, for tests whether points are inside.
struct FilledBody {
  SolidInterior interior;
  double volume;
};

class FilledBodies {
 public:
  /// Null if the mesh is not closed.
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

/// Estimates the common volume of two bodies, cubic metres, by points in their common box. Stops early if the first
/// points show that it is too small.
double commonVolume(const RigidBody& a, const FilledBody& inA, const RigidBody& b, const FilledBody& inB,
                    double wanted) {
  constexpr int kPoints = 4000;
  constexpr int kFirst = 200;
  // Powers of the root of x^4 = x + 1: evenly spread in three dimensions (Roberts 2018, sequence R3).
  constexpr double kSteps[3] = {0.8191725133961645, 0.6710436067037893, 0.5497004779019703};
  const Box3 common = boundingBox(*a.mesh, a.X_WB).intersection(boundingBox(*b.mesh, b.X_WB));
  const double volume = common.sizes().prod();
  const Pose X_AW = inverse(a.X_WB);
  const Pose X_BW = inverse(b.X_WB);
  int inBoth = 0;
  for (int i = 1; i <= kPoints; ++i) {
    const Vector3 share(spread(i, kSteps[0]), spread(i, kSteps[1]), spread(i, kSteps[2]));
    const Vector3 p = common.min() + common.sizes().cwiseProduct(share);
    if (inA.interior.contains(X_AW * p) && inB.interior.contains(X_BW * p)) ++inBoth;
    if (i == kFirst && volume * inBoth < 0.5 * wanted * kFirst) return 0.0;
  }
  return volume * inBoth / kPoints;
}

/// `boxes`: common volume of the bounding boxes, cubic metres. Nothing if the bodies share less than half of the larger
/// one.
std::optional<double> shareInCommon(const RigidBody& a, const RigidBody& b, double boxes, FilledBodies& solids) {
  const FilledBody* inA = solids.of(a.mesh);
  const FilledBody* inB = inA == nullptr ? nullptr : solids.of(b.mesh);
  if (inB == nullptr) return std::nullopt;
  const double larger = std::max(std::abs(inA->volume), std::abs(inB->volume));
  const double smaller = std::min(std::abs(inA->volume), std::abs(inB->volume));
  const double wanted = kInCommon * larger;
  if (smaller < wanted || boxes < wanted) return std::nullopt;
  const double common = commonVolume(a, *inA, b, *inB, wanted);
  return common < wanted ? std::nullopt : std::optional<double>(std::min(common / larger, 1.0));
}

}  // namespace

std::vector<Alternative> findAlternatives(const std::vector<RigidBody>& bodies, const StopToken& stop) {
  std::vector<Box3> boxes;
  for (const RigidBody& body : bodies) boxes.push_back(boundingBox(*body.mesh, body.X_WB));
  FilledBodies solids;
  std::vector<Alternative> alternatives;
  for (std::size_t a = 0; a < bodies.size() && !stop.stopRequested(); ++a) {
    for (std::size_t b = a + 1; b < bodies.size(); ++b) {
      const Box3 common = boxes[a].intersection(boxes[b]);
      if (common.isEmpty()) continue;
      const auto share = shareInCommon(bodies[a], bodies[b], common.sizes().prod(), solids);
      if (share) alternatives.push_back({a, b, *share});
    }
  }
  return alternatives;
}

std::vector<std::vector<std::size_t>> variantsOf(const std::vector<Alternative>& alternatives) {
  std::vector<std::set<std::size_t>> groups;
  for (const Alternative& each : alternatives) {
    std::set<std::size_t> joined{each.a, each.b};
    std::erase_if(groups, [&](const std::set<std::size_t>& group) {
      if (group.count(each.a) == 0 && group.count(each.b) == 0) return false;
      joined.insert(group.begin(), group.end());
      return true;
    });
    groups.push_back(std::move(joined));
  }
  std::vector<std::vector<std::size_t>> variants;
  for (const auto& group : groups) variants.emplace_back(group.begin(), group.end());
  std::sort(variants.begin(), variants.end());
  return variants;
}

Warnings warningsOf(const std::vector<Alternative>& alternatives, const std::vector<RigidBody>& bodies) {
  Warnings warnings;
  for (const Alternative& each : alternatives) {
    const std::string& a = bodies[each.a].shown();
    const std::string& b = bodies[each.b].shown();
    const auto percent = static_cast<int>(std::round(100.0 * each.share));
    warnings.push_back(
        {ErrorKind::InCollision,
         "",
         {GLISSADE_TEXT("'%1' and '%2'"), {a, b}},
         {GLISSADE_TEXT("fill the same place (%1 % of the larger one): they may be variants of one part"), {percent}},
         {GLISSADE_TEXT("Exclude one (--without %1)."), {a}}});
  }
  return warnings;
}

}  // namespace glissade
