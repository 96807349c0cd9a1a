#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/assembly/product.h"
#include "engine/base/parameters.h"
#include "engine/environment/forbidden_places.h"
#include "engine/environment/rigid_body.h"
#include "engine/import/asset.h"
#include "engine/planning/coarse/strategy_rules.h"
#include "engine/planning/problem.h"
#include "engine/product/joint.h"
#include "engine/product/object_fits.h"
#include "engine/scenario/kept_path.h"
#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/order_rules.h"

namespace glissade {

/// A body of the product as the file names it.
struct BodyDescription {
  std::string id;
  std::string name{};
  Mobility mobility = Mobility::Static;
  Geometry geometry{};
  Pose pose{};  ///< X_WB; for URDF the pose of its root
  std::optional<Colour> colour{};
  Attributes attributes{};
};

/// What moves: the bodies of the product that a person has chosen, as one rigid body.
struct ObjectDescription {
  /// At least one. The first one's frame is that of the object's geometry, G: its own pose is not used. The pose of
  /// the others is X_GB.
  std::vector<BodyDescription> bodies{BodyDescription{"object"}};
  /// OMPL.app moves the robot so that the mean of its imported vertices is the reference point. Of one body only.
  bool centreOnVertexMean = false;
  /// Where else the reference point is, in G. Written down, because the triangles of a STEP part are not the same
  /// everywhere.
  Vector3 referencePoint = Vector3::Zero();

  BodyDescription& first() { return bodies.front(); }
  const BodyDescription& first() const { return bodies.front(); }
  bool isGroup() const { return bodies.size() > 1; }
};

/// A person's plan for the simulated operator: free configurations to pass through in order.
using WayPoints = std::vector<Pose>;

/// One scenario file as a value: what is asked, not yet loaded geometry.
struct Scenario {
  std::string name;
  std::string description;
  std::vector<Asset> assets;
  std::vector<BodyDescription> bodies;  ///< those that do not move
  ObjectDescription object;
  std::vector<BodyDescription>
      leftOut;                         ///< of the product, and not there: nothing is about them until they are put back
  std::vector<NodeDescription> nodes;  ///< of its tree, where the names of the bodies do not say it all
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
  /// Of the places that edits forbid, when the file was saved. Planners find them anew.
  ForbiddenPlaces forbiddenRegions;
  std::optional<StrategyRules> rules;  ///< of strategy "own"
  FitSettings fits;
  std::vector<JointEdit> joints;  ///< what a person says of joints
  SequenceDemands sequence;
  std::uint64_t seed = 1;
  KeptPaths paths;                           ///< results that are kept, by name
  std::shared_ptr<const AssemblyPlan> plan;  ///< the sequence that was planned last; null: none. It may hold no more
};

/// What the user has said about places and bodies, as the semantic layer takes it; and back.
SemanticEdits semanticEditsOf(const Scenario& scenario);
void setSemanticEdits(const SemanticEdits& edits, Scenario& scenario);

/// A scenario with its geometry loaded and checked: ready to be planned and drawn.
struct LoadedScenario {
  Scenario scenario;
  std::string file;                  ///< where it came from
  std::vector<RigidBody> obstacles;  ///< in the order of the scenario, URDF links and STEP parts expanded
  RigidBody object;                  ///< X_WB is the start; its id is that of the object's first body
  /// The bodies that the object is made of, as bodies of the product, where they start. One is the object itself.
  std::vector<RigidBody> objectBodies;
  Product product;         ///< the tree of all bodies, those that are left out among them
  GeometryCache geometry;  ///< what the bodies and the object are made of
  /// Shapes that files state and that are no bodies: certificates are about the scenario without them.
  MissingShapes missing;
  /// Metres that meshes are off the surfaces they stand for, about: of STEP parts, by rigid body's id.
  std::map<std::string, double> deflections;
  /// Metres that meshes may be off their files, by rigid body's id: 32-bit numbers, edges closed at T-junctions.
  std::map<std::string, double> coordinateSpacings;
  ObjectFits fits;                 ///< empty where the scenario's fits are off
  bool fitsPending = false;        ///< they are on and still to be found: the object is not thinned yet
  std::map<MeshPtr, bool> closed;  ///< whether a mesh of the bodies or the object is a closed surface
  Problem problem;                 ///< its world has the object thinned as the fits allow
  ParameterValues parameters{1.0};
  Warnings warnings;
};

/// How far the surfaces of the object and of an obstacle may be, together, from where their triangles are:
/// certificates are about the triangles. 0 where those are what there is.
double surfaceDeviation(const LoadedScenario& scenario);

/// How far vertices of the object and of an obstacle may be, together, from where the programs that wrote their
/// files had them: the spacing of 32-bit numbers at their coordinates. 0 where the files hold decimal numbers.
double coordinateSpacing(const LoadedScenario& scenario);

}  // namespace glissade
