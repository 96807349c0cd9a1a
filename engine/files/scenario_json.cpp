#include <algorithm>
#include <array>
#include <set>

#include "engine/base/overloaded.h"
#include "engine/files/fits_json.h"
#include "engine/files/joints_json.h"
#include "engine/files/kept_path_json.h"
#include "engine/files/parameters_json.h"
#include "engine/files/plan_file.h"
#include "engine/files/plan_json.h"
#include "engine/files/scenario_file.h"
#include "engine/files/semantics_json.h"
#include "engine/files/sequence_json.h"
#include "engine/geometry/pose_json.h"
#include "engine/import/json_checksum.h"
#include "engine/model/body_id_json.h"

namespace glissade {
namespace {

using Json = JsonCursor::Json;

constexpr const char* kScenarioFormat = "glissade-scenario";
constexpr int kScenarioVersion = 1;

/// Migrates a document to the next version; entry i migrates version i + 1. The list is empty, because version 1 is the
/// first.
using Migration = void (*)(Json&);
constexpr std::array<Migration, kScenarioVersion - 1> kMigrations{};

/// Ids leave "<body>/<link>" to the links of URDF files.
constexpr FunctionFormat kId{[](const JsonCursor& at) {
                               std::string id = at.nonEmptyText();
                               if (id.find('/') != std::string::npos)
                                 at.fail(GLISSADE_TEXT("holds a '/'"), GLISSADE_TEXT("Leave it out."));
                               return id;
                             },
                             kAsItIs, R"({"type": "string", "pattern": "^[^/]+$"})"};

constexpr FunctionFormat kIdOfBody{[](const JsonCursor& at) { return BodyId(kId.read(at)); }, kAsItIs, kId.text};

constexpr GetterFormat<std::string> kPath{&JsonCursor::exactText, R"({"type": "string", "pattern": "^[^\\\\]+$"})"};
constexpr GetterFormat<std::string> kSha256{&JsonCursor::text, R"({"type": "string", "pattern": "^[0-9a-f]{64}$"})"};

constexpr FunctionFormat kColour{[](const JsonCursor& at) -> Colour {
                                   const Vector3 v = readVector(at);
                                   if (v.minCoeff() < 0.0 || v.maxCoeff() > 1.0)
                                     at.fail(GLISSADE_TEXT("is not a colour: three numbers from 0 to 1"));
                                   return {v.x(), v.y(), v.z()};
                                 },
                                 kAsItIs,
                                 R"({"description": "sRGB.", "type": "array", "minItems": 3, "maxItems": 3,
        "items": {"type": "number", "minimum": 0, "maximum": 1}})"};

constexpr FunctionFormat kBoxSize{
    [](const JsonCursor& at) {
      const Vector3 size = readVector(at);
      if (!limits::isSize(size.minCoeff()))
        at.fail(GLISSADE_TEXT("has a size that is not above zero, or below 1e-12 m"));
      return size;
    },
    [](const Vector3& size) { return kVector.write(size); },
    R"({"type": "array", "minItems": 3, "maxItems": 3, "items": {"type": "number", "exclusiveMinimum": 0}})"};

/// Exactly one of {"mesh": ...}, {"urdf": asset}, {"step": ...}, {"box": size}, {"cylinder": ...}, {"sphere": ...}.
struct GeometryFormat {
  Geometry read(const JsonCursor& at) const;
  Json write(const Geometry& geometry) const;
  Json schema(SchemaDefinitions& definitions) const;
};

struct GoalFormat {
  Goal read(const JsonCursor& at) const {
    if (!at.isString()) return readPose(at);
    if (at.text() != "out") at.fail(GLISSADE_TEXT("is neither a configuration nor \"out\""));
    return GoalOut{};
  }
  Json write(const Goal& goal) const {
    const Pose* pose = std::get_if<Pose>(&goal);
    return pose != nullptr ? kObject<Pose>.write(*pose) : Json("out");
  }
  Json schema(SchemaDefinitions& definitions) const {
    return {{"oneOf", {kObject<Pose>.schema(definitions), Json{{"const", "out"}}}}};
  }
};

struct WorkspaceFormat {
  Box3 read(const JsonCursor& at) const {
    at.allowOnly({"min", "max"});
    const Box3 box(readVector(at.at("min")), readVector(at.at("max")));
    if (box.isEmpty()) at.fail(GLISSADE_TEXT("has a minimum above its maximum"));
    return box;
  }
  Json write(const Box3& box) const { return {{"min", kVector.write(box.min())}, {"max", kVector.write(box.max())}}; }
  Json schema(SchemaDefinitions& definitions) const {
    return {{"type", "object"},
            {"additionalProperties", false},
            {"required", {"min", "max"}},
            {"properties", {{"min", kVector.schema(definitions)}, {"max", kVector.schema(definitions)}}}};
  }
};

/// A member of the first body of the object.
template <class Value>
constexpr auto ofFirst(Value BodyDescription::*member) {
  return Accessor{[member](const ObjectDescription& object) -> const Value& { return object.first().*member; },
                  [member](ObjectDescription& object, Value value) { object.first().*member = std::move(value); }};
}

constexpr Accessor kOtherBodies{[](const ObjectDescription& object) {
                                  return std::vector<BodyDescription>(object.bodies.begin() + 1, object.bodies.end());
                                },
                                [](ObjectDescription& object, std::vector<BodyDescription> others) {
                                  for (BodyDescription& each : others) object.bodies.push_back(std::move(each));
                                }};

constexpr Accessor kPlan{[](const Scenario& scenario) { return planDocument(*scenario.plan, scenario.name); },
                         [](Scenario& scenario, PlanDocument read) {
                           scenario.plan = std::make_shared<const AssemblyPlan>(std::move(read.plan));
                         }};

void checkObject(const ObjectDescription& object, const JsonCursor& at) {
  const auto said = at.find("centre_on_vertex_mean");
  if (!object.centreOnVertexMean || !said) return;
  if (!std::holds_alternative<MeshGeometry>(object.first().geometry))
    said->fail(GLISSADE_TEXT("is for mesh files only"));
  if (const auto point = at.find("reference_point"))
    point->fail(GLISSADE_TEXT("is said twice: there is 'centre_on_vertex_mean'"));
  if (object.isGroup()) at.at("with").fail(GLISSADE_TEXT("is not beside 'centre_on_vertex_mean'"));
}

bool hasFits(const Scenario& scenario) {
  const FitSettings& fits = scenario.fits;
  return fits.on || fits.acceptedClash > 0.0 || !fits.pairs.empty() || !fits.cut.empty();
}

/// Checks that the ids of assets and of bodies are unique, and that geometries name assets of the scenario.
class IdCheck {
 public:
  void asset(const Asset& asset, const JsonCursor& at) { add(assets_, asset.id, at); }
  void body(const BodyDescription& body, const JsonCursor& at) {
    add(bodies_, body.id.text(), at);
    const JsonCursor shape = at.at("geometry");
    std::visit(Overloaded{[&](const MeshGeometry& mesh) { expectAsset(mesh.asset, shape.at("mesh")); },
                          [&](const UrdfGeometry& urdf) { expectAsset(urdf.asset, shape.at("urdf")); },
                          [&](const StepGeometry& step) { expectAsset(step.asset, shape.at("step")); },
                          [](const auto& /*primitive*/) {}},
               body.geometry);
  }

 private:
  static void add(std::set<std::string>& seen, const std::string& id, const JsonCursor& at) {
    if (seen.insert(id).second) return;
    at.at("id").fail({GLISSADE_TEXT("has the id '%1' a second time"), {id}},
                     GLISSADE_TEXT("Give every one an id of its own."));
  }
  void expectAsset(const std::string& id, const JsonCursor& at) const {
    if (assets_.count(id) != 0) return;
    const JsonCursor name = at.isString() ? at : at.at("asset");
    name.fail({GLISSADE_TEXT("names the asset '%1', which is not in /assets"), {id}}, GLISSADE_TEXT("Add the asset."));
  }

  std::set<std::string> assets_;
  std::set<std::string> bodies_;
};

void checkScenarioIds(const Scenario& scenario, const JsonCursor& root) {
  IdCheck check;
  for (std::size_t i = 0; i < scenario.assets.size(); ++i) {
    check.asset(scenario.assets[i], root.at("assets").element(i));
  }
  const auto checkBodies = [&](const std::vector<BodyDescription>& bodies, const char* key) {
    for (std::size_t i = 0; i < bodies.size(); ++i) check.body(bodies[i], root.at(key).element(i));
  };
  checkBodies(scenario.bodies, "bodies");
  const JsonCursor object = root.at("object");
  check.body(scenario.object.first(), object);
  for (std::size_t i = 1; i < scenario.object.bodies.size(); ++i) {
    check.body(scenario.object.bodies[i], object.at("with").element(i - 1));
  }
  checkBodies(scenario.leftOut, "left_out");
}

}  // namespace

template <class Archive>
void describe(Archive& asset, Type<Asset> /*type*/) {
  asset.type("asset");
  asset.required("id", &Asset::id, kId);
  asset.required("path", &Asset::path, kPath, "Relative to the scenario's folder, or absolute; separated by '/'.");
  asset.optional("sha256", &Asset::sha256, kSha256,
                 "SHA-256 of the file's bytes. Where a STEP file names others for its parts: of a text of the SHA-256 "
                 "of its bytes, and for each of those files, in the order in which they are named, a line feed, the "
                 "SHA-256 of its bytes (nothing where it is missing), a blank and its name below the folder.");
  asset.optional("unit", &Asset::unit, kLength, "Metres for one unit of the file.", Always());
  asset.optional("up_axis", &Asset::up, named(kUpAxisNames), "The axis of the file that points up in the world.",
                 Always());
  asset.optional("deflection", &Asset::deflection, kLength,
                 "Metres that the triangles of a STEP file's parts may be off their surfaces; absent: a thousandth of "
                 "each part's diagonal, from 0.00001 to 0.0005.");
  asset.optional("close_holes", &Asset::closeHoles, kBoolean,
                 "Planar holes of a mesh are closed, and a warning counts them. Absent: false.");
}

template <class Archive>
void describe(Archive& mesh, Type<MeshGeometry> /*type*/) {
  mesh.type("mesh_groups", "The groups of an OBJ file, each as a body, or one of them.");
  mesh.required("asset", &MeshGeometry::asset, kText);
  mesh.optional("part", &MeshGeometry::part, kNonEmptyText, "The group of this name; absent: all groups.");
  mesh.check([](MeshGeometry& read, const JsonCursor& /*at*/) { read.groups = true; });
}

template <class Archive>
void describe(Archive& step, Type<StepGeometry> /*type*/) {
  step.type("step_geometry");
  step.required("asset", &StepGeometry::asset, kText);
  step.optional("part", &StepGeometry::part, kNonEmptyText,
                "A part of the file where its assembly has it, or an assembly in it, as pump/rotor; absent: all of the "
                "file.");
  step.optional("as_one", &StepGeometry::asOne, kBoolean,
                "Each product of several solids is one body. Absent: each of its solids is a body.");
}

template <class Archive>
void describe(Archive& cylinder, Type<CylinderGeometry> /*type*/) {
  cylinder.type("cylinder");
  cylinder.required("radius", &CylinderGeometry::radius, kLength);
  cylinder.required("length", &CylinderGeometry::length, kLength);
}

template <class Archive>
void describe(Archive& sphere, Type<SphereGeometry> /*type*/) {
  sphere.type("sphere");
  sphere.required("radius", &SphereGeometry::radius, kLength);
}

namespace {

Geometry GeometryFormat::read(const JsonCursor& at) const {
  at.allowOnly({"mesh", "urdf", "step", "box", "cylinder", "sphere"});
  if (at.json().size() != 1) at.fail(GLISSADE_TEXT("does not name exactly one shape"));
  if (const auto mesh = at.find("mesh")) {
    if (mesh->isString()) return MeshGeometry{mesh->text()};
    return kObject<MeshGeometry>.read(*mesh);
  }
  if (const auto urdf = at.find("urdf")) return UrdfGeometry{urdf->text()};
  if (const auto step = at.find("step")) return kObject<StepGeometry>.read(*step);
  if (const auto box = at.find("box")) return BoxGeometry{kBoxSize.read(*box)};
  if (const auto cylinder = at.find("cylinder")) return kObject<CylinderGeometry>.read(*cylinder);
  return kObject<SphereGeometry>.read(at.at("sphere"));
}

Json GeometryFormat::write(const Geometry& geometry) const {
  return std::visit(Overloaded{[](const MeshGeometry& mesh) -> Json {
                                 return {{"mesh", mesh.groups ? kObject<MeshGeometry>.write(mesh) : Json(mesh.asset)}};
                               },
                               [](const UrdfGeometry& urdf) -> Json {
                                 return {{"urdf", urdf.asset}};
                               },
                               [](const StepGeometry& step) -> Json {
                                 return {{"step", kObject<StepGeometry>.write(step)}};
                               },
                               [](const BoxGeometry& box) -> Json {
                                 return {{"box", kBoxSize.write(box.size)}};
                               },
                               [](const CylinderGeometry& cylinder) -> Json {
                                 return {{"cylinder", kObject<CylinderGeometry>.write(cylinder)}};
                               },
                               [](const SphereGeometry& sphere) -> Json {
                                 return {{"sphere", kObject<SphereGeometry>.write(sphere)}};
                               }},
                    geometry);
}

Json GeometryFormat::schema(SchemaDefinitions& definitions) const {
  const Json text = kText.schema(definitions);
  return definitions.reference(
      "geometry",
      {{"description", "Exactly one of these; metres. mesh, urdf and step name an asset; box has three edges."},
       {"type", "object"},
       {"additionalProperties", false},
       {"minProperties", 1},
       {"maxProperties", 1},
       {"properties",
        {{"mesh", {{"anyOf", {text, kObject<MeshGeometry>.schema(definitions)}}}},
         {"urdf", text},
         {"step", kObject<StepGeometry>.schema(definitions)},
         {"box", kBoxSize.schema(definitions)},
         {"cylinder", kObject<CylinderGeometry>.schema(definitions)},
         {"sphere", kObject<SphereGeometry>.schema(definitions)}}}});
}

}  // namespace

template <class Archive>
void describe(Archive& body, Type<BodyDescription> /*type*/) {
  body.type("body");
  body.required("id", &BodyDescription::id, kIdOfBody);
  body.check([](BodyDescription& read, const JsonCursor& /*at*/) { read.name = read.id.text(); });
  body.optional("name", &BodyDescription::name, kText, "", Always());
  body.optional("mobility", &BodyDescription::mobility, named(kMobilityNames), "", Always());
  body.required("geometry", &BodyDescription::geometry, GeometryFormat());
  body.optional("pose", &BodyDescription::pose, kObject<Pose>, "", Always());
  body.optional("colour", &BodyDescription::colour, kColour);
  body.optional("attributes", &BodyDescription::attributes, AttributesFormat());
}

template <class Archive>
void describe(Archive& object, Type<ObjectDescription> /*type*/) {
  object.type("object");
  object.required("id", ofFirst(&BodyDescription::id), kIdOfBody);
  object.check([](ObjectDescription& read, const JsonCursor& /*at*/) { read.first().name = read.first().id.text(); });
  object.optional("name", ofFirst(&BodyDescription::name), kText, "", Always());
  object.optional("mobility", ofFirst(&BodyDescription::mobility), named(kMobilityNames),
                  "Mobility of the body where it does not move as the object.");
  object.required("geometry", ofFirst(&BodyDescription::geometry), GeometryFormat());
  object.optional("with", kOtherBodies, kObjects<BodyDescription>,
                  "Other bodies that move with it as one rigid body. Their poses are in the frame of the object's "
                  "geometry.");
  object.optional("centre_on_vertex_mean", &ObjectDescription::centreOnVertexMean, kBoolean);
  object.optional("reference_point", &ObjectDescription::referencePoint, kVector,
                  "The object's reference point in the frame of its geometry; not beside centre_on_vertex_mean.");
  object.optional("colour", ofFirst(&BodyDescription::colour), kColour);
  object.optional("attributes", ofFirst(&BodyDescription::attributes), AttributesFormat());
  object.check(checkObject);
}

template <class Archive>
void describe(Archive& node, Type<NodeDescription> /*type*/) {
  node.type("node");
  node.required("id", &NodeDescription::id, kNonEmptyText, "Id of an assembly or a body.");
  node.optional("name", &NodeDescription::name, kText,
                "Name of the product in the CAD file. Absent: the last step of its path.");
  node.optional("occurrence", &NodeDescription::occurrence, kText, "Name of its use in the assembly, in the CAD file.");
  node.optional("designator", &NodeDescription::designator, kText, "Reference designator of its use, in the CAD file.");
  node.optional("in", &NodeDescription::in, kText,
                "Id of the assembly that contains it; empty: none. Absent: the one of its path.");
  node.optional("attributes", &NodeDescription::attributes, AttributesFormat(),
                "Attributes of an assembly, for all bodies below it that do not state others.");
}

template <class Archive>
void describe(Archive& scenario, Type<Scenario> /*type*/) {
  scenario.type("scenario",
                "One planning question: parts, the object that moves, start, goal and workspace. SI units: metres, "
                "radians; poses in the world frame, Z-up.");
  scenario.constant("format", kScenarioFormat);
  scenario.constant("version", kScenarioVersion);
  scenario.optional("name", &Scenario::name, kText, "", Always());
  scenario.optional("description", &Scenario::description, kText, "", Always());
  scenario.optional("assets", &Scenario::assets, kObjects<Asset>, "", Always());
  scenario.required("bodies", &Scenario::bodies, kObjects<BodyDescription>);
  scenario.required("object", &Scenario::object, kObject<ObjectDescription>);
  scenario.optional("left_out", &Scenario::leftOut, kObjects<BodyDescription>,
                    "Bodies of the product that are not there, such as variants that are not built. They are not used "
                    "until they are among the bodies again.");
  scenario.optional("product", &Scenario::nodes, kObjects<NodeDescription>,
                    "Statements about nodes of the product's tree that the names of the bodies do not determine. The "
                    "name of a body is its path, as pump/rotor: 'pump' is an assembly, and \"pump\" its id.");
  scenario.required("start", &Scenario::start, kObject<Pose>);
  scenario.required("goal", &Scenario::goal, GoalFormat(),
                    "A configuration, or \"out\": any that is clear of the bounding box of the bodies.");
  scenario.required("workspace", &Scenario::workspace, WorkspaceFormat(),
                    "The box of the object's reference point; min below max on every axis.");
  scenario.optional("way_points", &Scenario::wayPoints, kObjects<Pose>,
                    "A person's plan for the simulated operator: free configurations to pass in order.", Always());
  scenario.optional("planner", &Scenario::planner, kNonEmptyText, "", Always());
  scenario.optional("parameters", &Scenario::parameters, ParametersFormat(),
                    "Values that differ from the defaults. Lengths in metres.", Always());
  scenario.optional("environment", &Scenario::environment, kObject<EnvironmentOptions>);
  scenario.optional("attributes", &Scenario::attributeDefinitions, kObjects<AttributeDefinition>,
                    "The user's own attributes, beside those that are built in.");
  scenario.optional("places", &Scenario::places, kObjects<PlaceEdit>,
                    "Edits of places, each bound to a point inside its place.");
  scenario.optional("milestones", &Scenario::milestones, kObjects<MilestoneEdit>,
                    "Configurations to pass through, each bound to a point inside the overlap of a border.");
  scenario.optional("forbidden_regions", &Scenario::forbiddenRegions, kObjects<ForbiddenPlace>,
                    "The forbidden places when the file was saved, in the world frame, metres. The boxes are closed, "
                    "and the object's reference point keeps a hundred-thousandth of its radius from them. Programs "
                    "without an environment model read these.");
  scenario.optional("rules", &Scenario::rules, kObject<StrategyRules>);
  scenario.optional("fits", &Scenario::fits, kObject<FitSettings>, "", hasFits);
  scenario.optional("joints", &Scenario::joints, JointEditsFormat());
  scenario.optional("sequence", &Scenario::sequence, kObject<SequenceDemands>);
  scenario.optional("seed", &Scenario::seed, kCount, "", Always());
  scenario.optional("paths", &Scenario::paths, KeptPathsFormat(),
                    "Paths that are kept. They are proved again when the scenario is opened.");
  scenario.optional("plan", kPlan, PlanDocumentFormat(),
                    "The assembly plan that was found last, without checksum. Its steps are judged again when the "
                    "scenario is opened.",
                    [](const Scenario& written) { return written.plan != nullptr; });
  scenario.check(checkScenarioIds);
  scenario.check([](const Scenario& read, const JsonCursor& at) { checkSemantics(read, at); });
}

namespace {

std::uint64_t readVersion(const JsonCursor& root) {
  if (root.at("format").text() != kScenarioFormat)
    root.at("format").fail({GLISSADE_TEXT("is not \"%1\""), {kScenarioFormat}});
  const JsonCursor at = root.at("version");
  const std::uint64_t version = at.wholeNumber();
  if (version < 1 || version > kScenarioVersion) {
    at.fail({GLISSADE_TEXT("is version %1; this program reads up to version %2"), {version, kScenarioVersion}},
            GLISSADE_TEXT("Use a newer Glissade."));
  }
  return version;
}

}  // namespace

Result<Scenario> parseScenario(const std::string& text, const std::string& file) {
  Warnings ignored;
  return parseScenario(text, file, ignored);
}

Result<Scenario> parseScenario(const std::string& text, const std::string& file, Warnings& warnings) {
  auto document = parseJson(text, file);
  if (!document) return document.error();
  if (takeChecksum(*document) == ChecksumState::Wrong) {
    warnings.push_back(
        wrongChecksum(file, GLISSADE_TEXT("Check the scenario, then save it again or remove the checksum.")));
  }
  try {
    const std::uint64_t version = readVersion(JsonCursor(*document, file, ""));
    for (std::size_t v = version - 1; v < kMigrations.size(); ++v) kMigrations[v](*document);
    return readDescribed<Scenario>(JsonCursor(*document, file, ""));
  } catch (const JsonError& error) {
    return error.diagnostic;
  }
}

Json scenarioSchema() {
  Json schema = describedSchema<Scenario>("Glissade scenario, version 1");
  addChecksumProperty(schema);
  return schema;
}

std::string scenarioText(const Scenario& scenario) { return jsonText(writeDescribed(scenario), 2) + "\n"; }

std::string writeScenario(const Scenario& scenario) {
  Json json = writeDescribed(scenario);
  addChecksum(json);
  return jsonText(json, 2) + "\n";
}

}  // namespace glissade
