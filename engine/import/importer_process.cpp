#include "engine/import/importer_process.h"

#include <dlfcn.h>
#include <link.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/base/child_process.h"
#include "engine/base/message_json.h"

namespace glissade {
namespace {

namespace protocol = import_protocol;

/// Larger than any message of kMostElements, kMostFaces and kMostParts.
constexpr std::size_t kMostOutput = std::size_t{40} * protocol::kMostElements +
                                    sizeof(protocol::Face) * protocol::kMostFaces +
                                    std::size_t{1024} * protocol::kMostParts;

/// The folder of the file that holds this code: the program, or the shared library. Empty where the system does not
/// tell.
std::filesystem::path folderOfThisCode(bool& isProgram) {
  std::error_code error;
  Dl_info info{};
  link_map* map = nullptr;
  static const char here = 0;  // an address in the file that holds this code
  const int found = ::dladdr1(&here, &info, reinterpret_cast<void**>(&map), RTLD_DL_LINKMAP);
  // The map of the program itself has no name.
  isProgram = found == 0 || map == nullptr || map->l_name == nullptr || *map->l_name == '\0';
  const std::string file = isProgram ? "/proc/self/exe" : map->l_name;
  return std::filesystem::canonical(file, error).parent_path();
}

}  // namespace

std::string programFile(const std::string& name) {
  const char* const named = std::getenv(kProgramsFolder);
  if (named != nullptr && *named != '\0') return (std::filesystem::path(named) / name).string();
  bool isProgram = true;
  const std::filesystem::path folder = folderOfThisCode(isProgram);
  std::error_code error;
  if (isProgram || std::filesystem::exists(folder / name, error)) return (folder / name).string();
  return (folder / GLISSADE_PROGRAMS_FROM_LIBRARY / name).lexically_normal().string();
}

namespace {

/// True if each text names each argument at most once. Others could make a text of any length of a short message.
bool cannotGrow(const Message& message) {
  for (char digit = '1'; digit <= '9'; ++digit) {
    const std::string argument{'%', digit};
    if (message.text.find(argument) != message.text.rfind(argument)) return false;
  }
  return std::all_of(message.arguments.begin(), message.arguments.end(), [](const MessageArgument& argument) {
    const auto* inner = std::get_if<Message>(&argument.value);
    return inner == nullptr || cannotGrow(*inner);
  });
}

/// The message of a process that reads nothing. The process is not trusted: a text of another form is empty.
struct ImporterRefusal {
  Location location;
  Message reason;
};
ImporterRefusal refusalIn(const std::string& text) {
  const auto json = nlohmann::json::parse(text, nullptr, false);
  const auto part = [&](const char* key) {
    return json.is_object() && json.contains(key) ? messageOfProgram(json[key]).value_or(Message()) : Message();
  };
  return {part("location"), part("reason")};
}

/// True if the program ended without a message: libraries crash on some files.
bool hasCrashed(const ChildEnd& end) {
  if (end.ending == ChildEnding::Signalled) return end.signal != SIGXCPU;
  return end.ending == ChildEnding::Exited && end.output.size() < sizeof(protocol::Header);
}

}  // namespace

Diagnostic refusalOf(const ImporterCall& call, const Message& reason, const Location& location) {
  return {ErrorKind::MalformedInput, call.file, location, reason, call.advice};
}

namespace {

ChildCommand commandOf(const ImporterCall& call, std::string_view content) {
  ChildCommand command;
  command.program = programFile(call.program);
  command.arguments = call.arguments;
  command.input = content;
  command.environment = requiredEnvironment();
  command.limits.seconds = std::chrono::duration<double>(call.limits.patience).count();
  command.limits.memoryBytes = call.limits.memory;
  command.limits.cpuSeconds = call.limits.seconds;
  command.limits.outputBytes = std::min<std::uint64_t>(kMostOutput, call.limits.memory);
  return command;
}

}  // namespace

std::string callImporterOfSeveral(const ImporterCall& call, std::string_view content, const StopToken& stop) {
  auto child = runChild(commandOf(call, content), stop);
  return child ? std::move(child->output) : std::string();
}

Result<ImporterAnswer> callImporter(const ImporterCall& call, std::string_view content, const StopToken& stop) {
  ChildCommand command = commandOf(call, content);
  auto child = runChild(command, stop);
  if (child && hasCrashed(*child) && !call.argumentsAfterCrash.empty()) {
    command.arguments = call.argumentsAfterCrash;
    child = runChild(command, stop);
  }
  if (!child) return child.error();
  if (child->ending == ChildEnding::Stopped) {
    return Diagnostic{ErrorKind::Interrupted, call.file, "", GLISSADE_TEXT("was not read to its end"),
                      GLISSADE_TEXT("Read it again.")};
  }
  if (child->ending == ChildEnding::OutputTooLarge) return refusalOf(call, GLISSADE_TEXT("is too large"));
  if (child->ending == ChildEnding::TimeOver || child->signal == SIGXCPU) {
    return refusalOf(call, GLISSADE_TEXT("takes too long to read: it is too complex or malformed"));
  }
  if (hasCrashed(*child)) {
    const char* signal = child->signal == 0 ? nullptr : ::strsignal(child->signal);
    if (signal == nullptr) {
      return refusalOf(call, GLISSADE_TEXT("was not read: the library that reads this format crashed on it"));
    }
    return refusalOf(call,
                     {GLISSADE_TEXT("was not read: the library that reads this format crashed on it (%1)"), {signal}});
  }
  ImporterAnswer answer{{}, ImportMessage(std::move(child->output))};
  const protocol::Header& header = answer.header;
  if (!answer.message.take(&answer.header, 1) || header.magic != protocol::kMagic) {
    return refusalOf(call, GLISSADE_TEXT("the importer failed on it"));
  }
  const bool refused = header.kind == protocol::kNotConfined || header.kind == protocol::kError;
  const ImporterRefusal why = refused ? refusalIn(answer.message.rest()) : ImporterRefusal();
  if (header.kind == protocol::kNotConfined) {
    return Diagnostic{
        ErrorKind::MalformedInput,
        call.file,
        "",
        {GLISSADE_TEXT("was not read: the importing process cannot give up its rights (%1)"), {why.reason}},
        GLISSADE_TEXT(
            "Files are read only where the kernel permits seccomp filters: use another machine or container.")};
  }
  if (header.kind == protocol::kError) return refusalOf(call, why.reason, why.location);
  if (header.vertices > protocol::kMostElements || header.triangles > protocol::kMostElements) {
    return refusalOf(call, {GLISSADE_TEXT("holds %1 vertices and %2 triangles; at most %3 of each are read"),
                            {header.vertices, header.triangles, protocol::kMostElements}});
  }
  return answer;
}

std::optional<Message> messageOfProgram(const nlohmann::json& json) {
  auto message = messageFrom(json);
  return message && cannotGrow(*message) ? message : std::nullopt;
}

std::optional<Message> faultOf(const TriangleMesh& mesh) {
  constexpr double kLargestCoordinate = 1e9;
  for (const Vector3& vertex : mesh.vertices) {
    if (vertex.allFinite() && vertex.cwiseAbs().maxCoeff() <= kLargestCoordinate) continue;
    return GLISSADE_TEXT("has a vertex whose coordinates are not finite, or too large");
  }
  for (const TriangleIndices& triangle : mesh.triangles) {
    if (*std::max_element(triangle.begin(), triangle.end()) < mesh.vertices.size()) continue;
    return GLISSADE_TEXT("has a triangle with a corner that does not exist");
  }
  return std::nullopt;
}

}  // namespace glissade
