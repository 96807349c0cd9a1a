// Swapchains of the runtime for tests, which are textures in the program's own context, and the pictures that are
// shown.
#include <cstring>
#include <utility>

#include "tests/widgets/headset/runtime/runtime_state.h"

#define GL_GLEXT_PROTOTYPES
#define XR_USE_PLATFORM_XLIB
#define XR_USE_GRAPHICS_API_OPENGL
#include <GL/gl.h>
#include <GL/glx.h>
#include <openxr/openxr_platform.h>

namespace glissade::test {
namespace {

using Lock = std::lock_guard<std::mutex>;

constexpr std::size_t kTextures = 3;

/// Complains if the program's context is not current: Mesa accepts one context in two threads without an error.
void expectContext(RuntimeState& state, const char* call) {
  if (glXGetCurrentContext() != state.context) complainOf(state, std::string(call) + ": the context is not current");
}

FakeSwapchain& swapchainOf(RuntimeState& state, XrSwapchain swapchain) {
  return state.swapchains.at(reinterpret_cast<std::uint64_t>(swapchain));
}

XRAPI_ATTR XrResult XRAPI_CALL enumerateFormats(XrSession /*session*/, std::uint32_t capacity, std::uint32_t* count,
                                                std::int64_t* formats) {
  const std::int64_t known[] = {GL_RGBA16F, GL_SRGB8_ALPHA8, GL_RGBA8};
  *count = 3;
  if (capacity >= *count) std::memcpy(formats, known, sizeof known);
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL createSwapchain(XrSession /*session*/, const XrSwapchainCreateInfo* info,
                                               XrSwapchain* swapchain) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  if (const XrResult result = sessionResult(state); result != XR_SUCCESS) return result;
  expectContext(state, "xrCreateSwapchain");
  FakeSwapchain made;
  made.width = static_cast<int>(info->width);
  made.height = static_cast<int>(info->height);
  made.textures.resize(kTextures);
  glGenTextures(kTextures, made.textures.data());
  for (const unsigned texture : made.textures) {
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexStorage2D(GL_TEXTURE_2D, 1, static_cast<GLenum>(info->format), made.width, made.height);
  }
  glBindTexture(GL_TEXTURE_2D, 0);
  *swapchain = newHandle<XrSwapchain>(state);
  state.swapchains[reinterpret_cast<std::uint64_t>(*swapchain)] = made;
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL destroySwapchain(XrSwapchain swapchain) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  expectContext(state, "xrDestroySwapchain");
  glDeleteTextures(kTextures, swapchainOf(state, swapchain).textures.data());
  state.swapchains.erase(reinterpret_cast<std::uint64_t>(swapchain));
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL enumerateImages(XrSwapchain swapchain, std::uint32_t capacity, std::uint32_t* count,
                                               XrSwapchainImageBaseHeader* images) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  *count = kTextures;
  auto* textures = reinterpret_cast<XrSwapchainImageOpenGLKHR*>(images);
  for (std::uint32_t i = 0; i < capacity && i < kTextures; ++i) {
    textures[i].image = swapchainOf(state, swapchain).textures[i];
  }
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL acquireImage(XrSwapchain swapchain, const XrSwapchainImageAcquireInfo* /*info*/,
                                            std::uint32_t* index) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  if (const XrResult result = callResult(state); result != XR_SUCCESS) return result;
  expectContext(state, "xrAcquireSwapchainImage");
  FakeSwapchain& chain = swapchainOf(state, swapchain);
  if (chain.acquired) return XR_ERROR_CALL_ORDER_INVALID;
  chain.acquired = true;
  chain.next = (chain.next + 1) % kTextures;
  *index = static_cast<std::uint32_t>(chain.next);
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL waitImage(XrSwapchain /*swapchain*/, const XrSwapchainImageWaitInfo* /*info*/) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  return callResult(state);
}

XRAPI_ATTR XrResult XRAPI_CALL releaseImage(XrSwapchain swapchain, const XrSwapchainImageReleaseInfo* /*info*/) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  if (const XrResult result = callResult(state); result != XR_SUCCESS) return result;
  expectContext(state, "xrReleaseSwapchainImage");
  FakeSwapchain& chain = swapchainOf(state, swapchain);
  if (!chain.acquired) return XR_ERROR_CALL_ORDER_INVALID;
  chain.acquired = false;
  return XR_SUCCESS;
}

/// Reads a picture with its rows from the top; OpenGL has them from the bottom.
EyePicture read(const FakeSwapchain& chain) {
  EyePicture picture{chain.width, chain.height, {}};
  const std::size_t row = 4U * static_cast<std::size_t>(chain.width);
  std::vector<std::uint8_t> upwards(row * static_cast<std::size_t>(chain.height));
  glBindTexture(GL_TEXTURE_2D, chain.textures[chain.next]);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, upwards.data());
  glBindTexture(GL_TEXTURE_2D, 0);
  for (std::size_t y = static_cast<std::size_t>(chain.height); y-- > 0;) {
    const auto begin = upwards.begin() + static_cast<std::ptrdiff_t>(y * row);
    picture.rgba.insert(picture.rgba.end(), begin, begin + static_cast<std::ptrdiff_t>(row));
  }
  return picture;
}

XRAPI_ATTR XrResult XRAPI_CALL endFrame(XrSession /*session*/, const XrFrameEndInfo* info) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  if (const XrResult result = callResult(state); result != XR_SUCCESS) return result;
  expectContext(state, "xrEndFrame");
  if (!state.inFrame) return XR_ERROR_CALL_ORDER_INVALID;
  state.inFrame = false;
  if (info->layerCount == 0) return XR_SUCCESS;
  ++state.shown;
  if (!std::exchange(state.picturesWanted, false)) return XR_SUCCESS;
  const auto* layer = reinterpret_cast<const XrCompositionLayerProjection*>(info->layers[0]);
  for (std::uint32_t eye = 0; eye < layer->viewCount; ++eye) {
    state.pictures.push_back(read(swapchainOf(state, layer->views[eye].subImage.swapchain)));
  }
  state.changed.notify_all();
  return XR_SUCCESS;
}

}  // namespace

PFN_xrVoidFunction pictureFunction(const char* name) {
  const std::pair<const char*, PFN_xrVoidFunction> functions[] = {
      {"xrEnumerateSwapchainFormats", reinterpret_cast<PFN_xrVoidFunction>(enumerateFormats)},
      {"xrCreateSwapchain", reinterpret_cast<PFN_xrVoidFunction>(createSwapchain)},
      {"xrDestroySwapchain", reinterpret_cast<PFN_xrVoidFunction>(destroySwapchain)},
      {"xrEnumerateSwapchainImages", reinterpret_cast<PFN_xrVoidFunction>(enumerateImages)},
      {"xrAcquireSwapchainImage", reinterpret_cast<PFN_xrVoidFunction>(acquireImage)},
      {"xrWaitSwapchainImage", reinterpret_cast<PFN_xrVoidFunction>(waitImage)},
      {"xrReleaseSwapchainImage", reinterpret_cast<PFN_xrVoidFunction>(releaseImage)},
      {"xrEndFrame", reinterpret_cast<PFN_xrVoidFunction>(endFrame)},
  };
  for (const auto& [known, function] : functions) {
    if (std::strcmp(known, name) == 0) return function;
  }
  return nullptr;
}

}  // namespace glissade::test
