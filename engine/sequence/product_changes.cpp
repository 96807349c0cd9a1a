#include "engine/sequence/product_changes.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>

#include "engine/geometry/triangle_tree.h"
#include "engine/sequence/body_group.h"
#include "engine/sequence/plan_bodies.h"
#include "engine/sequence/step_order.h"

namespace glissade {
namespace {

/// Largest distance of a vertex of one mesh, placed by `X`, from the surface of the other.
double farthestVertex(const TriangleMesh& mesh, const Pose& X, const TriangleTree& other, double enough) {
  double farthest = 0.0;
  for (const Vector3& vertex : mesh.vertices) {
    farthest = std::max(farthest, other.nearest(X * vertex, std::numeric_limits<double>::infinity(), enough).distance);
  }
  return farthest;
}

/// Compares the shapes of two products and keeps the trees of their meshes.
class ShapeComparison {
 public:
  ShapeComparison(const AssembledProduct& before, const AssembledProduct& now) : before_(before), now_(now) {}

  /// Largest distance between the surfaces; `X_NB`: places the frame of the earlier body in that of the later one.
  double distance(std::size_t before, std::size_t now, const Pose& X_NB) {
    const TriangleMesh& a = *before_.bodies[before].mesh;
    const TriangleMesh& b = *now_.bodies[now].mesh;
    const double enough = accuracy(before, now);
    return std::max(farthestVertex(a, X_NB, treeOf(b), enough), farthestVertex(b, inverse(X_NB), treeOf(a), enough));
  }

  bool isSame(std::size_t before, std::size_t now, const Pose& X_NB) {
    const TriangleMesh& a = *before_.bodies[before].mesh;
    const TriangleMesh& b = *now_.bodies[now].mesh;
    const bool haveSameTriangles = a.vertices.size() == b.vertices.size() && a.triangles == b.triangles;
    if (!haveSameTriangles) return distance(before, now, X_NB) <= accuracy(before, now);
    // Triangles that correspond show differences that are smaller than the accuracy of the triangles.
    const double rounding = roundingOf(before, now);
    for (std::size_t i = 0; i < a.vertices.size(); ++i) {
      if ((X_NB * a.vertices[i] - b.vertices[i]).norm() > rounding) return false;
    }
    return true;
  }

  /// Metres by which two meshes of the same surface may differ.
  double accuracy(std::size_t before, std::size_t now) const {
    const auto deflection = [](const AssembledProduct& product, std::size_t body) {
      return body < product.deflections.size() ? product.deflections[body] : 0.0;
    };
    return deflection(before_, before) + deflection(now_, now) + roundingOf(before, now);
  }

  /// Metres by which the same vertex may differ in two files.
  double roundingOf(std::size_t before, std::size_t now) const {
    constexpr double kOfSize = 1e-7;  // files hold seven significant digits at least
    const double size = boundingBox(*before_.bodies[before].mesh).diagonal().norm();
    return before_.spacingOf(before) + now_.spacingOf(now) + kOfSize * size;
  }

 private:
  const TriangleTree& treeOf(const TriangleMesh& mesh) { return trees_.try_emplace(&mesh, mesh).first->second; }

  const AssembledProduct& before_;
  const AssembledProduct& now_;
  std::map<const TriangleMesh*, TriangleTree> trees_{};
};

/// Finds the differences of two revisions.
class Comparison {
 public:
  Comparison(const AssembledProduct& before, const AssembledProduct& now, const StopToken& stop)
      : before_(before), now_(now), stop_(stop), shapes_(before, now), isMatched_(now.bodies.size(), false) {}

  ProductChanges find() {
    const std::map<BodyId, std::size_t> indices = now_.indicesById();
    for (std::size_t i = 0; i < before_.bodies.size() && !stop_.stopRequested(); ++i) {
      const auto same = indices.find(before_.bodies[i].id);
      if (same == indices.end()) {
        changes_.went.push_back(i);
        continue;
      }
      isMatched_[same->second] = true;
      compare(i, same->second);
    }
    std::erase_if(changes_.went, [this](std::size_t body) { return !stop_.stopRequested() && isRenamed(body); });
    for (std::size_t i = 0; i < now_.bodies.size(); ++i) {
      if (!isMatched_[i]) changes_.came.push_back(i);
    }
    return std::move(changes_);
  }

 private:
  /// The frame of the earlier body in the frame of the later one, where both are assembled.
  Pose assembled(std::size_t before, std::size_t now) const {
    return inverse(now_.bodies[now].X_WB) * before_.bodies[before].X_WB;
  }

  void compare(std::size_t before, std::size_t now) {
    const Pose X_NB = assembled(before, now);
    if (shapes_.isSame(before, now, X_NB)) {
      ++changes_.unchanged;
      return;
    }
    ChangedPart changed{before, now};
    if (shapes_.isSame(before, now, Pose())) {
      changed.moved = X_NB.position.norm();
      changed.turned = Eigen::AngleAxisd(X_NB.orientation).angle();
    } else {
      changed.reshaped = shapes_.distance(before, now, X_NB);
    }
    changes_.changed.push_back(changed);
  }

  bool isRenamed(std::size_t before) {
    const Box3 box = boundingBox(*before_.bodies[before].mesh, before_.bodies[before].X_WB);
    for (std::size_t now = 0; now < now_.bodies.size(); ++now) {
      if (isMatched_[now]) continue;
      const Box3 other = boundingBox(*now_.bodies[now].mesh, now_.bodies[now].X_WB);
      const double apart = std::max((box.min() - other.min()).norm(), (box.max() - other.max()).norm());
      if (apart > 2.0 * shapes_.accuracy(before, now) || !shapes_.isSame(before, now, assembled(before, now))) continue;
      isMatched_[now] = true;
      changes_.renamed.emplace_back(before, now);
      return true;
    }
    return false;
  }

  const AssembledProduct& before_;
  const AssembledProduct& now_;
  const StopToken& stop_;
  ShapeComparison shapes_;
  std::vector<bool> isMatched_;  ///< of the later revision
  ProductChanges changes_{};
};

/// Carries steps over to a product that lacks bodies of theirs.
class StepCarrier {
 public:
  explicit StepCarrier(const AssembledProduct& product) : present_(product.indicesById()) {}

  /// `from`: receives the index of each step that is left.
  void carry(std::vector<AssemblyStep>& steps, std::vector<SubassemblyLine>& lines,
             std::vector<std::size_t>& from) const {
    std::vector<std::size_t> numbers(steps.size() + 1, 0);  // new number of each step by its number, from 1; 0: none
    std::vector<AssemblyStep> left;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      std::erase_if(steps[i].motions, [&](const StepMotion& motion) {
        const std::vector<BodyId> bodies = motion.bodies();
        return std::any_of(bodies.begin(), bodies.end(), isGone());
      });
      if (steps[i].motions.empty()) continue;
      left.push_back(std::move(steps[i]));
      from.push_back(i);
      numbers[i + 1] = left.size();
    }
    steps = std::move(left);
    for (AssemblyStep& step : steps) {
      for (std::size_t& number : step.after) number = numbers[number];
      std::erase(step.after, 0U);
      forget(step);
    }
    for (SubassemblyLine& line : lines) line.step = numbers[line.step];
    std::erase_if(lines, [](const SubassemblyLine& line) { return line.step == 0; });
    for (SubassemblyLine& line : lines) {
      std::vector<std::size_t> ignored;
      carry(line.steps, line.lines, ignored);
    }
  }

  void keepPresent(std::vector<BodyId>& bodies) const { std::erase_if(bodies, isGone()); }
  void keepPresent(std::vector<StuckBody>& all) const {
    std::erase_if(all, [&](const StuckBody& stuck) { return isGone()(stuck.body); });
    for (StuckBody& stuck : all) keepPresent(stuck.blockedBy);
  }

 private:
  std::function<bool(const BodyId&)> isGone() const {
    return [this](const BodyId& id) { return present_.count(id) == 0; };
  }

  /// Removes proofs, measurements, and statements about bodies that are gone.
  void forget(AssemblyStep& step) const {
    for (StepMotion& motion : step.motions) forget(motion);
    std::erase_if(step.violates, [&](StepViolation& violation) {
      keepPresent(violation.bodies);
      return violation.bodies.empty();
    });
  }

  void forget(StepMotion& motion) const {
    const auto gone = isGone();
    motion.proof = {};
    keepPresent(motion.falling);
    std::erase_if(motion.allowances, [&](const Allowance& each) { return gone(each.body); });
    for (Allowance& each : motion.allowances) each.evidence = {};
    std::erase_if(motion.joints, [&](StepJoint& joint) {
      keepPresent(joint.others);
      keepPresent(joint.clamped);
      return gone(joint.body) || joint.others.empty();
    });
  }

  std::map<BodyId, std::size_t> present_;
};

}  // namespace

AssembledProduct withIdsOf(const AssembledProduct& before, AssembledProduct now) {
  const std::map<BodyId, std::size_t> ofBefore = before.indicesById();
  const std::map<BodyId, std::size_t> ofNow = now.indicesById();
  std::map<std::string, BodyId> ids;  // by name
  for (const RigidBody& body : before.bodies) {
    if (ofNow.count(body.id) == 0) ids.emplace(body.name, body.id);
  }
  for (RigidBody& body : now.bodies) {
    if (ofBefore.count(body.id) != 0) continue;
    const auto found = ids.extract(body.name);
    if (!found.empty()) body.id = found.mapped();
  }
  return now;
}

ProductChanges changesBetween(const AssembledProduct& before, const AssembledProduct& now, const StopToken& stop) {
  return Comparison(before, now, stop).find();
}

CarriedPlan carriedTo(const AssembledProduct& product, const AssemblyPlan& plan) {
  CarriedPlan carried{plan, {}};
  const StepCarrier carrier(product);
  carrier.carry(carried.plan.steps, carried.plan.lines, carried.from);
  for (AssemblyStep& step : carried.plan.steps) {
    for (StepMotion& motion : step.motions) {
      lengthen(motion, without(BodySet(product.bodies.size(), true), product.indicesOf(motion.bodies())), product);
    }
  }
  carried.plan.bodies = idsOf(product.bodies);
  carrier.keepPresent(carried.plan.staying);
  carrier.keepPresent(carried.plan.stuck);
  carried.plan.refusals.clear();
  carried.plan.waiting.clear();
  return carried;
}

}  // namespace glissade
