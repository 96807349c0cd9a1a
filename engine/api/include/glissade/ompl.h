/// @file
/// Glissade's world for planners of OMPL (Şucan, Moll, Kavraki 2012). No other public header includes this one; a
/// program that includes it links OMPL, too.
#pragma once

#include <glissade/glissade.h>
#include <ompl/base/MotionValidator.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateValidityChecker.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/geometric/PathGeometric.h>

#include <memory>
#include <utility>
#include <vector>

namespace glissade::api {

/// The configuration X_WB of a state of ompl::base::SE3StateSpace.
inline Pose poseOf(const ompl::base::State* state) {
  const auto* at = state->as<ompl::base::SE3StateSpace::StateType>();
  const auto& turn = at->rotation();
  return {{at->getX(), at->getY(), at->getZ()}, Quaternion(turn.w, turn.x, turn.y, turn.z).normalized()};
}

/// Sets a state of ompl::base::SE3StateSpace to the configuration X_WB.
inline void setPose(ompl::base::State* state, const Pose& X_WB) {
  auto* at = state->as<ompl::base::SE3StateSpace::StateType>();
  at->setXYZ(X_WB.position.x(), X_WB.position.y(), X_WB.position.z());
  auto& turn = at->rotation();
  turn.x = X_WB.orientation.x();
  turn.y = X_WB.orientation.y();
  turn.z = X_WB.orientation.z();
  turn.w = X_WB.orientation.w();
}

/// A state is valid if it is within the bounds, and the object is clear of all obstacles. For one thread.
class WorldValidityChecker : public ompl::base::StateValidityChecker {
 public:
  /// The checker of a space with this world.
  WorldValidityChecker(const ompl::base::SpaceInformationPtr& space, const World& world)
      : StateValidityChecker(space), query_(world.query()) {}

  /// True if the state is valid.
  bool isValid(const ompl::base::State* state) const override {
    if (!si_->satisfiesBounds(state)) return false;
    const auto collides = query_.collides(poseOf(state));
    return collides && !*collides;
  }
  /// Distance to the nearest obstacle, metres.
  double clearance(const ompl::base::State* state) const override {
    const auto nearest = query_.nearest(poseOf(state));
    return nearest ? nearest->distance : 0.0;
  }

 private:
  mutable Query query_;
};

/// A motion is valid if it is proved to keep the clearance, so that OMPL's paths need no resolution. For one thread.
class WorldMotionValidator : public ompl::base::MotionValidator {
 public:
  /// `required`: the clearance that each motion keeps, metres, above 0.
  WorldMotionValidator(const ompl::base::SpaceInformationPtr& space, const World& world, double required)
      : MotionValidator(space), query_(world.query()), required_(required) {}

  /// True if the motion is proved.
  bool checkMotion(const ompl::base::State* from, const ompl::base::State* to) const override {
    const bool isValid = isProved(from, to);
    ++(isValid ? valid_ : invalid_);
    return isValid;
  }
  /// True if the motion is proved. Else `last` is its longest proved beginning, to a 64th of the motion.
  bool checkMotion(const ompl::base::State* from, const ompl::base::State* to,
                   std::pair<ompl::base::State*, double>& last) const override {
    if (checkMotion(from, to)) return true;
    constexpr int kHalvings = 6;
    ompl::base::State* end = si_->allocState();
    double proved = 0.0;
    double refused = 1.0;
    for (int i = 0; i < kHalvings; ++i) {
      const double share = 0.5 * (proved + refused);
      si_->getStateSpace()->interpolate(from, to, share, end);
      (isProved(from, end) ? proved : refused) = share;
    }
    si_->freeState(end);
    last.second = proved;
    if (last.first != nullptr) si_->getStateSpace()->interpolate(from, to, proved, last.first);
    return false;
  }

 private:
  bool isProved(const ompl::base::State* from, const ompl::base::State* to) const {
    if (!si_->satisfiesBounds(to)) return false;
    const auto proof = query_.certify(poseOf(from), poseOf(to), required_);
    return proof && proof->certified();
  }

  mutable Query query_;
  double required_;
};

/// SE(3) within the bounds of the problem, with both checks, set up. OMPL interpolates as Path does. The clearance is
/// the parameter "required_clearance" of the problem.
inline ompl::base::SpaceInformationPtr spaceInformationOf(const Problem& problem) {
  const auto space = std::make_shared<ompl::base::SE3StateSpace>();
  ompl::base::RealVectorBounds bounds(3);
  const Box box = problem.bounds();
  for (unsigned axis = 0; axis < 3; ++axis) {
    bounds.setLow(axis, box.lower[axis]);
    bounds.setHigh(axis, box.upper[axis]);
  }
  space->setBounds(bounds);
  auto information = std::make_shared<ompl::base::SpaceInformation>(space);
  information->setStateValidityChecker(std::make_shared<WorldValidityChecker>(information, problem.world()));
  information->setMotionValidator(std::make_shared<WorldMotionValidator>(
      information, problem.world(), problem.parameters().at("required_clearance")));
  information->setup();
  return information;
}

/// The configurations of a path of OMPL, for Path::make().
inline std::vector<Pose> configurationsOf(const ompl::geometric::PathGeometric& path) {
  std::vector<Pose> configurations;
  for (std::size_t i = 0; i < path.getStateCount(); ++i) {
    configurations.push_back(poseOf(path.getState(static_cast<unsigned>(i))));
  }
  return configurations;
}

}  // namespace glissade::api
