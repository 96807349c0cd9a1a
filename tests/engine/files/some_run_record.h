#pragma once

#include "engine/base/random_stream.h"
#include "engine/files/run_record.h"
#include "tests/engine/support/random_pose.h"

namespace glissade::test {

/// A run record as version 1 wrote it.
inline constexpr const char* kRunRecordOfVersion1 = R"({
 "format": "glissade-run", "version": 1, "program": "Glissade 0.1.0", "scenario": "samples/a.json",
 "scenario_sha256": "00", "planner": "contact-birrt", "seed": 5, "parameters": {"alpha": 0.25},
 "parameter_changes": [{"step": 3, "parameter": "alpha", "value": 0.5}], "had_operator": true, "nodes": 42,
 "operator_stream": [{"step": 0, "q": {"position": [1, 2, 3], "orientation": [0, 0, 0, 1]}}]})";

inline std::shared_ptr<const SemanticEdits> someEdits() {
  auto edits = std::make_shared<SemanticEdits>();
  AttributeDefinition fragile;
  fragile.name = "fragile";
  fragile.label = Message("fragile");
  fragile.type = AttributeType::Bool;
  fragile.initial = false;
  edits->definitions.push_back(fragile);
  edits->places.push_back({Vector3(0.1, 1.0 / 3.0, 2.0), "narrow", {{"fragile", true}, {"complexity", 3.0}}});
  edits->bodies["wall"] = {{"mobility", std::string("mobile")}};
  edits->milestones.push_back({Vector3(1, 2, 3), Pose::translation({0.1, 0.2, 0.3})});
  return edits;
}

/// A record that uses every part of the format.
inline RunRecord someRunRecord() {
  RunRecord record;
  record.program = "Glissade 0.1.0";
  record.build = "GNU, x86_64, -O3";
  record.scenario = "/somewhere/scenario.json";
  record.problemSha256 = std::string(64, '1');
  record.assets = {{"part", std::string(64, '2')}};
  RunLog& log = record.log;
  log.start.planner = "contact-birrt";
  log.start.seed = 12345678901234567890U;
  log.start.edits = someEdits();
  log.start.knowledge = KnowledgeSource{{0.125, 16.0, 5, "watershed"}, nullptr, 1e-4};
  for (const ParameterSpec& spec : parameterTable()) record.parameters[spec.id] = spec.defaultValue / 3.0;
  log.parameterChanges = {{5, ParameterId::Alpha, 0.1}, {5, ParameterId::ContactDistance, 1.0 / 7.0}};
  log.semanticChanges = {{7, someEdits()}, {9, nullptr}};
  RandomStream random(11, "run-record");
  for (std::uint64_t step = 0; step < 500; step += 2) log.operatorStream.push_back({step, randomPose(random, 1e3)});
  log.operatorStream.push_back({500, std::nullopt});
  log.checkpoints = {{1000, 10, 9, 0xfedcba9876543210U, 1.0 / 3.0}};
  log.end = RunCheckpoint{1500, 20, 19, 1, 0.5};
  return record;
}

}  // namespace glissade::test
