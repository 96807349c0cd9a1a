#include "engine/scenario/run_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/base/random_stream.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

RunRecord someRecord() {
  RunRecord record;
  record.scenario = "samples/scenario.json";
  record.scenarioSha256 = std::string(64, '1');
  record.planner = "contact-birrt";
  record.seed = 12345678901234567890U;
  for (const ParameterSpec& spec : parameterTable()) record.parameters[spec.id] = spec.defaultValue / 3.0;
  record.parameterChanges = {{5, ParameterId::Alpha, 0.1}, {5, ParameterId::ContactDistance, 1.0 / 7.0}};
  RandomStream random(11, "run-record");
  for (std::uint64_t step = 0; step < 500; step += 2) {
    Pose q;
    for (int i = 0; i < 3; ++i) q.position[i] = 1e3 * random.normal();
    q.orientation = Quaternion(random.normal(), random.normal(), random.normal(), random.normal()).normalized();
    record.operatorStream.push_back({step, q});
  }
  record.hadOperator = true;
  record.nodes = 100;
  return record;
}

TEST(RunRecordFile, ReadsBackBitByBit) {
  const test::TemporaryFolder folder;
  const RunRecord written = someRecord();
  ASSERT_TRUE(writeRunRecord(written, folder / "run.json").ok());
  const Result<RunRecord> read = readRunRecord(folder / "run.json");
  ASSERT_TRUE(read.ok()) << toString(read.error());
  ASSERT_TRUE(writeRunRecord(*read, folder / "again.json").ok());
  EXPECT_EQ(test::readWhole(folder / "again.json"), test::readWhole(folder / "run.json"));
  EXPECT_EQ(read->seed, written.seed);
  EXPECT_EQ(read->parameters, written.parameters);
  EXPECT_EQ(read->parameterChanges[1].value, 1.0 / 7.0);
  ASSERT_EQ(read->operatorStream.size(), written.operatorStream.size());
  for (std::size_t i = 0; i < written.operatorStream.size(); ++i) {
    EXPECT_EQ(read->operatorStream[i].step, written.operatorStream[i].step);
    EXPECT_EQ(read->operatorStream[i].q_device, written.operatorStream[i].q_device);
  }
  EXPECT_TRUE(read->hadOperator);
  EXPECT_EQ(read->nodes, 100U);
}

TEST(RunRecordFile, IsReadStrictly) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writeRunRecord(someRecord(), folder / "run.json").ok());
  const auto sound = nlohmann::json::parse(test::readWhole(folder / "run.json"));
  const std::vector<std::tuple<const char*, std::string>> table{
      {R"([{"op": "replace", "path": "/format", "value": "x"}])", "/format"},
      {R"([{"op": "replace", "path": "/version", "value": 2}])", "/version"},
      {R"([{"op": "add", "path": "/extra", "value": 2}])", "/extra"},
      {R"([{"op": "remove", "path": "/nodes"}])", "/nodes"},
      {R"([{"op": "replace", "path": "/operator_stream/3/step", "value": 1}])", "/operator_stream/3/step"},
      {R"([{"op": "replace", "path": "/operator_stream/3/q/orientation/3", "value": 9}])",
       "/operator_stream/3/q/orientation"},
      {R"([{"op": "replace", "path": "/parameter_changes/0/parameter", "value": "x"}])",
       "/parameter_changes/0/parameter"},
      {R"([{"op": "add", "path": "/parameters/x", "value": 1}])", "/parameters/x"},
  };
  for (const auto& [patch, place] : table) {
    const Result<RunRecord> read =
        readRunRecord(folder.write("broken.json", sound.patch(nlohmann::json::parse(patch)).dump()));
    ASSERT_FALSE(read.ok()) << patch;
    EXPECT_EQ(read.error().kind, ErrorKind::MalformedInput);
    EXPECT_EQ(read.error().place, place);
  }
}

}  // namespace
}  // namespace glissade
