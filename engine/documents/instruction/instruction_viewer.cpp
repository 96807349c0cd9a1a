#include "engine/documents/instruction/instruction_viewer.h"

#include "engine/base/file.h"

namespace glissade {
namespace {

/// Largest animation. The encoded page is larger by a third.
constexpr std::size_t kMostAnimationBytes = 48U << 20;
constexpr std::size_t kMostLibraryBytes = 8U << 20;

}  // namespace

Result<InstructionScene> instructionScene(const std::string& glb, const std::string& folder) {
  if (glb.size() > kMostAnimationBytes) {
    return Diagnostic{ErrorKind::LimitReached, "", "",
                      GLISSADE_TEXT("the page has no 3D view, because the animation is too large"),
                      GLISSADE_TEXT("Save the animation as GLB, and open it in a 3D viewer.")};
  }
  InstructionScene scene{glb, {}};
  for (const char* file :
       {"/build/three.min.js", "/examples/js/loaders/GLTFLoader.js", "/examples/js/controls/OrbitControls.js"}) {
    const auto text = readFile(folder + file, kMostLibraryBytes);
    if (!text) {
      return Diagnostic{ErrorKind::MalformedInput, "", "",
                        GLISSADE_TEXT("the page has no 3D view, because three.js is not installed"),
                        GLISSADE_TEXT("Install the package libjs-three, and save the page again.")};
    }
    scene.library += *text + "\n";
  }
  return scene;
}

}  // namespace glissade
