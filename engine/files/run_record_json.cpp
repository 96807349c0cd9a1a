#include "engine/files/run_record_json.h"

#include <charconv>

#include "engine/base/tolerances.h"
#include "engine/files/semantics_json.h"
#include "engine/geometry/pose_json.h"

namespace glissade {

using Json = JsonCursor::Json;

namespace {

using EditsPtr = std::shared_ptr<const SemanticEdits>;

Json toJson(const EditsPtr& edits) { return edits ? kObject<SemanticEdits>.write(*edits) : Json(nullptr); }

std::string toHex(std::uint64_t value) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text(16, '0');
  for (std::size_t i = 16; i-- > 0; value >>= 4U) text[i] = kDigits[value & 15U];
  return text;
}

Json toJson(const RunCheckpoint& checkpoint) {
  return {{"step", checkpoint.step},
          {"nodes", checkpoint.nodes},
          {"edges", checkpoint.edges},
          {"hash", toHex(checkpoint.hash)},
          {"seconds", checkpoint.seconds}};
}

/// [step, x, y, z, qx, qy, qz, qw], or [step] where nobody holds the object. The form is short because a record has
/// many of these.
Json toJson(const RunLog::HandPose& pose) {
  Json json = Json::array({pose.step});
  if (!pose.q_device) return json;
  for (int i = 0; i < 3; ++i) json.push_back(pose.q_device->position[i]);
  for (int i = 0; i < 4; ++i) json.push_back(pose.q_device->orientation.coeffs()[i]);
  return json;
}

Json toJson(const KnowledgeSource& source) {
  return {{"environment", kObject<EnvironmentOptions>.write(source.options)},
          {"semantics", toJson(source.edits)},
          {"required_clearance", source.requiredClearance}};
}

ParameterId readParameterId(const JsonCursor& at, const std::string& key) {
  const auto id = parameterByKey(key);
  if (!id) at.fail({GLISSADE_TEXT("names the unknown parameter '%1'"), {key}});
  return *id;
}

/// Reads a step, which must not be less than the step of the entry before: a replay processes them in order.
template <class Entry>
std::uint64_t readStep(const JsonCursor& at, const std::vector<Entry>& before) {
  const std::uint64_t step = at.wholeNumber();
  if (!before.empty() && step < before.back().step) at.fail(GLISSADE_TEXT("comes before the step above it"));
  return step;
}

EditsPtr readEdits(const JsonCursor& at) {
  return at.json().is_null() ? nullptr : std::make_shared<const SemanticEdits>(kObject<SemanticEdits>.read(at));
}

KnowledgeSource readKnowledge(const JsonCursor& at) {
  at.allowOnly({"environment", "semantics", "required_clearance"});
  return {kObject<EnvironmentOptions>.read(at.at("environment")), readEdits(at.at("semantics")),
          at.at("required_clearance").length()};
}

RunCheckpoint readCheckpoint(const JsonCursor& at) {
  at.allowOnly({"step", "nodes", "edges", "hash", "seconds"});
  RunCheckpoint checkpoint;
  checkpoint.step = at.at("step").wholeNumber();
  if (checkpoint.step == 0) at.at("step").fail(GLISSADE_TEXT("is 0"));
  checkpoint.nodes = at.at("nodes").wholeNumber();
  checkpoint.edges = at.at("edges").wholeNumber();
  checkpoint.seconds = at.at("seconds").number();
  const std::string hash = at.at("hash").text();
  const auto parsed = std::from_chars(hash.data(), hash.data() + hash.size(), checkpoint.hash, 16);
  if (hash.size() != 16 || parsed.ec != std::errc() || parsed.ptr != hash.data() + hash.size()) {
    at.at("hash").fail(GLISSADE_TEXT("is not a number of 16 hexadecimal digits"));
  }
  return checkpoint;
}

RunLog::HandPose readHandPose(const JsonCursor& at, const std::vector<RunLog::HandPose>& before) {
  const std::size_t size = at.size();
  if (size != 1 && size != 8) at.fail(GLISSADE_TEXT("is neither [step] nor [step, x, y, z, qx, qy, qz, qw]"));
  RunLog::HandPose entry{readStep(at.element(0), before), std::nullopt};
  if (size == 1) return entry;
  Pose q;
  for (std::size_t i = 0; i < 3; ++i) q.position[static_cast<Eigen::Index>(i)] = at.element(1 + i).coordinate();
  for (std::size_t i = 0; i < 4; ++i) {
    q.orientation.coeffs()[static_cast<Eigen::Index>(i)] = at.element(4 + i).number();
  }
  if (std::abs(q.orientation.norm() - 1.0) > tolerance::kQuaternionNorm)
    at.fail(GLISSADE_TEXT("holds no unit quaternion"));
  entry.q_device = q;
  return entry;
}

/// Reads the stream of hand poses, by far the longest part of a record.
void readStream(const JsonCursor& stream, int version, const WorkWatch& watch, RunLog& log) {
  constexpr std::size_t kBetweenLooks = 4096;
  for (std::size_t i = 0; i < stream.size(); ++i) {
    if (i % kBetweenLooks == 0) {
      if (watch.stop.stopRequested()) throw JsonError{readingStopped(stream.file())};
      watch.report(static_cast<double>(i) / static_cast<double>(stream.size()));
    }
    const JsonCursor at = stream.element(i);
    if (version == 2) {
      log.operatorStream.push_back(readHandPose(at, log.operatorStream));
      continue;
    }
    at.allowOnly({"step", "q"});
    log.operatorStream.push_back({readStep(at.at("step"), log.operatorStream), readPose(at.at("q"))});
  }
}

void readParameterChanges(const JsonCursor& changes, RunLog& log) {
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const JsonCursor at = changes.element(i);
    at.allowOnly({"step", "parameter", "value"});
    log.parameterChanges.push_back({readStep(at.at("step"), log.parameterChanges),
                                    readParameterId(at.at("parameter"), at.at("parameter").text()),
                                    at.at("value").number()});
  }
}

void readCommon(const JsonCursor& root, const WorkWatch& watch, RunRecord& record) {
  if (const auto program = root.find("program")) record.program = program->text();
  record.scenario = root.at("scenario").exactText();
  record.log.start.planner = root.at("planner").nonEmptyText();
  record.log.start.seed = root.at("seed").wholeNumber();
  const JsonCursor parameters = root.at("parameters");
  if (!parameters.json().is_object()) parameters.fail(GLISSADE_TEXT("is not an object"));
  for (const auto& item : parameters.json().items()) {
    const JsonCursor at = parameters.at(item.key());
    record.parameters[readParameterId(at, item.key())] = at.number();
  }
  readParameterChanges(root.at("parameter_changes"), record.log);
  readStream(root.at("operator_stream"), record.version, watch, record.log);
}

void readVersion1(const JsonCursor& root, RunRecord& record) {
  root.allowOnly({"format", "version", "program", "scenario", "scenario_sha256", "planner", "seed", "parameters",
                  "parameter_changes", "had_operator", "operator_stream", "nodes"});
  (void)root.at("scenario_sha256").text();
  (void)root.at("had_operator").boolean();
  RunCheckpoint end;
  end.nodes = root.at("nodes").wholeNumber();
  record.log.end = end;
}

RunRecord::Loss readLoss(const JsonCursor& at) {
  at.allowOnly({"lines", "after_step"});
  const RunRecord::Loss loss{at.at("lines").wholeNumber(), at.at("after_step").wholeNumber()};
  if (loss.lines == 0) at.at("lines").fail(GLISSADE_TEXT("is 0"));
  return loss;
}

void readVersion2(const JsonCursor& root, RunRecord& record) {
  root.allowOnly({"format", "version", "program", "build", "scenario", "problem_sha256", "assets", "planner", "seed",
                  "parameters", "semantics", "knowledge", "parameter_changes", "semantic_changes", "operator_stream",
                  "checkpoints", "end", "cut_short", "lost"});
  record.build = root.at("build").text();
  record.problemSha256 = root.at("problem_sha256").nonEmptyText();
  const JsonCursor assets = root.at("assets");
  for (std::size_t i = 0; i < assets.size(); ++i) {
    assets.element(i).allowOnly({"id", "sha256"});
    record.assets.push_back({assets.element(i).at("id").nonEmptyText(), assets.element(i).at("sha256").text()});
  }
  RunLog& log = record.log;
  log.start.edits = readEdits(root.at("semantics"));
  if (!root.at("knowledge").json().is_null()) log.start.knowledge = readKnowledge(root.at("knowledge"));
  const JsonCursor changes = root.at("semantic_changes");
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const JsonCursor at = changes.element(i);
    at.allowOnly({"step", "semantics"});
    log.semanticChanges.push_back({readStep(at.at("step"), log.semanticChanges), readEdits(at.at("semantics"))});
  }
  const JsonCursor checkpoints = root.at("checkpoints");
  for (std::size_t i = 0; i < checkpoints.size(); ++i) {
    (void)readStep(checkpoints.element(i).at("step"), log.checkpoints);
    log.checkpoints.push_back(readCheckpoint(checkpoints.element(i)));
  }
  if (!root.at("end").json().is_null()) log.end = readCheckpoint(root.at("end"));
  if (log.end && !log.checkpoints.empty() && log.end->step < log.checkpoints.back().step) {
    root.at("end").at("step").fail(GLISSADE_TEXT("comes before the last checkpoint"));
  }
  log.cutShort = root.at("cut_short").boolean();
  if (const auto lost = root.find("lost")) record.loss = readLoss(*lost);
}

Json toJson(const RunLog::ParameterChange& change) {
  return {{"step", change.step}, {"parameter", std::string(specOf(change.id).key)}, {"value", change.value}};
}

Json toJson(const RunLog::SemanticChange& change) {
  return {{"step", change.step}, {"semantics", toJson(change.edits)}};
}

Json toJson(const RunRecord::AssetHash& asset) { return {{"id", asset.id}, {"sha256", asset.sha256}}; }

template <class Entries>
Json entryList(const Entries& entries) {
  Json json = Json::array();
  for (const auto& entry : entries) json.push_back(toJson(entry));
  return json;
}

}  // namespace

Json headToJson(const RunRecord& record) {
  const RunStart& start = record.log.start;
  Json json;
  json["format"] = "glissade-run";
  json["version"] = 2;
  json["program"] = record.program;
  json["build"] = record.build;
  json["scenario"] = record.scenario;
  json["problem_sha256"] = record.problemSha256;
  json["assets"] = entryList(record.assets);
  json["planner"] = start.planner;
  json["seed"] = start.seed;
  json["parameters"] = Json::object();
  for (const auto& [id, value] : record.parameters) json["parameters"][std::string(specOf(id).key)] = value;
  json["semantics"] = toJson(start.edits);
  json["knowledge"] = start.knowledge ? toJson(*start.knowledge) : Json(nullptr);
  return json;
}

void addEvents(const RunLog& log, Json& json) {
  json["parameter_changes"] = entryList(log.parameterChanges);
  json["semantic_changes"] = entryList(log.semanticChanges);
  json["operator_stream"] = entryList(log.operatorStream);
  json["checkpoints"] = entryList(log.checkpoints);
  json["end"] = log.end ? toJson(*log.end) : Json(nullptr);
  json["cut_short"] = log.cutShort;
}

void addLoss(const std::optional<RunRecord::Loss>& loss, Json& json) {
  if (loss) json["lost"] = {{"lines", loss->lines}, {"after_step", loss->afterStep}};
}

RunRecord readRecord(const JsonCursor& root, const WorkWatch& watch) {
  if (root.at("format").text() != "glissade-run")
    root.at("format").fail({GLISSADE_TEXT("is not \"%1\""), {"glissade-run"}});
  const std::uint64_t version = root.at("version").wholeNumber();
  if (version != 1 && version != 2)
    root.at("version").fail(GLISSADE_TEXT("is neither 1 nor 2"), GLISSADE_TEXT("Use a newer Glissade."));
  RunRecord record;
  record.version = static_cast<int>(version);
  readCommon(root, watch, record);
  if (version == 1) {
    readVersion1(root, record);
  } else {
    readVersion2(root, record);
  }
  return record;
}

}  // namespace glissade
