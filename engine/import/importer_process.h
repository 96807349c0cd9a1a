#pragma once

#include <cstring>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/stop_token.h"
#include "engine/geometry/triangle_mesh.h"
#include "engine/import/import_protocol.h"

namespace glissade {

/// The environment variable that names the folder of the importing programs. Without it they are beside the running
/// program; for the shared library they are where it was installed.
inline constexpr const char* kProgramsFolder = "GLISSADE_PROGRAMS";

/// The file of one of our programs, which may be missing. It is in the folder that the environment names, beside this
/// program, or, for the shared library, beside the library (a build folder) or in the folder of the installed programs.
std::string programFile(const std::string& name);

/// The call of an importing program for a file.
struct ImporterCall {
  std::string program;                 ///< name
  std::vector<std::string> arguments;  ///< arguments of the program
  std::string file;                    ///< for messages
  import_protocol::Limits limits;
  Message advice;  ///< advice of errors
  /// If the program crashes, it is started once more with these arguments; empty: the crash is an error.
  std::vector<std::string> argumentsAfterCrash = {};
};

/// Reads plain values from the output of an importing program, without trusting any of them.
class ImportMessage {
 public:
  explicit ImportMessage(std::string bytes) : bytes_(std::move(bytes)) {}

  template <class T>
  bool take(T* values, std::size_t count) {
    if (count == 0) return true;
    if (count > (bytes_.size() - position_) / sizeof(T)) return false;
    std::memcpy(values, bytes_.data() + position_, count * sizeof(T));
    position_ += count * sizeof(T);
    return true;
  }
  /// Takes this number of bytes. False if there are fewer.
  bool takeText(std::size_t count, std::string& text) {
    if (count > bytes_.size() - position_) return false;
    text = bytes_.substr(position_, count);
    position_ += count;
    return true;
  }
  std::string rest() const { return bytes_.substr(position_); }

 private:
  std::string bytes_;
  std::size_t position_ = 0;
};

/// The answer of a program about a file: a header of limited size whose kind is no error, and the data that follow.
struct ImporterAnswer {
  import_protocol::Header header;
  ImportMessage message;
};
/// Passes the file's content to the program. Errors are MalformedInput with the file's name, or Interrupted.
Result<ImporterAnswer> callImporter(const ImporterCall& call, std::string_view content, const StopToken& stop = {});

/// The output of the program for several files in one content (kSeveral), as far as it arrives. It is not checked, and
/// the end of the program does not matter.
std::string callImporterOfSeveral(const ImporterCall& call, std::string_view content, const StopToken& stop);

/// The error that the file, or the program's output for it, is malformed.
Diagnostic refusalOf(const ImporterCall& call, const Message& reason, const Location& location = {});

/// The text that a program wrote as data; nothing if it has another form, or could grow: see import_protocol.h.
std::optional<Message> messageOfProgram(const nlohmann::json& json);

/// The fault of a mesh that a program wrote: a number or an index out of range.
std::optional<Message> faultOf(const TriangleMesh& mesh);

}  // namespace glissade
