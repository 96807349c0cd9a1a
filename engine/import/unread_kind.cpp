#include "engine/import/unread_kind.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "engine/base/file.h"

namespace glissade {
namespace {

enum class Remedy { Step, Mesh, Unpack };

struct UnreadKind {
  std::string_view endings;  ///< with a bar before and after each
  const char* name;
  Remedy remedy = Remedy::Step;
};

constexpr std::array<UnreadKind, 26> kUnreadKinds{{{"|sldprt|sldasm|slddrw|", "a SolidWorks file"},
                                                   {"|catpart|catproduct|cgr|", "a CATIA file"},
                                                   {"|ipt|iam|", "an Inventor file"},
                                                   {"|prt|asm|", "a part or an assembly of NX, Creo or Solid Edge"},
                                                   {"|par|psm|", "a Solid Edge file"},
                                                   {"|jt|", "a JT file"},
                                                   {"|x_t|x_b|xmt_txt|xmt_bin|", "a Parasolid file"},
                                                   {"|sat|sab|", "an ACIS file"},
                                                   {"|f3d|f3z|", "a Fusion file"},
                                                   {"|fcstd|", "a FreeCAD file"},
                                                   {"|3dm|", "a Rhino file"},
                                                   {"|dwg|dxf|", "an AutoCAD drawing"},
                                                   {"|vda|", "a VDA-FS file"},
                                                   {"|bbrep|", "a binary BREP file"},
                                                   {"|scad|", "an OpenSCAD program", Remedy::Mesh},
                                                   {"|3mf|", "a 3MF file", Remedy::Mesh},
                                                   {"|amf|", "an AMF file", Remedy::Mesh},
                                                   {"|skp|", "a SketchUp file", Remedy::Mesh},
                                                   {"|blend|", "a Blender file", Remedy::Mesh},
                                                   {"|fbx|", "an FBX file", Remedy::Mesh},
                                                   {"|3ds|max|", "a 3ds Max file", Remedy::Mesh},
                                                   {"|usd|usda|usdc|usdz|", "a USD file", Remedy::Mesh},
                                                   {"|wrl|x3d|", "a VRML or X3D file", Remedy::Mesh},
                                                   {"|ifc|", "a building model (IFC)", Remedy::Mesh},
                                                   {"|stpx|stpxz|", "STEP as XML"},
                                                   {"|stpz|gz|zip|7z|rar|", "a compressed file", Remedy::Unpack}}};

const char* adviceFor(Remedy remedy) {
  switch (remedy) {
    case Remedy::Step: return "Export it as STEP (AP214 or AP242) in the program that it is from.";
    case Remedy::Mesh: return "Export it as STL, OBJ, PLY or glTF in the program that it is from.";
    case Remedy::Unpack: return "Unpack it, and give the file that is in it.";
  }
  return "";
}

/// Creo writes the number of the version after the ending: "bolt.prt.3".
std::string endingWithoutVersion(const std::string& file) {
  const std::string ending = endingOf(file);
  const bool isVersion = !ending.empty() && ending.find_first_not_of("0123456789") == std::string::npos;
  return isVersion ? endingOf(file.substr(0, file.rfind('.'))) : ending;
}

}  // namespace

std::optional<Diagnostic> unreadKind(const std::string& file) {
  const std::string ending = endingWithoutVersion(file);
  if (ending.empty()) return std::nullopt;
  const auto kind = std::find_if(kUnreadKinds.begin(), kUnreadKinds.end(), [&](const UnreadKind& each) {
    return each.endings.find("|" + ending + "|") != std::string_view::npos;
  });
  if (kind == kUnreadKinds.end()) return std::nullopt;
  return Diagnostic{ErrorKind::MalformedInput, file, "", std::string("is ") + kind->name + ", which is not read",
                    adviceFor(kind->remedy)};
}

}  // namespace glissade
