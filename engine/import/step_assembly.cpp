#include "engine/import/step_assembly.h"

#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_AsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "engine/base/length_units.h"
#include "engine/base/printable_text.h"
#include "engine/import/import_protocol.h"
#include "engine/import/import_refusal.h"
#include "engine/import/node_steps.h"
#include "engine/import/nothing_read.h"
#include "engine/import/step_external_files.h"
#include "engine/import/step_losses.h"
#include "engine/import/step_mirrors.h"
#include "engine/import/step_missing_shapes.h"
#include "engine/import/step_names.h"
#include "engine/import/step_second_shapes.h"
#include "engine/import/step_shape_notes.h"
#include "engine/model/body_path.h"

namespace glissade {
namespace {

namespace protocol = import_protocol;

std::string nameOf(const TDF_Label& label) {
  Handle(TDataStd_Name) name;
  if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return {};
  std::string text(static_cast<std::size_t>(name->Get().LengthOfCString()) + 1, '\0');
  Standard_PCharacter start = text.data();
  text.resize(static_cast<std::size_t>(name->Get().ToUTF8CString(start)));
  return text;
}

/// The solids of a shape, and one compound of its loose shells and faces.
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

/// True for the names that OpenCASCADE gives to shapes that the file has no product for.
bool isKindOfShape(const std::string& name) {
  constexpr std::array kKinds{"SOLID", "COMPOUND", "COMPSOLID", "SHELL", "FACE", "WIRE", "EDGE", "VERTEX"};
  return std::find(kKinds.begin(), kKinds.end(), name) != kKinds.end();
}

class AssemblyWalk {
 public:
  AssemblyWalk(const Handle(XCAFDoc_ShapeTool) & shapes, const Handle(XCAFDoc_ColorTool) & colours,
               const ExternalFiles& externalFiles, MirroredInstances& mirrored, const StepNames& names)
      : shapes_(shapes), colours_(colours), externalFiles_(externalFiles), mirrored_(mirrored), names_(names) {}

  StepAssembly walk() {
    TDF_LabelSequence roots;
    shapes_->GetFreeShapes(roots);
    std::vector<NodeNames> names;
    std::vector<std::string> former;
    for (const TDF_Label& root : roots) {
      former.push_back(nameOf(root));
      names.push_back({names_.ofRoot(root).value_or(printableLine(former.back()))});
    }
    const std::vector<NodeStep> steps = stepsFor(names, former);
    const bool several = steps.size() > 1;
    if (steps.size() == 1 && !XCAFDoc_ShapeTool::IsAssembly(roots.First())) assembly_.rootName = steps.front().step;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const TDF_Label& root = roots.Value(static_cast<int>(i) + 1);
      Place top;
      top.product = names[i].product;
      top.colour = colourOf(root);
      visit(root, several ? below(top, steps[i]) : top);
    }
    return std::move(assembly_);
  }

 private:
  using OptionalColour = std::optional<std::array<double, 3>>;

  /// Data that a product inherits from the assemblies that contain it.
  struct Place {
    std::string path;
    std::string formerPath;
    std::vector<NodeNames> names;  ///< names of the path's steps
    std::string product;           ///< name of the product at this place
    TopLoc_Location location;
    OptionalColour colour;
    int depth = 0;
    bool isBesideUses = false;  ///< it is a shape of an assembly that also uses products
  };

  void visit(const TDF_Label& product, const Place& place) {
    if (place.depth > protocol::kDeepestAssembly) {
      throw ImportRefusal{GLISSADE_TEXT("its assemblies are nested too deeply, or hold themselves")};
    }
    if (++occurrences_ > protocol::kMostOccurrences) {
      throw ImportRefusal{{GLISSADE_TEXT("it has more than %1 assemblies and parts"), {protocol::kMostOccurrences}}};
    }
    if (!XCAFDoc_ShapeTool::IsAssembly(product)) {
      addSolids(product, place);
      return;
    }
    const std::vector<Component> components = componentsOf(product, place.product);
    const bool usesProducts = std::any_of(components.begin(), components.end(),
                                          [](const Component& component) { return !component.isOwnShape; });
    for (const Component& component : components) {
      Place inside = below(place, component.name);
      inside.location = place.location * XCAFDoc_ShapeTool::GetLocation(component.use);
      if (!inside.colour) inside.colour = colourOf(component.use);
      if (!inside.colour) inside.colour = colourOf(component.part);
      ++inside.depth;
      inside.isBesideUses = component.isOwnShape && usesProducts;
      visit(component.part, inside);
    }
  }

  struct Component {
    TDF_Label use;
    TDF_Label part;
    NodeStep name;
    bool isOwnShape = false;  ///< a shape of the assembly's own product
  };

  /// The step is made of the product's name, which people know; the name of a use is often only a number. OpenCASCADE
  /// makes an assembly of a product with several shapes, and calls them "SOLID": they have the name of the product.
  std::vector<Component> componentsOf(const TDF_Label& assembly, const std::string& product) const {
    TDF_LabelSequence labels;
    XCAFDoc_ShapeTool::GetComponents(assembly, labels);
    std::vector<Component> components;
    std::vector<TopoDS_Shape> shapes;
    std::vector<std::string> former;
    for (const TDF_Label& use : labels) {
      TDF_Label part;
      if (!XCAFDoc_ShapeTool::GetReferredShape(use, part)) continue;
      components.push_back({use, part, {}});
      shapes.push_back(XCAFDoc_ShapeTool::GetShape(use));
      const std::string name = nameOf(part);
      former.push_back(asStep(name).empty() ? nameOf(use) : name);
    }
    std::vector<NodeNames> names;
    std::vector<bool> isUse;
    for (const auto& own : names_.ofUses(assembly, shapes)) {
      isUse.push_back(own.has_value());
      names.push_back(own.value_or(NodeNames{}));
      // A node without a name gets the name that OpenCASCADE gives to it.
      if (asStep(names.back().product).empty()) names.back().product = printableLine(former[names.size() - 1]);
    }
    const std::vector<NodeStep> steps = stepsFor(names, former);
    for (std::size_t i = 0; i < steps.size(); ++i) {
      components[i].name = steps[i];
      if (isUse[i] || !isKindOfShape(former[i]) || product.empty()) continue;
      components[i].name.names.product = product;
      components[i].isOwnShape = true;
    }
    return components;
  }

  static Place below(const Place& place, const NodeStep& name) {
    Place inside = place;
    inside.path = joinedPath(place.path, name.step);
    inside.formerPath = joinedPath(place.formerPath, name.former);
    inside.names.push_back(name.names);
    inside.product = name.names.product;
    return inside;
  }

  void addSolids(const TDF_Label& product, const Place& place) {
    const TopoDS_Shape whole = XCAFDoc_ShapeTool::GetShape(product);
    const std::vector<TopoDS_Shape> shapes = rigidShapesOf(whole);
    if (shapes.empty()) addExternalPart(whole, place);
    if (!whole.IsNull() && seen_.Add(whole.Located(TopLoc_Location()))) {
      for (StepNote& note : curveNotes(whole, place.path)) assembly_.notes.push_back(std::move(note));
    }
    const bool several = shapes.size() > 1;
    const std::vector<NodeStep> steps = solidNames(product, shapes);
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      if (assembly_.solids.size() == protocol::kMostParts) {
        throw ImportRefusal{{GLISSADE_TEXT("it has more than %1 parts"), {protocol::kMostParts}}};
      }
      const TopoDS_Shape& shape = shapes[i];
      const Place at = several ? below(place, steps[i]) : place;
      const StepPlacement placement = mirrored_.placementOf(place.location * shape.Location(), at.path);
      assembly_.solids.push_back({at.path, at.names, shape.Located(TopLoc_Location()), placement,
                                  place.colour ? place.colour : colourOf(shape)});
      // Solids beside the uses of an assembly are parts of it.
      assembly_.solids.back().isOneOfSeveral = several && !place.isBesideUses;
      if (at.formerPath != at.path) assembly_.solids.back().formerPath = at.formerPath;
    }
  }

  /// A product without a shape may be in another file.
  void addExternalPart(const TopoDS_Shape& shape, const Place& place) {
    const auto file = externalFiles_.find(shape.TShape().get());
    if (file == externalFiles_.end()) return;
    const TopLoc_Location location = place.location * shape.Location();
    assembly_.externalParts.push_back({place.path, place.names, rigidPlacement(location, place.path), file->second});
  }

  gp_Trsf rigidPlacement(const TopLoc_Location& location, const std::string& path) {
    const StepPlacement placement = mirrored_.placementOf(location, path);
    if (placement.mirrored || placement.scale != 1.0) {
      throw ImportRefusal{{GLISSADE_TEXT("'%1' is mirrored or scaled by its assembly and is in another file"), {path}}};
    }
    return placement.rigid;
  }

  std::vector<NodeStep> solidNames(const TDF_Label& product, const std::vector<TopoDS_Shape>& shapes) const {
    std::vector<NodeNames> names;
    std::vector<std::string> former;
    for (const TopoDS_Shape& shape : shapes) {
      names.push_back({printableLine(solidName(product, shape))});
      former.push_back(names.back().product);
    }
    return stepsFor(names, former);
  }

  std::string solidName(const TDF_Label& product, const TopoDS_Shape& shape) const {
    if (shape.ShapeType() != TopAbs_SOLID) return "surfaces";
    TDF_Label label;
    const std::string name = shapes_->FindSubShape(product, shape, label) ? nameOf(label) : "";
    return asStep(name).empty() ? "solid" : name;
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

  /// The colour of the solid, or of its first face with a colour.
  OptionalColour colourOf(const TopoDS_Shape& shape) const {
    OptionalColour colour = colourOfOne(shape);
    for (TopExp_Explorer face(shape, TopAbs_FACE); !colour && face.More(); face.Next()) {
      colour = colourOfOne(face.Current());
    }
    return colour;
  }

  Handle(XCAFDoc_ShapeTool) shapes_;
  Handle(XCAFDoc_ColorTool) colours_;
  const ExternalFiles& externalFiles_;
  MirroredInstances& mirrored_;
  const StepNames& names_;
  TopTools_MapOfShape seen_;  ///< products, at any place
  StepAssembly assembly_;
  std::size_t occurrences_ = 0;
};

/// Assigns each loss to the parts that have its face, including all instances of a solid.
void assign(const std::vector<StepLoss>& losses, std::vector<StepSolid>& solids) {
  std::map<const TopoDS_TShape*, std::vector<StepSolid*>> solidsOfFace;
  for (StepSolid& solid : solids) {
    for (TopExp_Explorer face(solid.shape, TopAbs_FACE); face.More(); face.Next()) {
      solidsOfFace[face.Current().TShape().get()].push_back(&solid);
    }
  }
  for (const StepLoss& loss : losses) {
    const auto found = loss.face.IsNull() ? solidsOfFace.end() : solidsOfFace.find(loss.face.TShape().get());
    if (found == solidsOfFace.end()) throw ImportRefusal{{GLISSADE_TEXT("%1: %2"), {loss.entity, loss.what}}};
    for (StepSolid* solid : found->second) ++solid->losses;
  }
}

/// Many losses are reported as a few notes and one note that counts the rest.
StepNotes inNotes(const std::vector<StepLoss>& losses) {
  constexpr std::size_t kMost = 20;
  StepNotes notes;
  for (std::size_t i = 0; i < std::min(kMost, losses.size()); ++i) {
    notes.push_back({protocol::kLossLine, losses[i].entity, losses[i].what});
  }
  if (losses.size() > kMost) {
    notes.push_back({protocol::kLossLine, "", {GLISSADE_TEXT("%1 more could not be made"), {losses.size() - kMost}}});
  }
  return notes;
}

/// Unit of length, metres: the first of several units; millimetres for an unknown name.
double lengthUnitOf(STEPControl_Reader& reader) {
  static constexpr std::array<std::pair<const char*, double>, 8> kUnits{{{"INCH", kInch},
                                                                         {"FOOT", kFoot},
                                                                         {"MILE", 1609.344},
                                                                         {"MICRO", 1e-6},
                                                                         {"MILLI", 1e-3},
                                                                         {"CENTI", 1e-2},
                                                                         {"KILO", 1e3},
                                                                         {"MET", 1.0}}};
  TColStd_SequenceOfAsciiString lengths;
  TColStd_SequenceOfAsciiString angles;
  TColStd_SequenceOfAsciiString solidAngles;
  reader.FileUnits(lengths, angles, solidAngles);
  if (lengths.IsEmpty()) return protocol::kMillimetre;
  TCollection_AsciiString name = lengths.First();
  name.UpperCase();
  for (const auto& [part, metres] : kUnits) {
    if (name.Search(part) > 0) return metres;
  }
  return protocol::kMillimetre;
}

}  // namespace

StepAssembly readStepAssembly(std::istream& content, bool solidNames, StepText text) {
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
  Interface_Static::SetCVal("read.step.codepage", "UTF8");
  if (reader.ChangeReader().ReadStream("standard input", content) != IFSelect_RetDone) {
    throw ImportRefusal{GLISSADE_TEXT("it is not sound STEP text")};
  }
  MirroredInstances mirrored(reader);
  Handle(TDocStd_Document) document = new TDocStd_Document("XmlXCAF");
  if (!reader.Transfer(document)) {
    throw ImportRefusal{GLISSADE_TEXT("it holds no product that can be understood")};
  }
  mirrored.locate(reader);
  StandInShapes standIns(reader, std::move(text.standIns), text.stated);
  const ExternalFiles externalFiles = externalFilesOf(reader);
  const StepNames names(reader);
  StepAssembly assembly =
      AssemblyWalk(XCAFDoc_DocumentTool::ShapeTool(document->Main()), XCAFDoc_DocumentTool::ColorTool(document->Main()),
                   externalFiles, mirrored, names)
          .walk();
  mirrored.demandAllUsed();
  SecondShapes second = takeOutSecondShapes(assembly.solids, standIns);
  std::vector<TopoDS_Shape> bodies;
  for (const StepSolid& solid : assembly.solids) bodies.push_back(solid.shape);
  for (StepNote& note :
       missingShapeNotes(reader, {text.entities, text.stated, standIns, second.items, externalFiles}, bodies)) {
    assembly.notes.push_back(std::move(note));
  }
  std::move(second.notes.begin(), second.notes.end(), std::back_inserter(assembly.notes));
  assembly.standIns = std::move(standIns);
  if (assembly.solids.empty() && assembly.externalParts.empty()) {
    throw ImportRefusal{nothingRead(assembly.notes)};
  }
  const std::vector<StepLoss> losses = lossesOf(reader);
  if (!losses.empty()) assign(losses, assembly.solids);
  assembly.losses = inNotes(losses);
  assembly.faceEntities = FaceEntities(reader);
  assembly.measures = statedMeasuresOf(reader);
  assembly.unit = lengthUnitOf(reader.ChangeReader());
  return assembly;
}

}  // namespace glissade
