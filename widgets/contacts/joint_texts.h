#pragma once

#include <QString>

#include "widgets/contacts/joint_table.h"

namespace glissade {

// Texts of joints in the user's language.

/// Name of the kind, such as "screw".
QString jointKindText(JointKind kind);
/// Name of the state, such as "suggested".
QString jointStateText(JointRowState state);
/// The bodies that it is joined with, then those that it clamps: "block; clamps washer, plate".
QString joinedWithText(const JointRow& row, const JointTable& table);
/// Designation, or else the size of the thread, and the turns: "ISO 4762 M3x8, 5.0 turns", "M5, 3.2 turns", "Ø 5.3 mm,
/// 2.0 turns". Empty if the joint has neither.
QString jointSizeText(const Joint& joint);
/// The drive and its size, such as "hexagon socket 4.00 mm". Empty if there is none.
QString driveText(const Joint& joint);
/// The evidence of the joint, each as a line, and the reason of a refusal.
QStringList jointEvidence(const JointRow& row);
/// A summary such as "Joints: 3 (2 × screw, 1 × nut); suggested: 1".
QString jointsSummary(const JointTable& table);

}  // namespace glissade
