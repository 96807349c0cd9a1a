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
#include <stdexcept>

#include "engine/assembly/body_path.h"
#include "engine/assembly/unique_names.h"
#include "engine/base/length_units.h"
#include "engine/base/printable_text.h"
#include "engine/import/import_protocol.h"
#include "engine/import/step_external_files.h"
#include "engine/import/step_losses.h"
#include "engine/import/step_mirrors.h"
#include "engine/import/step_missing_shapes.h"
#include "engine/import/step_second_shapes.h"
#include "engine/import/step_shape_notes.h"

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

/// The names of a product and of its use, where one of them is said.
struct StepName {
  std::string step;  ///< never empty
  std::string name;  ///< as the file has it, on one line
};

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
  AssemblyWalk(const Handle(XCAFDoc_ShapeTool) & shapes, const Handle(XCAFDoc_ColorTool) & colours,
               const ExternalFiles& externalFiles, MirroredInstances& mirrored)
      : shapes_(shapes), colours_(colours), externalFiles_(externalFiles), mirrored_(mirrored) {}

  StepAssembly walk() {
    TDF_LabelSequence roots;
    shapes_->GetFreeShapes(roots);
    if (roots.Length() == 1) {
      const TDF_Label& root = roots.First();
      if (!XCAFDoc_ShapeTool::IsAssembly(root)) assembly_.rootName = stepOf(root, root).step;
      visit(root, {"", {}, TopLoc_Location(), colourOf(root), 0});
    } else {
      UniqueNames names;
      for (const TDF_Label& root : roots) {
        const StepName step = stepOf(root, root);
        visit(root, {names.take(step.step), {step.name}, {}, colourOf(root), 0});
      }
    }
    return std::move(assembly_);
  }

 private:
  using OptionalColour = std::optional<std::array<double, 3>>;

  /// What a product inherits from the assemblies that it is in.
  struct Place {
    std::string path;
    std::vector<std::string> names;  ///< of its steps
    TopLoc_Location location;
    OptionalColour colour;
    int depth = 0;
  };

  void visit(const TDF_Label& product, const Place& place) {
    if (place.depth > protocol::kDeepestAssembly)
      throw std::runtime_error("its assemblies are nested too deeply, or hold themselves");
    if (++occurrences_ > protocol::kMostOccurrences) {
      throw std::runtime_error("it has more than " + std::to_string(protocol::kMostOccurrences) +
                               " assemblies and parts");
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
      const StepName step = stepOf(part, component);
      visit(part, {joinedPath(place.path, names.take(step.step)), with(place.names, step.name),
                   place.location * XCAFDoc_ShapeTool::GetLocation(component), colour, place.depth + 1});
    }
  }

  void addSolids(const TDF_Label& product, const Place& place) {
    const TopoDS_Shape whole = XCAFDoc_ShapeTool::GetShape(product);
    const std::vector<TopoDS_Shape> shapes = rigidShapesOf(whole);
    if (shapes.empty()) addExternalPart(whole, place);
    if (!whole.IsNull() && seen_.Add(whole.Located(TopLoc_Location()))) {
      for (std::string& note : curveNotes(whole, place.path)) assembly_.curves.push_back(std::move(note));
    }
    UniqueNames names;
    for (const TopoDS_Shape& shape : shapes) {
      if (assembly_.solids.size() == protocol::kMostParts) {
        throw std::runtime_error("it has more than " + std::to_string(protocol::kMostParts) + " parts");
      }
      OptionalColour colour = place.colour;
      if (!colour) colour = colourOf(shape);
      const bool alone = shapes.size() == 1;
      const StepName step = alone ? StepName{} : solidName(product, shape);
      const std::string path = alone ? place.path : joinedPath(place.path, names.take(step.step));
      assembly_.solids.push_back({path, alone ? place.names : with(place.names, step.name),
                                  shape.Located(TopLoc_Location()),
                                  mirrored_.placementOf(place.location * shape.Location(), path), colour});
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
      throw std::runtime_error("'" + path + "' is mirrored or scaled by its assembly and is in another file");
    }
    return placement.rigid;
  }

  /// The product's name, which people know; that of its use is often only a number.
  static StepName stepOf(const TDF_Label& product, const TDF_Label& component) {
    StepName name = stepNamed(nameOf(product));
    if (name.step.empty()) name = stepNamed(nameOf(component));
    if (name.step.empty()) name.step = "part";
    return name;
  }

  static StepName stepNamed(const std::string& name) { return {asStep(name), printableLine(name)}; }

  static std::vector<std::string> with(std::vector<std::string> names, const std::string& name) {
    names.push_back(name);
    return names;
  }

  StepName solidName(const TDF_Label& product, const TopoDS_Shape& shape) const {
    if (shape.ShapeType() != TopAbs_SOLID) return {"surfaces", "surfaces"};
    TDF_Label label;
    const StepName name = shapes_->FindSubShape(product, shape, label) ? stepNamed(nameOf(label)) : StepName{};
    return name.step.empty() ? StepName{"solid", "solid"} : name;
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
  const ExternalFiles& externalFiles_;
  MirroredInstances& mirrored_;
  TopTools_MapOfShape seen_;  ///< products, wherever they are placed
  StepAssembly assembly_;
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

/// ": #12 CSG_SOLID: its kind is not read" of the first shape that is missing; empty where none is.
std::string firstMissing(const std::vector<std::string>& shapeLines) {
  for (const std::string& line : shapeLines) {
    if (line.front() != protocol::kMissingLine) continue;
    std::string text = line.substr(line.find('\t', 2) + 1);
    text.replace(text.rfind('\t'), 1, ": ");
    std::replace(text.begin(), text.end(), '\t', ' ');
    return ": " + text;
  }
  return {};
}

/// Metres. Of several units the first; of a name that is not known millimetres.
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

StepAssembly readStepAssembly(std::istream& content, bool solidNames, bool isUtf8, StepText text) {
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
  Interface_Static::SetCVal("read.step.codepage", isUtf8 ? "UTF8" : "CP1252");
  if (reader.ChangeReader().ReadStream("standard input", content) != IFSelect_RetDone) {
    throw std::runtime_error("it is not sound STEP text");
  }
  MirroredInstances mirrored(reader);
  Handle(TDocStd_Document) document = new TDocStd_Document("XmlXCAF");
  if (!reader.Transfer(document)) throw std::runtime_error("it holds no product that can be understood");
  mirrored.locate(reader);
  StandInShapes standIns(reader, std::move(text.standIns), text.stated);
  const ExternalFiles externalFiles = externalFilesOf(reader);
  StepAssembly assembly = AssemblyWalk(XCAFDoc_DocumentTool::ShapeTool(document->Main()),
                                       XCAFDoc_DocumentTool::ColorTool(document->Main()), externalFiles, mirrored)
                              .walk();
  mirrored.demandAllUsed();
  SecondShapes second = takeOutSecondShapes(assembly.solids, standIns);
  std::vector<TopoDS_Shape> bodies;
  for (const StepSolid& solid : assembly.solids) bodies.push_back(solid.shape);
  assembly.shapeLines =
      missingShapeLines(reader, {text.entities, text.stated, standIns, second.items, externalFiles}, bodies);
  std::move(second.notes.begin(), second.notes.end(), std::back_inserter(assembly.shapeLines));
  assembly.standIns = std::move(standIns);
  if (assembly.solids.empty() && assembly.externalParts.empty()) {
    throw std::runtime_error("it holds neither a solid nor a face" + firstMissing(assembly.shapeLines));
  }
  const std::vector<StepLoss> losses = lossesOf(reader);
  if (!losses.empty()) assign(losses, assembly.solids);
  assembly.losses = inLines(losses);
  assembly.faceEntities = FaceEntities(reader);
  assembly.measures = statedMeasuresOf(reader);
  assembly.unit = lengthUnitOf(reader.ChangeReader());
  return assembly;
}

}  // namespace glissade
