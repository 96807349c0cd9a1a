#pragma once

#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/stop_token.h"
#include "engine/geometry/triangle_mesh.h"
#include "engine/import/import_protocol.h"

namespace glissade {

/// A file for one of the importing programs.
struct ImporterCall {
  std::string program;                 ///< beside this one
  std::vector<std::string> arguments;  ///< its own
  std::string file;                    ///< for messages
  import_protocol::Limits limits;
  std::string advice;  ///< of errors
  /// Where the program crashes it is started once more with these; none: that is an error.
  std::vector<std::string> argumentsAfterCrash = {};
};

/// Takes plain values out of what an importing program wrote, without trusting any of it.
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
  /// So many bytes. False where there are fewer.
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

/// What a program made of a file: a header of a kind that is no error and not too large, and what follows.
struct ImporterAnswer {
  import_protocol::Header header;
  ImportMessage message;
};
/// Gives the file's content to the program. Errors are MalformedInput with the file's name, or Interrupted.
Result<ImporterAnswer> callImporter(const ImporterCall& call, std::string_view content, const StopToken& stop = {});

/// What the program writes of several files that are given to it as one content (kSeveral), as far as it comes: nothing
/// of it is checked, and how the program ends does not matter.
std::string callImporterOfSeveral(const ImporterCall& call, std::string_view content, const StopToken& stop);

/// That the file, or what the program made of it, is not what it should be.
Diagnostic refusalOf(const ImporterCall& call, const std::string& reason, const std::string& location = {});

/// What is wrong with a mesh that a program wrote: a number or an index out of all measure.
std::optional<std::string> faultOf(const TriangleMesh& mesh);

}  // namespace glissade
