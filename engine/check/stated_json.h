#pragma once

#include "engine/base/json_reader.h"
#include "engine/check/path.h"
#include "engine/check/product.h"

namespace glissade::check {

// Readers of values that paths, plans and scenarios have in common. They throw JsonError.

StatedThread readThread(const JsonCursor& at);
std::vector<StatedAllowance> readAllowances(const JsonCursor& at);
std::vector<Point> readPoints(const JsonCursor& at);
/// The demands of the section "sequence" of a scenario or a plan that steps have to keep.
Demands readDemands(const JsonCursor& at);
/// Adds a list of statements about joints, later than `words`: pairs whose joint a person dissolves or presses out.
PartingWords readPartings(const JsonCursor& joints, PartingWords words);
/// Adds the section "sequence" of a scenario or a plan, which also states whether joints are used.
PartingWords readPartingsOfSequence(const JsonCursor& sequence, PartingWords words);
/// Adds a list of statements about joints, later than `words`: flexible bodies, units, pitches.
JointWords readJointWords(const JsonCursor& joints, JointWords words);
/// The bends that a person confirms in a list of statements about joints. The last statement about a snap counts.
std::vector<SnapWord> readSnaps(const JsonCursor& at);

}  // namespace glissade::check
