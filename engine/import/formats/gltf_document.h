#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "engine/import/formats/mesh_content.h"

namespace glissade {

/// The numbers of an accessor, component by component.
struct GltfNumbers {
  std::vector<double> values;
  bool single = false;  ///< they are 32-bit floats
};

/// A glTF 2.0 file, as text or in its binary container (GLB), with checked access to its parts. Data in other files is
/// not read. Every function throws FormatError with a JSON pointer or a byte as its location.
class GltfDocument {
 public:
  using Json = nlohmann::json;

  explicit GltfDocument(std::string_view bytes);

  const Json& root() const { return root_; }
  /// An element of a list of the root, such as "nodes".
  const Json& element(const char* list, std::uint64_t index) const;
  /// All numbers of an accessor with `components` components an element; they may be infinite or not a number.
  GltfNumbers numbers(std::uint64_t accessor, std::size_t components) const;

 private:
  struct View {
    std::string_view bytes;
    std::uint64_t stride = 0;  ///< 0: elements follow without gaps
  };

  void readContainer(std::string_view bytes);
  void checkVersion() const;
  void readBuffers();
  View view(std::uint64_t index) const;
  void readPlain(const Json& accessor, const std::string& location, std::size_t components, GltfNumbers& numbers) const;
  void replaceSparse(const Json& accessor, const std::string& location, std::size_t components,
                     GltfNumbers& numbers) const;

  Json root_;
  std::string_view binary_;           ///< binary part of a GLB
  std::vector<std::string> decoded_;  ///< content of data URIs, by buffer
  std::vector<std::string_view> buffers_;
};

/// A whole number of a JSON object. Throws FormatError if it is no whole number, or if it is missing without a
/// fallback.
std::uint64_t wholeNumber(const nlohmann::json& object, const char* key, const std::string& location);
std::uint64_t wholeNumber(const nlohmann::json& object, const char* key, const std::string& location,
                          std::uint64_t fallback);

}  // namespace glissade
