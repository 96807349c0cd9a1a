#include "engine/import/step_assembly.h"

#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "engine/base/printable_text.h"
#include "engine/import/import_protocol.h"
#include "engine/import/step_losses.h"

namespace glissade {
namespace {

/// An assembly that holds itself would have no end.
constexpr int kDeepestAssembly = 64;
/// Assemblies that use each other twice at every level would take time without end.
constexpr std::size_t kMostOccurrences = 100'000;

std::string nameOf(const TDF_Label& label) {
  Handle(TDataStd_Name) name;
  if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return {};
  std::string text(static_cast<std::size_t>(name->Get().LengthOfCString()) + 1, '\0');
  Standard_PCharacter start = text.data();
  text.resize(static_cast<std::size_t>(name->Get().ToUTF8CString(start)));
  return text;
}

/// As one step of a path: printable, without '/', ASCII's control characters and blanks at its ends.
std::string asStep(std::string name) {
  std::replace(name.begin(), name.end(), '/', '_');
  name.erase(std::remove_if(name.begin(), name.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }),
             name.end());
  name = printableLine(name);
  const auto first = name.find_first_not_of(' ');
  if (first == std::string::npos) return {};
  return name.substr(first, name.find_last_not_of(' ') - first + 1);
}

/// Names that are each given once: the second "pin" is "pin#2".
class UniqueNames {
 public:
  std::string take(const std::string& name) {
    std::string unique = name;
    for (int number = 2; !taken_.insert(unique).second; ++number) unique = name + "#" + std::to_string(number);
    return unique;
  }

 private:
  std::set<std::string> taken_;
};

std::string joined(const std::string& path, const std::string& step) { return path.empty() ? step : path + "/" + step; }

bool isRigid(const gp_Trsf& placement) { return std::abs(placement.ScaleFactor() - 1.0) < 1e-9; }

/// Solids, and what lies beside them: loose shells and faces as one.
std::vector<TopoDS_Shape> rigidShapesOf(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Shape> shapes;
  for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next()) shapes.push_back(solid.Current());
  TopoDS_Compound loose;
  BRep_Builder builder;
  builder.MakeCompound(loose);
  TopExp_Explorer face(shape, TopAbs_FACE, TopAbs_SOLID);
  const bool any = face.More();
  for (; face.More(); face.Next()) builder.Add(loose, face.Current());
  if (any) shapes.push_back(loose);
  return shapes;
}

class AssemblyWalk {
 public:
  AssemblyWalk(const Handle(XCAFDoc_ShapeTool) & shapes, const Handle(XCAFDoc_ColorTool) & colours)
      : shapes_(shapes), colours_(colours) {}

  std::vector<StepSolid> walk() {
    TDF_LabelSequence roots;
    shapes_->GetFreeShapes(roots);
    // The one product that the file is about needs no name.
    if (roots.Length() == 1 && XCAFDoc_ShapeTool::IsAssembly(roots.First())) {
      visit(roots.First(), {"", TopLoc_Location(), colourOf(roots.First()), 0});
      return std::move(solids_);
    }
    UniqueNames names;
    for (const TDF_Label& root : roots) visit(root, {names.take(stepOf(root, root)), {}, colourOf(root), 0});
    return std::move(solids_);
  }

 private:
  using OptionalColour = std::optional<std::array<double, 3>>;

  /// What a product inherits from the assemblies that it is in.
  struct Place {
    std::string path;
    TopLoc_Location location;
    OptionalColour colour;
    int depth = 0;
  };

  void visit(const TDF_Label& product, const Place& place) {
    if (place.depth > kDeepestAssembly)
      throw std::runtime_error("its assemblies are nested too deeply, or hold themselves");
    if (++occurrences_ > kMostOccurrences) {
      throw std::runtime_error("it has more than " + std::to_string(kMostOccurrences) + " assemblies and parts");
    }
    if (!XCAFDoc_ShapeTool::IsAssembly(product)) {
      addSolids(product, place);
      return;
    }
    TDF_LabelSequence components;
    XCAFDoc_ShapeTool::GetComponents(product, components);
    UniqueNames names;
    for (const TDF_Label& component : components) {
      TDF_Label part;
      if (!XCAFDoc_ShapeTool::GetReferredShape(component, part)) continue;
      OptionalColour colour = place.colour;
      if (!colour) colour = colourOf(component);
      if (!colour) colour = colourOf(part);
      visit(part, {joined(place.path, names.take(stepOf(part, component))),
                   place.location * XCAFDoc_ShapeTool::GetLocation(component), colour, place.depth + 1});
    }
  }

  void addSolids(const TDF_Label& product, const Place& place) {
    const std::vector<TopoDS_Shape> shapes = rigidShapesOf(XCAFDoc_ShapeTool::GetShape(product));
    UniqueNames names;
    for (const TopoDS_Shape& shape : shapes) {
      if (solids_.size() == import_protocol::kMostParts) {
        throw std::runtime_error("it has more than " + std::to_string(import_protocol::kMostParts) + " parts");
      }
      OptionalColour colour = place.colour;
      if (!colour) colour = colourOf(shape);
      const std::string path =
          shapes.size() == 1 ? place.path : joined(place.path, names.take(solidName(product, shape)));
      const gp_Trsf placement = (place.location * shape.Location()).Transformation();
      if (!isRigid(placement)) throw std::runtime_error("'" + path + "' is mirrored or scaled by its assembly");
      solids_.push_back({path, shape.Located(TopLoc_Location()), placement, colour});
    }
  }

  /// The product's name, which people know; that of its use is often only a number.
  static std::string stepOf(const TDF_Label& product, const TDF_Label& component) {
    std::string name = asStep(nameOf(product));
    if (name.empty()) name = asStep(nameOf(component));
    return name.empty() ? "part" : name;
  }

  std::string solidName(const TDF_Label& product, const TopoDS_Shape& shape) const {
    if (shape.ShapeType() != TopAbs_SOLID) return "surfaces";
    TDF_Label label;
    const std::string name = shapes_->FindSubShape(product, shape, label) ? asStep(nameOf(label)) : "";
    return name.empty() ? "solid" : name;
  }

  template <class Thing>
  OptionalColour colourOfOne(const Thing& thing) const {
    Quantity_Color colour;
    for (const XCAFDoc_ColorType type : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen}) {
      if (!colours_->GetColor(thing, type, colour)) continue;
      std::array<double, 3> values{};
      colour.Values(values[0], values[1], values[2], Quantity_TOC_sRGB);
      return values;
    }
    return std::nullopt;
  }

  OptionalColour colourOf(const TDF_Label& label) const { return colourOfOne(label); }

  /// Of the solid, or of the first of its faces that has one.
  OptionalColour colourOf(const TopoDS_Shape& shape) const {
    OptionalColour colour = colourOfOne(shape);
    for (TopExp_Explorer face(shape, TopAbs_FACE); !colour && face.More(); face.Next()) {
      colour = colourOfOne(face.Current());
    }
    return colour;
  }

  Handle(XCAFDoc_ShapeTool) shapes_;
  Handle(XCAFDoc_ColorTool) colours_;
  std::vector<StepSolid> solids_;
  std::size_t occurrences_ = 0;
};

/// Counts each loss with the parts that have its face, instances of one solid too.
void assign(const std::vector<StepLoss>& losses, std::vector<StepSolid>& solids) {
  std::map<const TopoDS_TShape*, std::vector<StepSolid*>> solidsOfFace;
  for (StepSolid& solid : solids) {
    for (TopExp_Explorer face(solid.shape, TopAbs_FACE); face.More(); face.Next()) {
      solidsOfFace[face.Current().TShape().get()].push_back(&solid);
    }
  }
  for (const StepLoss& loss : losses) {
    const auto found = loss.face.IsNull() ? solidsOfFace.end() : solidsOfFace.find(loss.face.TShape().get());
    if (found == solidsOfFace.end()) throw std::runtime_error(loss.entity + ": " + loss.what);
    for (StepSolid* solid : found->second) ++solid->losses;
  }
}

/// More than a few lines are one line that counts them.
std::vector<std::string> inLines(const std::vector<StepLoss>& losses) {
  constexpr std::size_t kMost = 20;
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < std::min(kMost, losses.size()); ++i) {
    lines.push_back(losses[i].entity + "\t" + losses[i].what);
  }
  if (losses.size() > kMost) lines.push_back("\t" + std::to_string(losses.size() - kMost) + " more could not be made");
  return lines;
}

}  // namespace

StepAssembly readStepAssembly(std::istream& content, bool solidNames) {
  STEPCAFControl_Reader reader;
  reader.SetNameMode(true);
  reader.SetColorMode(true);
  reader.SetLayerMode(false);
  reader.SetPropsMode(false);
  reader.SetGDTMode(false);
  reader.SetMatMode(false);
  reader.SetViewMode(false);
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  Interface_Static::SetIVal("read.stepcaf.subshapes.name", solidNames ? 1 : 0);
  if (reader.ChangeReader().ReadStream("standard input", content) != IFSelect_RetDone) {
    throw std::runtime_error("it is not sound STEP text");
  }
  Handle(TDocStd_Document) document = new TDocStd_Document("XmlXCAF");
  if (!reader.Transfer(document)) throw std::runtime_error("it holds no product that can be understood");
  if (!reader.ExternFiles().IsEmpty())
    throw std::runtime_error("it names other files for its parts, which are not read");
  std::vector<StepSolid> solids =
      AssemblyWalk(XCAFDoc_DocumentTool::ShapeTool(document->Main()), XCAFDoc_DocumentTool::ColorTool(document->Main()))
          .walk();
  if (solids.empty()) throw std::runtime_error("it holds neither a solid nor a face");
  const std::vector<StepLoss> losses = lossesOf(reader);
  if (!losses.empty()) assign(losses, solids);
  return {std::move(solids), inLines(losses)};
}

}  // namespace glissade
