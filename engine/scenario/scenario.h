#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/base/parameters.h"
#include "engine/environment/rigid_body.h"
#include "engine/planning/coarse/strategy_rules.h"
#include "engine/planning/problem.h"
#include "engine/product/object_fits.h"
#include "engine/scenario/kept_path.h"
#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/order_rules.h"

namespace glissade {

enum class UpAxis { Y, Z };

/// A file that geometry comes from.
struct Asset {
  std::string id;
  std::string path;  ///< relative to the scenario's folder or absolute, '/' separated; assetFile() finds it
  /// Of the content that was loaded, or when the scenario was saved; empty: unknown. Where a STEP file names others for
  /// its parts, of their contents, too.
  std::string sha256;
  double unit = 1.0;  ///< metres per unit of the file (the chosen interpretation)
  UpAxis up = UpAxis::Z;
  double deflection = 0.0;  ///< metres that triangles may be off a STEP surface; 0: by the size of each part
  bool closeHoles = false;  ///< of a mesh: planar holes are closed
};

struct MeshGeometry {
  std::string asset;
};
/// All links (fixed joints) of a URDF file: bodies "<body id>/<link>", or the one compound object.
struct UrdfGeometry {
  std::string asset;
};
/// A part of a STEP file where its assembly has it, an assembly in it ("pump" has "pump/rotor"), or (empty)
/// all of it: bodies "<body id>/<part>" where it is several, or the one compound object.
struct StepGeometry {
  std::string asset;
  std::string part;
};
struct BoxGeometry {
  Vector3 size;
};
struct CylinderGeometry {
  double radius;
  double length;
};
struct SphereGeometry {
  double radius;
};
using Geometry = std::variant<MeshGeometry, UrdfGeometry, StepGeometry, BoxGeometry, CylinderGeometry, SphereGeometry>;

struct BodyDescription {
  std::string id;
  std::string name;
  Mobility mobility = Mobility::Static;
  Geometry geometry;
  Pose pose;  ///< X_WB; for URDF the pose of its root
  std::optional<Colour> colour;
  Attributes attributes;
};

struct ObjectDescription {
  std::string id = "object";
  std::string name;
  Geometry geometry;
  /// OMPL.app moves the robot so that the mean of its imported vertices is the reference point.
  bool centreOnVertexMean = false;
  /// Where else its reference point is, in the geometry's frame. Written down, because the triangles of a STEP
  /// part are not the same everywhere.
  Vector3 referencePoint = Vector3::Zero();
  std::optional<Colour> colour;
  Attributes attributes;
};

/// A person's plan for the simulated operator: free configurations to pass through in order.
using WayPoints = std::vector<Pose>;

/// One scenario file as a value: what is asked, not yet loaded geometry (DESIGN section 5).
struct Scenario {
  std::string name;
  std::string description;
  std::vector<Asset> assets;
  std::vector<BodyDescription> bodies;
  ObjectDescription object;
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
  std::optional<StrategyRules> rules;  ///< of strategy "own"
  FitSettings fits;
  SequenceDemands sequence;
  std::uint64_t seed = 1;
  KeptPaths paths;                           ///< results that are kept, by name
  std::shared_ptr<const AssemblyPlan> plan;  ///< the sequence that was planned last; null: none. It may hold no more
};

/// What the user has said about places and bodies, as the semantic layer takes it; and back.
SemanticEdits semanticEditsOf(const Scenario& scenario);
void setSemanticEdits(const SemanticEdits& edits, Scenario& scenario);

/// One rigid part of what a geometry names, as read.
struct GeometryPart {
  std::string name;  ///< of the URDF link or STEP part; empty where there is only one part
  MeshPtr mesh;      ///< in the part's frame P
  Pose X_BP;
  std::optional<Colour> colour;
  double deflection = 0.0;           ///< metres that the mesh is off a STEP surface, about; else 0
  std::size_t facesWithoutMesh = 0;  ///< of STEP, that are missing because they could not be tessellated
  bool isClosed = false;             ///< known to be a closed surface; else it is to be found out
  double coordinateSpacing = 0.0;    ///< metres that the mesh may be off the file: want of digits, closed T-junctions
};
struct LoadedGeometry {
  std::vector<GeometryPart> parts;
  Vector3 vertexMean = Vector3::Zero();  ///< of a mesh file's vertices, as imported, in the body's frame
  /// Of the bytes that it was read from, and of the files that a STEP file names; empty for primitives.
  std::string sha256;
  Warnings warnings;  ///< what was lost, left out or added in reading it
};
using LoadedGeometryPtr = std::shared_ptr<const LoadedGeometry>;
/// By what was asked for: a file and how it is interpreted, or a primitive's sizes.
using GeometryCache = std::map<std::string, LoadedGeometryPtr>;

/// A scenario with its geometry loaded and checked: ready to be planned and drawn.
struct LoadedScenario {
  Scenario scenario;
  std::string file;                  ///< where it came from
  std::vector<RigidBody> obstacles;  ///< in the order of the scenario, URDF links and STEP parts expanded
  RigidBody object;                  ///< X_WB is the start
  GeometryCache geometry;            ///< what the bodies and the object are made of
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
