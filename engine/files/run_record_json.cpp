#include "engine/files/run_record_json.h"

#include <charconv>
#include <limits>

#include "engine/base/tolerances.h"
#include "engine/files/parameters_json.h"
#include "engine/files/semantics_json.h"
#include "engine/geometry/pose_json.h"
#include "engine/import/json_checksum.h"

namespace glissade {
namespace {

using Json = JsonCursor::Json;

constexpr const char* kRecordFormat = "glissade-run";

std::string toHex(std::uint64_t value) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text(16, '0');
  for (std::size_t i = 16; i-- > 0; value >>= 4U) text[i] = kDigits[value & 15U];
  return text;
}

constexpr FunctionFormat kHash{
    [](const JsonCursor& at) {
      std::uint64_t hash = 0;
      const std::string text = at.text();
      const auto parsed = std::from_chars(text.data(), text.data() + text.size(), hash, 16);
      if (text.size() != 16 || parsed.ec != std::errc() || parsed.ptr != text.data() + text.size())
        at.fail(GLISSADE_TEXT("is not a number of 16 hexadecimal digits"));
      return hash;
    },
    toHex, R"({"type": "string", "pattern": "^[0-9a-f]{16}$"})"};

/// The form is short because a record has many of these.
constexpr FunctionFormat kHandPose{[](const JsonCursor& at) {
                                     const std::size_t size = at.size();
                                     if (size != 1 && size != 8)
                                       at.fail(GLISSADE_TEXT("is neither [step] nor [step, x, y, z, qx, qy, qz, qw]"));
                                     RunLog::HandPose entry{at.element(0).wholeNumber(), std::nullopt};
                                     if (size == 1) return entry;
                                     Pose q;
                                     for (std::size_t i = 0; i < 3; ++i)
                                       q.position[static_cast<Eigen::Index>(i)] = at.element(1 + i).coordinate();
                                     for (std::size_t i = 0; i < 4; ++i)
                                       q.orientation.coeffs()[static_cast<Eigen::Index>(i)] =
                                           at.element(4 + i).number();
                                     if (std::abs(q.orientation.norm() - 1.0) > tolerance::kQuaternionNorm)
                                       at.fail(GLISSADE_TEXT("holds no unit quaternion"));
                                     entry.q_device = q;
                                     return entry;
                                   },
                                   [](const RunLog::HandPose& entry) {
                                     Json json = Json::array({entry.step});
                                     if (!entry.q_device) return json;
                                     for (int i = 0; i < 3; ++i) json.push_back(entry.q_device->position[i]);
                                     for (int i = 0; i < 4; ++i)
                                       json.push_back(entry.q_device->orientation.coeffs()[i]);
                                     return json;
                                   },
                                   R"({"type": "array", "minItems": 1, "maxItems": 8, "items": {"type": "number"}})"};

/// A pose of the hand in version 1.
RunLog::HandPose readHandPose1(const JsonCursor& at) {
  at.allowOnly({"step", "q"});
  return {at.at("step").wholeNumber(), readPose(at.at("q"))};
}

/// Reads the stream of hand poses, by far the longest part of a record.
template <class ReadPose>
std::vector<RunLog::HandPose> readStream(const JsonCursor& stream, const WorkWatch& watch, ReadPose readEntry) {
  constexpr std::size_t kBetweenLooks = 4096;
  std::vector<RunLog::HandPose> poses;
  for (std::size_t i = 0; i < stream.size(); ++i) {
    if (i % kBetweenLooks == 0) {
      if (watch.stop.stopRequested()) throw JsonError{readingStopped(stream.file())};
      watch.report(static_cast<double>(i) / static_cast<double>(stream.size()));
    }
    poses.push_back(readEntry(stream.element(i)));
  }
  return poses;
}

/// Refuses a list whose steps descend, because a replay processes the entries in their order. `stepOf`: the place of
/// an entry's step.
template <class Entries, class StepOf>
void expectAscending(const Entries& entries, const JsonCursor& list, StepOf stepOf) {
  for (std::size_t i = 1; i < entries.size(); ++i) {
    if (entries[i].step < entries[i - 1].step)
      stepOf(list.element(i)).fail(GLISSADE_TEXT("comes before the step above it"));
  }
}

template <class Entries>
void expectAscending(const Entries& entries, const JsonCursor& list) {
  expectAscending(entries, list, [](const JsonCursor& entry) { return entry.at("step"); });
}

void checkEvents(const RunLog& log, const JsonCursor& at) {
  expectAscending(log.parameterChanges, at.at("parameter_changes"));
  expectAscending(log.semanticChanges, at.at("semantic_changes"));
  expectAscending(log.checkpoints, at.at("checkpoints"));
  if (log.end && !log.checkpoints.empty() && log.end->step < log.checkpoints.back().step)
    at.at("end").at("step").fail(GLISSADE_TEXT("comes before the last checkpoint"));
}

/// A member that is a pointer to semantic edits, as a value.
template <class Owner>
constexpr auto editsOf(std::shared_ptr<const SemanticEdits> Owner::*member) {
  return Accessor{[member](const Owner& owner) -> const auto& {return owner.*member;
}
, [member](Owner& owner, std::optional<SemanticEdits> edits) {
  owner.*member = edits ? std::make_shared<const SemanticEdits>(*std::move(edits)) : nullptr;
}
};  // namespace
}  // namespace glissade

/// A value of a run's start.
template <class Member>
constexpr auto ofStart(Member member) {
  return Accessor{
      [member](const RunRecord& record) -> decltype(auto) { return describing::valueOf(record.log.start, member); },
      [member](RunRecord& record, auto value) { describing::assign(record.log.start, member, std::move(value)); }};
}

constexpr auto kEdits = orNull(kObject<SemanticEdits>);

}  // namespace

template <class Archive>
void describe(Archive& source, Type<KnowledgeSource> /*type*/) {
  source.type("knowledge");
  source.required("environment", &KnowledgeSource::options, kObject<EnvironmentOptions>);
  source.required("semantics", editsOf(&KnowledgeSource::edits), kEdits);
  source.required("required_clearance", &KnowledgeSource::requiredClearance, kLength, "Metres.");
}

template <class Archive>
void describe(Archive& checkpoint, Type<RunCheckpoint> /*type*/) {
  checkpoint.type("checkpoint");
  checkpoint.required("step", &RunCheckpoint::step, kCountFrom1);
  checkpoint.required("nodes", &RunCheckpoint::nodes, kCount);
  checkpoint.required("edges", &RunCheckpoint::edges, kCount);
  checkpoint.required("hash", &RunCheckpoint::hash, kHash, "Hash of all nodes and edges of the roadmap.");
  checkpoint.required("seconds", &RunCheckpoint::seconds, kNumber, "Seconds since the start, in the run's own time.");
}

template <class Archive>
void describe(Archive& change, Type<RunLog::ParameterChange> /*type*/) {
  change.type("parameter_change");
  change.required("step", &RunLog::ParameterChange::step, kCount);
  change.required("parameter", &RunLog::ParameterChange::id, ParameterKeyFormat());
  change.required("value", &RunLog::ParameterChange::value, kNumber);
}

template <class Archive>
void describe(Archive& change, Type<RunLog::SemanticChange> /*type*/) {
  change.type("semantic_change");
  change.required("step", &RunLog::SemanticChange::step, kCount);
  change.required("semantics", editsOf(&RunLog::SemanticChange::edits), kEdits);
}

template <class Archive>
void describe(Archive& log, Type<RunLog> /*type*/) {
  log.type("events");
  log.required("parameter_changes", &RunLog::parameterChanges, listOf(kObject<RunLog::ParameterChange>, 0, kAnyNumber));
  log.required("semantic_changes", &RunLog::semanticChanges, listOf(kObject<RunLog::SemanticChange>, 0, kAnyNumber));
  log.required("operator_stream", &RunLog::operatorStream, listOf(kHandPose, 0, kAnyNumber),
               "[step, x, y, z, qx, qy, qz, qw]: the pose of the object from that step on; [step]: nobody held it.");
  log.required("checkpoints", &RunLog::checkpoints, listOf(kObject<RunCheckpoint>, 0, kAnyNumber));
  log.required("end", &RunLog::end, orNull(kObject<RunCheckpoint>),
               "The last step that a stop did not interrupt; null where there was none.");
  log.required("cut_short", &RunLog::cutShort, kBoolean, "The run went on after the recording was full.");
  log.check(checkEvents);
}

template <class Archive>
void describe(Archive& asset, Type<RunRecord::AssetHash> /*type*/) {
  asset.type("asset");
  asset.required("id", &RunRecord::AssetHash::id, kNonEmptyText);
  asset.required("sha256", &RunRecord::AssetHash::sha256, kText);
}

template <class Archive>
void describe(Archive& loss, Type<RunRecord::Loss> /*type*/) {
  loss.type("loss");
  loss.required("lines", &RunRecord::Loss::lines, kCountFrom1);
  loss.required("after_step", &RunRecord::Loss::afterStep, kCount);
}

template <class Archive>
void describe(Archive& record, Type<RunRecord> /*type*/) {
  record.type("record",
              "All inputs of an interactive session: they suffice to grow the same roadmap again. Steps are session "
              "steps, the calls of the planner to the session. An entry of step n was in force from the pass that "
              "followed n others. A journal is a record in lines: the first line has all keys, and every other line "
              "has entries to append to the lists.");
  record.constant("format", kRecordFormat);
  record.constant("version", 2);
  record.optional("program", &RunRecord::program, kText, "", Always());
  record.required("build", &RunRecord::build, kText, "Compiler, processor, flags.");
  record.required("scenario", &RunRecord::scenario, kFilePath, "The file, relative to the folder of the record.");
  record.required("problem_sha256", &RunRecord::problemSha256, kNonEmptyText);
  record.required("assets", &RunRecord::assets, kObjects<RunRecord::AssetHash>);
  record.required("planner", ofStart(&RunStart::planner), kNonEmptyText);
  record.required("seed", ofStart(&RunStart::seed), kCount);
  record.required("parameters", &RunRecord::parameters, ParametersFormat());
  record.required("semantics", ofStart(editsOf(&RunStart::edits)), kEdits,
                  "Attributes, places and milestones as in a scenario; attributes of bodies by body id.");
  record.required("knowledge", ofStart(&RunStart::knowledge), orNull(kObject<KnowledgeSource>),
                  "Source of the environment model; null where the planner built it, or none was used.");
  record.embed(&RunRecord::log);
  record.optional("lost", &RunRecord::loss, kObject<RunRecord::Loss>,
                  "Lines that a damaged journal has lost; the record is complete up to a step.");
}

template struct ObjectFormat<RunRecord>;
template struct ObjectFormat<RunLog>;
template struct ObjectFormat<RunRecord::Loss>;

Json runRecordSchema() {
  Json schema = describedSchema<RunRecord>("Glissade run record, version 2");
  addChecksumProperty(schema);
  return schema;
}

namespace {

RunRecord readVersion1(const JsonCursor& root, const WorkWatch& watch) {
  root.allowOnly({"format", "version", "program", "scenario", "scenario_sha256", "planner", "seed", "parameters",
                  "parameter_changes", "had_operator", "operator_stream", "nodes"});
  RunRecord record;
  record.version = 1;
  if (const auto program = root.find("program")) record.program = program->text();
  record.scenario = root.at("scenario").exactText();
  (void)root.at("scenario_sha256").text();
  (void)root.at("had_operator").boolean();
  record.parameters = ParametersFormat().read(root.at("parameters"));
  RunLog& log = record.log;
  log.start.planner = root.at("planner").nonEmptyText();
  log.start.seed = root.at("seed").wholeNumber();
  log.parameterChanges = listOf(kObject<RunLog::ParameterChange>, 0, kAnyNumber).read(root.at("parameter_changes"));
  expectAscending(log.parameterChanges, root.at("parameter_changes"));
  log.operatorStream = readStream(root.at("operator_stream"), watch, readHandPose1);
  expectAscending(log.operatorStream, root.at("operator_stream"));
  log.end.emplace().nodes = root.at("nodes").wholeNumber();
  return record;
}

/// The stream of hand poses is read apart, so that its reading can be stopped.
RunRecord readVersion2(Json& document, const std::string& file, const WorkWatch& watch) {
  Json stream = Json::array();
  if (document.contains("operator_stream")) stream.swap(document["operator_stream"]);
  RunRecord record = readDescribed<RunRecord>(JsonCursor(document, file, ""));
  const JsonCursor at(stream, file, "/operator_stream");
  record.log.operatorStream = readStream(at, watch, [](const JsonCursor& entry) { return kHandPose.read(entry); });
  expectAscending(record.log.operatorStream, at, [](const JsonCursor& entry) { return entry.element(0); });
  return record;
}

}  // namespace

RunRecord readRecord(Json& document, const std::string& file, const WorkWatch& watch) {
  const JsonCursor root(document, file, "");
  const bool isOld = root.at("format").text() == kRecordFormat && root.at("version").wholeNumber() == 1;
  return isOld ? readVersion1(root, watch) : readVersion2(document, file, watch);
}

}  // namespace glissade
