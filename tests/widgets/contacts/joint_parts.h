// A product with joints for tests of the window: a screw in a block that clamps a plate, and a pin in the block.
#pragma once

#include <memory>

#include "tests/engine/fits/turned_parts.h"
#include "widgets/contacts/joint_table.h"

namespace glissade::test {

/// Bodies: plate 0, screw 1, block 2, pin 3.
inline ProductPtr screwedProduct() {
  ProductOfParts parts;
  parts.add("plate", plateMesh(0.0028, 0.06, -0.006, 0.0))
      .add("screw", capScrew(0.005, 0.02))
      .add("block", blockMesh(0.0021, 0.02, 0.06, -0.046, -0.006))
      .add("pin", rodMesh(0.002, 0.0, 0.01));
  return std::make_shared<const AssembledProduct>(parts.product());
}

inline Joint screwJoint() {
  Joint joint;
  joint.kind = JointKind::Screw;
  joint.body = 1;
  joint.others = {2};
  joint.clamped = {0};
  joint.thread = JointThread{0.005, 0.0008, false, 0.008, 0.008};
  joint.drive = DriveKind::HexSocket;
  joint.driveSize = 0.004;
  joint.isDoubtful = true;
  joint.evidence = {Message("a shaft of 5 mm with a head"), Message("the name says 'screw'")};
  return joint;
}

inline Joint pinJoint(JointKind kind = JointKind::Insert) {
  Joint joint;
  joint.kind = kind;
  joint.body = 3;
  joint.others = {0};
  joint.evidence = {Message("a pin in a hole")};
  return joint;
}

inline Joint suggestedUnit() {
  Joint joint;
  joint.kind = JointKind::Unit;
  joint.state = JointState::Suggested;
  joint.body = 0;
  joint.others = {2};
  joint.evidence = {Message("the assembly is called 'pump'")};
  return joint;
}

/// A table with a screw, a pin, and a suggested unit.
inline std::shared_ptr<const JointTable> screwedTable(std::vector<JointEdit> said = {}) {
  const Joints found{suggestedUnit(), screwJoint(), pinJoint()};
  return std::make_shared<const JointTable>(screwedProduct(), std::make_shared<const Joints>(found), std::move(said));
}

/// The row of this body; the test fails if there is none.
inline const JointRow& rowOf(const JointTable& table, const BodyId& body) {
  for (const JointRow& row : table.rows()) {
    if (row.key.body == body) return row;
  }
  throw std::runtime_error("no row of " + body.text());
}

}  // namespace glissade::test
