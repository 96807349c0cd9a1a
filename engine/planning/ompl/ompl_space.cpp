#include "engine/planning/ompl/ompl_space.h"

#include <ompl/base/samplers/UniformValidStateSampler.h>

#include <array>
#include <cmath>
#include <numbers>

#include "engine/planning/random_shooter.h"

namespace glissade {
namespace {

namespace ob = ompl::base;

struct SerialState final : ob::SE3StateSpace::StateType {
  std::uint64_t serial = 0;
};

/// `q` moved by a tangent vector: a translation and a rotation vector times the object's radius.
Pose moved(const Pose& q, const std::array<double, 6>& tangent, double radius) {
  const Vector3 rotation = Vector3(tangent[3], tangent[4], tangent[5]) / radius;
  const double angle = std::min(rotation.norm(), std::numbers::pi);
  Pose result = q;
  result.position += Vector3(tangent[0], tangent[1], tangent[2]);
  if (angle > 0.0) {
    const Quaternion turn(Eigen::AngleAxisd(angle, rotation.normalized()));
    result.orientation = (turn * q.orientation).normalized();
  }
  return result;
}

/// Mirrors a position out of bounds at their faces. Clamping would accumulate positions on the faces.
Vector3 mirroredInto(const Box3& bounds, const Vector3& p) {
  const Vector3 inside = bounds.min().cwiseMax(2.0 * bounds.min() - p).cwiseMax(p);
  const Vector3 mirrored = inside.cwiseMin(2.0 * bounds.max() - inside);
  return mirrored.cwiseMax(bounds.min()).cwiseMin(bounds.max());
}

class Sampler final : public ob::StateSampler {
 public:
  Sampler(const ob::StateSpace* space, OmplWorld& world) : StateSampler(space), world_(world) {}

  void sampleUniform(ob::State* state) override { OmplSpace::setPose(state, world_.draw()); }
  void sampleUniformNear(ob::State* state, const ob::State* near, double distance) override {
    OmplSpace::setPose(state, world_.drawNear(OmplSpace::poseOf(near), distance, false));
  }
  void sampleGaussian(ob::State* state, const ob::State* mean, double deviation) override {
    OmplSpace::setPose(state, world_.drawNear(OmplSpace::poseOf(mean), deviation, true));
  }

 private:
  OmplWorld& world_;
};

/// OMPL's own sampler that counts its draws.
class CountingSampler final : public ob::StateSampler {
 public:
  CountingSampler(const ob::StateSpace* space, OmplWorld& world)
      : StateSampler(space), own_(space->allocDefaultStateSampler()), world_(world) {}

  void sampleUniform(ob::State* state) override {
    ++world_.draws;
    own_->sampleUniform(state);
  }
  void sampleUniformNear(ob::State* state, const ob::State* near, double distance) override {
    ++world_.draws;
    own_->sampleUniformNear(state, near, distance);
  }
  void sampleGaussian(ob::State* state, const ob::State* mean, double deviation) override {
    ++world_.draws;
    own_->sampleGaussian(state, mean, deviation);
  }

 private:
  ob::StateSamplerPtr own_;
  OmplWorld& world_;
};

class ValidityChecker final : public ob::StateValidityChecker {
 public:
  ValidityChecker(ob::SpaceInformation* space, OmplWorld& world) : StateValidityChecker(space), world_(world) {}

  bool isValid(const ob::State* state) const override { return world_.isFree(OmplSpace::poseOf(state)); }

 private:
  OmplWorld& world_;
};

/// Checks edges at the papers' step instead of at a fraction of the space's extent.
class GrowthValidator final : public ob::MotionValidator {
 public:
  GrowthValidator(ob::SpaceInformation* space, OmplWorld& world) : MotionValidator(space), world_(world) {}

  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    return count(world_.freeFraction(OmplSpace::poseOf(from), OmplSpace::poseOf(to)) >= 1.0);
  }

  bool checkMotion(const ob::State* from, const ob::State* to, std::pair<ob::State*, double>& last) const override {
    const Pose a = OmplSpace::poseOf(from);
    const Pose b = OmplSpace::poseOf(to);
    const double free = world_.freeFraction(a, b);
    if (free < 1.0) {
      if (last.first != nullptr) OmplSpace::setPose(last.first, interpolate(a, b, free));
      last.second = free;
    }
    return count(free >= 1.0);
  }

 private:
  bool count(bool valid) const {
    ++(valid ? valid_ : invalid_);
    return valid;
  }

  OmplWorld& world_;
};

}  // namespace

std::recursive_mutex& omplSeedMutex() {
  static std::recursive_mutex mutex;
  return mutex;
}

OmplWorld::OmplWorld(const Problem& problem_, std::uint64_t seed)
    : problem(problem_),
      metric(problem_.metric()),
      query(problem_.world->makeQuery()),
      stream(seed, "ompl"),
      shooter(problem_, seed) {}

Pose OmplWorld::draw() {
  ++draws;
  if (problem.source && !problem.region) return drawFromSource();
  Pose q;
  if (problem.region) {
    q.position = problem.region->sample(stream, problem.bounds);
  } else {
    for (int axis = 0; axis < 3; ++axis) {
      q.position[axis] = stream.uniform(problem.bounds.min()[axis], problem.bounds.max()[axis]);
    }
  }
  q.orientation = RandomShooter::orientation(stream);
  return q;
}

Pose OmplWorld::drawFromSource() {
  try {
    return shooter.shoot();
  } catch (...) {
    sourceError = std::current_exception();
    return problem.start;
  }
}

Pose OmplWorld::drawNear(const Pose& near, double distance, bool normal) {
  constexpr int kAttempts = 8;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    ++draws;
    std::array<double, 6> tangent;
    double squared = 0.0;
    for (double& coordinate : tangent) {
      coordinate = stream.normal();
      squared += coordinate * coordinate;
    }
    const double scale = normal ? distance : distance * std::pow(stream.uniform(), 1.0 / 6.0) / std::sqrt(squared);
    for (double& coordinate : tangent) coordinate *= scale;
    Pose q = moved(near, tangent, metric.radius());
    q.position = mirroredInto(problem.bounds, q.position);
    if (!problem.region || problem.region->contains(q.position)) return q;
  }
  const Pose towards = draw();
  const double length = metric.distance(near, towards);
  return length > distance ? interpolate(near, towards, distance / length) : towards;
}

bool OmplWorld::isFree(const Pose& q) {
  if (!problem.bounds.contains(q.position)) return false;
  if (!surfaces) return !query->collides(q);
  ++surfaceQueries;
  return !surfaces->touches(q);
}

QueryCounts OmplWorld::queryCounts() const {
  QueryCounts counts = query->counts();
  counts.collision += surfaceQueries;
  return counts;
}

double OmplWorld::freeFraction(const Pose& from, const Pose& to) {
  if (!problem.bounds.contains(to.position)) return 0.0;
  double t = glissade::freeFraction(*query, from, to, growthStep, stop);
  if (t < 1.0) {
    const double length = metric.distance(from, to);
    t = std::floor(t * length / extensionStep) * extensionStep / length;
  }
  if (!certifyEdges || t <= 0.0) return t;
  const MotionCheck check =
      query->checkMotion(from, interpolate(from, to, t), requiredClearance, SeekViolation::Any, stop);
  return check.status == CertificateStatus::Certified ? t : 0.0;
}

SerialSpace::SerialSpace(const Problem& problem) {
  ob::RealVectorBounds bounds(3);
  for (unsigned axis = 0; axis < 3; ++axis) {
    bounds.setLow(axis, problem.bounds.min()[axis]);
    bounds.setHigh(axis, problem.bounds.max()[axis]);
  }
  setBounds(bounds);
}

Pose SerialSpace::poseOf(const ob::State* state) {
  const auto* q = state->as<StateType>();
  const ob::SO3StateSpace::StateType& rotation = q->rotation();
  return {Vector3(q->getX(), q->getY(), q->getZ()), Quaternion(rotation.w, rotation.x, rotation.y, rotation.z)};
}

void SerialSpace::setPose(ob::State* state, const Pose& q) {
  auto* target = state->as<StateType>();
  target->setXYZ(q.position.x(), q.position.y(), q.position.z());
  target->rotation().x = q.orientation.x();
  target->rotation().y = q.orientation.y();
  target->rotation().z = q.orientation.z();
  target->rotation().w = q.orientation.w();
}

std::uint64_t SerialSpace::serialOf(const ob::State* state) { return static_cast<const SerialState*>(state)->serial; }

ob::State* SerialSpace::allocState() const {
  // OMPL's contract: it frees the state with freeState(), through the virtual destructor.
  auto* state = new SerialState;
  state->serial = allocated_++;
  allocStateComponents(state);
  return state;
}

OmplSpace::OmplSpace(const Problem& problem)
    : SerialSpace(problem), bounds_(problem.bounds), metric_(problem.metric()) {}

double OmplSpace::distance(const ob::State* a, const ob::State* b) const {
  return metric_.distance(poseOf(a), poseOf(b));
}

double OmplSpace::getMaximumExtent() const {
  return std::hypot(bounds_.diagonal().norm(), std::numbers::pi * metric_.radius());
}

void OmplSpace::interpolate(const ob::State* from, const ob::State* to, double t, ob::State* state) const {
  setPose(state, glissade::interpolate(poseOf(from), poseOf(to), t));
}

bool OmplSpace::satisfiesBounds(const ob::State* state) const { return bounds_.contains(poseOf(state).position); }

ob::SpaceInformationPtr makeSpaceInformation(OmplWorld& world, unsigned attempts) {
  const auto space = std::make_shared<OmplSpace>(world.problem);
  space->setStateSamplerAllocator([&world](const ob::StateSpace* owner) -> ob::StateSamplerPtr {
    const std::lock_guard<std::recursive_mutex> lock(omplSeedMutex());
    return std::make_shared<Sampler>(owner, world);
  });
  auto information = std::make_shared<ob::SpaceInformation>(space);
  information->setStateValidityChecker(std::make_shared<ValidityChecker>(information.get(), world));
  information->setMotionValidator(std::make_shared<GrowthValidator>(information.get(), world));
  information->setValidStateSamplerAllocator([attempts](const ob::SpaceInformation* owner) -> ob::ValidStateSamplerPtr {
    const std::lock_guard<std::recursive_mutex> lock(omplSeedMutex());
    auto sampler = std::make_shared<ob::UniformValidStateSampler>(owner);
    sampler->setNrAttempts(attempts);
    return sampler;
  });
  information->setup();
  return information;
}

ob::SpaceInformationPtr makePlainSpaceInformation(OmplWorld& world) {
  const auto space = std::make_shared<SerialSpace>(world.problem);
  space->setStateSamplerAllocator([&world](const ob::StateSpace* owner) -> ob::StateSamplerPtr {
    const std::lock_guard<std::recursive_mutex> lock(omplSeedMutex());
    return std::make_shared<CountingSampler>(owner, world);
  });
  auto information = std::make_shared<ob::SpaceInformation>(space);
  information->setStateValidityChecker(std::make_shared<ValidityChecker>(information.get(), world));
  return information;
}

}  // namespace glissade
