#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "engine/documents/instruction/instruction_template.h"
#include "engine/files/joints_json.h"
#include "engine/files/plan_file.h"
#include "engine/files/run_record.h"
#include "engine/study/study_reader.h"
#include "tests/engine/files/broken_semantics.h"
#include "tests/engine/files/some_plan.h"
#include "tests/engine/files/some_run_record.h"
#include "tests/engine/study/broken_studies.h"
#include "tests/engine/support/directories.h"
#include "tests/engine/support/temporary_folder.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

using Adapter = valijson::adapters::NlohmannJsonAdapter;

class Schema {
 public:
  explicit Schema(const std::string& name)
      : document_(nlohmann::json::parse(
            test::readWhole(test::sourceDirectory() + "/resources/schema/" + name + ".schema.json"))) {
    valijson::SchemaParser().populateSchema(Adapter(document_), schema_);
  }

  /// The fault of a document; empty where it is valid.
  std::string complaint(const std::string& text) {
    const auto document = nlohmann::json::parse(text);
    valijson::Validator validator;
    valijson::ValidationResults results;
    if (validator.validate(schema_, Adapter(document), &results)) return {};
    valijson::ValidationResults::Error error;
    return results.popError(error) ? error.description : "invalid";
  }

 private:
  nlohmann::json document_;
  valijson::Schema schema_;
};

TEST(ScenarioSchema, AcceptsWhatIsWritten) {
  Schema schema("scenario-1");
  EXPECT_EQ(schema.complaint(writeScenario(test::boxScenario())), "");
  EXPECT_EQ(schema.complaint(writeScenario(test::fullScenario())), "");
  for (const char* name : {"environment-1", "environment-2", "sliding-plane"}) {
    EXPECT_EQ(schema.complaint(test::readWhole(test::sample(name))), "") << name;
  }
  for (const char* name : {"shape-game/tight-star", "shape-game/paper-like-circle", "pump/mount", "pump/unmount"}) {
    EXPECT_EQ(schema.complaint(test::readWhole(test::sourceDirectory() + "/samples/" + name + ".json")), "") << name;
  }
}

TEST(ScenarioSchema, KnowsEveryParameter) {
  Schema schema("scenario-1");
  for (const ParameterSpec& spec : parameterTable()) {
    Scenario scenario = test::boxScenario();
    scenario.parameters[spec.id] = spec.defaultValue;
    EXPECT_EQ(schema.complaint(writeScenario(scenario)), "") << spec.key;
  }
}

TEST(ScenarioSchema, RefusesWhatTheReaderRefuses) {
  Schema schema("scenario-1");
  for (const auto& rows : {test::brokenScenarios(), test::brokenSemantics()}) {
    for (const test::BrokenScenario& row : rows) {
      EXPECT_EQ(schema.complaint(test::broken(row)).empty(), !row.schemaSees) << row.patch;
    }
  }
}

TEST(PlanSchema, AcceptsWhatIsWritten) {
  Schema schema("plan-2");
  const test::TemporaryFolder folder;
  ASSERT_TRUE(savePlan(test::somePlan(), "product.step", folder / "plan.json").ok());
  EXPECT_EQ(schema.complaint(test::readWhole(folder / "plan.json")), "");
  EXPECT_NE(schema.complaint(R"({"format": "glissade-plan", "version": 2})"), "");
}

TEST(JointsSchema, AcceptsWhatIsWritten) {
  Schema schema("joints-1");
  AssembledProduct product;
  product.bodies = {boxBody("block", {1.0, 1.0, 1.0}, {}), boxBody("screw", {1.0, 1.0, 1.0}, {})};
  Joint joint;
  joint.body = 1;
  joint.others = {0};
  joint.thread = JointThread{0.003, 0.0005, false, 0.004, 0.005};
  joint.drive = DriveKind::HexSocket;
  joint.driveSize = 0.0025;
  joint.designation = "ISO 4762 M3x8";
  joint.evidence = {Message("a shaft with a head")};
  nlohmann::ordered_json json{{"format", "glissade-joints"}, {"version", 1}, {"counts", {{"screw", 1}}}};
  json["joints"] = {toJson(joint, product), toJson(Joint{}, product)};
  EXPECT_EQ(schema.complaint(json.dump()), "");
  json["joints"][0]["kind"] = "rivet";
  EXPECT_NE(schema.complaint(json.dump()), "");
}

/// The files are written by the code that reads and writes the documents. GLISSADE_UPDATE_GOLDEN=1 writes them.
TEST(Schemas, FilesAreWhatTheCodeDescribes) {
  const std::pair<const char*, nlohmann::ordered_json> schemas[] = {
      {"scenario-1", scenarioSchema()},
      {"plan-2", planSchema()},
      {"run-2", runRecordSchema()},
      {"study-1", studySchema()},
      {"instruction-template-1", instructionTemplateSchema()}};
  for (const auto& [name, schema] : schemas) {
    const std::string file = test::sourceDirectory() + "/resources/schema/" + name + ".schema.json";
    const std::string text = schema.dump(2) + "\n";
    if (std::getenv("GLISSADE_UPDATE_GOLDEN") != nullptr) std::ofstream(file) << text;
    EXPECT_TRUE(test::readWhole(file) == text) << name << " differs. Write it with GLISSADE_UPDATE_GOLDEN=1.";
  }
}

/// The template of instruction_template_test.cpp is valid.
TEST(InstructionTemplateSchema, KnowsEveryMember) {
  Schema schema("instruction-template-1");
  const auto with = [](const std::string& members) {
    return R"({"format": "glissade-instruction-template", "version": 1)" + members + "}";
  };
  EXPECT_EQ(schema.complaint(with("")), "");
  EXPECT_EQ(schema.complaint(with(R"(, "company": "Muster", "logo": "logo.png", "columns": ["count", "part"],
                                     "language": "fr", "paper": "Letter")")),
            "");
  for (const char* wrong : {R"(, "colour": "red")", R"(, "columns": [])", R"(, "columns": ["price"])",
                            R"(, "language": "de")", R"(, "paper": "A3")"}) {
    EXPECT_NE(schema.complaint(with(wrong)), "") << wrong;
  }
}

TEST(RunSchema, AcceptsWhatIsWritten) {
  Schema schema("run-2");
  const test::TemporaryFolder folder;
  RunRecord record = test::someRunRecord();
  record.log.start.seed = 5;  // the validator does not support whole numbers beyond 2^63
  for (const ParameterSpec& spec : parameterTable()) record.parameters[spec.id] = spec.defaultValue;
  ASSERT_TRUE(writeRunRecord(record, folder / "run.json").ok());
  EXPECT_EQ(schema.complaint(test::readWhole(folder / "run.json")), "");
  EXPECT_NE(schema.complaint("{}"), "");
}

TEST(StudySchema, AcceptsWhatIsShipped) {
  Schema schema("study-1");
  EXPECT_EQ(schema.complaint(test::tinyStudy().dump()), "");
  for (const char* name : {"table-1", "table-2", "table-3", "table-4", "table-5", "figure-14", "figure-14-paper-like",
                           "automatic", "public-problems", "made-problems", "tuned"}) {
    const std::string file = test::sourceDirectory() + "/samples/studies/" + name + ".json";
    EXPECT_EQ(schema.complaint(test::readWhole(file)), "") << name;
  }
}

TEST(StudySchema, KnowsEveryParameterAndLimit) {
  Schema schema("study-1");
  for (const ParameterSpec& spec : parameterTable()) {
    const std::string key(spec.key);
    auto parameter = test::tinyStudy();
    parameter["parameters"][key] = spec.defaultValue;
    auto limit = test::tinyStudy();
    limit["limits"][key] = spec.defaultValue;
    EXPECT_NE(schema.complaint(parameter.dump()).empty(), schema.complaint(limit.dump()).empty()) << key;
  }
}

TEST(StudySchema, RefusesWhatTheReaderRefuses) {
  Schema schema("study-1");
  for (const test::BrokenStudy& row : test::brokenStudies()) {
    EXPECT_EQ(schema.complaint(test::broken(row)).empty(), !row.schemaSees) << row.patch;
  }
}
TEST(RunSchema, StillDescribesVersion1) { EXPECT_EQ(Schema("run-1").complaint(test::kRunRecordOfVersion1), ""); }

}  // namespace
}  // namespace glissade
