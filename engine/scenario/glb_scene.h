#pragma once

#include <vector>

#include "engine/environment/rigid_body.h"
#include "engine/scenario/glb_builder.h"
#include "engine/scenario/path_animation.h"

namespace glissade {

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
