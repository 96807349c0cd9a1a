#include "engine/sequence/easier_motions.h"

#include "engine/sequence/joint_removal.h"
#include "engine/sequence/plan_steps.h"
#include "engine/sequence/removal_directions.h"
#include "engine/sequence/step_motion.h"

namespace glissade {
namespace {

/// Least difference of slides that counts, as a share of the size of the body.
constexpr double kWorthwhileSlide = 0.1;

/// The displacements of a motion.
std::vector<Vector3> displacementsOf(const std::vector<PathPoint>& path) {
  std::vector<Vector3> ways;
  for (std::size_t i = 1; i < path.size(); ++i) ways.push_back(path[i].q.position - path[i - 1].q.position);
  return ways;
}

class EasierMotions {
 public:
  EasierMotions(const SequenceQuestion& question, const StopToken& stop) : question_(question), stop_(stop) {
    for (const RigidBody& body : question.product.bodies) boxes_.push_back(boundingBox(*body.mesh, body.X_WB));
  }

  bool takeIn(AssemblyPlan& plan) {
    bool changed = false;
    BodySet present = question_.initial();
    for (std::size_t place = 0; place < plan.steps.size() && !stop_.stopRequested(); ++place) {
      StepMotion& motion = plan.steps[place].only();
      const BodyGroup group = groupOf(motion, question_.product);
      changed = take(motion, group, present, place) || changed;
      present = without(present, group);
    }
    return changed;
  }

 private:
  struct Handling {
    double slide = 0.0;  ///< metres
    bool fromBelow = false;
  };

  Handling handlingOf(const BodyGroup& group, const std::vector<PathPoint>& path, const BodySet& others) const {
    const auto boxOf = [&](std::size_t body) { return boxes_[body]; };
    return {slideOf(group, displacementsOf(path), others, *question_.fits, boxOf),
            senseOf(exitDirection(path), question_.up) < 0};
  }

  bool take(StepMotion& motion, const BodyGroup& group, const BodySet& present, std::size_t place) const {
    if (!motion.certified || motion.method == kTurned || motion.method == kByHand) return false;
    const BodySet others = without(present, group);
    const double least = kWorthwhileSlide * boxes_[group.front()].diagonal().norm();
    const Handling now = handlingOf(group, motion.path, others);
    if (now.slide <= least && !now.fromBelow) return false;
    const RemovalAnswer answer = question_.trial.tryRemoval(group, present, 0, stop_);
    const auto* removed = std::get_if<Removed>(&answer);
    if (removed == nullptr) return false;
    const Handling other = handlingOf(group, removed->path.points, others);
    const bool isShorter = other.slide < now.slide - least;
    const bool isFromAbove = now.fromBelow && !other.fromBelow && other.slide < now.slide + least;
    if (!isShorter && !isFromAbove) return false;
    const std::vector<BodyId> falling = motion.falling;
    motion = makeMotion(group, *removed, question_, present, place);
    motion.falling = falling;
    return true;
  }

  const SequenceQuestion& question_;
  const StopToken& stop_;
  std::vector<Box3> boxes_;
};

}  // namespace

bool takeEasierMotions(AssemblyPlan& plan, const SequenceQuestion& question, const StopToken& stop) {
  return question.fits != nullptr && EasierMotions(question, stop).takeIn(plan);
}

}  // namespace glissade
