// Gives glissade-cli malformed files of every format, and prints one row of the table of packaging/reliability.sh for
// each: name | tried | clean | defects | seconds | peak MB | seed. FORMAT: only this one. It uses no code of the
// engine.
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "tests/engine/support/sample_cfg.h"
#include "tests/oracle/child_run.h"
#include "tests/oracle/mesh_writer.h"
#include "tests/oracle/shapes.h"

namespace glissade::reliability {
namespace {

/// A well-formed file, and the command with which `glissade-cli` reads it.
struct GoodFile {
  std::string format;   ///< as in the table
  std::string name;     ///< file name in the campaign's folder
  std::string content;  ///< malformed variants are made of it
  /// Arguments of glissade-cli, with the file's name as in `name`.
  std::vector<std::string> command;
  bool mesh = false;  ///< whether its triangles are counted
};

namespace fs = std::filesystem;

using oracle::MeshFormat;

std::string contentOf(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void save(const std::string& file, const std::string& content) { std::ofstream(file, std::ios::binary) << content; }

/// A scenario with an object that moves past a wall. The object's geometry is that of the asset, or a box.
std::string scenarioWith(const std::string& kind, const std::string& assetFile) {
  const std::string pose = R"("orientation": [0, 0, 0, 1]})";
  std::string text = R"({"format": "glissade-scenario", "version": 1, "name": "Malformed", "assets": [)";
  if (!assetFile.empty()) text += R"({"id": "part", "path": ")" + assetFile + R"(", "unit": 1.0, "up_axis": "z"})";
  text += R"(], "bodies": [{"id": "wall", "name": "wall", "mobility": "static",
    "geometry": {"box": [1, 4, 1]}, "pose": {"position": [0, 0, 0], )" +
          pose + R"(}], "object": {"id": "object", "name": "object", "geometry": )";
  if (kind == "box") text += R"({"box": [0.5, 0.5, 0.5]})";
  if (kind == "mesh") text += R"({"mesh": "part"})";
  if (kind == "urdf") text += R"({"urdf": "part"})";
  if (kind == "step") text += R"({"step": {"asset": "part"}})";
  text += R"(}, "start": {"position": [-3, 0, 0], )" + pose + R"(, "goal": {"position": [3, 0, 0], )" + pose +
          R"(, "workspace": {"min": [-5, -5, -5], "max": [5, 5, 5]}, "seed": 1})" + "\n";
  return text;
}

const char* const kPly =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
    "element face 4\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
    "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

const char* const kDae = R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="1" name="meter"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g" name="g"><mesh>
<source id="p"><float_array id="a" count="12">0 0 0 1 0 0 0 1 0 0 0 1</float_array>
<technique_common><accessor source="#a" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/><p>0 2 1 0 1 3 1 2 3 0 3 2</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene>
</COLLADA>
)";

/// A tetrahedron in little-endian floats.
std::string binaryPly() {
  std::string file =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 4\nproperty list uchar int vertex_indices\nend_header\n";

  const auto add = [&](const auto& value) { file.append(reinterpret_cast<const char*>(&value), sizeof value); };

  for (const float coordinate : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F}) add(coordinate);

  const std::int32_t faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};

  for (const auto& corners : faces) {
    file += '\x03';
    for (const std::int32_t corner : corners) add(corner);
  }

  return file;
}

/// A tetrahedron; the buffer is in the file.
const char* const kGltf = R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
"nodes": [{"mesh": 0, "translation": [0, 0, 1]}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 1}, "indices": 0}]}],
"accessors": [{"bufferView": 0, "componentType": 5123, "count": 12, "type": "SCALAR"},
{"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1]}],
"bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 24}, {"buffer": 0, "byteOffset": 24, "byteLength": 48}],
"buffers": [{"byteLength": 72, "uri": "data:application/octet-stream;base64,AAACAAEAAAABAAMAAQACAAMAAAADAAIAAAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/"}]}
)";

const char* const kUrdf = R"(<?xml version="1.0"?>
<robot name="r"><link name="root"><collision><geometry><box size="0.4 0.4 0.4"/></geometry></collision></link>
<link name="arm"><collision><origin xyz="0.4 0 0.6" rpy="0 0 0.1"/><geometry><cylinder radius="0.1" length="0.8"/></geometry></collision></link>
<joint name="j" type="fixed"><parent link="root"/><child link="arm"/><origin xyz="0 0 0.1" rpy="0 0 0"/></joint></robot>
)";

/// Entries of a scenario about environment and semantics.
const char* const kSemantics =
    R"json("environment": {"cell_size": 0.1, "memory": 16, "topology_level": 5, "places": "watershed"},
"attributes": [{"name": "weight", "type": "number", "of": "body", "unit": "kg", "minimum": 0, "maximum": 1000, "initial": 2.5},
{"name": "quality", "type": "choice", "of": "place", "choices": ["bad", "good"], "initial": "good"}],
"places": [{"at": [0, 3, 0], "name": "gap", "attributes": {"quality": "bad"}}],
"milestones": [{"at": [0, 3, 0], "pose": {"position": [0, 3, 0], "orientation": [0, 0, 0, 1]}}],
"rules": {"node": "1", "edge": "if(2 > 1 and not (1 == 2), 1, max(2, -3))", "fine": [{"when": "1", "geometrical": true, "local": "rrt"}], "loop": true},
"seed": 1)json";

/// A recording as a run writes it during the run: a line about the run's settings, and a line with its events.
std::string journalOf(const std::string& record) {
  nlohmann::ordered_json head = nlohmann::ordered_json::parse(record, nullptr, false);
  if (head.is_discarded()) return {};
  head.erase("checksum");
  nlohmann::ordered_json events;
  for (auto& [key, value] : head.items()) {
    const bool list = value.is_array() && key != "assets";
    if (!list && key != "end" && key != "cut_short") continue;
    events[key] = value;
    if (list) value = nlohmann::ordered_json::array();
    if (key == "end") value = nullptr;
  }
  return head.dump() + "\n" + events.dump() + "\n";
}

/// Entries of a scenario about fits, the order of bodies, and kept paths.
const char* const kProduct =
    R"json("fits": {"mode": "on", "accept_clashes": 0.001, "pairs": [{"a": "object", "b": "wall", "kind": "overlap",
"allowance": 0.0001, "accepted": true}]},
"sequence": {"together": [["object", "wall"]], "before": [["object", "wall"]], "gravity": [0, 0, -1],
"densities": [{"body": "wall", "density": 2700}]},
"paths": [{"name": "out", "pinned": true, "object": "object", "planner": "birrt", "seed": 1, "smoothed": true,
"required_clearance": 0.00001, "clearance": 0.1, "proved_clearance": 0.05, "allowances": [{"body": "wall", "allowance": 0.0001}],
"problem_sha256": "00", "configurations": [
{"position": [-0.75, 0, 0], "orientation": [0, 0, 0, 1], "author": "computer"},
{"position": [-3, 0, 0], "orientation": [0, 0, 0, 1], "author": "operator", "segment_author": "contact"}]}],
"seed": 1)json";

const char* const kStudy = R"({"format": "glissade-study", "version": 1, "name": "malformed", "title": "Malformed",
"scenarios": ["scenario.json"], "strategies": ["birrt"], "limits": {"max_steps": 100}, "seeds": {"first": 1, "count": 2}, "rows": [{"label": "plain"}]}
)";

std::string replaced(std::string text, const std::string& word, const std::string& by) {
  return text.replace(text.find(word), word.size(), by);
}

std::size_t countOf(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

/// Writes what the files refer to (scenarios) into the folder. `cli` makes the paths and the run record, STEP
/// files come from the folder `stepFiles` (empty: none).
std::vector<GoodFile> makeGoodFiles(const std::string& folder, const std::string& cli, const std::string& stepFiles) {
  const auto in = [&](const std::string& name) { return folder + "/" + name; };
  const oracle::Triangles part = oracle::lShape(0.6, 0.2, 0.2);
  std::vector<GoodFile> files;
  const auto addAsset = [&](const std::string& format, const std::string& kind, const std::string& ending,
                            const std::string& content) {
    const std::string scenario = in(format + ".json");
    save(scenario, scenarioWith(kind, format + ending));
    save(in(format + ending), content);
    files.push_back({format, format + ending, content, {"info", scenario, "--json"}, kind == "mesh"});
  };
  addAsset("stl-text", "mesh", ".stl", meshFile(part, MeshFormat::TextStl));
  addAsset("stl-binary", "mesh", ".stl", meshFile(part, MeshFormat::BinaryStl));
  addAsset("obj", "mesh", ".obj", meshFile(part, MeshFormat::Obj));
  addAsset("ply", "mesh", ".ply", kPly);
  addAsset("ply-binary", "mesh", ".ply", binaryPly());
  addAsset("dae", "mesh", ".dae", kDae);
  addAsset("glb", "mesh", ".glb", meshFile(part, MeshFormat::Glb));
  addAsset("gltf", "mesh", ".gltf", kGltf);
  addAsset("urdf", "urdf", ".urdf", kUrdf);
  for (const std::string solid : {"plate", "pin", "housing", "rotor"}) {
    const std::string file = "split-" + solid + ".stp";
    if (!stepFiles.empty() && fs::exists(stepFiles + "/" + file)) save(in(file), contentOf(stepFiles + "/" + file));
  }
  for (const std::string name : {"box", "plate", "split"}) {
    const std::string step = stepFiles + "/" + name + ".step";
    if (!stepFiles.empty() && fs::exists(step)) addAsset("step-" + name, "step", ".step", contentOf(step));
  }
  for (const auto& [format, name] : {std::pair("iges", "surfaces.igs"), std::pair("brep", "solids.brep")}) {
    const std::string file = stepFiles + "/" + name;
    if (!stepFiles.empty() && fs::exists(file)) addAsset(format, "step", fs::path(name).extension(), contentOf(file));
  }
  const std::string scenario = in("scenario.json");
  save(scenario, scenarioWith("box", ""));
  save(in("robot.stl"), meshFile(part, MeshFormat::BinaryStl));
  save(in("world.stl"), meshFile(oracle::box(1, 4, 1), MeshFormat::BinaryStl));
  const auto addFile = [&](const std::string& format, const std::string& name, const std::string& content,
                           std::vector<std::string> command) {
    save(in(name), content);
    files.push_back({format, name, content, std::move(command)});
  };
  addFile("scenario", "variant.json", scenarioWith("box", ""), {"info", in("variant.json")});
  addFile("semantics", "semantics.json", replaced(scenarioWith("box", ""), "\"seed\": 1", kSemantics),
          {"info", in("semantics.json")});
  const std::string touching = replaced(scenarioWith("box", ""), "[-3, 0, 0]", "[-0.75, 0, 0]");
  addFile("product", "product.json", replaced(touching, "\"seed\": 1", kProduct), {"info", in("product.json")});
  addFile("cfg", "variant.cfg", test::kSampleCfg, {"info", in("variant.cfg")});
  addFile("study", "study.json", kStudy, {"study", in("study.json"), "--out", in("results"), "--dry-run"});
  for (const std::string ending : {"csv", "json", "path"}) {
    const std::string path = "path." + ending;
    oracle::runChild(
        {cli, "plan", scenario, "--strategy", "birrt", "--seed", "1", "--out", in(path), "--record", in("record.json")},
        {});
    addFile("path-" + ending, path, contentOf(in(path)), {"check", scenario, in(path)});
  }
  oracle::runChild({cli, "sequence", scenario, "--out", in("assembly-plan.json")}, {});
  addFile("assembly-plan", "assembly-plan.json", contentOf(in("assembly-plan.json")),
          {"check", scenario, in("assembly-plan.json")});
  addFile("record", "record.json", contentOf(in("record.json")), {"replay", in("record.json"), "--scenario", scenario});
  addFile("journal", "run.journal", journalOf(contentOf(in("record.json"))),
          {"replay", in("run.journal"), "--scenario", scenario});
  return files;
}

/// How many triangles a reader would count that takes a cut-off mesh file for what is there: facets begun in
/// text, facets claimed in binary.
std::size_t trianglesBegun(const GoodFile& file, const std::string& content) {
  if (file.format == "stl-text") return (countOf(content, "vertex") + 2) / 3;
  if (file.format == "obj") return countOf(content, "\nf ");
  if (file.format == "stl-binary") {
    std::uint32_t claimed = 0;
    if (content.size() >= 84) std::memcpy(&claimed, content.data() + 80, 4);
    return claimed;
  }
  return file.format == "dae" || file.format == "gltf" || file.format.rfind("ply", 0) == 0 ? 4 : 20;
}

constexpr std::array<const char*, 18> kNumbers{"nan",  "inf", "-inf", "1e400",      "1e39",       "-1",
                                               "0",    "",    "x",    "4294967295", "2147483648", "1e-400",
                                               "1e19", "--1", "1,5",  "0x10",       "99999999",   "-0.0"};

constexpr std::array<const char*, 8> kPieces{
    "<!DOCTYPE x [<!ENTITY a \"b\">]>", "&a;", "\"", "\\u0000", "\xff\xfe", "\0", "{", "../../../etc/passwd"};

class Mutator {
 public:
  Mutator(std::string text, std::mt19937_64& engine) : text_(std::move(text)), engine_(engine) {}

  std::string run() {
    const std::size_t changes = 1 + below(3);
    for (std::size_t i = 0; i < changes && !text_.empty(); ++i) change();
    return text_;
  }

 private:
  std::size_t below(std::size_t n) { return n == 0 ? 0 : engine_() % n; }

  void change() {
    switch (below(11)) {
      case 0: text_[below(text_.size())] ^= static_cast<char>(1U << below(8)); break;
      case 1: text_.erase(below(text_.size()), 1 + below(64)); break;
      case 2: {
        const std::size_t at = below(text_.size());
        text_.insert(at, text_.substr(at, 1 + below(200)));
        break;
      }
      case 3: text_.resize(below(text_.size())); break;
      case 4: writeWord(); break;
      case 5: text_.insert(below(text_.size()), kPieces[below(kPieces.size())]); break;
      case 6: text_.insert(below(text_.size()), std::string(1 + below(100'000), "[{(<a \n0"[below(8)])); break;
      case 7: moveLine(); break;
      default: replaceNumber();
    }
  }

  /// Four bytes, as binary formats hold counts and offsets.
  void writeWord() {
    constexpr std::array<std::uint32_t, 5> kWords{0U, 0xFFFFFFFFU, 0x7FFFFFFFU, 0x10000000U, 0x7FC00000U};
    const std::uint32_t word = kWords[below(kWords.size())];
    const std::size_t at = below(text_.size());
    for (std::size_t i = 0; i < 4 && at + i < text_.size(); ++i) text_[at + i] = static_cast<char>(word >> (8 * i));
  }

  void moveLine() {
    const std::size_t at = text_.rfind('\n', below(text_.size()));
    const std::size_t begin = at == std::string::npos ? 0 : at + 1;
    const std::size_t end = text_.find('\n', begin);
    const std::string line = text_.substr(begin, end == std::string::npos ? end : end - begin + 1);
    if (below(2) == 0) text_.erase(begin, line.size());
    text_.insert(below(text_.size()), line);
  }

  void replaceNumber() {
    const std::size_t from = below(text_.size());
    std::size_t begin = from;
    while (begin < text_.size() && std::isdigit(static_cast<unsigned char>(text_[begin])) == 0) ++begin;
    std::size_t end = begin;
    while (end < text_.size() && (std::isdigit(static_cast<unsigned char>(text_[end])) != 0 || text_[end] == '.'))
      ++end;
    text_.replace(begin, end - begin, kNumbers[below(kNumbers.size())]);
  }

  std::string text_;
  std::mt19937_64& engine_;
};

/// A malformed variant: one to three changes of bytes, numbers, lines or brackets, drawn by the engine. The same
/// engine gives the same variants everywhere.
std::string mutated(const std::string& good, std::mt19937_64& engine) { return Mutator(good, engine).run(); }

using oracle::ChildEnd;
using oracle::ChildLimits;
using oracle::runChild;

struct Options {
  std::string cli;
  std::string folder;     ///< folder of the campaign; variants with a defect stay in it
  std::string stepFiles;  ///< path of a folder, or empty
  std::uint64_t seed = 1;
  std::size_t variants = 200;           ///< number of variants of each format
  std::size_t truncations = 1'000'000;  ///< most truncations of each good file
  std::string format;                   ///< empty: all
};

struct Row {
  std::string name;
  std::size_t tried = 0;
  std::size_t defects = 0;
  double seconds = 0.0;
  long megabytes = 0;
};

class Campaign {
 public:
  explicit Campaign(Options options) : options_(std::move(options)) {}

  int run() {
    const std::vector<GoodFile> files = makeGoodFiles(options_.folder, options_.cli, options_.stepFiles);
    std::size_t defects = 0;
    for (const GoodFile& file : files) {
      if (!options_.format.empty() && options_.format != file.format) continue;
      checkTheGoodOne(file);
      defects += print(mutations(file));
      defects += print(truncations(file));
      put(file, file.content);
    }
    return defects == 0 ? 0 : 1;
  }

 private:
  void put(const GoodFile& file, const std::string& content) const {
    std::ofstream(options_.folder + "/" + file.name, std::ios::binary) << content;
  }

  ChildEnd ask(const GoodFile& file) const {
    std::vector<std::string> command{options_.cli};
    command.insert(command.end(), file.command.begin(), file.command.end());
    return runChild(command, limits_);
  }

  void checkTheGoodOne(const GoodFile& file) const {
    const ChildEnd end = ask(file);
    if (end.exitCode != 0) std::cerr << file.format << ": the good file is refused: " << end.errors << end.output;
  }

  Row mutations(const GoodFile& file) {
    Row row{"malformed " + file.format};
    std::mt19937_64 engine(options_.seed);
    for (std::size_t i = 0; i < options_.variants; ++i) tryOne(file, mutated(file.content, engine), false, row);
    return row;
  }

  Row truncations(const GoodFile& file) {
    Row row{"truncated " + file.format};
    const std::size_t stride =
        std::max<std::size_t>(1, (file.content.size() + options_.truncations - 1) / options_.truncations);
    for (std::size_t length = 0; length < file.content.size(); length += stride) {
      tryOne(file, file.content.substr(0, length), true, row);
    }
    return row;
  }

  void tryOne(const GoodFile& file, const std::string& content, bool cut, Row& row) {
    put(file, content);
    const ChildEnd end = ask(file);
    ++row.tried;
    row.seconds += end.seconds;
    row.megabytes = std::max(row.megabytes, end.megabytes);
    std::string defect = defectOf(end);
    if (defect.empty() && cut && file.mesh) defect = silentLoss(file, content, end);
    if (defect.empty()) return;
    const std::string kept = options_.folder + "/defect" + std::to_string(kept_++) + "-" + file.name;
    std::ofstream(kept, std::ios::binary) << content;
    std::cerr << "DEFECT " << row.name << ": " << defect << " (" << kept << ")\n";
    ++row.defects;
  }

  std::string defectOf(const ChildEnd& end) const {
    if (end.hung) return "no end within " + std::to_string(limits_.seconds) + " s";
    if (end.signal != 0) return "signal " + std::to_string(end.signal);
    if (end.megabytes > limits_.megabytes) return std::to_string(end.megabytes) + " MB";
    if (end.exitCode < 0 || end.exitCode > 5) return "exit code " + std::to_string(end.exitCode) + ": " + end.errors;
    if (end.exitCode != 0 && end.errors.empty() && end.output.empty()) return "refused without a message";
    return "";
  }

  /// The loss in a truncated mesh that is accepted without a warning although triangles are missing.
  static std::string silentLoss(const GoodFile& file, const std::string& content, const ChildEnd& end) {
    if (end.exitCode != 0 || !end.errors.empty()) return "";
    const auto report = nlohmann::json::parse(end.output, nullptr, false);
    if (report.is_discarded() || !report.contains("object")) return "no report";
    const auto found = report["object"].value("triangles", std::size_t{0});
    const std::size_t begun = trianglesBegun(file, content);
    if (found == begun) return "";
    return "silently " + std::to_string(found) + " triangles, " + std::to_string(begun) + " were begun";
  }

  std::size_t print(const Row& row) const {
    std::cout << row.name << " | " << row.tried << " | " << row.tried - row.defects << " | " << row.defects << " | "
              << std::lround(row.seconds) << " | " << row.megabytes << " | " << options_.seed << std::endl;
    return row.defects;
  }

  Options options_;
  ChildLimits limits_;
  std::size_t kept_ = 0;
};

}  // namespace
}  // namespace glissade::reliability

int main(int argc, char** argv) {
  using namespace glissade::reliability;
  if (argc != 7 && argc != 8) {
    std::cerr << "usage: malformed_campaign GLISSADE_CLI FOLDER STEP_FILES SEED VARIANTS TRUNCATIONS [FORMAT]\n";
    return 2;
  }
  fs::create_directories(argv[2]);
  return Campaign({argv[1], argv[2], argv[3], std::stoull(argv[4]), std::stoull(argv[5]), std::stoull(argv[6]),
                   argc == 8 ? argv[7] : ""})
      .run();
}
