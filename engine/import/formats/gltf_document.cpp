#include "engine/import/formats/gltf_document.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace glissade {
namespace {

/// Decodes a base64 text (RFC 4648); nothing if it is malformed.
std::optional<std::string> decodeBase64(std::string_view text) {
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t collected = 0;
  int bits = 0;
  for (const char c : text) {
    const std::size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos) return std::nullopt;
    collected = (collected << 6U) | static_cast<std::uint32_t>(digit);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>((collected >> static_cast<unsigned>(bits)) & 0xffU);
  }
  if (bits >= 6) return std::nullopt;
  return bytes;
}

using Json = nlohmann::json;

constexpr std::string_view kMagic = "glTF";
constexpr std::uint32_t kJsonChunk = 0x4e4f534a;
constexpr std::uint32_t kBinaryChunk = 0x004e4942;

template <class T>
T valueAt(std::string_view bytes, std::uint64_t at) {
  if (at > bytes.size() || bytes.size() - at < sizeof(T)) {
    throw FormatError{{GLISSADE_TEXT("byte %1"), {bytes.size()}}, GLISSADE_TEXT("ends before its last chunk")};
  }
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof(T));
  return value;
}

std::string locationOf(const char* list, std::uint64_t index) {
  return std::string("/") + list + "/" + std::to_string(index);
}

enum ComponentType : std::uint64_t { kByte = 5120, kUByte, kShort, kUShort, kUInt = 5125, kFloat };

std::size_t bytesOf(std::uint64_t type, const std::string& location) {
  switch (type) {
    case kByte:
    case kUByte: return 1;
    case kShort:
    case kUShort: return 2;
    case kUInt:
    case kFloat: return 4;
    default: throw FormatError{location, {GLISSADE_TEXT("has the unknown component type %1"), {type}}};
  }
}

template <class T>
double component(const char* at, bool normalized) {
  T value;
  std::memcpy(&value, at, sizeof value);
  if (!normalized) return static_cast<double>(value);
  return std::max(static_cast<double>(value) / static_cast<double>(std::numeric_limits<T>::max()), -1.0);
}

double component(const char* at, std::uint64_t type, bool normalized) {
  switch (type) {
    case kByte: return component<std::int8_t>(at, normalized);
    case kUByte: return component<std::uint8_t>(at, normalized);
    case kShort: return component<std::int16_t>(at, normalized);
    case kUShort: return component<std::uint16_t>(at, normalized);
    case kUInt: return component<std::uint32_t>(at, normalized);
    default: return component<float>(at, false);
  }
}

/// The `size` bytes from `offset` on.
std::string_view part(std::string_view bytes, std::uint64_t offset, std::uint64_t size, const Location& location) {
  if (offset > bytes.size() || size > bytes.size() - offset)
    throw FormatError{location, GLISSADE_TEXT("goes beyond the end of its data")};
  return bytes.substr(offset, size);
}

}  // namespace

std::uint64_t wholeNumber(const Json& object, const char* key, const std::string& location) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  if (!object.is_object() || found == object.end() || !found->is_number_unsigned()) {
    throw FormatError{location, {GLISSADE_TEXT("has no whole number '%1'"), {key}}};
  }
  return found->get<std::uint64_t>();
}

std::uint64_t wholeNumber(const Json& object, const char* key, const std::string& location, std::uint64_t fallback) {
  return object.is_object() && !object.contains(key) ? fallback : wholeNumber(object, key, location);
}

GltfDocument::GltfDocument(std::string_view bytes) {
  std::string_view text = bytes;
  if (bytes.substr(0, kMagic.size()) == kMagic) {
    readContainer(bytes);
  } else {
    root_ = Json::parse(text.begin(), text.end(), nullptr, false);
  }
  if (!root_.is_object()) throw FormatError{"", GLISSADE_TEXT("is not a glTF file: its JSON is malformed or cut off")};
  checkVersion();
  readBuffers();
}

void GltfDocument::readContainer(std::string_view bytes) {
  constexpr std::uint64_t kHeader = 12;
  constexpr std::uint64_t kChunkHeader = 8;
  const auto version = valueAt<std::uint32_t>(bytes, 4);
  if (version != 2)
    throw FormatError{{GLISSADE_TEXT("byte %1"), {4}}, {GLISSADE_TEXT("is of version %1; only 2 is read"), {version}}};
  const auto length = valueAt<std::uint32_t>(bytes, 8);
  if (length > bytes.size()) {
    throw FormatError{{GLISSADE_TEXT("byte %1"), {8}},
                      {GLISSADE_TEXT("claims a length of %1 bytes but is only %2 bytes long"), {length, bytes.size()}}};
  }
  const std::string_view whole = bytes.substr(0, length);
  for (std::uint64_t at = kHeader; at < whole.size();) {
    const auto size = valueAt<std::uint32_t>(whole, at);
    const auto type = valueAt<std::uint32_t>(whole, at + 4);
    const std::string_view chunk = part(whole, at + kChunkHeader, size, {GLISSADE_TEXT("byte %1"), {at}});
    if (type == kJsonChunk) root_ = Json::parse(chunk.begin(), chunk.end(), nullptr, false);
    if (type == kBinaryChunk) binary_ = chunk;
    at += kChunkHeader + size;
  }
}

void GltfDocument::checkVersion() const {
  const auto asset = root_.find("asset");
  const std::string version =
      asset != root_.end() && asset->contains("version") && (*asset)["version"].is_string() ? (*asset)["version"] : "";
  if (version.rfind("2.", 0) != 0)
    throw FormatError{"/asset", {GLISSADE_TEXT("is of version %1; only 2 is read"), {inQuotes(version)}}};
}

void GltfDocument::readBuffers() {
  const auto found = root_.find("buffers");
  if (found == root_.end()) return;
  decoded_.resize(found->size());
  for (std::size_t i = 0; i < found->size(); ++i) {
    const std::string location = locationOf("buffers", i);
    const Json& buffer = element("buffers", i);
    const std::uint64_t size = wholeNumber(buffer, "byteLength", location);
    const auto uri = buffer.find("uri");
    std::string_view bytes = binary_;
    if (uri != buffer.end()) {
      if (!uri->is_string()) throw FormatError{location, GLISSADE_TEXT("has a 'uri' that is not a text")};
      const auto& text = uri->get_ref<const std::string&>();
      const std::size_t data = text.find(";base64,");
      if (text.rfind("data:", 0) != 0 || data == std::string::npos) {
        throw FormatError{location, {GLISSADE_TEXT("keeps its data in a file of its own (%1)"), {inQuotes(text)}}};
      }
      auto decoded = decodeBase64(std::string_view(text).substr(data + 8));
      if (!decoded) throw FormatError{location, GLISSADE_TEXT("holds data that is not base64")};
      decoded_[i] = std::move(*decoded);
      bytes = decoded_[i];
    }
    buffers_.push_back(part(bytes, 0, size, location));
  }
}

const GltfDocument::Json& GltfDocument::element(const char* list, std::uint64_t index) const {
  const auto found = root_.find(list);
  if (found == root_.end() || !found->is_array() || index >= found->size() || !(*found)[index].is_object()) {
    throw FormatError{locationOf(list, index), GLISSADE_TEXT("does not exist")};
  }
  return (*found)[index];
}

GltfDocument::View GltfDocument::view(std::uint64_t index) const {
  const std::string location = locationOf("bufferViews", index);
  const Json& json = element("bufferViews", index);
  const std::uint64_t buffer = wholeNumber(json, "buffer", location);
  if (buffer >= buffers_.size()) throw FormatError{location, GLISSADE_TEXT("names a buffer that does not exist")};
  return {part(buffers_[buffer], wholeNumber(json, "byteOffset", location, 0),
               wholeNumber(json, "byteLength", location), location),
          wholeNumber(json, "byteStride", location, 0)};
}

GltfNumbers GltfDocument::numbers(std::uint64_t index, std::size_t components) const {
  const std::string location = locationOf("accessors", index);
  const Json& accessor = element("accessors", index);
  static constexpr std::array kTypes{"", "SCALAR", "VEC2", "VEC3"};
  if (!accessor.contains("type") || accessor["type"] != kTypes[components]) {
    throw FormatError{location, {GLISSADE_TEXT("is not of the type %1"), {kTypes[components]}}};
  }
  GltfNumbers numbers;
  numbers.single = wholeNumber(accessor, "componentType", location) == kFloat;
  if (accessor.contains("bufferView")) {
    readPlain(accessor, location, components, numbers);
  } else if (!accessor.contains("sparse")) {
    throw FormatError{location, GLISSADE_TEXT("has no data")};
  }
  if (accessor.contains("sparse")) replaceSparse(accessor, location, components, numbers);
  return numbers;
}

void GltfDocument::readPlain(const Json& accessor, const std::string& location, std::size_t components,
                             GltfNumbers& numbers) const {
  const std::uint64_t type = wholeNumber(accessor, "componentType", location);
  const std::uint64_t count = wholeNumber(accessor, "count", location);
  const std::size_t bytes = bytesOf(type, location);
  const View source = view(wholeNumber(accessor, "bufferView", location));
  const std::uint64_t offset = wholeNumber(accessor, "byteOffset", location, 0);
  const std::uint64_t size = components * bytes;
  const std::uint64_t stride = source.stride == 0 ? size : source.stride;
  if (count == 0) throw FormatError{location, GLISSADE_TEXT("has no element")};
  if (stride < size || offset > source.bytes.size() || source.bytes.size() - offset < size ||
      (source.bytes.size() - offset - size) / stride < count - 1) {
    throw FormatError{location, {GLISSADE_TEXT("claims %1 elements, more than its data holds"), {count}}};
  }
  const bool normalized = accessor.value("normalized", false);
  numbers.values.reserve(count * components);
  for (std::uint64_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < components; ++k) {
      numbers.values.push_back(component(source.bytes.data() + offset + i * stride + k * bytes, type, normalized));
    }
  }
}

void GltfDocument::replaceSparse(const Json& accessor, const std::string& location, std::size_t components,
                                 GltfNumbers& numbers) const {
  const Json& sparse = accessor["sparse"];
  const std::uint64_t count = wholeNumber(accessor, "count", location);
  if (!sparse.is_object() || !sparse.contains("indices") || !sparse.contains("values")) {
    throw FormatError{location + "/sparse", GLISSADE_TEXT("has no indices or no values")};
  }
  if (numbers.values.empty()) {
    // Zeros without data in the file; their number is limited by the number of bytes of the file.
    std::uint64_t bytes = 0;
    for (const std::string_view buffer : buffers_) bytes += buffer.size();
    if (count > bytes) throw FormatError{location, GLISSADE_TEXT("claims more elements than the file has bytes")};
    numbers.values.assign(count * components, 0.0);
  }
  const auto read = [&](const char* key, std::size_t width, std::uint64_t type) {
    Json plain = sparse[key];
    plain["count"] = wholeNumber(sparse, "count", location + "/sparse");
    plain["componentType"] = type;
    GltfNumbers found;
    readPlain(plain, location + "/sparse/" + key, width, found);
    return found.values;
  };
  const std::uint64_t indexType = wholeNumber(sparse["indices"], "componentType", location + "/sparse/indices");
  const std::vector<double> indices = read("indices", 1, indexType);
  const std::vector<double> values = read("values", components, wholeNumber(accessor, "componentType", location));
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (!(indices[i] >= 0.0 && indices[i] < static_cast<double>(count))) {
      throw FormatError{location + "/sparse", GLISSADE_TEXT("has an index that does not exist")};
    }
    std::copy_n(
        values.begin() + static_cast<std::ptrdiff_t>(i * components), components,
        numbers.values.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(indices[i]) * components));
  }
}

}  // namespace glissade
