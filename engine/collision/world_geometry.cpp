#include "engine/collision/world_geometry.h"

#include <algorithm>
#include <map>
#include <optional>

namespace glissade {
namespace {

constexpr std::size_t kMostTrianglesInOneTree = 200'000;
/// Bounds of the obstacles' size multiplied by the known scale, between which a large world keeps that scale and its
/// trees.
constexpr double kSmallestScaledSize = 0x1p-10;
constexpr double kLargestScaledSize = 0x1p10;

using TreePtr = std::shared_ptr<const BoxTree>;

/// Prepares the obstacles of a world.
class ObstaclePreparation {
 public:
  /// `known`: null where there is no other world.
  ObstaclePreparation(const std::vector<RigidBody>& obstacles, const WorldGeometry* known)
      : obstacles_(obstacles), known_(known != nullptr && known->solids ? known : nullptr) {
    for (std::size_t i = 0; known_ != nullptr && i < known_->obstacles->size(); ++i) {
      knownByMesh_.emplace((*known_->obstacles)[i].mesh.get(), i);
    }
  }

  std::vector<Solids::Placed> placedSolids() const {
    std::map<const TriangleMesh*, Solids::SolidPtr> prepared;
    std::vector<Solids::Placed> placed;
    placed.reserve(obstacles_.size());
    std::size_t next = 0;
    for (const RigidBody& body : obstacles_) {
      Solids::SolidPtr& solid = prepared[body.mesh.get()];
      const auto known = knownByMesh_.find(body.mesh.get());
      if (!solid && known != knownByMesh_.end()) solid = known_->solids->obstacles()[known->second].solid;
      if (!solid) solid = Solids::prepare(*body.mesh);
      const Box3* box = knownBox(body, next);
      placed.push_back({solid, body.X_WB, box != nullptr ? *box : boundingBox(*body.mesh, body.X_WB)});
    }
    return placed;
  }

  /// The occurrences and the object. An object with the mesh of an obstacle shares its tree.
  std::shared_ptr<const OccurrenceGeometry> occurrences(const MeshPtr& object, const Solids& solids,
                                                        const Box3& obstaclesBox) const {
    const double scale = scaleOfLarge(obstaclesBox);
    const OccurrenceGeometry* known = known_ != nullptr ? known_->occurrences.get() : nullptr;
    if (known != nullptr && known->scale != scale) known = nullptr;
    std::map<const TriangleMesh*, TreePtr> trees;
    std::vector<OccurrenceGeometry::Occurrence> placed;
    std::vector<Box3> boxes;
    for (std::size_t i = 0; i < obstacles_.size(); ++i) {
      const TriangleMesh* mesh = obstacles_[i].mesh.get();
      TreePtr& tree = trees[mesh];
      const auto before = knownByMesh_.find(mesh);
      if (!tree && known != nullptr && before != knownByMesh_.end()) tree = known->occurrences[before->second].tree;
      if (!tree) tree = kernelObstacle(*mesh, scale);
      placed.push_back({tree, obstacles_[i].X_WB});
      boxes.push_back(solids.obstacles()[i].box_W);
    }
    const auto shared = trees.find(object.get());
    TreePtr moving = shared != trees.end() ? shared->second : nullptr;
    const bool isKnown = known != nullptr && known_->object == object && knownByMesh_.count(object.get()) == 0;
    if (!moving) moving = isKnown ? known->object : kernelObject(*object, scale);
    return std::make_shared<const OccurrenceGeometry>(scale, std::move(placed), boxes, std::move(moving),
                                                      solids.object()->box);
  }

 private:
  /// The known box of a body. Most bodies are in the order of the other world.
  const Box3* knownBox(const RigidBody& body, std::size_t& next) const {
    constexpr std::size_t kMostThatCameOrWent = 3;
    if (known_ == nullptr) return nullptr;
    const std::size_t first = next < kMostThatCameOrWent ? 0 : next - kMostThatCameOrWent;
    const std::size_t last = std::min(next + kMostThatCameOrWent + 1, known_->obstacles->size());
    for (std::size_t i = first; i < last; ++i) {
      if (!isSamePlaced((*known_->obstacles)[i], body)) continue;
      next = i + 1;
      return &known_->solids->obstacles()[i].box_W;
    }
    ++next;
    return nullptr;
  }

  /// The scale of a large world. Answers do not depend on it, because it is a power of two.
  double scaleOfLarge(const Box3& box) const {
    const double scale = known_ != nullptr && known_->occurrences ? known_->occurrences->scale : kernelScale(box);
    const double size = scale * box.diagonal().norm();
    return size > kSmallestScaledSize && size < kLargestScaledSize ? scale : kernelScale(box);
  }

  const std::vector<RigidBody>& obstacles_;
  const WorldGeometry* known_;
  std::map<const TriangleMesh*, std::size_t> knownByMesh_;  ///< index of the first obstacle with the mesh
};

/// The first obstacle with this mesh; nothing where there is none.
std::optional<std::size_t> obstacleWith(const MeshPtr& mesh, const std::vector<RigidBody>& obstacles) {
  const auto same =
      std::find_if(obstacles.begin(), obstacles.end(), [&](const RigidBody& body) { return body.mesh == mesh; });
  if (same == obstacles.end()) return std::nullopt;
  return static_cast<std::size_t>(same - obstacles.begin());
}

}  // namespace

bool isLarge(const std::vector<RigidBody>& obstacles) {
  std::size_t triangles = 0;
  for (const RigidBody& body : obstacles) triangles += body.mesh->triangles.size();
  return triangles > kMostTrianglesInOneTree;
}

bool isSamePlaced(const RigidBody& a, const RigidBody& b) { return a.mesh == b.mesh && a.X_WB == b.X_WB; }

WorldGeometry prepareGeometry(std::vector<RigidBody> obstacles, const MeshPtr& object, CollisionBackend backend,
                              bool large, const WorldGeometry* known) {
  const ObstaclePreparation preparation(obstacles, known);
  WorldGeometry geometry;
  geometry.backend = backend;
  geometry.object = object;
  std::vector<Solids::Placed> solids = preparation.placedSolids();
  for (const Solids::Placed& placed : solids) geometry.obstaclesBox.extend(placed.box_W);
  Solids::SolidPtr moving;
  if (const auto same = obstacleWith(object, obstacles)) moving = solids[*same].solid;
  if (!moving && known != nullptr && known->solids && known->object == object) moving = known->solids->object();
  if (!moving) moving = Solids::prepare(*object);
  geometry.solids = std::make_shared<const Solids>(std::move(solids), std::move(moving));
  if (backend == CollisionBackend::Fcl) {
    geometry.fcl = makeFclGeometry(obstacles, *object);
  } else if (large) {
    geometry.occurrences = preparation.occurrences(object, *geometry.solids, geometry.obstaclesBox);
  } else {
    geometry.kernel = std::make_shared<const KernelGeometry>(obstacles, *object);
  }
  geometry.obstacles = std::make_shared<const std::vector<RigidBody>>(std::move(obstacles));
  return geometry;
}

WorldGeometry withOtherObject(const WorldGeometry& geometry, const MeshPtr& object) {
  WorldGeometry other = geometry;
  other.object = object;
  other.solids = std::make_shared<const Solids>(*geometry.solids, *object);
  if (geometry.kernel) {
    other.kernel = std::make_shared<const KernelGeometry>(*geometry.kernel, *object);
  } else if (geometry.occurrences) {
    auto occurrences = std::make_shared<OccurrenceGeometry>(*geometry.occurrences);
    const auto same = obstacleWith(object, *geometry.obstacles);
    auto tree = same ? occurrences->occurrences[*same].tree : kernelObject(*object, occurrences->scale);
    occurrences->setObject(std::move(tree), other.solids->object()->box);
    other.occurrences = std::move(occurrences);
  } else {
    other.fcl = makeFclGeometry(*geometry.obstacles, *object);
  }
  return other;
}

}  // namespace glissade
