#include "engine/import/covered_surfaces.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <memory>
#include <vector>

#include "engine/geometry/mesh_audit.h"
#include "engine/geometry/mesh_edges.h"
#include "engine/geometry/solid_interior.h"
#include "engine/geometry/triangle_tree.h"
#include "engine/import/part_solids.h"
#include "engine/model/body_path.h"

namespace glissade {
namespace {

using Corners = std::array<Vector3, 3>;

/// Least distance outside of a solid that does not count, metres.
constexpr double kRounding = 1e-6;

/// A closed mesh for questions about points.
class Interior {
 public:
  explicit Interior(const TriangleMesh& mesh)
      : surface_(mesh), interior_(mesh, edgeFactsOf(mesh).consistentlyOriented) {}

  /// The distance from the surface: above 0 inside, below 0 outside.
  double depthOf(const Vector3& p) const {
    const double distance = surface_.nearest(p, std::numeric_limits<double>::infinity()).distance;
    return interior_.contains(p) ? distance : -distance;
  }

 private:
  TriangleTree surface_;
  SolidInterior interior_;
};

/// Shows that a surface is within a solid by balls about points of its triangles, which are divided where a ball does
/// not reach.
class Cover {
 public:
  Cover(const Interior& solid, double tolerance) : solid_(solid), tolerance_(tolerance) {}

  bool covers(const Corners& corners) {
    if (--questionsLeft_ < 0) return false;
    const Vector3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    const double depth = solid_.depthOf(middle);
    if (depth < -tolerance_) return false;
    double reach = 0.0;
    for (const Vector3& corner : corners) reach = std::max(reach, (corner - middle).norm());
    if (depth - reach >= -tolerance_) return true;
    // The longest edge is divided.
    std::size_t longest = 0;
    const auto lengthOf = [&](std::size_t edge) { return (corners[(edge + 1) % 3] - corners[edge]).squaredNorm(); };
    for (std::size_t edge = 1; edge < 3; ++edge) {
      if (lengthOf(edge) > lengthOf(longest)) longest = edge;
    }
    const Vector3& from = corners[longest];
    const Vector3& to = corners[(longest + 1) % 3];
    const Vector3& opposite = corners[(longest + 2) % 3];
    const Vector3 between = 0.5 * (from + to);
    return covers({from, between, opposite}) && covers({between, to, opposite});
  }

 private:
  const Interior& solid_;
  double tolerance_;
  int questionsLeft_ = 200'000;
};

class CoveredSurfaces {
 public:
  bool isClosed(const Occurrence& part) {
    const auto [known, isNew] = isClosed_.try_emplace(part.mesh, false);
    if (isNew) known->second = isClosedSurface(*part.mesh);
    return known->second;
  }

  bool isCovered(const Occurrence& surface, const Occurrence& solid) {
    const Pose X_SB = inverse(solid.X_FP) * surface.X_FP;
    for (const Known& known : known_) {
      if (known.surface == surface.mesh && known.solid == solid.mesh && known.X_SB == X_SB) return known.isCovered;
    }
    known_.push_back({surface.mesh, solid.mesh, X_SB, covers(surface, X_SB, solid)});
    return known_.back().isCovered;
  }

 private:
  struct Known {
    MeshPtr surface;
    MeshPtr solid;
    Pose X_SB;
    bool isCovered;
  };

  bool covers(const Occurrence& surface, const Pose& X_SB, const Occurrence& solid) {
    std::unique_ptr<const Interior>& interior = interiors_[solid.mesh];
    if (!interior) interior = std::make_unique<const Interior>(*solid.mesh);
    Cover cover(*interior, surface.deflection + solid.deflection + kRounding);
    const TriangleMesh mesh = transformed(*surface.mesh, X_SB);
    return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const TriangleIndices& triangle) {
      return cover.covers({mesh.vertices[triangle[0]], mesh.vertices[triangle[1]], mesh.vertices[triangle[2]]});
    });
  }

  std::map<MeshPtr, bool> isClosed_;
  std::map<MeshPtr, std::unique_ptr<const Interior>> interiors_;
  std::vector<Known> known_;
};

/// The path of the part that a shape belongs to. A product with shapes of several representations is read as an
/// assembly of shapes that have its name.
std::string partOf(const Occurrence& shape) {
  if (shape.isSolidOfPart) return partPathOf(shape);
  std::vector<std::string> steps = stepsOf(shape.path);
  const std::size_t count = steps.size();
  if (count < 2) return shape.path;
  const auto productOf = [&](std::size_t step) {
    return shape.names.size() == count ? shape.names[step].product : withoutNumber(steps[step]);
  };
  if (productOf(count - 1) != productOf(count - 2)) return shape.path;
  steps.pop_back();
  return pathOf(steps);
}

/// Replaces the warning about the part.
void say(const std::string& path, std::size_t faces, const std::string& file, Warnings& warnings) {
  const Location place = Message(GLISSADE_TEXT("part '%1'"), {path});
  std::erase_if(warnings, [&](const Diagnostic& warning) { return warning.location == place; });
  warnings.push_back({ErrorKind::MalformedInput,
                      file,
                      place,
                      {GLISSADE_TEXT("has surfaces inside its solid (%1 {1|face|faces}), as cosmetic threads are: they "
                                     "are left out"),
                       {faces}},
                      GLISSADE_TEXT("The solid covers them, so that nothing is missing.")});
}

}  // namespace

void leaveOutCoveredSurfaces(StepProduct& product, const std::string& file) {
  CoveredSurfaces surfaces;
  std::map<std::string, std::vector<const Occurrence*>> solidsOf;
  for (const Occurrence& each : product.parts) {
    if (surfaces.isClosed(each)) solidsOf[partOf(each)].push_back(&each);
  }
  std::vector<Occurrence> kept;
  for (const Occurrence& each : product.parts) {
    const auto solids = solidsOf.find(partOf(each));
    const bool isBesideSolids = solids != solidsOf.end() && !surfaces.isClosed(each);
    const bool isCovered =
        isBesideSolids && std::any_of(solids->second.begin(), solids->second.end(),
                                      [&](const Occurrence* solid) { return surfaces.isCovered(each, *solid); });
    if (isCovered) {
      say(each.path, std::max<std::size_t>(1, each.mesh->faces.size()), file, product.warnings);
    } else {
      kept.push_back(each);
    }
  }
  product.parts = std::move(kept);
}

}  // namespace glissade
