#pragma once

#include <QString>

#include "widgets/panels/joint_table.h"

namespace glissade {

// Texts of joints in the user's language.

/// "screw".
QString jointKindText(JointKind kind);
/// "suggested".
QString jointStateText(JointRowState state);
/// What it is joined with, then what it clamps: "block; clamps washer, plate".
QString joinedWithText(const JointRow& row, const JointTable& table);
/// Designation, else the size of the thread, and the turns: "ISO 4762 M3x8, 5.0 turns", "M5, 3.2 turns", "Ø 5.3 mm, 2.0
/// turns". Empty where there is neither.
QString jointSizeText(const Joint& joint);
/// The drive and its size: "hexagon socket 4.00 mm". Empty where there is none.
QString driveText(const Joint& joint);
/// What it was concluded from, each as a line; why a word about it is refused.
QStringList jointEvidence(const JointRow& row);
/// "Joints: 3 (2 × screw, 1 × nut); suggested: 1".
QString jointsSummary(const JointTable& table);

}  // namespace glissade
