#pragma once

#include <string>

#include "engine/files/scenario.h"
#include "tests/engine/files/some_plan.h"
#include "tests/engine/support/directories.h"

namespace glissade::test {

inline std::string sample(const std::string& name) {
  return test::sourceDirectory() + "/samples/" + name + "/scenario.json";
}

/// A scenario of boxes that needs no file: the object passes beside a wall.
inline Scenario boxScenario() {
  Scenario scenario;
  scenario.name = "Boxes";
  BodyDescription wall;
  wall.id = "wall";
  wall.name = "The wall";
  wall.geometry = BoxGeometry{{1, 4, 1}};
  scenario.bodies = {wall};
  scenario.object.first().name = "Brick";
  scenario.object.first().geometry = BoxGeometry{{0.5, 0.5, 0.5}};
  scenario.start = Pose::translation({-3, 0, 0});
  scenario.goal = Pose::translation({3, 0, 0});
  scenario.workspace = Box3(Vector3(-5, -5, -5), Vector3(5, 5, 5));
  return scenario;
}

/// The user's attributes, one of each type and both owners.
inline std::vector<AttributeDefinition> ownAttributes() {
  const auto define = [](const char* name, AttributeType type, AttributeOwner owner, AttributeValue initial) {
    AttributeDefinition definition;
    definition.name = name;
    definition.label = Message(name);
    definition.type = type;
    definition.owner = owner;
    definition.initial = std::move(initial);
    return definition;
  };
  AttributeDefinition weight = define("weight", AttributeType::Number, AttributeOwner::Body, 1.0 / 3.0);
  weight.unit = "kg";
  weight.minimum = 1e-3;
  weight.maximum = 1e3;
  weight.description = Message("Masse – \"lourd\"");
  AttributeDefinition quality = define("quality", AttributeType::Choice, AttributeOwner::Place, std::string("good"));
  quality.choices = {"bad", "good"};
  return {weight, quality, define("fragile", AttributeType::Bool, AttributeOwner::Body, false),
          define("visits", AttributeType::Integer, AttributeOwner::Place, 2.0),
          define("remark", AttributeType::Text, AttributeOwner::Place, std::string("none"))};
}

/// A scenario with every key of the format, and numbers that need many digits.
inline Scenario fullScenario() {
  Scenario scenario = boxScenario();
  scenario.description = "Wände – \"quoted\"\n";
  scenario.assets = {{"part", "meshes/part.stl", std::string(64, 'a'), 0.001, UpAxis::Y},
                     {"robot", "robot.urdf", "", 1.0, UpAxis::Z},
                     {"product", "product.step", "", 1.0, UpAxis::Z, 1.0 / 3e4}};
  BodyDescription mesh;
  mesh.id = "mesh";
  mesh.name = "The mesh";
  mesh.mobility = Mobility::Mobile;
  mesh.geometry = MeshGeometry{"part"};
  mesh.pose = {{0.1, 1.0 / 3.0, -1e-17}, fromRollPitchYaw(0.1, 0.2, 0.3)};
  mesh.colour = Colour{0.25, 0.5, 1.0};
  mesh.attributes = {{"weight", 0.1}, {"fragile", true}, {"shape", std::string("star")}};
  BodyDescription urdf;
  urdf.id = "robot";
  urdf.name = "The robot";
  urdf.geometry = UrdfGeometry{"robot"};
  BodyDescription step;
  step.id = "pump.rotor";
  step.name = "pump/rotor";
  step.geometry = StepGeometry{"product", "pump/rotor"};
  BodyDescription product;
  product.id = "product";
  product.name = "The rest";
  product.geometry = StepGeometry{"product", ""};
  BodyDescription pin;
  pin.id = "pin";
  pin.name = "The pin";
  pin.geometry = CylinderGeometry{0.25, 2.0};
  scenario.bodies.insert(scenario.bodies.end(), {mesh, urdf, step, product, pin});
  scenario.object.first().geometry = SphereGeometry{0.125};
  scenario.object.referencePoint = {0.0, 1.0 / 3.0, -0.1};
  scenario.object.first().mobility = Mobility::Mobile;
  BodyDescription cap = pin;
  cap.id = "cap";
  cap.pose = mesh.pose;
  cap.attributes = {{"weight", 0.5}};
  scenario.object.bodies.push_back(cap);
  BodyDescription variant = mesh;
  variant.id = "variant";
  scenario.leftOut = {variant};
  scenario.nodes = {{"pump", "Pump / 1", std::nullopt, {{"weight", 0.25}}}, {"unit", "", ""}, {"pin", "M3/6", "unit"}};
  scenario.goal = GoalOut{};
  scenario.wayPoints = {scenario.start, Pose::translation({0, 4, 0})};
  scenario.planner = "own";
  scenario.parameters = {{ParameterId::Alpha, 0.7}, {ParameterId::ContactSamples, 5}};
  scenario.environment = {0.1, 1.0 / 3.0, 5, "watershed"};
  scenario.attributeDefinitions = ownAttributes();
  scenario.object.first().attributes = {{"weight", 2.5}};
  scenario.places = {{{1.0 / 3.0, 0, -0.1}, "Hall", {{"quality", std::string("bad")}, {"compatibility", 0.25}}},
                     {{2, 0, 0}, "", {{"forbidden", true}}},
                     {{3, 0, 0}, "Named only", {}}};
  scenario.milestones = {{{0.7, 0, 0}, mesh.pose}};
  scenario.rules = StrategyRules{"if(a.quality == \"bad\", size, 0)",
                                 "distance * (1 + object.weight)",
                                 {{"place.cluttered", true, "rrt"}, {"1", false, "linear"}},
                                 true,
                                 true};
  scenario.sequence.together = {{"wall", "part"}, {"a", "b", "c"}};
  scenario.sequence.before = {{"wall", "object"}};
  scenario.sequence.gravity = {1.0 / 3.0, 0.0, -1.0};
  scenario.sequence.densities = {{"wall", 2700.0}};
  scenario.sequence.stay = {"wall"};
  scenario.sequence.masses = {{"part", 1.0 / 3.0}};
  scenario.sequence.fragile = {"part"};
  scenario.sequence.tools = {{"part", "socket"}};
  scenario.sequence.fasteners = {{"part", "nut"}};
  scenario.sequence.cost = "length + body.price";
  scenario.sequence.attributes["part"] = {{"price", 2.0}};
  scenario.sequence.classes = {{"glass", "flexible_part", "Glass", "none", {{"fragile", true}}}};
  scenario.fits = {
      true, 0.0015, {{"object", "wall", ContactKind::Thread, 1.0 / 3e4, true}, {"product/pin", "wall", {}, {}, false}}};
  Joint made;
  made.kind = JointKind::Screw;
  made.state = JointState::Confirmed;
  made.point = {1.0 / 3.0, 0.0, 0.0};
  made.direction = {0.0, 0.0, -1.0};
  made.thread = JointThread{0.003, -0.0005, true, 0.004, 0.005};
  made.drive = DriveKind::HexSocket;
  made.driveSize = 0.0025;
  made.designation = "ISO 4762 M3x8";
  scenario.joints = {{{JointKind::Screw, "product/pin", {"wall"}}, JointEdit::Word::Confirmed, made, {"part"}},
                     {{JointKind::Unit, "object", {"part"}}, JointEdit::Word::Opened},
                     {{JointKind::Insert, "part", {"wall"}}, JointEdit::Word::PressedOut}};
  scenario.seed = 9223372036854775807U;
  KeptPath kept;
  kept.name = "Weg \"1\"";
  kept.pinned = kept.smoothed = true;
  kept.object = scenario.object.first().id.text();
  kept.provenance = {"gts", 12};
  kept.requiredClearance = 1.0 / 3e6;
  kept.clearance = 0.25;
  kept.provedClearance = 0.125;
  kept.allowances = {{"wall", ContactKind::Contact, 0.0, 1e-5}};
  kept.problemSha256 = std::string(64, 'b');
  kept.points = {{scenario.start}, {Pose::translation({1.0 / 3.0, 0, 0}), Author::Contact, Author::Operator}};
  scenario.paths = {std::make_shared<const KeptPath>(kept)};
  scenario.plan = std::make_shared<const AssemblyPlan>(somePlan());
  return scenario;
}

}  // namespace glissade::test
