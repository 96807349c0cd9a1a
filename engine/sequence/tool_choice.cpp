#include "engine/sequence/tool_choice.h"

#include <algorithm>
#include <array>

#include "engine/fits/suggested_joints.h"
#include "engine/sequence/fasteners.h"

namespace glissade {
namespace {

/// Least ratio of head height to shaft radius for a round head to be that of a socket head screw (ISO 4762: 2).
constexpr double kSocketHead = 1.6;

/// Empty if the drive is not known.
std::vector<ToolKind> toolsByDrive(DriveKind drive) {
  switch (drive) {
    case DriveKind::HexOutside: return {ToolKind::Socket, ToolKind::OpenWrench};
    case DriveKind::HexSocket: return {ToolKind::HexKey};
    case DriveKind::Cross:
    case DriveKind::Slot:
    case DriveKind::SixLobe: return {ToolKind::Screwdriver};
    case DriveKind::None: break;
  }
  return {};
}

/// Tools for a fastener of which only the shape is known; empty if it is not clear.
std::vector<ToolKind> toolsByShape(const ProductShapes& shapes, std::size_t body, FastenerKind kind) {
  if (kind == FastenerKind::Nut) return {ToolKind::Socket, ToolKind::OpenWrench};
  if (kind != FastenerKind::Screw) return {};
  const TurnedShape* shape = shapes.turned(body);
  const auto head = shape != nullptr ? headOf(*shapes.body(body).mesh, *shape) : std::nullopt;
  if (!head) return {ToolKind::Screwdriver};
  const std::vector<ToolKind> tools = toolsByDrive(head->drive);
  if (!tools.empty()) return tools;
  if (head->sides == 6 || head->sides == 4) return {ToolKind::Socket, ToolKind::OpenWrench};
  if (head->height >= kSocketHead * head->shaft) return {ToolKind::HexKey};
  return {};  // nothing on a smooth round head shows how it is turned
}

std::vector<ToolUse> usesOf(const std::vector<ToolKind>& tools, std::size_t turned) {
  std::vector<ToolUse> uses;
  for (const ToolKind kind : tools) uses.push_back({kind, turned});
  return uses;
}

/// A nut also comes off if it is held and its bolt is turned.
void addJointTools(const Joints& joints, ToolChoices& choices) {
  const ToolChoices byShape = choices;
  for (const Joint& joint : joints) {
    if (!isScrewed(joint.kind)) continue;
    std::vector<ToolUse>& own = choices[joint.body];
    const std::vector<ToolKind> tools = toolsByDrive(joint.drive);
    if (!tools.empty()) own = usesOf(tools, joint.body);
    if (joint.kind != JointKind::Nut) continue;
    for (const std::size_t bolt : joint.others) own.insert(own.end(), byShape[bolt].begin(), byShape[bolt].end());
  }
}

}  // namespace

Result<ToolChoices> chooseTools(const ProductShapes& shapes, const std::vector<FastenerKind>& kinds,
                                const Joints& joints, const SequenceDemands& demands) {
  ToolChoices choices;
  for (std::size_t body = 0; body < shapes.size(); ++body) {
    choices.push_back(usesOf(toolsByShape(shapes, body, kinds[body]), body));
  }
  addJointTools(joints, choices);
  for (const Joint& joint : joints) {
    if (joint.kind == JointKind::Flexible && isRetainingRing(shapes.product().nameInFile(joint.body)))
      choices[joint.body] = {{ToolKind::CirclipPliers, joint.body}};
  }
  for (const auto& [name, tool] : demands.tools) {
    const auto kind = kToolNames.find(tool);
    if (!kind) {
      return Diagnostic{ErrorKind::Usage,
                        "",
                        "",
                        {GLISSADE_TEXT("'%1' needs the tool '%2', which is unknown"), {name, tool}},
                        {GLISSADE_TEXT("Choose one of: %1."), {kToolNames.listed()}}};
    }
    for (const std::size_t body : bodiesNamed(shapes.product(), name)) {
      choices[body] = *kind == ToolKind::None ? std::vector<ToolUse>() : std::vector<ToolUse>{{*kind, body}};
    }
  }
  return choices;
}

}  // namespace glissade
