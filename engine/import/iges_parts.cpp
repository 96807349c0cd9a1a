#include "engine/import/iges_parts.h"

#include <IGESBasic_SubfigureDef.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Interface_Protocol.hxx>
#include <Interface_Static.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <array>
#include <cstdio>
#include <map>

#include "engine/base/printable_text.h"
#include "engine/import/import_protocol.h"
#include "engine/import/import_refusal.h"
#include "engine/import/loose_parts.h"
#include "engine/import/nothing_read.h"

namespace glissade {
namespace {

namespace protocol = import_protocol;

using Entity = Handle(IGESData_IGESEntity);
using Model = Handle(IGESData_IGESModel);

/// Limits of the gap between faces that sewing closes, millimetres; the file states it.
constexpr double kLeastGap = 1e-3;
constexpr double kMostGap = 0.05;

/// OpenCASCADE reads IGES from a file, or from standard input if the file has no name. The process cannot open files.
void readText(IGESControl_Reader& reader, std::vector<char>& content) {
  stdin = ::fmemopen(content.data(), content.size(), "r");
  if (stdin == nullptr) throw ImportRefusal{GLISSADE_TEXT("it needs more memory than an import may take")};
  if (reader.ReadFile("") != IFSelect_RetDone) throw ImportRefusal{GLISSADE_TEXT("it is not sound IGES text")};
}

std::string entityName(const Entity& entity) {
  Handle(TCollection_HAsciiString) name = entity->HasName() ? entity->NameValue() : nullptr;
  const auto definition = Handle(IGESBasic_SubfigureDef)::DownCast(entity);
  if (name.IsNull() && !definition.IsNull()) name = definition->Name();
  if (name.IsNull() && entity->HasShortLabel()) name = entity->ShortLabel();
  return name.IsNull() ? std::string() : std::string(name->ToCString());
}

/// True for types that OpenCASCADE does not read: blocks, wedges, cylinders, cones, spheres, tori, solids of revolution
/// and of extrusion, ellipsoids, operations, assemblies and instances of solids.
bool isUnreadSolid(int type) {
  static constexpr std::array<int, 12> kTypes{150, 152, 154, 156, 158, 160, 162, 164, 168, 180, 184, 430};
  return std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end();
}

/// True for bounded and trimmed surfaces, solids, faces and shells.
bool isBounded(int type) {
  static constexpr std::array<int, 5> kTypes{143, 144, 186, 510, 514};
  return std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end();
}

/// True for surfaces without a boundary, except planes: they are material if no other entity uses them.
bool isSurface(int type) {
  static constexpr std::array<int, 9> kTypes{114, 118, 120, 122, 128, 140, 192, 194, 196};
  return std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end();
}

class IgesShapes {
 public:
  explicit IgesShapes(const IGESControl_Reader& reader)
      : model_(Model::DownCast(reader.WS()->Model())), process_(reader.WS()->TransferReader()->TransientProcess()) {
    const Interface_Graph uses(model_, reader.WS()->Protocol());
    for (int i = 1; i <= model_->NbEntities(); ++i) {
      const auto entity = Entity::DownCast(model_->Value(i));
      if (entity.IsNull()) continue;
      const TopoDS_Shape shape = TransferBRep::ShapeResult(process_, entity);
      if (shape.IsNull()) {
        if (isMaterial(entity, uses)) missing_.push_back(missingNote(entity));
        continue;
      }
      std::string& name = names_[shape.TShape().get()];
      if (name.empty()) name = entityName(entity);
    }
  }

  std::string nameOf(const TopoDS_Shape& shape) const {
    const auto known = names_.find(shape.TShape().get());
    return known == names_.end() ? std::string() : known->second;
  }

  /// A note for each entity with material that was not made.
  const StepNotes& missing() const { return missing_; }

  double unit() const { return protocol::kMillimetre * model_->GlobalSection().UnitValue(); }

  double gap() const {
    const double stated = model_->GlobalSection().Resolution() * model_->GlobalSection().UnitValue();
    return std::clamp(stated, kLeastGap, kMostGap);
  }

 private:
  /// True if an entity that is not made is missing material.
  static bool isMaterial(const Entity& entity, const Interface_Graph& uses) {
    const int type = entity->TypeNumber();
    return isBounded(type) || isUnreadSolid(type) || (isSurface(type) && uses.Sharings(entity).NbEntities() == 0);
  }

  StepNote missingNote(const Entity& entity) const {
    const int type = entity->TypeNumber();
    const CatalogueText reason =
        isUnreadSolid(type) ? GLISSADE_TEXT("its kind is not read") : GLISSADE_TEXT("it could not be made");
    return {protocol::kMissingLine,
            "",
            reason,
            printableLine(entityName(entity)),
            model_->StringLabel(entity)->ToCString(),
            "IGES " + std::to_string(type)};
  }

  Model model_;
  Handle(Transfer_TransientProcess) process_;
  std::map<const TopoDS_TShape*, std::string> names_;
  StepNotes missing_;
};

}  // namespace

StepAssembly readIgesParts(std::vector<char>& content) {
  IGESControl_Reader reader;
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  readText(reader, content);
  reader.TransferRoots();
  std::vector<TopoDS_Shape> roots;
  for (int i = 1; i <= reader.NbShapes(); ++i) roots.push_back(reader.Shape(i));
  const IgesShapes shapes(reader);
  StepAssembly assembly =
      loosePartsOf(roots, shapes.gap(), [&](const TopoDS_Shape& shape) { return shapes.nameOf(shape); });
  assembly.notes.insert(assembly.notes.end(), shapes.missing().begin(), shapes.missing().end());
  if (assembly.solids.empty()) throw ImportRefusal{nothingRead(assembly.notes)};
  assembly.unit = shapes.unit();
  return assembly;
}

}  // namespace glissade
