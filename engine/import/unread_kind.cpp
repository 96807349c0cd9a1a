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
  CatalogueText name;
  Remedy remedy = Remedy::Step;
};

constexpr std::array<UnreadKind, 26> kUnreadKinds{
    {{"|sldprt|sldasm|slddrw|", GLISSADE_TEXT("a SolidWorks file")},
     {"|catpart|catproduct|cgr|", GLISSADE_TEXT("a CATIA file")},
     {"|ipt|iam|", GLISSADE_TEXT("an Inventor file")},
     {"|prt|asm|", GLISSADE_TEXT("a part or an assembly of NX, Creo or Solid Edge")},
     {"|par|psm|", GLISSADE_TEXT("a Solid Edge file")},
     {"|jt|", GLISSADE_TEXT("a JT file")},
     {"|x_t|x_b|xmt_txt|xmt_bin|", GLISSADE_TEXT("a Parasolid file")},
     {"|sat|sab|", GLISSADE_TEXT("an ACIS file")},
     {"|f3d|f3z|", GLISSADE_TEXT("a Fusion file")},
     {"|fcstd|", GLISSADE_TEXT("a FreeCAD file")},
     {"|3dm|", GLISSADE_TEXT("a Rhino file")},
     {"|dwg|dxf|", GLISSADE_TEXT("an AutoCAD drawing")},
     {"|vda|", GLISSADE_TEXT("a VDA-FS file")},
     {"|bbrep|", GLISSADE_TEXT("a binary BREP file")},
     {"|scad|", GLISSADE_TEXT("an OpenSCAD program"), Remedy::Mesh},
     {"|3mf|", GLISSADE_TEXT("a 3MF file"), Remedy::Mesh},
     {"|amf|", GLISSADE_TEXT("an AMF file"), Remedy::Mesh},
     {"|skp|", GLISSADE_TEXT("a SketchUp file"), Remedy::Mesh},
     {"|blend|", GLISSADE_TEXT("a Blender file"), Remedy::Mesh},
     {"|fbx|", GLISSADE_TEXT("an FBX file"), Remedy::Mesh},
     {"|3ds|max|", GLISSADE_TEXT("a 3ds Max file"), Remedy::Mesh},
     {"|usd|usda|usdc|usdz|", GLISSADE_TEXT("a USD file"), Remedy::Mesh},
     {"|wrl|x3d|", GLISSADE_TEXT("a VRML or X3D file"), Remedy::Mesh},
     {"|ifc|", GLISSADE_TEXT("a building model (IFC)"), Remedy::Mesh},
     {"|stpx|stpxz|", GLISSADE_TEXT("STEP as XML")},
     {"|stpz|gz|zip|7z|rar|", GLISSADE_TEXT("a compressed file"), Remedy::Unpack}}};

Message adviceFor(Remedy remedy) {
  switch (remedy) {
    case Remedy::Step: return GLISSADE_TEXT("Export it as STEP (AP214 or AP242) in the program that it is from.");
    case Remedy::Mesh: return GLISSADE_TEXT("Export it as STL, OBJ, PLY or glTF in the program that it is from.");
    case Remedy::Unpack: return GLISSADE_TEXT("Unpack it, and give the file that is in it.");
  }
  return {};
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
  return Diagnostic{ErrorKind::MalformedInput,
                    file,
                    "",
                    {GLISSADE_TEXT("is %1, which is not read"), {kind->name}},
                    adviceFor(kind->remedy)};
}

}  // namespace glissade
