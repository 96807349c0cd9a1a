#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/geometry/pose.h"

namespace glissade {

/// How bodies of a product are joined, and how they come apart.
enum class JointKind {
  Screw,      ///< turns out of what its thread is in; what it clamps stays until then
  Nut,        ///< turns off its shaft; what it clamps stays until then
  Thread,     ///< two bodies that are screwed together, neither a screw nor a nut: either turns off the other
  Insert,     ///< pressed or melted in: host and guest are one body, unless a person says that it is pressed out
  Pin,        ///< leaves along its axis
  Snap,       ///< leaves along a direction while its hook is bent
  Flexible,   ///< leaves when what covers it has left, without a proof
  Permanent,  ///< does not come apart
  Unit        ///< bodies of one assembly that are not taken apart
};

/// "screw", "nut", "thread", "insert", "pin", "snap", "flexible", "permanent", "unit".
const char* jointName(JointKind kind);
std::optional<JointKind> jointByName(const std::string& name);
/// It has a thread, and comes apart by turning only.
bool isScrewed(JointKind kind);

/// Who says that a joint is there.
enum class JointState {
  Recognised,  ///< the shapes do: it counts without a person
  Suggested,   ///< shape, name or class hint at it: it counts when a person confirms it
  Confirmed    ///< a person does
};

/// "recognised", "suggested", "confirmed".
const char* jointStateName(JointState state);
std::optional<JointState> jointStateByName(const std::string& name);

/// What a tool turns a fastener by.
enum class DriveKind { None, HexOutside, HexSocket, Cross, Slot, SixLobe };

/// "hex", "hex_socket", "cross", "slot", "six_lobe"; "none".
const char* driveName(DriveKind kind);
std::optional<DriveKind> driveByName(const std::string& name);

/// Where and how far a fastener turns.
struct JointThread {
  double diameter = 0.0;       ///< metres, of the thread outside
  double pitch = 0.0;          ///< metres a turn; below 0: left-handed
  bool isPitchStated = false;  ///< modelled, or said by a person; else the coarse pitch of ISO 261 for the diameter
  double engaged = 0.0;        ///< metres of the thread that are in the other one
  double travel = 0.0;  ///< metres along the axis until the thread is free: a nut passes the end of its shaft, too

  /// Until the thread is free; above 0 whatever the hand.
  double turns() const;
};

/// One joint of a product. Bodies by their index in the product; frames as the product is assembled.
struct Joint {
  JointKind kind = JointKind::Screw;
  JointState state = JointState::Recognised;
  /// The screw, the nut, one of two bodies that are screwed together, the guest of an insert, the pin, the body with
  /// the hook, the flexible body. Of a unit and a permanent joint the first body.
  std::size_t body = 0;
  /// What the thread is in or on; the host of an insert; the body with the hole of a pin or the edge of a snap; what a
  /// flexible body goes around; the other bodies of a unit or of a permanent joint.
  std::vector<std::size_t> others{};
  /// Of a screw or a nut: what lies between its head and its thread, the nearest to the head first.
  std::vector<std::size_t> clamped{};
  Vector3 point = Vector3::Zero();       ///< on the axis, world frame
  Vector3 direction = Vector3::UnitZ();  ///< unit, world frame: the way in which the body leaves
  std::optional<JointThread> thread{};   ///< of what is screwed
  DriveKind drive = DriveKind::None;
  /// Metres, across the flats of a hexagon, the width of a slot, the width of a cross or of six lobes from tip to tip;
  /// 0: not known.
  double driveSize = 0.0;
  double bend = 0.0;          ///< metres that the hook of a snap has to bend
  std::string designation{};  ///< as a name states it, "ISO 4762 M3x8"; empty: none
  bool isDoubtful = false;    ///< what speaks for it contradicts itself: where it is recognised, the shape wins
  bool makesHole = false;     ///< of a screw: it is in a body that is drawn without a hole
  std::vector<std::string> evidence{};  ///< for people, in English: each thing that it was concluded from
};

/// What identifies a joint in files and to people: its kind and the ids of its body and of the others.
struct JointKey {
  JointKind kind = JointKind::Screw;
  std::string body{};
  std::vector<std::string> others{};

  bool operator==(const JointKey&) const = default;
};

/// What a person says of a joint. Kept in scenarios and plans.
struct JointEdit {
  enum class Word {
    Confirmed,   ///< it is there, as found or as `made` says
    Dissolved,   ///< it is not there
    PressedOut,  ///< an insert that comes out along its axis
    Opened       ///< a unit that is taken apart
  };
  JointKey key;
  Word word = Word::Confirmed;
  std::optional<Joint> made{};  ///< of a joint that a person has made or changed; its bodies' indices do not count
  std::vector<std::string> clamped{};  ///< ids of what such a screw or nut clamps, the nearest to the head first

  bool operator==(const JointEdit&) const;
};

using Joints = std::vector<Joint>;

}  // namespace glissade
