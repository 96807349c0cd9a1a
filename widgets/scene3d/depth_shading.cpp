#include "widgets/scene3d/depth_shading.h"

#include <osg/BlendFunc>
#include <osg/Depth>
#include <osg/FrameBufferObject>
#include <osg/GLExtensions>
#include <osg/Program>

#include <cmath>
#include <utility>

namespace glissade {
namespace {

/// The render bin. OSG draws bins by their number: opaque bodies are in 0 to 2, transparent ones in 10.
constexpr int kAfterOpaque = 5;
/// Largest distance in pixels from which a place is darkened.
constexpr double kReach = 18.0;
/// Pairs of places that are sampled for each device pixel. Fewer pairs give bands, unless several pixels become one.
constexpr int kPairs = 32;
constexpr int kPairsOversampled = 12;
/// Pairs that are sampled first, over the whole reach: if none of them darkens, the others are skipped.
constexpr int kFirst = 8;
constexpr int kFirstOversampled = 6;
/// Angle between the directions of two pairs, which spreads any number of directions evenly.
constexpr double kGoldenAngle = 2.399963;

constexpr const char* kVertexShader = R"(#version 120
void main() {
  gl_Position = vec4(gl_Vertex.xy, 0.0, 1.0);
}
)";

// The depth of a plane is linear on the screen: the mean of two opposite places less the middle is 0 on a plane, and
// measures concavity elsewhere.
constexpr const char* kFragmentShader = R"(#version 120
uniform sampler2D depths;
uniform vec4 planes;  // near, far, 1 where there is no perspective, pixels per metre
uniform vec3 reach;   // the size of a pixel of the texture, the reach in pixels
uniform vec3 pairs[32];  // the way to one of the two places in reaches, its length; those looked at first
uniform vec2 counts;  // of pairs, of those looked at first
const float kUnseen = 0.02;  // occlusion that does not darken

void main() {
  vec2 here = gl_FragCoord.xy * reach.xy;
  float depth = texture2D(depths, here).r;
  if (depth >= 1.0) discard;
  float range = planes.y - planes.x;
  float distance = mix(planes.x * planes.y / (planes.y - depth * range), 1.0, planes.z);
  float metresPerDepth = mix(distance * distance * range / (planes.x * planes.y), range, planes.z);
  float metresPerPixel = distance / planes.w;
  // Where four pixels become one, each looks in other directions.
  vec2 parity = mod(floor(gl_FragCoord.xy), 2.0);
  float turn = counts.x < 32.0 ? 0.785398 * (parity.x + 2.0 * parity.y) : 0.0;
  mat2 turned = mat2(cos(turn), sin(turn), -sin(turn), cos(turn));
  float occlusion = 0.0;
  for (int i = 0; i < 32; ++i) {
    if (float(i) >= counts.x || (float(i) == counts.y && occlusion < kUnseen * counts.y)) break;
    float radius = reach.z * pairs[i].z;
    vec2 aside = reach.z * (turned * pairs[i].xy) * reach.xy;
    float mean = 0.5 * (texture2D(depths, here + aside).r + texture2D(depths, here - aside).r);
    float concave = (depth - mean) * metresPerDepth / (radius * metresPerPixel);
    // What is far before the place does not darken it as a corner does.
    occlusion += clamp(concave, 0.0, 1.0) * (1.0 - 0.85 * smoothstep(1.0, 5.0, concave));
  }
  float light = 1.0 - 0.62 * smoothstep(kUnseen, 0.9, occlusion / counts.x);
  gl_FragColor = vec4(light, light, light, 1.0);
}
)";

/// A state variable of OpenGL. OSG looks the function up, because this library is linked with no OpenGL of its own.
GLint numberOf(GLenum name) {
  using GetNumber = void (*)(GLenum, GLint*);
  GetNumber getNumber = nullptr;
  GLint number = 0;
  if (osg::setGLExtensionFuncPtr(getNumber, "glGetIntegerv")) getNumber(name, &number);
  return number;
}

/// Copies the depth of what has been drawn into the texture, then draws.
class CopyDepthFirst final : public osg::Drawable::DrawCallback {
 public:
  explicit CopyDepthFirst(const osg::ref_ptr<osg::Texture2D>& depth) : depth_(depth) {}

  void drawImplementation(osg::RenderInfo& info, const osg::Drawable* drawable) const override {
    if (depth_->getTextureWidth() <= 0) return;  // the window has not drawn, so that there is no size yet
    osg::State& state = *info.getState();
    state.applyTextureAttribute(0, depth_);
    if (numberOf(GL_SAMPLES) > 0) {
      resolve(state);
    } else {
      depth_->copyTexSubImage2D(state, 0, 0, 0, 0, depth_->getTextureWidth(), depth_->getTextureHeight());
    }
    drawable->drawImplementation(info);
  }

 private:
  /// Resolves the depth of a buffer with several samples per pixel, which only a blit can copy.
  void resolve(osg::State& state) const {
    const auto* gl = state.get<osg::GLExtensions>();
    const auto target = static_cast<GLuint>(numberOf(GL_FRAMEBUFFER_BINDING_EXT));
    if (framebuffer_ == 0) gl->glGenFramebuffers(1, &framebuffer_);
    gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER_EXT, framebuffer_);
    gl->glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER_EXT, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D,
                               depth_->getTextureObject(state.getContextID())->id(), 0);
    gl->glBindFramebuffer(GL_READ_FRAMEBUFFER_EXT, target);
    const int width = depth_->getTextureWidth();
    const int height = depth_->getTextureHeight();
    gl->glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    gl->glBindFramebuffer(GL_FRAMEBUFFER_EXT, target);
  }

  osg::ref_ptr<osg::Texture2D> depth_;
  mutable GLuint framebuffer_ = 0;
};

}  // namespace

DepthShading::DepthShading()
    : quad_(new osg::Geometry),
      depth_(new osg::Texture2D),
      planes_(new osg::Uniform("planes", osg::Vec4())),
      reach_(new osg::Uniform("reach", osg::Vec3())),
      pairs_(new osg::Uniform(osg::Uniform::FLOAT_VEC3, "pairs", kPairs)),
      counts_(new osg::Uniform("counts", osg::Vec2())) {
  depth_->setInternalFormat(GL_DEPTH24_STENCIL8_EXT);
  depth_->setSourceFormat(GL_DEPTH_STENCIL_EXT);
  depth_->setSourceType(GL_UNSIGNED_INT_24_8_EXT);
  depth_->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
  depth_->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
  depth_->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
  depth_->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
  depth_->setResizeNonPowerOfTwoHint(false);
  osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
  for (const auto& [x, y] : {std::pair{-1, -1}, std::pair{1, -1}, std::pair{1, 1}, std::pair{-1, 1}}) {
    corners->push_back(osg::Vec3(static_cast<float>(x), static_cast<float>(y), 0.0F));
  }
  quad_->setVertexArray(corners);
  quad_->addPrimitiveSet(new osg::DrawArrays(GL_QUADS, 0, 4));
  quad_->setUseDisplayList(false);
  quad_->setUseVertexBufferObjects(true);
  quad_->setCullingActive(false);
  quad_->setDrawCallback(new CopyDepthFirst(depth_));
  osg::ref_ptr<osg::Program> program = new osg::Program;
  program->addShader(new osg::Shader(osg::Shader::VERTEX, kVertexShader));
  program->addShader(new osg::Shader(osg::Shader::FRAGMENT, kFragmentShader));
  osg::StateSet* state = quad_->getOrCreateStateSet();
  state->setAttributeAndModes(program);
  state->setTextureAttribute(0, depth_);
  state->addUniform(new osg::Uniform("depths", 0));
  state->addUniform(planes_);
  state->addUniform(reach_);
  state->addUniform(pairs_);
  state->addUniform(counts_);
  state->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
  state->setAttributeAndModes(new osg::Depth(osg::Depth::ALWAYS, 0.0, 1.0, false));
  state->setAttributeAndModes(new osg::BlendFunc(GL_ZERO, GL_SRC_COLOR));
  state->setRenderBinDetails(kAfterOpaque, "RenderBin");
}

void DepthShading::prepare(int width, int height, double nearPlane, double farPlane, bool orthographic,
                           double pixelsPerMetre, double pixelScale) {
  if (width != depth_->getTextureWidth() || height != depth_->getTextureHeight()) {
    depth_->setTextureSize(width, height);
    depth_->dirtyTextureObject();
  }
  planes_->set(osg::Vec4(static_cast<float>(nearPlane), static_cast<float>(farPlane), orthographic ? 1.0F : 0.0F,
                         static_cast<float>(pixelsPerMetre)));
  const bool isOversampled = pixelScale >= 2.0;
  reach_->set(osg::Vec3(1.0F / static_cast<float>(width), 1.0F / static_cast<float>(height),
                        static_cast<float>(kReach * pixelScale)));
  if (isOversampled) {
    setPairs(kPairsOversampled, kFirstOversampled);
  } else {
    setPairs(kPairs, kFirst);
  }
}

/// Sets the pairs. Each has its own direction and distance; every n-th pair comes first.
void DepthShading::setPairs(int count, int first) {
  counts_->set(osg::Vec2(static_cast<float>(count), static_cast<float>(first)));
  const int stride = count / first;
  unsigned int next = 0;
  for (int begin = 0; begin < stride; ++begin) {
    for (int pair = begin; pair < count; pair += stride) {
      const double share = (pair + 0.5) / count;
      const double angle = kGoldenAngle * pair;
      pairs_->setElement(next++, osg::Vec3(static_cast<float>(share * std::cos(angle)),
                                           static_cast<float>(share * std::sin(angle)), static_cast<float>(share)));
    }
  }
}

}  // namespace glissade
