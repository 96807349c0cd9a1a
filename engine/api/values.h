// The private data of the public values: what the engine has, as it is.
#pragma once

#include <glissade/functions.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/guarded.h"
#include "engine/base/work_watch.h"
#include "engine/files/product_file.h"
#include "engine/files/scenario.h"
#include "engine/planning/path.h"
#include "engine/planning/problem.h"
#include "engine/sequence/assembly_plan.h"

namespace glissade::api {

struct Mesh::Impl {
  MeshPtr mesh;
};

struct World::Impl {
  CollisionWorldPtr world;
};

struct Query::Impl {
  CollisionWorldPtr world;
  std::unique_ptr<CollisionQuery> query;
};

struct Problem::Impl {
  glissade::Problem problem;
  ParameterValues parameters;
};

struct Scenario::Impl {
  std::shared_ptr<const LoadedScenario> loaded;
};

struct Product::Impl {
  ProductFile loaded;
  std::string file;
  double deflection = 0.0;  ///< with which the file was read, metres; 0: by the size of each part
};

struct Path::Impl {
  glissade::Path path;
  PathProvenance provenance;
  std::vector<Pose> configurations;
  Certificate certificate;
};

struct AssemblyPlan::Impl {
  glissade::AssemblyPlan plan;
};

/// The value with these private data.
template <class Value>
Value valueOf(typename Value::Impl impl) {
  return Value(std::make_shared<const typename Value::Impl>(std::move(impl)));
}

Pose publicPose(const glissade::Pose& pose);
std::vector<Pose> publicPoses(const std::vector<glissade::Pose>& poses);
Box publicBox(const Box3& box);
Diagnostic publicDiagnostic(const glissade::Diagnostic& diagnostic);
Warnings publicWarnings(const glissade::Warnings& warnings);
Certificate publicCertificate(const MotionCertificate& certificate, const CollisionWorld& world);
Nearest publicNearest(const NearestObstacle& nearest, const CollisionWorld& world);
std::vector<Body> publicBodies(const std::vector<RigidBody>& bodies);
Path publicPath(glissade::Path path, PathProvenance provenance, const CollisionWorld* world);

glissade::Pose enginePose(const Pose& pose);

/// The error of a call with a wrong argument.
Diagnostic wrongArgument(std::string argument, std::string reason);

/// The error where a pose or one of several is not finite or its quaternion is not unit; nothing where all are valid.
std::optional<Diagnostic> faultOfPose(const Pose& pose, const std::string& argument);
std::optional<Diagnostic> faultOfPoses(const std::vector<Pose>& poses, const std::string& argument);

/// The bodies as the engine has them. Errors: see World::make().
Result<std::vector<RigidBody>> engineBodies(const std::vector<Body>& bodies, Mobility mobility,
                                            const std::string& argument);

/// The result of `work`, or the diagnostic of the exception that leaves it. `doing`: see
/// currentExceptionAsDiagnostic().
template <class Value, class Work>
Result<Value> attempt(const char* doing, const Work& work) {
  try {
    return work();
  } catch (...) {
    return publicDiagnostic(currentExceptionAsDiagnostic(Message(doing)));
  }
}

}  // namespace glissade::api
