#include "engine/import/part_solids.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include "engine/geometry/mesh_audit.h"
#include "engine/model/body_path.h"
#include "engine/model/product.h"

namespace glissade {
namespace {

/// Tolerance for the poses of two instances of one solid: metres, and cosines.
constexpr double kSamePlace = 1e-9;

bool isSamePlace(const Pose& a, const Pose& b) {
  return (a.position - b.position).cwiseAbs().maxCoeff() <= kSamePlace &&
         std::abs(a.orientation.dot(b.orientation)) >= 1.0 - kSamePlace;
}

class PartsAsOne {
 public:
  using Occurrences = std::vector<Occurrence>;

  /// Joins the solids of one part; shapes of the part that are no solids remain separate.
  Occurrences joined(Occurrences::const_iterator first, Occurrences::const_iterator end) {
    Occurrences solids;
    Occurrences parts;
    for (auto shape = first; shape != end; ++shape) (isSolid(shape->mesh) ? solids : parts).push_back(*shape);
    if (solids.empty()) return parts;
    Occurrence whole = solids.size() > 1 ? joined(solids) : solids.front();
    whole.path = partPathOf(*first);
    if (!whole.names.empty()) whole.names.pop_back();
    whole.formerPath.clear();
    whole.isSolidOfPart = false;
    if (!parts.empty()) placeBeside(parts, whole);
    parts.insert(parts.begin(), std::move(whole));
    return parts;
  }

 private:
  /// Gives the joined solids a name of their own among the shapes of the part: that of the part, with a number if a
  /// shape has it.
  static void placeBeside(const Occurrences& shapes, Occurrence& whole) {
    const std::vector<std::string> steps = stepsOf(whole.path);
    const std::string beside = joinedPath(whole.path, steps.empty() ? "" : steps.back());
    const auto isTaken = [&](const std::string& path) {
      return std::any_of(shapes.begin(), shapes.end(), [&](const Occurrence& shape) { return shape.path == path; });
    };
    whole.path = beside;
    for (int number = 2; isTaken(whole.path); ++number) whole.path = beside + "#" + std::to_string(number);
    if (!whole.names.empty()) whole.names.push_back({whole.names.back().product});
  }

  struct PlacedSolid {
    MeshPtr mesh;
    Pose X_PS;
  };
  using Solids = std::vector<PlacedSolid>;

  /// The mesh of the whole part is in the frame of its first solid.
  Occurrence joined(const Occurrences& shapes) {
    Occurrence whole = shapes.front();
    Solids solids;
    whole.facesWithoutMesh = 0;
    for (const Occurrence& shape : shapes) {
      solids.push_back({shape.mesh, solids.empty() ? Pose::identity() : inverse(whole.X_FP) * shape.X_FP});
      if (!whole.colour) whole.colour = shape.colour;
      whole.deflection = std::max(whole.deflection, shape.deflection);
      whole.coordinateSpacing = std::max(whole.coordinateSpacing, shape.coordinateSpacing);
      whole.facesWithoutMesh += shape.facesWithoutMesh;
      whole.isClosed = whole.isClosed && shape.isClosed;
    }
    whole.mesh = meshOf(solids);
    return whole;
  }

  /// True for a closed mesh with outward orientation: an open mesh has no inside, and one turned inwards would remove
  /// the inside of the others where they overlap.
  bool isSolid(const MeshPtr& mesh) {
    const auto [known, isNew] = isSolid_.try_emplace(mesh, false);
    if (isNew) {
      const MeshAudit found = audit(*mesh);
      known->second = found.closed() && found.consistentlyOriented && found.volume > 0.0;
    }
    return known->second;
  }

  MeshPtr meshOf(const Solids& solids) {
    std::vector<std::pair<Solids, MeshPtr>>& known = meshes_[solids.front().mesh];
    const auto same = std::find_if(known.begin(), known.end(), [&](const auto& each) {
      return std::equal(each.first.begin(), each.first.end(), solids.begin(), solids.end(),
                        [](const auto& a, const auto& b) { return a.mesh == b.mesh && isSamePlace(a.X_PS, b.X_PS); });
    });
    if (same != known.end()) return same->second;
    TriangleMesh whole;
    for (const PlacedSolid& solid : solids) append(whole, transformed(*solid.mesh, solid.X_PS));
    known.emplace_back(solids, std::make_shared<const TriangleMesh>(std::move(whole)));
    return known.back().second;
  }

  std::map<MeshPtr, std::vector<std::pair<Solids, MeshPtr>>> meshes_;  ///< by the mesh of the first solid
  std::map<MeshPtr, bool> isSolid_;
};

}  // namespace

std::string partPathOf(const Occurrence& occurrence) {
  if (!occurrence.isSolidOfPart) return occurrence.path;
  std::vector<std::string> steps = stepsOf(occurrence.path);
  if (!steps.empty()) steps.pop_back();
  return pathOf(steps);
}

namespace {

using IsWanted = std::function<bool(const std::string&)>;

/// Joins the solids of each part for which `isWanted` holds.
std::vector<Occurrence> joinedParts(const std::vector<Occurrence>& solids, const IsWanted& isWanted) {
  PartsAsOne maker;
  std::vector<Occurrence> parts;
  for (auto first = solids.begin(); first != solids.end();) {
    const std::string path = partPathOf(*first);
    const auto isOther = [&](const Occurrence& each) { return !each.isSolidOfPart || partPathOf(each) != path; };
    const bool joins = first->isSolidOfPart && isWanted(path);
    const auto end = joins ? std::find_if(first + 1, solids.end(), isOther) : first + 1;
    if (joins) {
      for (Occurrence& part : maker.joined(first, end)) parts.push_back(std::move(part));
    } else {
      parts.push_back(*first);
    }
    first = end;
  }
  return parts;
}

/// Handles a plan of an earlier version, which names paths that no part has any more.
void takeFormerPaths(const std::set<std::string>& planBodies, std::vector<Occurrence>& solids) {
  std::set<std::string> paths;
  for (const Occurrence& solid : solids) paths.insert(solid.path);
  const bool isFormer = std::any_of(solids.begin(), solids.end(), [&](const Occurrence& solid) {
    return planBodies.count(solid.formerPath) > 0 && paths.count(solid.formerPath) == 0;
  });
  for (Occurrence& solid : solids) {
    if (isFormer && !solid.formerPath.empty()) solid.path = solid.formerPath;
  }
}

/// Adds the parts with several solids at or below one of the nodes, or with a solid among the nodes.
bool open(const std::vector<std::string>& nodes, const std::vector<Occurrence>& solids, std::set<std::string>& opened) {
  bool any = false;
  for (const Occurrence& solid : solids) {
    const std::string part = partPathOf(solid);
    const bool isMeant = std::any_of(nodes.begin(), nodes.end(), [&](const std::string& node) {
      return isWithin(part, node) || solid.path == node;
    });
    if (!solid.isSolidOfPart || !isMeant) continue;
    opened.insert(part);
    any = true;
  }
  return any;
}

}  // namespace

std::vector<Occurrence> withPartsAsOne(const std::vector<Occurrence>& solids, const std::string& node) {
  return joinedParts(solids, [&](const std::string& part) { return isWithin(part, node); });
}

std::vector<Occurrence> withPartsAsOne(const std::vector<Occurrence>& solids, const std::set<std::string>& opened) {
  return joinedParts(solids, [&](const std::string& part) { return opened.count(part) == 0; });
}

bool areSolidsOfOnePart(const std::vector<Occurrence>& shapes) {
  return shapes.size() > 1 && std::all_of(shapes.begin(), shapes.end(), [&](const Occurrence& each) {
           return each.isSolidOfPart && partPathOf(each) == partPathOf(shapes.front());
         });
}

Result<std::vector<Occurrence>> chosenParts(const std::vector<Occurrence>& solids, const std::string& whole,
                                            const PartChoice& choice) {
  std::vector<Occurrence> named = solids;
  const std::vector<std::string> ids = textsOf(choice.planBodies);
  const std::set<std::string> planBodies(ids.begin(), ids.end());
  takeFormerPaths(planBodies, named);
  std::vector<Occurrence> asOne = withPartsAsOne(named, std::set<std::string>());
  if (choice.open.empty() && asOne.size() == 1 && named.size() > 1) return named;
  std::set<std::string> joined;
  for (const Occurrence& part : asOne) joined.insert(part.path);
  std::set<std::string> opened;
  std::vector<ProductBody> bodies;
  for (const Occurrence& solid : named) {
    bodies.push_back({BodyId(solid.path), {solid.path, solid.names}});
    const bool isOfPlan = planBodies.count(solid.path) > 0 && joined.count(solid.path) == 0;
    if (solid.isSolidOfPart && isOfPlan) opened.insert(partPathOf(solid));
  }
  const Product tree(bodies);
  for (const std::string& name : choice.open) {
    std::vector<std::string> nodes;
    for (const std::size_t node : tree.named(name)) nodes.push_back(tree.nodes()[node].path);
    if (nodes.empty() && name == whole) nodes.emplace_back();
    if (open(nodes, named, opened)) continue;
    return Diagnostic{ErrorKind::Usage,
                      "",
                      "--open",
                      {GLISSADE_TEXT("names '%1', which is no part of several solids"), {name}},
                      GLISSADE_TEXT("See 'glissade-cli info' for the names.")};
  }
  return opened.empty() ? std::move(asOne) : withPartsAsOne(named, opened);
}

}  // namespace glissade
