#include <GL/osmesa.h>
#include <dlfcn.h>
#include <osg/GLExtensions>

#include <stdexcept>
#include <string>
#include <vector>

#include "widgets/scene3d/offscreen_context.h"

namespace osg {

/// Replaces OSG's own look-up, which would find libGL's empty functions for those that OSMesa does not export by name.
void* getGLExtensionFuncPtr(const char* name) { return reinterpret_cast<void*>(OSMesaGetProcAddress(name)); }

}  // namespace osg

namespace glissade {
namespace {

/// Checks that OSMesa comes before libGL in this executable: OSG finds gl* by symbol order.
void checkSymbolOrder() {
  Dl_info info{};
  void* clear = dlsym(RTLD_DEFAULT, "glClear");
  const bool found = clear != nullptr && dladdr(clear, &info) != 0 && info.dli_fname != nullptr;
  const std::string library = found ? info.dli_fname : "nothing";
  if (library.find("OSMesa") == std::string::npos) {
    throw std::runtime_error("OpenGL comes from " + library + " instead of OSMesa: this program was linked wrongly");
  }
}

class OsMesaContext final : public OffscreenContext {
 public:
  OsMesaContext() {
    checkSymbolOrder();
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              24,
                              OSMESA_STENCIL_BITS,
                              8,
                              OSMESA_PROFILE,
                              OSMESA_COMPAT_PROFILE,
                              0};
    context_ = OSMesaCreateContextAttribs(attributes, nullptr);
    if (context_ == nullptr || !makeCurrent(16, 16) || glGetString(GL_VERSION) == nullptr) {
      throw std::runtime_error("no OpenGL context can be had from OSMesa");
    }
  }
  ~OsMesaContext() override { OSMesaDestroyContext(context_); }
  OsMesaContext(const OsMesaContext&) = delete;
  OsMesaContext& operator=(const OsMesaContext&) = delete;

  bool makeCurrent(int width, int height) override {
    if (width != width_ || height != height_) {
      pixels_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4, 0);
      width_ = width;
      height_ = height;
    }
    const bool current = OSMesaMakeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, width, height) == GL_TRUE;
    OSMesaPixelStore(OSMESA_Y_UP, 0);
    return current;
  }

  QImage read() override {
    glFinish();
    return QImage(pixels_.data(), width_, height_, width_ * 4, QImage::Format_RGBX8888).copy();
  }

 private:
  OSMesaContext context_ = nullptr;
  std::vector<unsigned char> pixels_;
  int width_ = 0;
  int height_ = 0;
};

}  // namespace

std::unique_ptr<OffscreenContext> makeOsMesaContext() { return std::make_unique<OsMesaContext>(); }

}  // namespace glissade
