#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/files/path_animation.h"
#include "engine/places/rigid_body.h"

namespace glissade {

/// A GLB file (glTF 2.0, binary) in the making: its JSON and its one buffer of numbers.
class GlbBuilder {
 public:
  using Json = nlohmann::ordered_json;

  /// The purpose of numbers, because glTF requires that vertices are marked.
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

/// Adds the root node, which turns z up into y up, and returns it.
std::size_t addGlbWorld(GlbBuilder& glb);

/// Adds a body below the root node, with a material of its colour (glTF's colours are linear, ours sRGB). Returns its
/// node.
std::size_t addGlbBody(GlbBuilder& glb, std::size_t world, const RigidBody& body, double opacity);

/// Motion of a node.
struct GlbTrack {
  std::size_t node;
  std::vector<KeyFrame> frames;  ///< times increase strictly
};

/// Adds one animation that moves nodes, interpolated linearly.
void addGlbAnimation(GlbBuilder& glb, const char* name, const std::vector<GlbTrack>& tracks);

/// True if the coordinates fit into single precision, in which larger numbers would be infinite.
bool isWithinSinglePrecision(const std::vector<KeyFrame>& frames);

}  // namespace glissade
