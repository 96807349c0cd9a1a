#include "engine/import/step_stand_in_shapes.h"

#include <BRep_Tool.hxx>
#include <StepData_StepModel.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <set>

namespace glissade {
namespace {

/// Millimetres of a unit of the file: a stand-in is a thousand units large.
double unitOf(const TopoDS_Shape& standIn) {
  constexpr double kUnits = 1000.0;
  double largest = 0.0;
  for (TopExp_Explorer vertex(standIn.Located(TopLoc_Location()), TopAbs_VERTEX); vertex.More(); vertex.Next()) {
    const gp_Pnt at = BRep_Tool::Pnt(TopoDS::Vertex(vertex.Current()));
    largest = std::max({largest, at.X(), at.Y(), at.Z()});
  }
  return largest / kUnits;
}

}  // namespace

StandInShapes::StandInShapes(const STEPCAFControl_Reader& reader, StepStandIns standIns, const StatedShapes& stated) {
  if (standIns.tessellations.empty()) return;
  const auto model = Handle(StepData_StepModel)::DownCast(reader.Reader().WS()->Model());
  const Handle(Transfer_TransientProcess) process = reader.Reader().WS()->TransferReader()->TransientProcess();
  std::map<std::uint64_t, StatedShape> items;
  std::set<std::uint64_t> products;  // products that may have a second representation
  for (const auto* shapes : {&stated.items, &stated.orphans}) {
    for (const StatedShape& item : *shapes) {
      items.emplace(item.entity, item);
      if (item.mayBeSecond) products.insert(item.product);
    }
  }
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto item = items.find(static_cast<std::uint64_t>(model->IdentLabel(model->Value(i))));
    if (item == items.end()) continue;
    const TopoDS_Shape shape = TransferBRep::ShapeResult(process, model->Value(i));
    const auto found = standIns.tessellations.find(item->first);
    if (found != standIns.tessellations.end()) {
      take(item->second, std::move(found->second), shape);
    } else if (!shape.IsNull() && products.count(item->second.product) > 0) {
      for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
        boundaries_.emplace(face.Current().TShape().get(), item->second.product);
      }
    }
  }
}

void StandInShapes::take(const StatedShape& item, StepTessellation triangles, const TopoDS_Shape& standIn) {
  if (!triangles.fault.empty()) {
    faults_.emplace(item.entity, triangles.fault);
    return;
  }
  TopExp_Explorer solid(standIn, TopAbs_SOLID);
  if (!solid.More()) return;
  const double unit = unitOf(solid.Current());
  for (double& coordinate : triangles.vertices) coordinate *= unit;
  standIns_.emplace(solid.Current().TShape().get(), StandIn{item, std::move(triangles)});
}

const StepTessellation* StandInShapes::of(const TopoDS_Shape& solid) const {
  const auto found = standIns_.find(solid.TShape().get());
  return found == standIns_.end() ? nullptr : &found->second.triangles;
}

const StatedShape* StandInShapes::maybeSecond(const TopoDS_Shape& solid) const {
  const auto found = standIns_.find(solid.TShape().get());
  return found == standIns_.end() || !found->second.item.mayBeSecond ? nullptr : &found->second.item;
}

bool StandInShapes::isBoundaryOf(std::uint64_t product, const TopoDS_Shape& shape) const {
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
    const auto found = boundaries_.find(face.Current().TShape().get());
    if (found != boundaries_.end() && found->second == product) return true;
  }
  return false;
}

Message StandInShapes::faultOf(std::uint64_t item) const {
  const auto found = faults_.find(item);
  return found == faults_.end() ? Message() : found->second;
}

}  // namespace glissade
