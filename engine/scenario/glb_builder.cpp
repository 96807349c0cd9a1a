#include "engine/scenario/glb_builder.h"

#include <cstdint>
#include <cstring>
#include <limits>

#include "engine/base/json_reader.h"

namespace glissade {
namespace {

using Json = GlbBuilder::Json;

// The words of the glTF 2.0 specification.
constexpr int kFloat = 5126;
constexpr int kArrayBuffer = 34962;
constexpr std::uint32_t kMagic = 0x46546C67;      // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t kBinaryChunk = 0x004E4942;
constexpr std::uint32_t kGlbVersion = 2;
constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;

const char* typeOf(Eigen::Index rows) { return rows == 1 ? "SCALAR" : rows == 3 ? "VEC3" : "VEC4"; }

Json numberList(const Eigen::VectorXf& values) {
  Json list = Json::array();
  for (const float value : values) list.push_back(value);
  return list;
}

/// Little-endian, as are all machines that this runs on.
void append(std::string& bytes, std::size_t value) {
  const auto word = static_cast<std::uint32_t>(value);
  bytes.append(reinterpret_cast<const char*>(&word), sizeof word);
}

void appendChunk(std::string& bytes, std::uint32_t kind, const std::string& content) {
  append(bytes, content.size());
  append(bytes, kind);
  bytes += content;
}

}  // namespace

GlbBuilder::GlbBuilder(const std::string& generator) {
  json_["asset"] = {{"version", "2.0"}, {"generator", generator}};
}

std::size_t GlbBuilder::add(const char* list, Json entry) {
  json_[list].push_back(std::move(entry));
  return json_[list].size() - 1;
}

std::size_t GlbBuilder::addNumbers(const Eigen::MatrixXf& elements, Use use) {
  const std::size_t size = static_cast<std::size_t>(elements.size()) * sizeof(float);
  Json view{{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", size}};
  if (use == Use::Vertices) view["target"] = kArrayBuffer;
  buffer_.append(reinterpret_cast<const char*>(elements.data()), size);
  return add("accessors", {{"bufferView", add("bufferViews", view)},
                           {"componentType", kFloat},
                           {"count", elements.cols()},
                           {"type", typeOf(elements.rows())},
                           {"min", numberList(elements.rowwise().minCoeff())},
                           {"max", numberList(elements.rowwise().maxCoeff())}});
}

Result<std::string> GlbBuilder::bytes() const {
  Json json = json_;
  json["buffers"] = Json::array({{{"byteLength", buffer_.size()}}});
  std::string text = jsonText(json);
  text.resize((text.size() + 3) / 4 * 4, ' ');  // chunks are aligned; the buffer holds whole floats
  const std::size_t size = kHeaderBytes + 2 * kChunkHeaderBytes + text.size() + buffer_.size();
  if (size > std::numeric_limits<std::uint32_t>::max()) {
    return Diagnostic{ErrorKind::LimitReached, "", "", "the bodies have too many triangles for a GLB file (4 GiB)",
                      "Export the path in another format."};
  }
  std::string bytes;
  bytes.reserve(size);
  append(bytes, kMagic);
  append(bytes, kGlbVersion);
  append(bytes, size);
  appendChunk(bytes, kJsonChunk, text);
  appendChunk(bytes, kBinaryChunk, buffer_);
  return bytes;
}

}  // namespace glissade
