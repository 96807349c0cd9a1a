#include "engine/import/step_missing_shapes.h"

#include <StepBasic_Product.hxx>
#include <StepData_StepModel.hxx>
#include <TopExp_Explorer.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <unordered_map>

#include "engine/base/printable_text.h"
#include "engine/import/import_protocol.h"

namespace glissade {
namespace {

class MissingShapeSearch {
 public:
  MissingShapeSearch(const STEPCAFControl_Reader& reader, const KnownShapes& known,
                     const std::vector<TopoDS_Shape>& bodies)
      : known_(known), process_(reader.Reader().WS()->TransferReader()->TransientProcess()) {
    const auto model = Handle(StepData_StepModel)::DownCast(reader.Reader().WS()->Model());
    for (int i = 1; i <= model->NbEntities(); ++i) {
      made_.emplace(static_cast<std::uint64_t>(model->IdentLabel(model->Value(i))), model->Value(i));
    }
    for (const TopoDS_Shape& body : bodies) {
      for (TopExp_Explorer face(body, TopAbs_FACE); face.More(); face.Next()) ++uses_[face.Current().TShape().get()];
      for (TopExp_Explorer solid(body, TopAbs_SOLID); solid.More(); solid.Next())
        ++uses_[solid.Current().TShape().get()];
    }
  }

  StepNotes notes() {
    for (const StatedShape& item : known_.stated.items) {
      if (!item.isSecond && known_.second.count(item.entity) == 0) addItem(item);
    }
    for (const StatedShape& orphan : known_.stated.orphans) addOrphan(orphan);
    for (const StatedGap& gap : known_.stated.shapeless) {
      if (isExternal(gap.product)) continue;
      add(gap.entity, gap.kind, gap.product, GLISSADE_TEXT("the product has no shape in the file"));
    }
    for (const StatedGap& gap : known_.stated.unknownUses) {
      add(gap.entity, gap.kind, gap.product, GLISSADE_TEXT("it places the part, and is not understood"));
    }
    for (const StatedGap& gap : known_.stated.loose) {
      add(gap.entity, gap.kind, gap.product, GLISSADE_TEXT("it belongs to no solid of the file"));
    }
    return std::move(notes_);
  }

 private:
  bool isExternal(std::uint64_t product) const {
    const TopoDS_Shape shape = shapeOf(product);
    return !shape.IsNull() && known_.externalFiles.count(shape.TShape().get()) > 0;
  }

  void addItem(const StatedShape& item) {
    const std::uint64_t places = placesOf(item.entity);
    if (places >= item.places) return;
    add(item.entity, item.kind, item.product, reasonOf(item, places));
  }

  /// `places`: number of places in which the item was made.
  Message reasonOf(const StatedShape& item, std::uint64_t places) const {
    const Message fault = known_.standIns.faultOf(item.entity);
    if (!fault.empty()) return {GLISSADE_TEXT("its triangles cannot be read: %1"), {fault}};
    if (places > 0) return {GLISSADE_TEXT("it was made in %1 of its %2 {2|place|places}"), {places, item.places}};
    if (item.role == StepShapeRole::Unread) return GLISSADE_TEXT("its kind is not read");
    return GLISSADE_TEXT("it could not be made");
  }

  void addOrphan(const StatedShape& orphan) {
    if (placesOf(orphan.entity) == 0) {
      addItem(orphan);
      return;
    }
    notes_.push_back(stepShapeNote(
        import_protocol::kOrphanLine, orphan,
        GLISSADE_TEXT("it belongs to no product of the file and is read as a body where its coordinates are")));
  }

  /// The shape that OpenCASCADE has made of an entity; null: none.
  TopoDS_Shape shapeOf(std::uint64_t entity) const {
    const auto found = made_.find(entity);
    return found == made_.end() ? TopoDS_Shape() : TransferBRep::ShapeResult(process_, found->second);
  }

  /// Number of places of the entity in the bodies: as a solid, or of its face with the most places.
  std::uint64_t placesOf(std::uint64_t entity) const {
    const TopoDS_Shape shape = shapeOf(entity);
    if (shape.IsNull()) return 0;
    std::uint64_t most = usesOf(shape);
    for (const TopAbs_ShapeEnum type : {TopAbs_SOLID, TopAbs_FACE}) {
      for (TopExp_Explorer part(shape, type); part.More(); part.Next()) most = std::max(most, usesOf(part.Current()));
    }
    return most;
  }

  std::uint64_t usesOf(const TopoDS_Shape& shape) const {
    const auto found = uses_.find(shape.TShape().get());
    return found == uses_.end() ? 0 : found->second;
  }

  std::string nameOf(std::uint64_t definition) const {
    const auto found = made_.find(productOfDefinition(known_.entities, definition));
    const auto product = found == made_.end() ? nullptr : Handle(StepBasic_Product)::DownCast(found->second);
    if (product.IsNull()) return {};
    for (const auto& name : {product->Name(), product->Id()}) {
      if (!name.IsNull() && name->Length() > 0) return printableLine(name->ToCString());
    }
    return {};
  }

  void add(std::uint64_t entity, const std::string& kind, std::uint64_t product, const Message& what) {
    notes_.push_back(
        {import_protocol::kMissingLine, "", what, nameOf(product), "#" + std::to_string(entity), printableLine(kind)});
  }

  const KnownShapes& known_;
  Handle(Transfer_TransientProcess) process_;
  std::unordered_map<std::uint64_t, Handle(Standard_Transient)> made_;  ///< entities by number
  std::unordered_map<const TopoDS_TShape*, std::uint64_t> uses_;        ///< uses of solids and faces in the bodies
  StepNotes notes_;
};

}  // namespace

StepNotes missingShapeNotes(const STEPCAFControl_Reader& reader, const KnownShapes& known,
                            const std::vector<TopoDS_Shape>& bodies) {
  return MissingShapeSearch(reader, known, bodies).notes();
}

}  // namespace glissade
