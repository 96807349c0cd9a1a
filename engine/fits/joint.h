#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/enum_names.h"
#include "engine/base/message.h"
#include "engine/geometry/pose.h"
#include "engine/model/body_id.h"
#include "engine/model/drive_kind.h"

namespace glissade {

/// How bodies of a product are joined, and how they come apart.
enum class JointKind {
  Screw,      ///< turns out of the part that its thread is in; the parts that it clamps stay until then
  Nut,        ///< turns off its shaft; the parts that it clamps stay until then
  Thread,     ///< two bodies that are screwed together, neither a screw nor a nut: either turns off the other
  Insert,     ///< pressed or melted in: host and guest are one body, unless a person says that it is pressed out
  Pin,        ///< leaves along its axis
  Snap,       ///< leaves along a direction while its hook is bent
  Flexible,   ///< leaves without a proof, after the bodies that cover it
  Permanent,  ///< does not come apart
  Unit        ///< bodies of one assembly that are not taken apart
};

inline constexpr EnumNames<JointKind, 9> kJointKindNames{
    {"screw", "nut", "thread", "insert", "pin", "snap", "flexible", "permanent", "unit"}};
/// True if the joint has a thread and comes apart by turning only.
bool isScrewed(JointKind kind);

/// The origin of a joint.
enum class JointState {
  Recognised,  ///< shapes show it: it counts without a person
  Suggested,   ///< shape, name or class suggest it: it counts after a person confirms it
  Confirmed    ///< a person states it
};

inline constexpr EnumNames<JointState, 3> kJointStateNames{{"recognised", "suggested", "confirmed"}};

/// The thread of a fastener, and how far it turns.
struct JointThread {
  double diameter = 0.0;       ///< outer diameter of the thread, metres
  double pitch = 0.0;          ///< metres a turn; below 0: left-handed
  bool isPitchStated = false;  ///< modelled, or stated by a person; else the coarse pitch of ISO 261 for the diameter
  double engaged = 0.0;        ///< length of the thread inside the other body, metres
  double travel = 0.0;  ///< metres along the axis until the thread is free; a nut also passes the end of its shaft

  /// Turns until the thread is free; above 0 for either hand.
  double turns() const;
};

/// A joint of a product. Bodies by their index in the product; frames as the product is assembled.
struct Joint {
  JointKind kind = JointKind::Screw;
  JointState state = JointState::Recognised;
  /// The screw, the nut, one of two bodies that are screwed together, the guest of an insert, the pin, the body with
  /// the hook, the flexible body, or the first body of a unit or a permanent joint.
  std::size_t body = 0;
  /// The bodies that the thread is in or on; the host of an insert; the body with the hole of a pin or the edge of a
  /// snap; the bodies that a flexible body goes around; the other bodies of a unit or a permanent joint.
  std::vector<std::size_t> others{};
  /// For a screw or a nut, the parts between its head and its thread, the nearest to the head first.
  std::vector<std::size_t> clamped{};
  Vector3 point = Vector3::Zero();       ///< on the axis, world frame
  Vector3 direction = Vector3::UnitZ();  ///< unit, world frame: exit direction of the body
  std::optional<JointThread> thread{};   ///< thread of a screwed joint
  DriveKind drive = DriveKind::None;
  /// Size of the drive, metres: across the flats of a hexagon, the width of a slot, the width of a cross or of six
  /// lobes from tip to tip; 0: not known.
  double driveSize = 0.0;
  double bend = 0.0;                ///< bend that the hook of a snap needs, metres
  std::string designation{};        ///< as stated by a name, "ISO 4762 M3x8"; empty: none
  bool isDoubtful = false;          ///< its evidence is contradictory; for a recognised joint the shape counts
  bool makesHole = false;           ///< it is a screw in a body that is drawn without a hole
  std::vector<Message> evidence{};  ///< each fact that supports it
};

/// Identifies a joint in files and to people: its kind and the ids of its bodies.
struct JointKey {
  JointKind kind = JointKind::Screw;
  BodyId body{};
  std::vector<BodyId> others{};

  bool operator==(const JointKey&) const = default;
};

/// A person's statement about a joint. Kept in scenarios and plans.
struct JointEdit {
  enum class Word {
    Confirmed,   ///< it exists, as found or as `made` states
    Dissolved,   ///< it does not exist
    PressedOut,  ///< an insert that is pressed out along its axis
    Opened       ///< a unit that is taken apart
  };
  JointKey key;
  Word word = Word::Confirmed;
  std::optional<Joint> made{};  ///< the joint that a person has made or changed; the indices of its bodies do not count
  std::vector<BodyId> clamped{};  ///< ids of the parts that it clamps, the nearest to the head first

  bool operator==(const JointEdit&) const;
};

using Joints = std::vector<Joint>;

}  // namespace glissade
