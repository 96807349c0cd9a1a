#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/base/result.h"

namespace glissade {

/// A GLB file (glTF 2.0, binary) in the making: its JSON and its one buffer of numbers.
class GlbBuilder {
 public:
  using Json = nlohmann::ordered_json;

  /// What numbers are for: glTF wants vertices marked.
  enum class Use { Vertices, KeyFrames };

  explicit GlbBuilder(const std::string& generator);

  Json& json() { return json_; }

  /// Appends an entry to one of the document's lists ("nodes", "meshes", ...) and returns its index.
  std::size_t add(const char* list, Json entry);
  /// Appends numbers to the buffer, a column an element of 1, 3 or 4 of them, and returns the index of
  /// their accessor, which has the smallest and largest of each row.
  std::size_t addNumbers(const Eigen::MatrixXf& elements, Use use);

  /// The file. An error where it is larger than GLB can be (4 GiB).
  Result<std::string> bytes() const;

 private:
  Json json_;
  std::string buffer_;
};

}  // namespace glissade
