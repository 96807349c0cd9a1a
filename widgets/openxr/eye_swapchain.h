#pragma once

#include <openxr/openxr.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "widgets/openxr/headset_session.h"

namespace glissade {

/// The pictures of one eye, in turn, as textures of the runtime. Functions throw HeadsetFailure.
class EyeSwapchain {
 public:
  EyeSwapchain(HeadsetSession& session, std::int64_t format, const XrViewConfigurationView& size);
  ~EyeSwapchain();
  EyeSwapchain(const EyeSwapchain&) = delete;
  EyeSwapchain& operator=(const EyeSwapchain&) = delete;

  int width() const { return width_; }
  int height() const { return height_; }
  /// Returns the texture to draw into next, and waits until the runtime does not read it any more. Nothing where the
  /// runtime refuses it.
  std::optional<unsigned> acquire();
  /// Gives the drawn texture back to the runtime.
  void release();
  /// The whole picture, as a layer refers to it.
  XrSwapchainSubImage picture() const;

 private:
  void readTextures();

  HeadsetSession& session_;
  XrSwapchain swapchain_ = XR_NULL_HANDLE;
  int width_;
  int height_;
  std::vector<unsigned> textures_;
};

/// A colour format of OpenGL that both the runtime and the program support; sRGB if possible.
std::int64_t chooseColourFormat(XrSession session);
/// The sizes that the runtime recommends for the eyes.
std::array<XrViewConfigurationView, 2> sizesOfEyes(const HeadsetRuntime& runtime);

}  // namespace glissade
