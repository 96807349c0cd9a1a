#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/base/parameters.h"
#include "engine/files/kept_path.h"
#include "engine/fits/joint.h"
#include "engine/fits/object_fits.h"
#include "engine/import/asset.h"
#include "engine/model/body_id.h"
#include "engine/model/product.h"
#include "engine/places/forbidden_places.h"
#include "engine/places/rigid_body.h"
#include "engine/planning/coarse/strategy_rules.h"
#include "engine/planning/problem.h"
#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/order_rules.h"

namespace glissade {

/// A body of the product in the file.
struct BodyDescription {
  BodyId id;
  std::string name{};
  Mobility mobility = Mobility::Static;
  Geometry geometry{};
  Pose pose{};  ///< X_WB; for URDF the pose of its root
  std::optional<Colour> colour{};
  Attributes attributes{};
};

/// The object: the bodies of the product that a person has chosen to move, as one rigid body.
struct ObjectDescription {
  /// At least one body. The frame of the first body is that of the object's geometry, G; its own pose is not used. The
  /// pose of the others is X_GB.
  std::vector<BodyDescription> bodies{BodyDescription{"object"}};
  /// The reference point is the mean of the imported vertices, as in OMPL.app. Only for an object of one body.
  bool centreOnVertexMean = false;
  /// Otherwise the reference point, in G. It is stored because the triangles of a STEP part are not the same on all
  /// machines.
  Vector3 referencePoint = Vector3::Zero();

  BodyDescription& first() { return bodies.front(); }
  const BodyDescription& first() const { return bodies.front(); }
  bool isGroup() const { return bodies.size() > 1; }
};

/// A person's plan for the simulated operator: free configurations to pass through in order.
using WayPoints = std::vector<Pose>;

/// One scenario file as a value: the planning problem without loaded geometry.
struct Scenario {
  std::string name;
  std::string description;
  std::vector<Asset> assets;
  std::vector<BodyDescription> bodies;  ///< bodies that do not move
  ObjectDescription object;
  std::vector<BodyDescription> leftOut;  ///< bodies of the product that are not used until they are put back
  std::vector<NodeDescription> nodes;    ///< nodes of the tree that the names of the bodies do not determine
  Pose start;
  Goal goal;
  Box3 workspace;
  WayPoints wayPoints;
  std::string planner = "contact-birrt";
  std::map<ParameterId, double> parameters;  ///< only what differs from the defaults
  EnvironmentOptions environment;
  std::vector<AttributeDefinition> attributeDefinitions;  ///< the user's own attributes
  std::vector<PlaceEdit> places;
  std::vector<MilestoneEdit> milestones;
  /// The places that edits forbid, at the time when the file was saved. Planners compute them anew.
  ForbiddenPlaces forbiddenRegions;
  std::optional<StrategyRules> rules;  ///< rules of strategy "own"
  FitSettings fits;
  std::vector<JointEdit> joints;  ///< a person's statements about joints
  SequenceDemands sequence;
  std::uint64_t seed = 1;
  KeptPaths paths;                           ///< results that are kept, by name
  std::shared_ptr<const AssemblyPlan> plan;  ///< the sequence that was planned last, which may be outdated; null: none
};

/// Converts the user's edits of places and bodies to those of the semantic layer, and back.
SemanticEdits semanticEditsOf(const Scenario& scenario);
void setSemanticEdits(const SemanticEdits& edits, Scenario& scenario);

/// A scenario with its geometry loaded and checked: ready to be planned and drawn.
struct LoadedScenario {
  Scenario scenario;
  std::string file;  ///< file from which it was loaded
  /// Obstacles in the order of the scenario, with URDF links and STEP parts expanded.
  std::vector<RigidBody> obstacles;
  RigidBody object;  ///< X_WB is the start; its id is that of the object's first body
  /// The bodies of the object at the start, as bodies of the product. An object of one body is that body.
  std::vector<RigidBody> objectBodies;
  Product product;         ///< the tree of all bodies, including those that are left out
  GeometryCache geometry;  ///< geometries of the bodies and of the object
  /// Shapes in the files that are no bodies. Certificates do not include them.
  MissingShapes missing;
  /// Approximate distance of the meshes of STEP parts from their surfaces, metres, by rigid body's id.
  std::map<BodyId, double> deflections;
  /// Largest error of mesh coordinates against the files, metres, by rigid body's id. Sources are 32-bit numbers and
  /// edges closed at T-junctions.
  std::map<BodyId, double> coordinateSpacings;
  ObjectFits fits;                 ///< empty where the scenario's fits are off
  bool fitsPending = false;        ///< fits are on and not found yet, so that the object is not thinned
  std::map<MeshPtr, bool> closed;  ///< states whether a mesh of the bodies or the object is a closed surface
  std::string problemSha256;       ///< problemSha256(scenario); it follows each edit of the scenario
  Problem problem;                 ///< the problem, in whose world the object is thinned as the fits allow
  ParameterValues parameters{1.0};
  Warnings warnings;
};

/// The plan of a simulated operator: the way-points of the scenario, and its goal if that is a configuration.
std::vector<Pose> routeOf(const LoadedScenario& scenario);

/// Largest distance of the surfaces of the object and of an obstacle from their triangles, added up, metres.
/// Certificates are about the triangles. 0 where the triangles are exact.
double surfaceDeviation(const LoadedScenario& scenario);

/// Largest rounding error of the vertices of the object and of an obstacle in their files, added up, metres: the
/// spacing of 32-bit numbers at their coordinates. 0 where the files hold decimal numbers.
double coordinateSpacing(const LoadedScenario& scenario);

}  // namespace glissade
