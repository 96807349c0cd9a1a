#include "tests/fuzz/targets.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "engine/base/limits.h"
#include "engine/base/utf8.h"
#include "engine/files/path_reader.h"
#include "engine/files/plan_file.h"
#include "engine/files/run_record.h"
#include "engine/files/scenario_io.h"
#include "engine/import/formats/gltf_reader.h"
#include "engine/import/formats/obj_reader.h"
#include "engine/import/formats/ply_reader.h"
#include "engine/import/formats/stl_reader.h"
#include "engine/import/omplapp_config.h"
#include "engine/import/step_answer.h"
#include "engine/import/step_text_check.h"
#include "engine/import/urdf_import.h"
#include "engine/study/study_plan.h"
#include "engine/study/study_reader.h"

namespace glissade::fuzz {
namespace {

void require(bool holds, const char* promise) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %s\n", promise);
  std::abort();
}

/// The text of a valid error; aborts where it is invalid.
std::string requireError(const Diagnostic& error) {
  const std::string text = toString(error);
  require(error.kind != ErrorKind::Internal, "an input is no fault of ours");
  require(!error.reason.empty(), "every error has a reason");
  require(isUtf8(text), "every error is valid UTF-8");
  require(text.find('\x1b') == std::string::npos, "no error holds a control character");
  return text;
}

/// The bytes as a file, for readers that need one. One file is used for all calls.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(::memfd_create("fuzz", MFD_CLOEXEC)) { require(descriptor_ >= 0, "memfd_create"); }
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  std::string with(const std::string& bytes) const {
    const auto size = static_cast<ssize_t>(bytes.size());
    const bool written =
        ::ftruncate(descriptor_, 0) == 0 && ::pwrite(descriptor_, bytes.data(), bytes.size(), 0) == size;
    require(written, "the memory file is written");
    return "/proc/self/fd/" + std::to_string(descriptor_);
  }

 private:
  int descriptor_;
};

std::string asFile(const std::string& bytes) {
  static const MemoryFile file;
  return file.with(bytes);
}

bool isNear(const Pose& pose) {
  return std::all_of(pose.position.data(), pose.position.data() + 3, limits::isCoordinate);
}

std::string scenario(const std::string& bytes) {
  const auto read = parseScenario(bytes, "scenario.json");
  if (!read) return requireError(read.error());
  require(isNear(read->start), "coordinates are within the limits");
  const std::string written = writeScenario(*read);
  const auto again = parseScenario(written, "written.json");
  require(again.ok(), "what is written can be read");
  require(writeScenario(*again) == written, "what is read is written as it was");
  return {};
}

std::string path(const std::string& bytes) {
  const auto points = readPath(asFile(bytes));
  if (!points) return requireError(points.error());
  require(!points->empty(), "a path has a configuration");
  for (const PathPoint& point : *points) require(isNear(point.q), "coordinates are within the limits");
  return {};
}

std::string record(const std::string& bytes) {
  const auto read = readRunRecord(asFile(bytes));
  if (!read) return requireError(read.error());
  for (const RunLog::HandPose& hand : read->log.operatorStream) {
    require(!hand.q_device || isNear(*hand.q_device), "coordinates are within the limits");
  }
  return {};
}

std::string study(const std::string& bytes) {
  std::string refused;
  for (const bool quick : {false, true}) {
    const auto read = parseStudy(bytes, "study.json", quick);
    if (!read) refused = requireError(read.error());
    if (read) require(!read->cells.empty(), "a study has a cell");
  }
  return refused;
}

std::string plan(const std::string& bytes) {
  const auto read = readPlan(bytes, "plan.json");
  return read ? std::string() : requireError(read.error());
}

std::string assemblyPlan(const std::string& bytes) {
  const auto read = parsePlan(bytes, "plan.json");
  if (!read) return requireError(read.error());
  const std::string written = planJson(*read, "product").dump();
  const auto again = parsePlan(written, "written.json");
  require(again.ok(), "what is written can be read");
  require(planJson(*again, "product").dump() == written, "what is read is written as it was");
  return {};
}

std::string urdf(const std::string& bytes) {
  const auto links = importUrdf(asFile(bytes), "/nonexistent");
  if (!links) return requireError(links.error());
  for (const Occurrence& link : *links) {
    require(!link.mesh->empty() && isNear(link.X_FP), "a link has triangles within the limits");
    require(isUtf8(link.path), "names are valid UTF-8");
  }
  return {};
}

std::string cfg(const std::string& bytes) {
  const auto config = readOmplAppConfig(asFile(bytes));
  if (!config) return requireError(config.error());
  require(isNear(config->start) && isNear(config->goal), "coordinates are within the limits");
  return {};
}

/// Reads a message that a compromised importer could send.
std::string stepProtocol(const std::string& bytes) {
  const ImporterCall call{
      "glissade-import-step", {"0"}, "part.step", import_protocol::kStepLimits, Message("Export it again.")};
  ImporterAnswer answer{{}, ImportMessage(bytes)};
  constexpr std::uint32_t kFew = 100'000;  // larger counts take time and are refused because the bytes are missing
  if (!answer.message.take(&answer.header, 1) || answer.header.vertices > kFew || answer.header.triangles > kFew)
    return "is no message";
  const auto product = decodeStepAnswer(call, answer);
  if (!product) return requireError(product.error());
  for (const StepExternal& part : product->externals) {
    require(isUtf8(part.path) && isUtf8(part.file) && isValid(part.X_FP),
            "a file that is named has a name and a place");
  }
  for (const Occurrence& part : product->parts) {
    require(isUtf8(part.path) && isValid(part.X_FP), "a part has a name and a place");
    for (const TriangleIndices& triangle : part.mesh->triangles) {
      for (const std::uint32_t corner : triangle) require(corner < part.mesh->vertices.size(), "corners exist");
    }
  }
  return {};
}

/// A reader of a mesh format, which runs in the confined process.
template <MeshContent (*read)(std::string_view)>
std::string mesh(const std::string& bytes) {
  try {
    const MeshContent content = read(bytes);
    for (const Vector3& vertex : content.mesh.vertices) require(vertex.allFinite(), "vertices are finite");
    for (const TriangleIndices& triangle : content.mesh.triangles) {
      for (const std::uint32_t corner : triangle) require(corner < content.mesh.vertices.size(), "corners exist");
    }
    return {};
  } catch (const FormatError& error) {
    return requireError({ErrorKind::MalformedInput, "mesh", error.location, error.reason, Message("Export it again.")});
  }
}

std::string stepText(const std::string& bytes) {
  const auto fault = faultOfStepText(bytes);
  return fault ? requireError({ErrorKind::MalformedInput, "part.step", "", *fault, Message("Export it again.")})
               : std::string();
}

const std::vector<std::string> kJsonWords{
    "{",    "}",      "[",     "]",          ",",          ":",  "\"",    "null",    "true", "1e19",
    "1e12", "-1e300", "1e-13", "4294967296", "\\u001b[2J", "-0", "1e999", "\\ud800", "\xff", "\xE2\x80\xAE"};

std::vector<std::string> withJsonWords(std::vector<std::string> words) {
  words.insert(words.end(), kJsonWords.begin(), kJsonWords.end());
  return words;
}

}  // namespace

const std::vector<Target>& targets() {
  static const std::vector<Target> kTargets{
      {"scenario", scenario,
       withJsonWords({"\"box\"", "\"sphere\"", "\"radius\"", "\"mesh\"", "\"step\"", "\"pose\"", "\"attributes\"",
                      "\"places\"", "\"rules\"", "\"parameters\"", "\"fits\"", "\"pitch_m\"", "\"sequence\"",
                      "\"paths\"", "((((", "not not "})},
      {"path", path, withJsonWords({"\n", " ", "0 0 0 0 0 0 1\n", "nan", "inf", "1e19", ",,", "operator", "contact"})},
      {"record", record, withJsonWords({"\n", "\"step\"", "\"semantics\"", "\"q\"", "\"operator_stream\"", "[0]"})},
      {"study", study, withJsonWords({"\"seeds\"", "\"count\"", "\"rows\"", "\"grid\"", "\"quick\"", "10000000"})},
      {"plan", plan, withJsonWords({"\"cells\"", "\"seeds\"", "\"paper\"", "\"settings\""})},
      {"assembly-plan", assemblyPlan,
       withJsonWords({"\"bodies\"", "\"steps\"", "\"after\"", "\"wave\"", "\"certificate\"", "\"allowances\"",
                      "\"path\"", "\"stuck\""})},
      {"urdf",
       urdf,
       {"<",
        ">",
        "/>",
        "</a>",
        "<a>",
        "<![CDATA[",
        "]]>",
        "<!--",
        "-->",
        "<?x?>",
        "<!DOCTYPE r>",
        "\"",
        "'",
        "=",
        "&#0;",
        "&lt;",
        "<link name=\"b\"/>",
        "<geometry>",
        "</geometry>",
        "nan",
        "1e300",
        "-1",
        "\xff",
        "\xC3",
        "\xE2\x82"}},
      {"cfg", cfg, {"=", "[problem]", "\n", "start.x", "1e19", "nan", "\xff", "\x1b[2J", "#", ";"}},
      {"stl",
       mesh<readStl>,
       {"solid", "endsolid", "facet normal 0 0 1\n", "outer loop\n", "vertex 0 0 0\n", "endfacet\n", "nan", "1e39",
        std::string(4, '\0'), "\xff\xff\xff\xff"}},
      {"obj",
       mesh<readObj>,
       {"v 0 0 0\n", "f 1 2 3\n", "f -1 -2 -3\n", "f 1/2/3 4//5 6\n", "\\\n", "nan", "1e400", "l 1 2\n"}},
      {"ply",
       mesh<readPly>,
       {"element vertex 99999999\n", "property list uchar int vertex_indices\n", "property double x\n",
        "format binary_big_endian 1.0\n", "end_header\n", "nan", "-1", std::string(4, '\0'), "\xff\xff\xff\xff"}},
      {"gltf", mesh<readGltf>,
       withJsonWords({"\"accessors\"", "\"byteOffset\"", "\"count\"", "\"children\"", "\"matrix\"", "\"mode\"", "AAAA",
                      "\"extensionsRequired\": [\"x\"]", "\"sparse\"", std::string(4, '\0'), "\xff\xff\xff\xff"})},
      {"step-text",
       stepText,
       {"(", ")", "((((((((", "'", "/*", "*/", ";", "#1=", "nan", "1.E400", "ENDSEC;", std::string(400, '9'), "\xff"}},
      {"step-protocol",
       stepProtocol,
       {std::string(4, '\0'), "\xff\xff\xff\xff", std::string("\0\0\0\0\0\0\xf8\x7f", 8), std::string("\1\0\0\0", 4)}},
  };
  return kTargets;
}

const Target* findTarget(const std::string& name) {
  const auto found = std::find_if(targets().begin(), targets().end(), [&](const Target& t) { return t.name == name; });
  return found == targets().end() ? nullptr : &*found;
}

}  // namespace glissade::fuzz
