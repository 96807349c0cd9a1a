#include "engine/import/json_checksum.h"

#include "engine/base/file.h"

namespace glissade {
namespace {

using Json = JsonCursor::Json;

constexpr const char* kKey = "checksum";

/// Checksum of an object without the member.
std::string checksumOf(const Json& object) { return "sha256:" + sha256(jsonText(object)); }

}  // namespace

void addChecksum(Json& object) { object[kKey] = checksumOf(object); }

ChecksumState takeChecksum(Json& document) {
  if (!document.is_object() || !document.contains(kKey)) return ChecksumState::Missing;
  const Json stated = document[kKey];
  document.erase(kKey);
  return stated == checksumOf(document) ? ChecksumState::Right : ChecksumState::Wrong;
}

void addChecksumProperty(Json& schema) {
  schema["properties"][kKey] = {
      {"description",
       "\"sha256:\" and the SHA-256 of this document without this member, as compact JSON: no white space, the keys in "
       "their order, numbers in their shortest form. It is the last member. A wrong one is a warning for a scenario, "
       "and "
       "an error for a plan."},
      {"type", "string"},
      {"pattern", "^sha256:[0-9a-f]{64}$"}};
}

Diagnostic wrongChecksum(const std::string& file, const Message& advice) {
  return {ErrorKind::MalformedInput, file, "/checksum",
          GLISSADE_TEXT("does not fit the content: the file was edited outside of Glissade, or it is damaged"), advice};
}

}  // namespace glissade
