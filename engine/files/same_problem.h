#pragma once

#include <string>

namespace glissade {

struct LoadedScenario;
struct RunRecord;
struct Scenario;

/// SHA-256 of a scenario's planning problem: bodies, object, start, goal, workspace, environment, fits and rules. It
/// excludes what a record holds itself (edits, planner, parameters, seed), and what does not change the problem of the
/// object: names, description, the tree of the product, joints, way points, kept paths, the plan, its demands, and
/// bodies that are left out.
std::string problemSha256(const Scenario& scenario);

/// Whether a run is about both scenarios, with its path and its recording. Names do not matter, except where a name
/// tells a thread: scenarios whose fits allow different things differ.
bool isSameProblem(const LoadedScenario& a, const LoadedScenario& b);

/// Whether the run was recorded on the problem of this scenario. Records of earlier programs include names and joints
/// in their SHA-256. Precondition: the record has version 2.
bool isRecordOf(const RunRecord& record, const LoadedScenario& scenario);

}  // namespace glissade
