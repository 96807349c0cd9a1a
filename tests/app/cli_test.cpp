// Runs glissade-cli as a user would: exit codes, messages, JSON, files.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "engine/base/quantity_text.h"
#include "tests/engine/support/directories.h"
#include "tests/engine/support/part_fixture.h"
#include "tests/engine/support/step_files.h"

namespace {

namespace fs = std::filesystem;
namespace test = glissade::test;
using Json = nlohmann::json;

struct Finished {
  int exitCode = -1;
  std::string out;
  std::string err;
};

class Cli : public testing::Test {
 protected:
  void SetUp() override {
    folder = fs::path(testing::TempDir()) /
             ("glissade-cli-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  Finished run(const std::string& arguments) const {
    const std::string err = (folder / "stderr").string();
    const std::string command = test::programDirectory() + "/glissade-cli " + arguments + " 2>" + err;
    Finished result;
    FILE* pipe = popen(command.c_str(), "r");
    std::array<char, 4096> buffer{};
    std::size_t count = 0;
    while ((count = fread(buffer.data(), 1, buffer.size(), pipe)) > 0) result.out.append(buffer.data(), count);
    result.exitCode = WEXITSTATUS(pclose(pipe));
    result.err = read(err);
    return result;
  }

  /// The motions of all steps of a plan.
  static Json motionsIn(const Json& plan) {
    Json motions = Json::array();
    for (const Json& step : plan["steps"])
      motions.insert(motions.end(), step["motions"].begin(), step["motions"].end());
    return motions;
  }

  /// "valid", "incomplete", ...
  std::string verdictOn(const std::string& product, const std::string& plan) const {
    return Json::parse(run("check " + product + " " + plan + " --json").out).value("verdict", "");
  }

  static std::string read(const fs::path& file) {
    std::ifstream stream(file);
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
  }
  std::string write(const std::string& name, const std::string& content) const {
    std::ofstream(folder / name, std::ios::binary) << content;
    return (folder / name).string();
  }
  static std::string sample(const std::string& name) {
    return test::sourceDirectory() + "/samples/" + name + "/scenario.json";
  }

  /// A scenario of primitives, changed by `change`.
  std::string scenario(const std::function<void(Json&)>& change) const {
    Json json = Json::parse(R"({
      "format": "glissade-scenario", "version": 1, "name": "t",
      "bodies": [{"id": "wall", "geometry": {"box": [1, 1, 1]}}],
      "object": {"id": "cube", "geometry": {"box": [0.2, 0.2, 0.2]}},
      "start": {"position": [-1, 0, 0], "orientation": [0, 0, 0, 1]},
      "goal": {"position": [1, 0, 0], "orientation": [0, 0, 0, 1]},
      "workspace": {"min": [-2, -2, -2], "max": [2, 2, 2]},
      "planner": "birrt"})");
    change(json);
    return write("scenario.json", json.dump());
  }

  fs::path folder;
};

TEST_F(Cli, PlansCertifiesAndChecks) {
  const std::string file = scenario([](Json&) {});
  const Finished plan = run("plan " + file + " --seed 3 --json --out " + (folder / "path.csv").string());
  ASSERT_EQ(plan.exitCode, 0) << plan.err;
  const Json report = Json::parse(plan.out);
  for (const char* key : {"solved", "status", "strategy", "wall_s", "planning_s", "virtual_s", "nodes", "edges",
                          "iterations", "random_configurations", "operator_configurations", "contact_configurations",
                          "collision_queries", "distance_queries", "path", "certificate", "seed", "version"}) {
    EXPECT_TRUE(report.contains(key)) << key;
  }
  EXPECT_EQ(report["solved"], true);
  EXPECT_EQ(report["seed"], 3);
  EXPECT_EQ(report["edges"], 2 * report["nodes"].get<int>() - 2);
  EXPECT_EQ(report["certificate"]["status"], "certified");
  EXPECT_EQ(report["certificate"]["surface_deviation_m"], 0.0);
  for (const std::string ending : {"csv", "path", "json"}) {
    const std::string path = (folder / ("again." + ending)).string();
    ASSERT_EQ(run("plan " + file + " --seed 3 --out " + path).exitCode, 0);
    const Finished check = run("check " + file + " " + path + " --json");
    EXPECT_EQ(check.exitCode, 0) << ending << check.out << check.err;
    EXPECT_EQ(Json::parse(check.out)["valid"], true);
  }
}

TEST_F(Cli, BothCollisionBackendsPlanTheSamePathAndBothCertifyIt) {
  const std::string file = scenario([](Json&) {});
  std::map<std::string, std::string> paths;
  for (const std::string backend : {"kernel", "fcl"}) {
    const std::string path = (folder / (backend + ".csv")).string();
    const Finished plan = run("plan " + file + " --seed 3 --collision " + backend + " --json --out " + path);
    ASSERT_EQ(plan.exitCode, 0) << backend << plan.err;
    EXPECT_EQ(Json::parse(plan.out)["certificate"]["status"], "certified") << backend;
    EXPECT_EQ(run("check " + file + " " + path).exitCode, 0) << backend;
    paths[backend] = read(path);
  }
  EXPECT_FALSE(paths["fcl"].empty());
  EXPECT_EQ(paths["fcl"], paths["kernel"]);
}

TEST_F(Cli, AnUnknownCollisionBackendIsOneClearErrorOfUsage) {
  const Finished plan = run("plan " + scenario([](Json&) {}) + " --collision bullet");
  EXPECT_EQ(plan.exitCode, 2);
  EXPECT_EQ(plan.out, "");
  EXPECT_NE(plan.err.find("--collision"), std::string::npos) << plan.err;
  EXPECT_NE(plan.err.find("kernel"), std::string::npos) << plan.err;
  EXPECT_NE(plan.err.find("fcl"), std::string::npos) << plan.err;
  EXPECT_EQ(plan.err.find("--collision"), plan.err.rfind("--collision")) << plan.err;
}

TEST_F(Cli, ReportsWhatSetItself) {
  const std::string file = scenario([](Json& json) { json["planner"] = "contact-birrt"; });
  const Json report = Json::parse(run("plan " + file + " --operator expert --tuning 5 --alpha 0.3 --json").out);
  EXPECT_EQ(report["parameters"]["alpha"], 0.3);  // the user's own value
  for (const char* which : {"final", "median"}) {
    EXPECT_GT(report["tuning"][which]["alpha"], 0.5) << which;
    EXPECT_GT(report["tuning"][which]["contact_distance"], 0.0) << which;
    EXPECT_FALSE(report["tuning"][which].contains("contact_samples")) << which;
  }
  EXPECT_FALSE(Json::parse(run("plan " + file + " --operator expert --json").out).contains("tuning"));
}

/// Such a path was called valid once.
TEST_F(Cli, APathThatLeavesTheWorkspaceIsInvalidAndTheEdgeIsNamed) {
  const std::string file = scenario([](Json&) {});
  const auto path = [&](const std::string& y) {
    return write("far.path", "-1 0 0 0 0 0 1\n-1 " + y + " 0 0 0 0 1\n1 " + y + " 0 0 0 0 1\n1 0 0 0 0 0 1\n");
  };
  EXPECT_EQ(run("check " + file + " " + path("1.5")).exitCode, 0);
  for (const std::string y : {"2.1", "1e6", "1e9"}) {
    const Finished check = run("check " + file + " " + path(y) + " --json");
    EXPECT_EQ(check.exitCode, 1) << y;
    const Json report = Json::parse(check.out);
    EXPECT_EQ(report["valid"], false);
    EXPECT_EQ(report["outside_workspace"], 1);
    EXPECT_EQ(report["certificate"]["edge"], 0);
    EXPECT_NE(run("check " + file + " " + path(y)).out.find("edge 0: configuration 1"), std::string::npos);
  }
  for (const std::string y : {"1e12", "1e19", "1e300"}) {
    const Finished check = run("check " + file + " " + path(y));
    EXPECT_EQ(check.exitCode, 3) << y;
    EXPECT_NE(check.err.find("line 2"), std::string::npos) << check.err;
    EXPECT_NE(check.err.find("1e9 m"), std::string::npos) << check.err;
  }
}

/// The message was only "undecided" once.
TEST_F(Cli, APathThatCannotBeDecidedHasAReason) {
  const std::string file = scenario([](Json& json) { json["goal"]["orientation"] = {0, 0, 1, 0}; });
  const std::string turn = write("turn.path", "-1 0 0 0 0 0 1\n-1 1.5 0 0 0 1 0\n1 1.5 0 0 0 1 0\n1 0 0 0 0 1 0\n");
  const Finished check = run("check " + file + " " + turn);
  EXPECT_EQ(check.exitCode, 1);
  EXPECT_NE(check.out.find("undecided on edge 0: the edge turns by half a circle"), std::string::npos) << check.out;
  const Json json = Json::parse(run("check " + file + " " + turn + " --json").out);
  EXPECT_EQ(json["certificate"]["why_undecided"].get<std::string>().find("the edge turns"), 0U);
  const std::string straight = write("a.path", "-1 0 0 0 0 0 1\n-1 1.5 0 0 0 0 1\n");
  EXPECT_FALSE(
      Json::parse(run("check " + file + " " + straight + " --json").out)["certificate"].contains("why_undecided"));
  const Json far =
      Json::parse(run("check " + file + " " + write("far.path", "-1 0 0 0 0 0 1\n-1 2.1 0 0 0 0 1\n") + " --json").out);
  EXPECT_NE(far["certificate"]["why_undecided"].get<std::string>().find("workspace"), std::string::npos);
}

/// These inputs ended with exit code 70 once.
TEST_F(Cli, BytesThatAreNoUtf8AndControlCharactersDoNoHarm) {
  const std::string sound = scenario([](Json& json) { json["name"] = "red\x1b[31m"; });
  const std::string header = "index,s,x,y,z,qx,qy,qz,qw,clearance,contact,author\n";
  const std::string csv = write("bad.csv", header + "0,0,\xff\xfe\x1b[31m,0,0,0,0,0,1,1,0,operator\n");
  const Finished check = run("check " + sound + " " + csv + " --json");
  EXPECT_EQ(check.exitCode, 3) << check.err;
  EXPECT_EQ(Json::parse(check.out)["error"]["place"], "line 2");
  EXPECT_EQ((check.out + check.err).find('\x1b'), std::string::npos);

  const std::string odd = (folder / "n\xff\x1b[31m.json").string();
  fs::copy_file(sound, odd);
  EXPECT_EQ(run("info '" + odd + "' --json").exitCode, 0);
  const Finished info = run("info '" + odd + "'");
  EXPECT_EQ(info.exitCode, 0);
  EXPECT_EQ(info.out.find('\x1b'), std::string::npos);
  const std::string record = (folder / "run.json").string();
  const Finished plan = run("plan '" + odd + "' --json --out " + (folder / "p.json").string() + " --record " + record);
  EXPECT_EQ(plan.exitCode, 0) << plan.err;
  EXPECT_EQ(run("replay " + record + " --scenario '" + odd + "'").exitCode, 0);
  const Finished gone = run("info '" + odd + ".gone' --json");
  EXPECT_EQ(gone.exitCode, 3);
  EXPECT_EQ(gone.err.find('\x1b'), std::string::npos);
  EXPECT_TRUE(Json::accept(gone.out)) << gone.out;

  const std::string part = (folder / "part\xe9.obj").string();
  std::ofstream(part) << "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  const Finished made = run("new " + (folder / "made.json").string() + " --moves '" + part + "'");
  EXPECT_EQ(made.exitCode, 3);
  EXPECT_NE(made.err.find("UTF-8"), std::string::npos) << made.err;
}

/// Exit code 70 is only for defects of the program.
TEST_F(Cli, ATargetThatTakesNothingEndsWithExitCode3AndItsReason) {
  const std::string file = scenario([](Json&) {});
  ASSERT_EQ(::mkfifo((folder / "pipe.csv").c_str(), 0600), 0);
  fs::create_directory(folder / "folder.csv");
  const std::string within = write("file", "x") + "/a.csv";
  for (const std::string& target : {(folder / "none/a.csv").string(), (folder / "pipe.csv").string(),
                                    (folder / "folder.csv").string(), within, std::string("/proc/a.csv")}) {
    const Finished plan = run("plan " + file + " --out " + target);
    EXPECT_EQ(plan.exitCode, 3) << target << "\n" << plan.err;
    EXPECT_NE(plan.err.find("cannot be saved"), std::string::npos) << plan.err;
  }
  const Finished full = run("info " + file + " > /dev/full");
  EXPECT_EQ(full.exitCode, 3);
  EXPECT_NE(full.err.find("standard output: cannot be written: No space left on device"), std::string::npos)
      << full.err;
  EXPECT_EQ(run("info " + file + " --json > /dev/full").exitCode, 3);
}

TEST_F(Cli, LengthsBeyondTheLimitAreWrongUsage) {
  const std::string file = scenario([](Json&) {});
  EXPECT_EQ(run("plan " + file + " --contact-distance 1e12").exitCode, 2);
  EXPECT_EQ(run("new " + (folder / "made.json").string() + " --moves a.stl --unit 1e10").exitCode, 2);
}

/// The part has 24 mm in metres, as a CAD system without a choice of units writes it.
TEST_F(Cli, AUnitIsAnyLengthAndIsGuessedFromTheSizeWhereItIsNotGiven) {
  const std::string made = (folder / "made.json").string();
  const std::string part =
      write("a.obj", "v 0 0 0\nv .024 0 0\nv 0 .024 0\nv 0 0 .024\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  const auto unitOf = [&](const std::string& options) {
    const Finished run = this->run("new " + made + " --moves " + part + options);
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_EQ(run.err.find("does not say its unit") != std::string::npos, options.empty()) << run.err;
    return Json::parse(read(made))["assets"][0]["unit"].get<double>();
  };
  EXPECT_EQ(unitOf(""), 1.0);
  EXPECT_EQ(unitOf(" --unit 1m"), 1.0);
  EXPECT_EQ(unitOf(" --unit 1in"), 0.0254);
  EXPECT_EQ(unitOf(" --unit 25.4mm"), 0.0254);
  EXPECT_EQ(unitOf(" --unit '1 in'"), 0.0254);
  EXPECT_EQ(unitOf(" --unit 2cm"), 0.02);
  for (const char* wrong : {"in", "1 furlong", "1inm", "'1 in in'", "0mm", "-1mm"}) {
    EXPECT_EQ(run("new " + made + " --moves " + part + " --unit " + wrong).exitCode, 2) << wrong;
  }
}

/// The part is a box without its lid.
TEST_F(Cli, PlanarHolesAreClosedWhereThatIsAskedFor) {
  const std::string made = (folder / "made.json").string();
  const std::string part = write("open.obj",
                                 "v 0 0 0\nv 30 0 0\nv 30 30 0\nv 0 30 0\nv 0 0 30\nv 30 0 30\nv 30 30 30\nv 0 30 "
                                 "30\nf 4 3 2 1\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  const Finished open = run("new " + made + " --moves " + part);
  EXPECT_EQ(open.exitCode, 0) << open.err;
  EXPECT_NE(open.err.find("is not a closed surface"), std::string::npos) << open.err;
  EXPECT_EQ(Json::parse(run("info " + made + " --json").out)["object"]["closed"], false);
  const Finished closed = run("new " + made + " --moves " + part + " --close-holes");
  EXPECT_EQ(closed.exitCode, 0) << closed.err;
  EXPECT_NE(closed.err.find("had 1 planar hole, which was closed as asked for; 0 holes"), std::string::npos)
      << closed.err;
  const Finished info = run("info " + made + " --json");
  EXPECT_EQ(Json::parse(info.out)["object"]["closed"], true);
  EXPECT_NEAR(Json::parse(info.out)["object"]["volume_m3"].get<double>(), 2.7e-5, 1e-12);
  EXPECT_NE(info.err.find("planar hole"), std::string::npos) << "said whenever it is loaded";
}

TEST_F(Cli, APathThroughTheWallIsInvalid) {
  const std::string file = scenario([](Json&) {});
  const std::string path = write("through.path", "-1 0 0 0 0 0 1\n1 0 0 0 0 0 1\n");
  const Finished check = run("check " + file + " " + path + " --json");
  EXPECT_EQ(check.exitCode, 1);
  EXPECT_EQ(Json::parse(check.out)["valid"], false);
  EXPECT_EQ(Json::parse(check.out)["certificate"]["body"], "wall");
}

TEST_F(Cli, OmplsOneTreeLeavesTheStart) {
  EXPECT_EQ(run("plan " + sample("teaching") + " --strategy ompl-est --seed 2 --max-steps 10000").exitCode, 0);
}

TEST_F(Cli, LimitsHaveTheirExitCode) {
  const std::string closed = scenario([](Json& json) { json["bodies"][0]["geometry"]["box"] = {0.1, 9, 9}; });
  const Finished steps = run("plan " + closed + " --max-steps 50 --json");
  EXPECT_EQ(steps.exitCode, 5);
  EXPECT_EQ(Json::parse(steps.out)["status"], "limit-reached");
  EXPECT_EQ(run("plan " + closed + " --max-samples 50").exitCode, 5);
  EXPECT_EQ(run("plan " + closed + " --time-limit 0.2").exitCode, 5);
}

TEST_F(Cli, StartAndGoalInCollisionNameTheBody) {
  for (const char* end : {"start", "goal"}) {
    const Finished plan = run("plan " + scenario([&](Json& json) { json[end]["position"] = {0, 0, 0}; }));
    EXPECT_EQ(plan.exitCode, 4);
    EXPECT_NE(plan.err.find(end), std::string::npos) << plan.err;
    EXPECT_NE(plan.err.find("wall"), std::string::npos) << plan.err;
  }
}

TEST_F(Cli, BadInputGetsOneClearMessage) {
  struct Bad {
    const char* what;
    std::string file;
    const char* mentions;
  };
  const auto changed = [this](const char* name, const std::function<void(Json&)>& change) {
    fs::rename(scenario(change), folder / name);
    return (folder / name).string();
  };
  std::string stl(84, '\0');
  stl[83] = '\x28';  // the file claims 671 million triangles
  write("huge.stl", stl);
  write("broken.urdf",
        "<robot name='x'><link name='a'><collision><geometry><box size='1 1 oops'/></geometry>"
        "</collision></link></robot>");
  const auto withAsset = [](const char* path, const char* kind) {
    return [=](Json& json) {
      json["assets"] = {{{"id", "a"}, {"path", path}}};
      json["bodies"][0]["geometry"] = {{kind, "a"}};
    };
  };
  const std::vector<Bad> table{
      {"missing file", (folder / "nothing.json").string(), "nothing.json"},
      {"empty file", write("empty.json", ""), "empty"},
      {"folder", folder.string(), "regular file"},
      {"syntax", write("syntax.json", "{\n  \"format\": ,\n}"), "line 2"},
      {"unknown key", changed("key.json", [](Json& json) { json["gaol"] = 1; }), "/gaol"},
      {"missing mesh", changed("mesh.json", withAsset("no.stl", "mesh")), "no.stl"},
      {"not a mesh", changed("escape.json", withAsset("/etc/passwd", "mesh")), "is of a kind that is not read"},
      {"2 GB claimed by 84 bytes", changed("claim.json", withAsset("huge.stl", "mesh")), "claims"},
      {"broken URDF", changed("urdf.json", withAsset("broken.urdf", "urdf")), "broken.urdf"},
      {"NaN in a pose", write("nan.json", read(scenario([](Json&) {})).replace(0, 1, "{\"seed\": NaN, ")), "line 1"},
      {"overflow in a pose", changed("inf.json", [](Json& json) { json["start"]["position"][0] = "1e999"; }), "/start"},
      {"bad quaternion",
       changed("quat.json",
               [](Json& json) {
                 json["goal"]["orientation"] = {1, 1, 1, 1};
               }),
       "/goal"},
      {"parameter out of range", changed("alpha.json", [](Json& json) { json["parameters"]["alpha"] = 2; }), "alpha"},
  };
  for (const Bad& bad : table) {
    const Finished plan = run("plan " + bad.file + " --max-steps 1");
    EXPECT_EQ(plan.exitCode, 3) << bad.what << ": " << plan.err;
    EXPECT_NE(plan.err.find(bad.mentions), std::string::npos) << bad.what << ": " << plan.err;
    EXPECT_EQ(std::count(plan.err.begin(), plan.err.end(), '\n'), 1) << bad.what << ": " << plan.err;
  }
}

TEST_F(Cli, WrongUsage) {
  const std::string file = scenario([](Json&) {});
  EXPECT_EQ(run("").exitCode, 2);
  EXPECT_EQ(run("plan").exitCode, 2);
  EXPECT_EQ(run("plan " + file + " --frobnicate").exitCode, 2);
  EXPECT_EQ(run("plan " + file + " --alpha 3").exitCode, 2);
  EXPECT_EQ(run("plan " + file + " --strategy warp").exitCode, 2);
  EXPECT_EQ(run("plan " + file + " --operator ghost").exitCode, 2);
  EXPECT_EQ(run("--help").exitCode, 0);
  EXPECT_EQ(run("--version").exitCode, 0);
}

TEST_F(Cli, SpeaksTheLanguageThatIsAskedFor) {
  const std::string file = scenario([](Json&) {});
  const std::string english = run("info " + file).out;
  EXPECT_NE(english.find("\nseed       "), std::string::npos) << english;
  EXPECT_EQ(run("info " + file + " --language en").out, english);
  const std::string french = run("info " + file + " --language fr").out;
  EXPECT_NE(french.find("\ngraine         "), std::string::npos) << french;
  EXPECT_EQ(run("--language fr info " + file).out, french);
  EXPECT_EQ(run("info --language=fr " + file).out, french);
  EXPECT_EQ(run("info " + file + " --json --language fr").out, run("info " + file + " --json").out);

  const std::string wrong = run("plan " + file + " --language fr --strategy warp").err;
  EXPECT_NE(wrong.find("il n'y a pas de stratégie «\u00a0warp\u00a0»"), std::string::npos) << wrong;
  EXPECT_NE(run("plan --help --language fr").out.find("Fichier de scénario"), std::string::npos);
  EXPECT_EQ(run("info " + file + " --language de").exitCode, 2);
}

TEST_F(Cli, AnInteractiveRunReplaysBitByBit) {
  const std::string record = (folder / "run.json").string();
  const std::string first = (folder / "first.path").string();
  ASSERT_EQ(
      run("plan " + sample("environment-1") + " --operator expert --seed 5 --record " + record + " --out " + first)
          .exitCode,
      0);
  const std::string original = read(first);
  ASSERT_FALSE(original.empty());
  for (int i = 0; i < 3; ++i) {
    const std::string again = (folder / "again.path").string();
    const std::string recordAgain = (folder / "again.json").string();
    const Finished replay = run("plan " + sample("environment-1") + " --operator replay:" + record + " --record " +
                                recordAgain + " --out " + again);
    ASSERT_EQ(replay.exitCode, 0) << replay.err;
    EXPECT_EQ(read(again), original);
    EXPECT_EQ(read(recordAgain), read(record));
  }
}

TEST_F(Cli, AReplayIsComparedBitByBit) {
  const std::string record = (folder / "run.json").string();
  ASSERT_EQ(run("plan " + sample("environment-1") + " --operator novice --seed 3 --record " + record).exitCode, 0);
  const Finished same = run("replay " + record + " --json");
  ASSERT_EQ(same.exitCode, 0) << same.err;
  const Json report = Json::parse(same.out);
  EXPECT_EQ(report["same"], true);
  EXPECT_EQ(report["solved"], true);
  EXPECT_GT(report["checkpoints"].get<int>(), 1);

  Json altered = Json::parse(read(record));
  for (std::size_t i = 0; i < 200; ++i) {  // not every pose is checked
    Json& x = altered["operator_stream"][i][1];
    x = x.get<double>() + 1e-9;
  }
  EXPECT_EQ(run("replay " + write("damaged.json", altered.dump())).exitCode, 3) << "its checksum does not fit";
  altered.erase("checksum");
  const std::string other = write("other.json", altered.dump());
  const Finished different = run("replay " + other + " --scenario " + sample("environment-1") + " --json");
  ASSERT_EQ(different.exitCode, 1) << different.err;
  const Json difference = Json::parse(different.out)["difference"];
  EXPECT_EQ(difference["same_until"], 0);
  EXPECT_EQ(run("replay " + record + " --scenario " + sample("environment-2")).exitCode, 2);
  EXPECT_EQ(run("replay " + (folder / "none.json").string()).exitCode, 3);
}

TEST_F(Cli, ARecordedOperatorMeetsOtherParameters) {
  const std::string record = (folder / "run.json").string();
  ASSERT_EQ(run("plan " + sample("environment-1") + " --operator expert --record " + record).exitCode, 0);
  const Finished other =
      run("plan " + sample("environment-1") + " --operator replay:" + record + " --alpha 0.9 --max-steps 300 --json");
  const Json report = Json::parse(other.out);
  EXPECT_EQ(report["parameters"]["alpha"], 0.9);
  EXPECT_LE(report["steps"].get<int>(), 300);
  EXPECT_GT(report["nodes_by_author"]["computer"].get<int>(), report["nodes_by_author"]["operator"].get<int>());
}

TEST_F(Cli, TheRunOfAStrategyWithAPersonSaysWhatTheHandDidAndReplaysBitByBit) {
  const std::string record = (folder / "hand.json").string();
  const std::string first = (folder / "hand.csv").string();
  const std::string again = (folder / "again.csv").string();
  const std::string plan = "plan " + sample("environment-1") + " --strategy interactive --json ";
  const Json report = Json::parse(run(plan + "--operator novice --seed 4 --record " + record + " --out " + first).out);
  ASSERT_TRUE(report["solved"].get<bool>());
  EXPECT_GT(report["hand"]["shown"].get<int>(), 0);
  EXPECT_LE(report["hand"]["moved_to_contact"].get<int>(), report["hand"]["in_collision"].get<int>());
  EXPECT_EQ(run("replay " + record).exitCode, 0);
  EXPECT_EQ(run(plan + "--operator replay:" + record + " --out " + again).exitCode, 0);
  EXPECT_EQ(read(first), read(again));
  EXPECT_EQ(run("check " + sample("environment-1") + " " + first).exitCode, 0);
  // Without a person the report has no hand. In the next run a person follows the path of another run.
  EXPECT_FALSE(Json::parse(run(plan + "--seed 4").out).contains("hand"));
  const Json shown = Json::parse(run(plan + "--operator task-expert --seed 5 --way " + first).out);
  EXPECT_TRUE(shown["solved"].get<bool>());
  EXPECT_GT(shown["hand"]["shown"].get<int>(), 0);
}

TEST_F(Cli, SharesOfTheAuthorsAddUp) {
  const Finished plan = run("plan " + sample("environment-1") + " --operator expert --json");
  ASSERT_EQ(plan.exitCode, 0) << plan.err;
  const Json report = Json::parse(plan.out);
  int nodes = 0;
  double path = 0.0;
  for (const char* author : {"computer", "operator", "contact"}) {
    nodes += report["nodes_by_author"][author].get<int>();
    path += report["path_share_by_author"][author].get<double>();
  }
  EXPECT_EQ(nodes, report["nodes"].get<int>());
  EXPECT_NEAR(path, 1.0, 1e-9);
}

TEST_F(Cli, InfoTellsWhatIsThere) {
  const Finished info = run("info " + sample("environment-1") + " --json");
  ASSERT_EQ(info.exitCode, 0) << info.err;
  const Json report = Json::parse(info.out);
  EXPECT_EQ(report["bodies"].size(), 10U);
  for (const Json& body : report["bodies"]) EXPECT_EQ(body["closed"], true);
  EXPECT_NEAR(report["object"]["radius_m"].get<double>(), 1.536, 0.001);
}

/// The command lists assemblies with their numbers of bodies and attributes, and the bodies of a group.
TEST_F(Cli, InfoListsTheAssembliesAndTheBodiesOfAGroup) {
  const std::string product = glissade::test::stepFile("unit.step");
  const Finished file = run("info " + product);
  ASSERT_EQ(file.exitCode, 0) << file.err;
  EXPECT_NE(file.out.find("\nassemblies\n  pump  2 bodies\n"), std::string::npos) << file.out;
  const std::string made = (folder / "group.json").string();
  ASSERT_EQ(
      run("new " + made + " --moves " + product + ":pin --moves " + product + ":pin#2 --static " + product).exitCode,
      0);
  Json json = Json::parse(read(made));
  json.erase("checksum");
  json["product"] = {{{"id", "pump"}, {"name", "Pump / 1"}, {"attributes", {{"fragile", true}}}}};
  std::ofstream(made) << json;
  const Finished text = run("info " + made);
  ASSERT_EQ(text.exitCode, 0) << text.err;
  EXPECT_NE(text.out.find("  Pump / 1  2 bodies  fragile yes\n"), std::string::npos) << text.out;
  const Json report = Json::parse(run("info " + made + " --json").out);
  EXPECT_EQ(report["assemblies"].size(), 1U);
  EXPECT_EQ(report["assemblies"][0]["bodies"], 2);
  EXPECT_EQ(report["assemblies"][0]["attributes"]["fragile"], true);
  ASSERT_EQ(report["object"]["with"].size(), 2U);
  EXPECT_EQ(report["object"]["with"][1]["id"], "pin#2");
  json["product"][0]["id"] = "pumpe";
  std::ofstream(made) << json;
  const Finished wrong = run("info " + made);
  EXPECT_EQ(wrong.exitCode, 3);
  EXPECT_NE(wrong.err.find("/product/0/id"), std::string::npos) << wrong.err;
}

TEST_F(Cli, AMilestoneOutsideOfTheWorkspaceIsOneErrorWithItsFile) {
  const std::string edited = scenario([](Json& json) {
    Json pose = json["goal"];
    pose["position"] = {50, 0, 0};
    json["milestones"] = {{{"at", {1, 1, 0.3}}, {"pose", pose}}};
    json["planner"] = "gts";
  });
  const Finished run = this->run("plan " + edited);
  EXPECT_EQ(run.exitCode, 3);
  EXPECT_NE(run.err.find(edited + ": /milestones/0: the milestone lies outside the workspace. Put it inside"),
            std::string::npos)
      << run.err;
}

TEST_F(Cli, AnEditOfNoPlaceIsWarnedOfAndChangesNothingElse) {
  const std::string edited = scenario([](Json& json) {
    json["places"] = {{{"at", {5, 5, 5}}, {"attributes", {{"preference", 2.0}}}}};
    json["milestones"] = {{{"at", {9, 9, 9}}, {"pose", json["goal"]}}};
  });
  for (const std::string& command : {"info --places " + edited, "plan " + edited}) {
    const Finished run = this->run(command);
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_NE(run.err.find("warning: " + edited + ": /places/0: lies in no place"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("warning: " + edited + ": /milestones/0: lies in no border"), std::string::npos) << run.err;
  }
  EXPECT_EQ(run("info --places " + sample("teaching")).err, "");
}

TEST_F(Cli, AProhibitionOfNoPlaceIsNotDropped) {
  const std::string edited = scenario([](Json& json) {
    json["places"] = {{{"at", {5, 5, 5}}, {"attributes", {{"forbidden", true}}}}};
  });
  const Finished plan = run("plan " + edited);
  EXPECT_EQ(plan.exitCode, 3);
  EXPECT_NE(plan.err.find("/places/0: forbids a place that is not there"), std::string::npos) << plan.err;
}

/// A person has written the file, which forbids a place and does not state its region.
TEST_F(Cli, AForbiddenPlaceThatTheFileDoesNotLocateIsJudged) {
  Json json = Json::parse(read(sample("teaching")));
  json.erase("checksum");
  json["parameters"]["max_steps"] = 2000;
  json["places"] = {{{"at", {1.35, 0.945, 0.3}}, {"attributes", {{"forbidden", true}}}},
                    {{"at", {0.36, 0.945, 0.3}}, {"attributes", {{"forbidden", true}}}}};
  const std::string forbidden = write("forbidden.json", json.dump());
  const auto pathOf = [&](const char* name, const std::vector<std::array<double, 3>>& positions) {
    std::ostringstream text;
    for (const auto& [x, y, z] : positions) text << x << " " << y << " " << z << " 0 0 0 1\n";
    return write(name, text.str());
  };
  const auto judged = [&](const std::string& file, const std::string& path) {
    return run("check " + file + " " + path);
  };
  const std::string through = pathOf("through.path", {{0.35, 0.35, 0.3}, {1.35, 0.5, 0.3}, {1.35, 1.2, 0.3}});
  const Finished refused = judged(forbidden, through);
  EXPECT_EQ(refused.exitCode, 1);
  EXPECT_NE(refused.out.find("meets the forbidden place"), std::string::npos) << refused.out;
  EXPECT_NE(refused.err.find("/forbidden_regions: is missing"), std::string::npos) << refused.err;

  const Finished beside = judged(forbidden, pathOf("beside.path", {{0.35, 0.35, 0.3}, {1.35, 0.5, 0.3}}));
  EXPECT_NE(beside.out.find("forbidden places: the path keeps"), std::string::npos) << beside.out;

  const Finished sequence = run("sequence " + forbidden + " --time-limit 1");
  EXPECT_NE(sequence.err.find("forbids places to the path of its object"), std::string::npos) << sequence.err;

  // The path lies on the floor of the workspace, which is a face of both places.
  json["start"]["position"] = {1.35, 0.5, 0.0};
  json["goal"]["position"] = {1.35, 1.2, 0.0};
  const std::string floor = write("floor.json", json.dump());
  const Finished plan = run("plan " + floor + " --strategy auto --seed 1");
  EXPECT_EQ(plan.exitCode, 5) << "the limit of steps: " << plan.out;
  EXPECT_NE(plan.err.find("forbidden: P"), std::string::npos) << plan.err;
  EXPECT_EQ(judged(floor, pathOf("floor.path", {{1.35, 0.5, 0.0}, {1.35, 1.2, 0.0}})).exitCode, 1);

  json["places"][0]["at"] = {9, 9, 9};
  const Finished nowhere = judged(write("nowhere.json", json.dump()), through);
  EXPECT_EQ(nowhere.exitCode, 3);
  EXPECT_NE(nowhere.err.find("forbids a place that is not there"), std::string::npos) << nowhere.err;
}

TEST_F(Cli, ConvertsPathsBackAndForth) {
  const std::string file = scenario([](Json&) {});
  const std::string csv = (folder / "a.csv").string();
  const std::string ompl = (folder / "b.path").string();
  const std::string json = (folder / "c.json").string();
  const std::string back = (folder / "d.path").string();
  ASSERT_EQ(run("plan " + file + " --out " + csv).exitCode, 0);
  ASSERT_EQ(run("convert " + csv + " " + ompl).exitCode, 0);
  ASSERT_EQ(run("convert " + ompl + " " + json + " --scenario " + file).exitCode, 0);
  ASSERT_EQ(run("convert " + json + " " + back).exitCode, 0);
  EXPECT_EQ(read(back), read(ompl));
  EXPECT_EQ(run("convert " + ompl + " " + csv).exitCode, 2) << "a CSV holds clearances: it needs the scenario";
}

TEST_F(Cli, WritesAnAnimationThatItDoesNotTakeForAPath) {
  const std::string file = scenario([](Json&) {});
  const std::string csv = (folder / "a.csv").string();
  const std::string planned = (folder / "planned.glb").string();
  const std::string converted = (folder / "converted.GLB").string();
  ASSERT_EQ(run("plan " + file + " --seed 3 --out " + csv).exitCode, 0);
  ASSERT_EQ(run("plan " + file + " --seed 3 --out " + planned).exitCode, 0);
  EXPECT_EQ(read(planned).substr(0, 4), "glTF");
  EXPECT_EQ(run("convert " + csv + " " + converted).exitCode, 2) << "it holds the bodies: it needs the scenario";
  ASSERT_EQ(run("convert " + csv + " " + converted + " --scenario " + file).exitCode, 0);
  EXPECT_EQ(read(converted).substr(0, 4), "glTF");
  EXPECT_EQ(run("smooth " + file + " " + csv + " " + converted).exitCode, 0);
  const Finished check = run("check " + file + " " + planned);
  EXPECT_EQ(check.exitCode, 3);
  EXPECT_NE(check.err.find("can only be written"), std::string::npos) << check.err;
}

TEST_F(Cli, AnUnknownEndingIsRefusedBeforeAnythingIsDone) {
  const std::string file = scenario([](Json&) {});
  const std::string path = write("a.path", "-1 0 0 0 0 0 1\n-1 0 0.1 0 0 0 1\n");
  const std::vector<std::string> commands{"plan " + file + " --out x.xyz", "plan gone.json --out x",
                                          "smooth " + file + " " + path + " x.xyz", "convert " + path + " x.xyz"};
  for (const std::string& command : commands) {
    const Finished refused = run(command);
    EXPECT_EQ(refused.exitCode, 2) << command;
    EXPECT_EQ(refused.out, "") << command;
    for (const char* ending : {".csv", ".json", ".path", ".glb"}) {
      EXPECT_NE(refused.err.find(ending), std::string::npos) << command << ": " << refused.err;
    }
  }
  for (const char* command : {"plan", "smooth", "convert"}) {
    EXPECT_NE(run(std::string(command) + " --help").out.find(".glb"), std::string::npos) << command;
  }
  EXPECT_EQ(run("check --help").out.find(".glb"), std::string::npos) << "it cannot be read";
}

TEST_F(Cli, MakesAScenarioOfPartsAndTakesOneOut) {
  const glissade::test::TrayProduct product;
  const std::string made = (folder / "tray.json").string();
  const std::string block = product.writeBlock("resting.obj", {0.0, 0.0, -7.5});  // on the tray's floor
  const std::string parts = " --moves " + block + " --static " + product.tray;
  ASSERT_EQ(run("new " + made + parts).exitCode, 0);
  EXPECT_EQ(run("plan " + made).exitCode, 0) << "they touch, which is a fit";
  EXPECT_EQ(run("plan " + made + " --fits off").exitCode, 4) << "they touch";
  ASSERT_EQ(run("new " + made + parts + " --fits off").exitCode, 0);
  EXPECT_EQ(run("plan " + made).exitCode, 4);
  EXPECT_EQ(run("plan " + made + " --fits on").exitCode, 0);
  const Finished clear = run("new " + made + parts + " --clear");
  ASSERT_EQ(clear.exitCode, 0) << clear.err;
  EXPECT_NE(clear.out.find("start moved clear by"), std::string::npos) << clear.out;
  EXPECT_EQ(run("plan " + made).exitCode, 0);
  EXPECT_EQ(run("new " + made + " --moves gone.stl").exitCode, 3);
  EXPECT_EQ(run("new " + made).exitCode, 2);
  EXPECT_EQ(run("new " + made + parts + " --up x").exitCode, 2);
}

TEST_F(Cli, AProductInOneStepFileIsPlannedPartByPart) {
  const std::string made = (folder / "product.json").string();
  const std::string path = (folder / "product.csv").string();
  const std::string unit = glissade::test::stepFile("unit.step");
  const Finished fresh = run("new " + made + " --moves " + unit + ":pin --static " + unit + " --deflection 0.1mm");
  ASSERT_EQ(fresh.exitCode, 0) << fresh.err;
  const Json info = Json::parse(run("info " + made + " --json").out);
  ASSERT_EQ(info["bodies"].size(), 4U);
  EXPECT_EQ(info["bodies"][1]["name"], "pin#2");
  const double pin = info["object"]["deflection_m"];
  double largest = 0.0;
  for (const Json& body : info["bodies"]) largest = std::max<double>(largest, body["deflection_m"]);
  EXPECT_GT(pin, 0.0);
  EXPECT_LE(std::max(pin, largest), 1e-4);
  EXPECT_EQ(info["object"]["closed"], true);
  const Json file = Json::parse(run("info " + unit + " --json").out);
  EXPECT_EQ(file["bodies"].size(), 5U);
  EXPECT_LT(file["meshes"], 5U) << "the pins share their mesh";
  EXPECT_EQ(run("info " + unit + " --places").exitCode, 2);
  const Finished part = run("plan " + unit);
  EXPECT_EQ(part.exitCode, 2);
  EXPECT_NE(part.err.find("glissade-cli new"), std::string::npos) << part.err;
  EXPECT_NE(run("info " + made).out.find("mm of its surface"), std::string::npos);
  const Finished plan = run("plan " + made + " --out " + path);
  ASSERT_EQ(plan.exitCode, 0);
  std::ostringstream deviation;
  deviation << "CAD accuracy of the certificate: +/- " << glissade::inMillimetres(pin + largest);
  EXPECT_NE(plan.out.find(deviation.str()), std::string::npos) << plan.out;
  const Json check = Json::parse(run("check " + made + " " + path + " --json").out);
  EXPECT_EQ(check["valid"], true);
  EXPECT_NEAR(check["certificate"]["surface_deviation_m"], pin + largest, 1e-15);
  const Finished wrong = run("new " + made + " --moves " + unit + ":pim");
  EXPECT_EQ(wrong.exitCode, 3);
  EXPECT_NE(wrong.err.find("plate, pin, pin#2"), std::string::npos) << wrong.err;
  EXPECT_EQ(run("new " + made + " --moves " + unit + " --deflection 0").exitCode, 2);
  EXPECT_EQ(run("fits " + unit + " --deflection 0").exitCode, 2);
  EXPECT_EQ(run("fits " + unit + " --deflection 0.02mm").exitCode, 0);
  EXPECT_EQ(run("fits " + made + " --deflection 0.02mm").exitCode, 2);
}

TEST_F(Cli, TwoRevisionsAreComparedAndStepsThatHoldAreKept) {
  const std::string scenarioOfOld = R"({
    "format": "glissade-scenario", "version": 1, "name": "t", "planner": "birrt", "fits": {"mode": "on"},
    "bodies": [{"id": "base", "geometry": {"box": [0.2, 0.2, 0.02]}},
               {"id": "post", "geometry": {"box": [0.02, 0.02, 0.1]},
                "pose": {"position": [0.05, 0, 0.06], "orientation": [0, 0, 0, 1]}}],
    "object": {"id": "lid", "geometry": {"box": [0.1, 0.1, 0.01]}},
    "start": {"position": [0.05, 0, 0.115], "orientation": [0, 0, 0, 1]},
    "goal": {"position": [0.5, 0, 0.5], "orientation": [0, 0, 0, 1]},
    "workspace": {"min": [-2, -2, -2], "max": [2, 2, 2]}})";
  const std::string old = write("old.json", scenarioOfOld);
  const std::string plan = (folder / "plan.json").string();
  ASSERT_EQ(run("sequence " + old + " --out " + plan).exitCode, 0);
  EXPECT_EQ(run("compare " + old + " " + old + " --plan " + plan).exitCode, 0);

  Json revised = Json::parse(scenarioOfOld);
  revised["bodies"].push_back({{"id", "roof"},
                               {"geometry", {{"box", {0.15, 0.15, 0.01}}}},
                               {"pose", {{"position", {0.145, 0, 0.14}}, {"orientation", {0, 0, 0, 1}}}}});
  const std::string now = write("now.json", revised.dump());
  EXPECT_EQ(run("compare " + old + " " + now).exitCode, 1);
  const Finished compared = run("compare " + old + " " + now + " --plan " + plan + " --json");
  EXPECT_EQ(compared.exitCode, 1);
  const Json report = Json::parse(compared.out);
  EXPECT_EQ(report["came"], Json({"roof"}));
  EXPECT_EQ(report["without_step"], Json({"roof"}));
  std::map<std::string, bool> holds;
  for (const Json& step : report["steps"]) holds[step["bodies"][0]] = step["holds"];
  EXPECT_EQ(holds, (std::map<std::string, bool>{{"lid", false}, {"post", true}}));

  Json renamed = Json::parse(scenarioOfOld);
  renamed["bodies"][1]["id"] = "column";
  const Finished ofRenamed =
      run("compare " + old + " " + write("renamed.json", renamed.dump()) + " --plan " + plan + " --json");
  EXPECT_EQ(ofRenamed.exitCode, 0) << ofRenamed.out;
  EXPECT_EQ(Json::parse(ofRenamed.out)["renamed"][0]["now"], "column");

  const std::string again = (folder / "again.json").string();
  EXPECT_EQ(run("sequence " + now + " --reuse " + plan + " --out " + again).exitCode, 0);
  EXPECT_EQ(run("check " + now + " " + again).exitCode, 0);
  EXPECT_EQ(run("compare " + old + " " + now + " --plan " + again).exitCode, 3) << "a plan of another product";
}

TEST_F(Cli, PartsThatFitComeOutAndTheAllowanceIsStated) {
  const std::string made = (folder / "screw.json").string();
  const std::string path = (folder / "screw-path.json").string();
  const std::string product = glissade::test::stepFile("fits.step");
  ASSERT_EQ(run("new " + made + " --moves " + product + ":screw --static " + product).exitCode, 0);
  const Finished plan = run("plan " + made + " --strategy auto --out " + path + " --json");
  ASSERT_EQ(plan.exitCode, 0) << plan.err;
  const Json report = Json::parse(plan.out);
  const std::string pulled = report["pulled_threads"].at(0);
  EXPECT_NE(pulled.find("not for assembly: the path pulls 'screw' through the thread of 'plate'"), std::string::npos);
  const Json allowances = report["certificate"]["allowances"];
  ASSERT_EQ(allowances.size(), 1U) << allowances;
  EXPECT_EQ(allowances[0]["object"], "screw");
  EXPECT_EQ(allowances[0]["kind"], "thread");
  EXPECT_NEAR(allowances[0]["overlap_m"].get<double>(), 4e-4, 2.4e-5) << "of triangles";
  EXPECT_GT(allowances[0]["allowance_m"].get<double>(), 4e-4);
  EXPECT_EQ(Json::parse(read(path))["certificate"]["allowances"], allowances);

  const Finished check = run("check " + made + " " + path);
  EXPECT_EQ(check.exitCode, 0) << check.out;
  EXPECT_NE(check.out.find("'plate', 0.4"), std::string::npos) << check.out;
  EXPECT_NE(check.out.find("not for assembly: 'screw' is pulled off 'plate'"), std::string::npos) << check.out;
  EXPECT_NE(check.out.find("mm on 'screw' (overlap 0.4"), std::string::npos) << check.out;
  EXPECT_EQ(run("check " + made + " " + path + " --fits off").exitCode, 1) << "the whole screw does not come out";
  EXPECT_EQ(run("plan " + made + " --fits off").exitCode, 4);
  EXPECT_EQ(run("plan " + made + " --fits auto").exitCode, 2);
}

/// Names and shapes make the nut a thread. What a person says of the joint counts for both commands.
TEST_F(Cli, ABoltThatIsPulledThroughItsNutIsSaidByPlanAndCheck) {
  const std::string made = (folder / "bolt.json").string();
  const std::string path = (folder / "bolt.csv").string();
  const std::string product = glissade::test::stepFile("bolt-and-nut.step");
  ASSERT_EQ(run("new " + made + " --moves " + product + ":bolt --static " + product).exitCode, 0);
  const auto saysBoth = [&] {
    const Finished plan = run("plan " + made + " --strategy auto --out " + path);
    EXPECT_EQ(plan.exitCode, 0) << plan.err;
    const Finished check = run("check " + made + " " + path);
    EXPECT_EQ(check.exitCode, 0) << check.out;
    const bool planSays = plan.out.find("not for assembly") != std::string::npos;
    EXPECT_EQ(check.out.find("not for assembly") != std::string::npos, planSays) << plan.out << check.out;
    return planSays;
  };
  EXPECT_TRUE(saysBoth());
  Json scenario = Json::parse(read(made));
  const std::string nut = scenario["bodies"].back()["id"];
  scenario.erase("checksum");
  scenario["joints"] = {{{"kind", "nut"}, {"body", nut}, {"others", {"bolt"}}, {"word", "dissolved"}}};
  std::ofstream(made) << scenario;
  EXPECT_FALSE(saysBoth()) << "the joint is dissolved";
  scenario.erase("joints");
  scenario["sequence"]["joint_use"] = "off";
  std::ofstream(made) << scenario;
  EXPECT_FALSE(saysBoth()) << "no joints are used";
}

/// Nothing shows a thread in a hole that is as wide as the shaft.
TEST_F(Cli, ABoltInAPlainHoleIsNoThreadForPlanAndCheck) {
  const std::string made = (folder / "bolt.json").string();
  const std::string path = (folder / "path.json").string();
  const std::string product = glissade::test::stepFile("bolt-in-plate.step");
  ASSERT_EQ(run("new " + made + " --moves " + product + ":bolt --static " + product).exitCode, 0);
  const Finished plan = run("plan " + made + " --strategy auto --out " + path);
  EXPECT_EQ(plan.exitCode, 0) << plan.err;
  const Finished check = run("check " + made + " " + path);
  EXPECT_EQ(check.exitCode, 0) << check.out;
  EXPECT_EQ((plan.out + check.out).find("not for assembly"), std::string::npos) << plan.out << check.out;
}

TEST_F(Cli, APathWithoutAShapeThatTheFileStatesHoldsOnACondition) {
  const std::string made = (folder / "bolt.json").string();
  const std::string path = (folder / "path.json").string();
  const std::string product = glissade::test::stepFile("bolt-and-nut.step");
  ASSERT_EQ(run("new " + made + " --moves " + product + ":plate --static " + product).exitCode, 0);
  Json scenario = Json::parse(read(made));
  scenario.erase("checksum");
  ASSERT_EQ(scenario["bodies"].size(), 2U);
  scenario["bodies"].erase(1);
  std::ofstream(made) << scenario;
  for (const std::string& command : {"plan " + made + " --strategy auto --out " + path, "check " + made + " " + path,
                                     "smooth " + made + " " + path + " " + path}) {
    const Finished end = run(command);
    EXPECT_EQ(end.exitCode, 7) << command << end.out << end.err;
    EXPECT_NE(end.out.find("without these shapes, which the file states"), std::string::npos) << end.out;
  }
}

/// No standard thread has the pitch that is taken for a bolt of 254 mm, as in a file with wrong units: both commands
/// ask for a person's word.
TEST_F(Cli, WhatOnlyThePlanStatesIsAConditionOfSequenceAndCheck) {
  const std::string product = glissade::test::stepFile("large-bolt-and-nut.step");
  const std::string plan = (folder / "plan.json").string();
  const Finished sequence = run("sequence " + product + " --out " + plan);
  EXPECT_EQ(sequence.exitCode, 7) << sequence.out;
  const Finished check = run("check " + product + " " + plan);
  EXPECT_EQ(check.exitCode, 7) << check.out;
  const std::string condition = "condition: the thread of 'nut' in 'bolt' has a pitch of 6 mm";
  EXPECT_NE(sequence.out.find(condition), std::string::npos) << sequence.out;
  EXPECT_NE(check.out.find(condition), std::string::npos) << check.out;
}

/// The thread takes a fifth of the wall of the nut, which is unscrewed over the end of the bolt that protrudes.
TEST_F(Cli, ANutWithTheHoleForItsTapIsUnscrewedOverTheEndOfItsBolt) {
  const std::string product = glissade::test::stepFile("tapped-nut.step");
  const std::string plan = (folder / "plan.json").string();
  const Finished sequence = run("sequence " + product + " --out " + plan);
  EXPECT_EQ(sequence.exitCode, 0) << sequence.out;
  EXPECT_NE(sequence.out.find("base: plate"), std::string::npos) << sequence.out;
  EXPECT_NE(sequence.out.find("2 of 2 parts removed"), std::string::npos) << sequence.out;
  EXPECT_NE(sequence.out.find("tool: socket 8"), std::string::npos) << sequence.out;
  const Finished check = run("check " + product + " " + plan);
  EXPECT_EQ(check.exitCode, 0) << check.out;
}

TEST_F(Cli, WhereNoPathIsFoundThoseThatHoldTheObjectAreNamed) {
  const std::string made = (folder / "bracket.json").string();
  const std::string product = glissade::test::stepFile("fits.step");
  ASSERT_EQ(run("new " + made + " --moves " + product + ":bracket --static " + product).exitCode, 0);
  const Finished plan = run("plan " + made + " --max-steps 500");
  ASSERT_EQ(plan.exitCode, 5) << plan.err;
  EXPECT_NE(plan.out.find("held at its start by 'plate', 'bolt'"), std::string::npos) << plan.out;
  const Json report = Json::parse(run("plan " + made + " --max-steps 500 --json").out);
  EXPECT_EQ(report["blocked_by"], Json({"plate", "bolt"}));
}

TEST_F(Cli, AClashIsAcceptedByAPersonOnly) {
  const std::string made = (folder / "block.json").string();
  const std::string product = glissade::test::stepFile("fits.step");
  const Finished fresh = run("new " + made + " --moves " + product + ":block --static " + product);
  ASSERT_EQ(fresh.exitCode, 0);
  EXPECT_NE(fresh.err.find("clash"), std::string::npos) << fresh.err;
  const Finished refused = run("plan " + made + " --strategy auto");
  EXPECT_EQ(refused.exitCode, 4);
  EXPECT_NE(refused.err.find("--accept-clashes 3mm"), std::string::npos) << refused.err;
  EXPECT_EQ(run("plan " + made + " --accept-clashes -1mm").exitCode, 2);
  Json scenario = Json::parse(read(made));
  scenario.erase("checksum");
  scenario["fits"]["pairs"] = {{{"a", "block"}, {"b", "washer"}}};
  const Finished unknown = run("plan " + write("unknown.json", scenario.dump()));
  EXPECT_EQ(unknown.exitCode, 3);
  EXPECT_NE(unknown.err.find("/fits/pairs/0"), std::string::npos) << unknown.err;
}

/// A plan cannot leave a body out by itself: the check needs the same option.
TEST_F(Cli, WhatAPersonLeavesOutIsNotThere) {
  const std::string product = glissade::test::stepFile("fits.step");
  const std::string plan = (folder / "plan.json").string();
  const Finished found = run("sequence " + product + " --without block --json --out " + plan);
  ASSERT_EQ(found.exitCode, 0) << found.err;
  EXPECT_NE(found.err.find("'block': is excluded"), std::string::npos) << found.err;
  EXPECT_EQ(Json::parse(found.out)["parts"], 5) << "the dowel that is pressed in stays with the plate";
  EXPECT_EQ(run("check " + product + " " + plan).exitCode, 1) << "the block is there";
  const Finished check = run("check " + product + " " + plan + " --without block");
  EXPECT_EQ(check.exitCode, 0) << check.out << check.err;
  EXPECT_NE(check.err.find("'block': is excluded"), std::string::npos) << check.err;
  const Json fits = Json::parse(run("fits " + product + " --without block --json").out);
  EXPECT_EQ(fits["counts"].count("clash"), 0U) << fits["counts"];
  const std::string made = (folder / "screw.json").string();
  const Finished without =
      run("new " + made + " --moves " + product + ":screw --static " + product + " --without block");
  ASSERT_EQ(without.exitCode, 0) << without.err;
  EXPECT_NE(without.err.find("'block': is excluded"), std::string::npos) << without.err;
  EXPECT_EQ(Json::parse(read(made))["bodies"].size(), 6U);
  const Finished unknown = run("fits " + product + " --without blok");
  EXPECT_EQ(unknown.exitCode, 2);
  EXPECT_NE(unknown.err.find("'blok', which is not a body"), std::string::npos) << unknown.err;
}

/// The smaller body of a pair is thinned, whichever moves, and each format of the table says so.
TEST_F(Cli, FitsSayWhichBodyGivesWayAndWhyAPairIsRefused) {
  const std::string product = glissade::test::stepFile("fits.step");
  const Json fits = Json::parse(run("fits " + product + " --json").out);
  int refused = 0;
  for (const Json& pair : fits["pairs"]) {
    ASSERT_EQ(pair["ways"].size(), 2U);
    const bool isClash = pair["status"] == "clash";
    refused += isClash ? 1 : 0;
    for (const Json& way : pair["ways"]) {
      EXPECT_EQ(way.contains("refused"), isClash) << pair;
      EXPECT_EQ(way["thinner"].empty(), isClash) << pair;
    }
    if (isClash) continue;
    const Json& first = pair["ways"][0]["thinner"];
    const Json& second = pair["ways"][1]["thinner"];
    ASSERT_EQ(first.size(), second.size()) << pair;
    for (const Json& each : first) EXPECT_NE(each["body"], "fits/plate") << "the plate is the largest";
  }
  EXPECT_EQ(refused, 1);
  const std::string table = run("fits " + product).out;
  EXPECT_NE(table.find("allowance"), std::string::npos) << table;
  EXPECT_NE(table.find("clash "), std::string::npos) << table;
  EXPECT_NE(run("fits " + product + " --csv").out.find("status,thinner,refused"), std::string::npos);
}

/// The product of fits.step has a screw in a tapped hole.
TEST_F(Cli, JointsOfAProductAreListed) {
  const std::string product = glissade::test::stepFile("fits.step");
  const Finished listed = run("joints " + product + " --json");
  ASSERT_EQ(listed.exitCode, 0) << listed.err;
  const Json joints = Json::parse(listed.out);
  EXPECT_EQ(joints["format"], "glissade-joints");
  int sum = 0;
  for (const auto& count : joints["counts"].items()) sum += count.value().get<int>();
  EXPECT_EQ(sum, static_cast<int>(joints["joints"].size()));
  const std::string table = run("joints " + product).out;
  EXPECT_NE(table.find("evidence"), std::string::npos) << table;
  EXPECT_NE(table.find(std::to_string(sum) + " joints of "), std::string::npos) << table;
  EXPECT_EQ(run("joints " + product + " --joints suggested").exitCode, 0);
  EXPECT_EQ(run("joints " + product + " --joints all").exitCode, 2);
  EXPECT_EQ(run("joints " + (folder / "absent.step").string()).exitCode, 3);
  EXPECT_EQ(run("joints").exitCode, 2);
}

TEST_F(Cli, TheLiaisonGraphIsWrittenForOtherPrograms) {
  const std::string product = glissade::test::stepFile("tapped-nut.step");
  const Finished json = run("liaisons " + product + " --json");
  ASSERT_EQ(json.exitCode, 0) << json.err;
  const Json graph = Json::parse(json.out);
  ASSERT_EQ(graph["liaisons"].size(), 3U) << json.out;
  EXPECT_EQ(graph["clusters"].size(), 1U);
  const Json& bolt = graph["liaisons"][0];
  EXPECT_EQ(bolt["a"], "plate");
  EXPECT_EQ(bolt["contact"], "cylindrical");
  EXPECT_EQ(bolt["lets_go"].size(), 2U) << "both senses of the axis";
  const Json& nut = graph["liaisons"][2];
  EXPECT_EQ(nut["joints"], Json::array({"nut"}));
  EXPECT_EQ(nut["lets_go"].size(), 1U) << "a nut leaves by the end of its bolt";
  const Finished csv = run("liaisons " + product);
  EXPECT_EQ(csv.out.rfind("a,b,contact,joints,x,y,z\nplate,", 0), 0U) << csv.out;
  EXPECT_EQ(run("liaisons " + (folder / "absent.step").string()).exitCode, 3);
}

TEST_F(Cli, AWordAboutAJointThatCannotBeIsOneMessage) {
  const std::string made = (folder / "joints.json").string();
  const std::string product = glissade::test::stepFile("fits.step");
  ASSERT_EQ(run("new " + made + " --moves " + product + ":screw --static " + product).exitCode, 0);
  Json scenario = Json::parse(glissade::test::readWhole(made));
  scenario.erase("checksum");
  const auto refused = [&](const Json& word) {
    scenario["joints"] = Json::array({word});
    std::ofstream(made) << scenario.dump();
    const Finished finished = run("joints " + made);
    EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1) << finished.err;
    EXPECT_TRUE(finished.exitCode == 2 || finished.exitCode == 3) << finished.exitCode;
    return finished.err;
  };
  EXPECT_NE(refused({{"kind", "pin"}, {"body", "nobody"}, {"word", "dissolved"}}).find("there is no body 'nobody'"),
            std::string::npos);
  EXPECT_NE(refused({{"kind", "rivet"}, {"body", "screw"}, {"word", "dissolved"}}).find("is not one of: screw"),
            std::string::npos);
  EXPECT_NE(refused({{"kind", "unit"}, {"body", "screw"}, {"word", "opened"}}).find("no such joint"),
            std::string::npos);
}

TEST_F(Cli, AProductIsTakenApartAndTheCheckAgrees) {
  const std::string product = glissade::test::stepFile("fits.step");
  const std::string plan = (folder / "plan.json").string();
  const std::string command = "sequence " + product + " --accept-clashes 3mm";
  // The block is 3 mm deep in the plate. It cannot be thinned so much, so it is removed first.
  const Finished found = run(command + " --json --out " + plan);
  ASSERT_EQ(found.exitCode, 0) << found.err << found.out;
  const Json report = Json::parse(found.out);
  EXPECT_EQ(report["parts"], 6);
  EXPECT_EQ(report["removed"], 6);
  EXPECT_EQ(report["staying"], Json({"plate", "dowel"})) << "the dowel is pressed in";
  EXPECT_EQ(report["certified"], true);
  EXPECT_TRUE(report["stuck"].empty());
  EXPECT_GT(report["wall_s"], 0.0);
  EXPECT_NE(found.err.find("6 of 6 parts"), std::string::npos) << found.err;

  const Json check = Json::parse(run("check " + product + " " + plan + " --accept-clashes 3mm --json").out);
  EXPECT_EQ(check["valid"], true) << check;
  EXPECT_EQ(check["steps_valid"], report["steps"].size());
  const Finished unaccepted = run("check " + product + " " + plan);
  EXPECT_EQ(unaccepted.exitCode, 7) << "nobody accepts the clash: " << unaccepted.out;
  EXPECT_NE(unaccepted.out.find("valid only if clashes up to 3 mm are accepted"), std::string::npos) << unaccepted.out;
  EXPECT_EQ(run("check " + product + " " + plan + " --trust-plan").exitCode, 0);
  EXPECT_EQ(run("check " + product + " " + plan + " --fits off").exitCode, 1) << "whole parts do not leave";
  EXPECT_EQ(run("check " + glissade::test::stepFile("unit.step") + " " + plan).exitCode, 1)
      << "the plan of another product";

  const std::string again = (folder / "again.json").string();
  ASSERT_EQ(run(command + " --lanes 2 --out " + again).exitCode, 0);
  EXPECT_EQ(read(again), read(plan)) << "threads do not change the plan";
  const std::string cut = (folder / "cut.json").string();
  EXPECT_EQ(run(command + " --time-limit 1e-6 --out " + cut).exitCode, 5);
  EXPECT_EQ(Json::parse(read(cut))["end"], "time_limit");
  ASSERT_EQ(run(command + " --resume " + cut + " --out " + again).exitCode, 0);
  EXPECT_EQ(read(again), read(plan)) << "what is resumed becomes the same plan";
}

TEST_F(Cli, AKilledSequenceGoesOnFromWhatWasFound) {
  const std::string product = glissade::test::stepFile("fits.step");
  const std::string whole = (folder / "whole.json").string();
  ASSERT_EQ(run("sequence " + product + " --out " + whole).exitCode, 1);
  const std::string plan = (folder / "plan.json").string();
  // The command is killed as soon as the plan file exists, or after its end.
  const std::string program = test::programDirectory() + "/glissade-cli";
  const std::string script =
      write("kill.sh", program + " sequence " + product + " --save-every 0 --out " + plan + " & pid=$!\nwhile [ ! -e " +
                           plan + " ] && kill -0 $pid; do :; done\n" + "kill -9 $pid\nwait $pid\n");
  ASSERT_NE(std::system(("sh " + script + " 2>/dev/null").c_str()), -1);
  ASSERT_EQ(run("sequence " + product + " --resume " + plan + " --out " + plan).exitCode, 1);
  EXPECT_EQ(read(plan), read(whole)) << "what is resumed becomes the same plan";
}

TEST_F(Cli, APersonsDemandsOnStepsAreKeptAndJudged) {
  const std::string product = glissade::test::stepFile("fits.step");
  const std::string plan = (folder / "plan.json").string();
  const Json report = Json::parse(run("sequence " + product + " --json --out " + plan).out);
  const std::string last = report["steps"].back()["motions"][0]["bodies"][0];
  const std::string placed = "sequence " + product + " --json --out " + plan + " --place 1," + last;
  const Json forced = Json::parse(run(placed).out);
  EXPECT_EQ(forced["sequence"]["places"][0]["place"], 1);
  const bool first = forced["steps"][0]["motions"][0]["bodies"][0] == last;
  EXPECT_TRUE(first || forced["stuck"].size() > report["stuck"].size()) << forced;
  EXPECT_EQ(verdictOn(product, plan), "incomplete") << "the block is stuck";
  EXPECT_EQ(run("sequence " + product + " --resume " + plan + " --place 2," + last).exitCode, 2);
  for (const char* wrong : {"--place 0,block", "--place 1,plate", "--forbid block,-q", "--save-every -1"}) {
    EXPECT_EQ(run("sequence " + product + " " + wrong).exitCode, 2) << wrong;
  }
}

TEST_F(Cli, InterlockedSamplesLeaveByATurnOrAsAGroupOrAreRefused) {
  const std::string folderOfSamples = glissade::test::sourceDirectory() + "/samples/interlocked/";
  const std::string plan = (folder / "plan.json").string();
  struct Row {
    std::string name;
    int exitCode;
    std::vector<std::vector<std::string>> steps;
  };
  for (const Row& row : std::initializer_list<Row>{
           {"turn", 0, {{"turn-key"}}}, {"group", 0, {{"group-slot", "group-tongue"}}}, {"two-hands", 1, {}}}) {
    const std::string file = folderOfSamples + row.name + ".json";
    const Finished found = run("sequence " + file + " --json --out " + plan);
    EXPECT_EQ(found.exitCode, row.exitCode) << row.name << found.err;
    const Json report = Json::parse(found.out);
    ASSERT_EQ(report["steps"].size(), row.steps.size()) << row.name;
    for (std::size_t i = 0; i < row.steps.size(); ++i) {
      EXPECT_EQ(motionsIn(report)[i]["bodies"], Json(row.steps[i]));
    }
    EXPECT_EQ(run("check " + file + " " + plan).exitCode, row.exitCode) << row.name;
    if (row.name == "turn") {
      EXPECT_NE(motionsIn(report)[0]["method"], "straight");
    }
    if (row.name != "two-hands") continue;
    ASSERT_EQ(report["stuck"].size(), 2U);
    EXPECT_NE(report["stuck"][0]["reason"].get<std::string>().find("hold each other"), std::string::npos);
  }
}

TEST_F(Cli, DemandsAboutASequenceAreKeptAndCheapestOrdersAreCertified) {
  const std::string product = glissade::test::stepFile("fits.step");
  const std::string plan = (folder / "plan.json").string();
  const std::string command = "sequence " + product + " --json --out " + plan;
  const Json demanded = Json::parse(run(command + " --before rod,screw --before screw,bracket").out);
  std::vector<std::string> order;
  for (const Json& motion : motionsIn(demanded)) order.push_back(motion["bodies"][0]);
  const auto place = [&](const std::string& id) { return std::find(order.begin(), order.end(), id) - order.begin(); };
  EXPECT_LT(place("rod"), place("screw"));
  EXPECT_LT(place("screw"), place("bracket"));
  EXPECT_LT(place("nut"), place("bolt")) << "nuts before bolts";
  EXPECT_EQ(motionsIn(demanded)[static_cast<std::size_t>(place("nut"))]["fastener"], "nut");
  const Json together = Json::parse(run(command + " --together rod,bracket").out);
  bool asOne = false;
  for (const Json& motion : motionsIn(together)) asOne = asOne || motion["bodies"].size() == 2;
  EXPECT_TRUE(asOne);
  EXPECT_EQ(verdictOn(product, plan), "incomplete") << "the block is stuck";
  EXPECT_EQ(Json::parse(run(command + " --strategy best-first").out)["removed"], 5)
      << "the dowel is pressed in, and stays with the plate";
  EXPECT_EQ(verdictOn(product, plan), "incomplete") << "the block is stuck";
  const Finished costly = run(command + " --strategy best-first --cost lenght");
  EXPECT_EQ(costly.exitCode, 2);
  EXPECT_NE(costly.err.find("lenght"), std::string::npos) << costly.err;
  EXPECT_EQ(Json::parse(run(command + " --strategy best-first --cost '5 * tool_change'").out)["sequence"]["cost"],
            "5 * tool_change");
  EXPECT_EQ(run("sequence " + product + " --resume " + plan + " --cost short").exitCode, 2) << "the plan has its own";
  EXPECT_EQ(run(command + " --before rod").exitCode, 2);
  EXPECT_EQ(run(command + " --before rod,lid").exitCode, 2);
  EXPECT_EQ(run(command + " --before rod,screw --before screw,rod").exitCode, 2);
  EXPECT_EQ(run(command + " --gravity 0 0 0").exitCode, 2);
}

TEST_F(Cli, ScrewsTurnOutOfTheirThreadsUnlessJointsAreOff) {
  const std::string product = glissade::test::stepFile("fits.step");
  const std::string plan = (folder / "plan.json").string();
  const auto methodOf = [&](const Json& report, const std::string& id) {
    for (const Json& motion : motionsIn(report)) {
      if (motion["bodies"][0] == id) return motion["method"].get<std::string>();
    }
    return std::string("it does not leave");
  };
  const Json turned = Json::parse(run("sequence " + product + " --json --out " + plan).out);
  EXPECT_EQ(methodOf(turned, "screw"), "turned");
  EXPECT_EQ(methodOf(turned, "nut"), "turned");
  for (const Json& motion : motionsIn(turned)) {
    if (motion["bodies"][0] != "screw") continue;
    EXPECT_EQ(motion["joints"][0]["kind"], "screw");
    EXPECT_EQ(motion["joints"][0]["pitch_m"], 0.0008) << "the coarse pitch of M5";
    EXPECT_GT(motion["joints"][0]["turns"].get<double>(), 5.0);
  }
  EXPECT_EQ(verdictOn(product, plan), "incomplete") << "the judge proves the turns, and the block is stuck";
  const Finished text = run("sequence " + product);
  EXPECT_NE(text.out.find("unscrew "), std::string::npos) << text.out;
  const Json pulled = Json::parse(run("sequence " + product + " --json --joints off").out);
  EXPECT_EQ(methodOf(pulled, "screw"), "straight");
  EXPECT_EQ(pulled["sequence"]["joint_use"], "off");
  EXPECT_EQ(run("sequence " + product + " --joints all").exitCode, 2);
}

TEST_F(Cli, WrongUseOfASequenceIsNamed) {
  const std::string product = glissade::test::stepFile("unit.step");
  EXPECT_EQ(run("sequence").exitCode, 2);
  EXPECT_EQ(run("sequence " + product + " --lanes 0").exitCode, 2);
  EXPECT_EQ(run("sequence " + product + " --strategy best").exitCode, 2);
  const Finished stay = run("sequence " + product + " --stay lid");
  EXPECT_EQ(stay.exitCode, 2);
  EXPECT_NE(stay.err.find("'lid'"), std::string::npos) << stay.err;
  EXPECT_EQ(run("sequence gone.step").exitCode, 3);
  EXPECT_EQ(run("sequence " + glissade::test::stepFile("box.step")).exitCode, 3) << "one body";
  const Finished resume =
      run("sequence " + product + " --resume " + write("plan.json", R"({"format": "glissade-plan"})"));
  EXPECT_EQ(resume.exitCode, 3);
  EXPECT_NE(resume.err.find("/version"), std::string::npos) << resume.err;
}

TEST_F(Cli, AccessSaysWhichStepsAHandReaches) {
  const std::string plan = (folder / "plan.json").string();
  const std::string stand = sample("roller-stand");
  ASSERT_EQ(run("sequence " + stand + " --out " + plan).exitCode, 0);
  const Finished access = run("access " + stand + " --plan " + plan + " --hand p95m --json");
  EXPECT_EQ(access.exitCode, 1) << "not all steps";
  const Json report = Json::parse(access.out);
  EXPECT_EQ(report["hand"], "p95m");
  EXPECT_EQ(report["sampled"], true);
  ASSERT_EQ(report["steps"].size(), 10U);
  std::size_t reached = 0;
  for (const Json& step : report["steps"]) {
    if (step["hand"] == "free" && step["sight"]["seen"] == true) ++reached;
  }
  EXPECT_EQ(report["reached"], reached);
  const Finished below = run("access " + stand + " --plan " + plan + " --eye 0 0 -2");
  EXPECT_NE(below.out.find("hidden by"), std::string::npos) << "seen from below the base";
  EXPECT_NE(below.out.find("no proof"), std::string::npos);
}

TEST_F(Cli, WrongUseOfAccessIsNamed) {
  const std::string stand = sample("roller-stand");
  EXPECT_EQ(run("access " + stand).exitCode, 2);
  EXPECT_EQ(run("access " + stand + " --plan a.json --path b.csv").exitCode, 2);
  EXPECT_EQ(run("access " + stand + " --plan a.json --hand p99").exitCode, 2);
  EXPECT_EQ(run("access " + stand + " --plan a.json --eye 0 0 nan").exitCode, 2);
  EXPECT_EQ(run("access " + stand + " --plan " + (folder / "none.json").string()).exitCode, 3);
  EXPECT_EQ(run("access " + stand + " --path " + (folder / "none.csv").string()).exitCode, 3);
}

TEST_F(Cli, AScenarioIsTakenApartWhereFitsAreOff) {
  const std::string file = scenario([](Json& json) {
    json["bodies"].push_back({{"id", "lid"},
                              {"geometry", {{"box", {0.5, 0.5, 0.1}}}},
                              {"pose", {{"position", {0, 0, 0.6}}, {"orientation", {0, 0, 0, 1}}}}});
  });
  const Finished found = run("sequence " + file + " --json");
  ASSERT_EQ(found.exitCode, 0) << found.err;
  const Json report = Json::parse(found.out);
  EXPECT_EQ(report["staying"], Json({"wall"}));
  EXPECT_EQ(report["removed"], 2);
}

TEST_F(Cli, TheSamplesAreCanonicalAndSolvable) {
  for (const std::string name : {"environment-1", "environment-2", "sliding-plane"}) {
    fs::copy(fs::path(sample(name)).parent_path(), folder / name);
    const std::string file = (folder / name / "scenario.json").string();
    ASSERT_EQ(run("convert " + file + " " + file).exitCode, 0);
    EXPECT_EQ(read(file), read(sample(name))) << name << ": load then save is not byte-identical";
  }
  EXPECT_EQ(run("plan " + sample("sliding-plane") + " --operator expert --max-steps 8000").exitCode, 0);
}

TEST_F(Cli, OmplAppsProblemsAreReadAsOmplAppReadsThem) {
  const fs::path problems = fs::path(test::sourceDirectory()) / "../shared/problems/omplapp";
  if (!fs::exists(problems)) GTEST_SKIP() << "the public problems are not here";
  for (const std::string name : {"Easy", "cubicles", "alpha-1.5"}) {
    const Finished check = run("check " + (problems / (name + ".cfg")).string() + " " +
                               (problems / (name + ".path")).string() + " --json --required-clearance 1e-4");
    EXPECT_EQ(Json::parse(check.out)["certificate"]["status"], "certified") << name << check.out;
  }
  EXPECT_EQ(run("plan " + (problems / "Easy.cfg").string() + " --seed 1 --time-limit 60").exitCode, 0);
}

TEST_F(Cli, EveryEdgeHasItsCertificate) {
  const std::string path = (folder / "path.json").string();
  const Finished plan = run("plan " + sample("environment-1") + " --operator expert --json --edges --out " + path);
  ASSERT_EQ(plan.exitCode, 0) << plan.err;
  const Json report = Json::parse(plan.out);
  const Json& edges = report["certificate"]["edges"];
  ASSERT_EQ(edges.size() + 1, report["path"]["configurations"].get<std::size_t>());
  double least = 1e9;
  for (const Json& edge : edges) {
    EXPECT_EQ(edge["status"], "certified");
    EXPECT_GE(edge["proved_clearance_m"].get<double>(), edge["required_m"].get<double>());
    EXPECT_GE(edge["min_clearance_m"].get<double>(), edge["proved_clearance_m"].get<double>());
    least = std::min(least, edge["min_clearance_m"].get<double>());
  }
  EXPECT_EQ(report["certificate"]["min_clearance_m"].get<double>(), least);
  EXPECT_EQ(Json::parse(read(path))["certificate"]["edges"].size(), edges.size());
  const Finished check = run("check " + sample("environment-1") + " " + path + " --json --edges");
  EXPECT_EQ(check.exitCode, 0) << check.out;
  EXPECT_EQ(Json::parse(check.out)["certificate"]["edges"].size(), edges.size());
}

TEST_F(Cli, LengthsMayNameTheirUnit) {
  const std::string file = scenario([](Json&) {});
  const Finished plan = run("plan " + file + " --required-clearance 2.5mm --json");
  ASSERT_EQ(plan.exitCode, 0) << plan.err;
  EXPECT_DOUBLE_EQ(Json::parse(plan.out)["parameters"]["required_clearance"].get<double>(), 0.0025);
  EXPECT_GE(Json::parse(plan.out)["certificate"]["proved_clearance_m"].get<double>(), 0.0025);
  EXPECT_EQ(run("plan " + file + " --required-clearance 2.5ft").exitCode, 2);
  EXPECT_EQ(run("plan " + file + " --required-clearance 2m").exitCode, 2) << "out of range";
}

TEST_F(Cli, SmoothingShortensAndTheJudgeAgrees) {
  const std::string file = scenario([](Json&) {});
  const std::string planned = (folder / "planned.csv").string();
  const std::string smooth = (folder / "smooth.csv").string();
  const std::string both = (folder / "both.csv").string();
  ASSERT_EQ(run("plan " + file + " --seed 3 --out " + planned).exitCode, 0);
  const Finished smoothed = run("smooth " + file + " " + planned + " " + smooth + " --json");
  ASSERT_EQ(smoothed.exitCode, 0) << smoothed.err;
  const Json report = Json::parse(smoothed.out);
  EXPECT_LT(report["metric_length_m"].get<double>(), report["metric_length_before_m"].get<double>());
  EXPECT_EQ(run("check " + file + " " + smooth).exitCode, 0);
  ASSERT_EQ(run("plan " + file + " --seed 3 --smooth --out " + both).exitCode, 0);
  EXPECT_EQ(run("check " + file + " " + both).exitCode, 0);
  EXPECT_NE(read(both), read(planned));
  const std::string through = write("through.path", "-1 0 0 0 0 0 1\n1 0 0 0 0 0 1\n");
  EXPECT_EQ(run("smooth " + file + " " + through + " " + smooth).exitCode, 1);
}

TEST_F(Cli, WhereNoPathIsFoundTheDifficultyIsTold) {
  // Two walls leave a gap 10 mm narrower than the cube, up to the workspace's borders.
  const std::string file = scenario([](Json& json) {
    json["bodies"] = Json::parse(R"([
      {"id": "left", "geometry": {"box": [0.2, 2, 5]}, "pose": {"position": [0, -1.095, 0], "orientation": [0, 0, 0, 1]}},
      {"id": "right", "geometry": {"box": [0.2, 2, 5]}, "pose": {"position": [0, 1.095, 0], "orientation": [0, 0, 0, 1]}}])");
    json["workspace"] = Json::parse(R"({"min": [-2, -1, -1], "max": [2, 1, 1]})");
  });
  const Finished plan = run("plan " + file + " --max-steps 500 --difficulty --json");
  ASSERT_EQ(plan.exitCode, 5) << plan.err;
  const Json difficulty = Json::parse(plan.out)["difficulty"];
  EXPECT_GT(difficulty["frontier"]["distance_m"].get<double>(), 0.0);
  EXPECT_FALSE(difficulty["frontier"]["blocked_by"].get<std::string>().empty());
  EXPECT_FALSE(difficulty["tightest"]["body"].get<std::string>().empty());
  EXPECT_GE(difficulty["least_penetration"]["depth_mm"].get<double>(), 4.9);
  EXPECT_LT(difficulty["least_penetration"]["depth_mm"].get<double>(), 12.0);
  const Finished text = run("plan " + file + " --max-steps 500 --difficulty");
  EXPECT_NE(text.out.find("mm more room between"), std::string::npos) << text.out;
}

}  // namespace
