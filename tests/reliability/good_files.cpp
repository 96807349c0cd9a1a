#include "tests/reliability/good_files.h"

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/engine/support/sample_cfg.h"
#include "tests/oracle/child_run.h"
#include "tests/oracle/mesh_writer.h"
#include "tests/oracle/shapes.h"

namespace glissade::reliability {
namespace {

namespace fs = std::filesystem;
using oracle::MeshFormat;

std::string contentOf(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void save(const std::string& file, const std::string& content) { std::ofstream(file, std::ios::binary) << content; }

/// An object that moves past a wall. The object's geometry is that of the asset, or a box.
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

/// The same tetrahedron in little-endian floats.
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

/// What a scenario may say beside bodies and ends.
const char* const kSemantics =
    R"json("environment": {"cell_size": 0.1, "memory": 16, "topology_level": 5, "places": "watershed"},
"attributes": [{"name": "weight", "type": "number", "of": "body", "unit": "kg", "minimum": 0, "maximum": 1000, "initial": 2.5},
{"name": "quality", "type": "choice", "of": "place", "choices": ["bad", "good"], "initial": "good"}],
"places": [{"at": [0, 3, 0], "name": "gap", "attributes": {"quality": "bad"}}],
"milestones": [{"at": [0, 3, 0], "pose": {"position": [0, 3, 0], "orientation": [0, 0, 0, 1]}}],
"rules": {"node": "1", "edge": "if(2 > 1 and not (1 == 2), 1, max(2, -3))", "fine": [{"when": "1", "geometrical": true, "local": "rrt"}], "loop": true},
"seed": 1)json";

/// A recording as a run writes it while it goes on: a line that says what is run, and one of what has happened.
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

/// What a product says of its pairs, of the order of its bodies, and of paths that were kept.
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

}  // namespace

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

}  // namespace glissade::reliability
