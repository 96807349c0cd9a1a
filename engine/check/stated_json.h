#pragma once

#include "engine/base/json_reader.h"
#include "engine/check/path.h"
#include "engine/check/product.h"

namespace glissade::check {

// Values that paths, plans and scenarios have in common. Reading throws JsonError.

StatedThread readThread(const JsonCursor& at);
std::vector<StatedAllowance> readAllowances(const JsonCursor& at);
std::vector<Point> readPoints(const JsonCursor& at);
/// The section "sequence" of a scenario or a plan, as far as steps have to keep it.
Demands readDemands(const JsonCursor& at);
/// Of a list of words about joints, said after the others: pairs whose joint a person dissolves or has pressed out.
PartingWords readPartings(const JsonCursor& joints, PartingWords words);
/// The same of the section "sequence" of a scenario or a plan, which also says whether joints are used at all.
PartingWords readPartingsOfSequence(const JsonCursor& sequence, PartingWords words);
/// Of a list of words about joints, said after the others: what is flexible, what is one unit, pitches.
JointWords readJointWords(const JsonCursor& joints, JointWords words);
/// Of a list of words about joints: the bends that a person confirms. What is said last of a snap counts.
std::vector<SnapWord> readSnaps(const JsonCursor& at);

}  // namespace glissade::check
