#include "engine/import/step_names.h"

#include <Interface_InterfaceModel.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepRepr_NextAssemblyUsageOccurrence.hxx>
#include <TDF_Tool.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <map>

#include "engine/base/printable_text.h"

namespace glissade {
namespace {

using Definition = Handle(StepBasic_ProductDefinition);
using Text = Handle(TCollection_HAsciiString);

std::string textOf(const Text& text) { return text.IsNull() ? std::string() : printableLine(text->ToCString()); }

bool isBlank(const std::string& text) { return text.find_first_not_of(' ') == std::string::npos; }

Handle(StepBasic_Product) productOf(const Definition& definition) {
  if (definition.IsNull() || definition->Formation().IsNull()) return nullptr;
  return definition->Formation()->OfProduct();
}

/// The name of the product, or its id if it has no name.
std::string nameOf(const Definition& definition) {
  const Handle(StepBasic_Product) product = productOf(definition);
  if (product.IsNull()) return {};
  const std::string name = textOf(product->Name());
  return isBlank(name) ? textOf(product->Id()) : name;
}

/// A use whose name is the id of its product has no name.
NodeNames namesOf(const Handle(StepRepr_NextAssemblyUsageOccurrence) & use) {
  const Definition definition = use->RelatedProductDefinition();
  const Handle(StepBasic_Product) product = productOf(definition);
  const std::string id = product.IsNull() ? "" : textOf(product->Id());
  NodeNames names{nameOf(definition), textOf(use->Name()), ""};
  if (use->HasReferenceDesignator()) names.designator = textOf(use->ReferenceDesignator());
  if (!namesTheOccurrence(names.occurrence, id)) names.occurrence.clear();
  if (!namesTheOccurrence(names.designator, id)) names.designator.clear();
  return names;
}

std::string entryOf(const TDF_Label& label) {
  TCollection_AsciiString entry;
  TDF_Tool::Entry(label, entry);
  return entry.ToCString();
}

/// The label of a product in the document. Several products with one shape may have the same label.
std::string entryOf(const TopoDS_Shape& product, const STEPCAFControl_Reader& reader) {
  const TopoDS_Shape atOrigin = product.Located(TopLoc_Location());
  return reader.GetShapeLabelMap().IsBound(atOrigin) ? entryOf(reader.GetShapeLabelMap().Find(atOrigin)) : "";
}

}  // namespace

StepNames::StepNames(STEPCAFControl_Reader& reader) {
  const Handle(XSControl_WorkSession) session = reader.Reader().WS();
  const Handle(Transfer_TransientProcess) process = session->TransferReader()->TransientProcess();
  const Handle(Interface_InterfaceModel) model = session->Model();
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto use = Handle(StepRepr_NextAssemblyUsageOccurrence)::DownCast(model->Value(i));
    if (!use.IsNull() && !use->RelatingProductDefinition().IsNull()) {
      const TopoDS_Shape shape = TransferBRep::ShapeResult(process, use);
      const TopoDS_Shape above = TransferBRep::ShapeResult(process, use->RelatingProductDefinition());
      if (!shape.IsNull() && !above.IsNull()) usesIn_[entryOf(above, reader)].push_back({shape, namesOf(use)});
    }
    const auto product = Definition::DownCast(model->Value(i));
    const TopoDS_Shape shape = product.IsNull() ? TopoDS_Shape() : TransferBRep::ShapeResult(process, product);
    if (!shape.IsNull()) productsAt_[entryOf(shape, reader)].push_back({shape, {nameOf(product), "", ""}});
  }
}

std::optional<std::string> StepNames::ofRoot(const TDF_Label& product) const {
  const auto known = productsAt_.find(entryOf(product));
  if (known == productsAt_.end()) return std::nullopt;
  const std::vector<Use>& products = known->second;
  const auto own = std::find_if(products.begin(), products.end(),
                                [](const Use& each) { return each.shape.Location().IsIdentity(); });
  return (own == products.end() ? products.front() : *own).names.product;
}

std::vector<std::optional<NodeNames>> StepNames::ofUses(const TDF_Label& assembly,
                                                        const std::vector<TopoDS_Shape>& uses) const {
  std::vector<std::optional<NodeNames>> names(uses.size());
  const auto known = usesIn_.find(entryOf(assembly));
  if (known == usesIn_.end()) return names;
  std::map<const TopoDS_TShape*, std::vector<const Use*>> left;
  for (const Use& use : known->second) left[use.shape.TShape().get()].push_back(&use);
  for (std::size_t i = 0; i < uses.size(); ++i) {
    std::vector<const Use*>& alike = left[uses[i].TShape().get()];
    const auto same = std::find_if(alike.begin(), alike.end(),
                                   [&](const Use* each) { return each->shape.Location() == uses[i].Location(); });
    if (same == alike.end()) continue;
    names[i] = (*same)->names;
    alike.erase(same);
  }
  return names;
}

}  // namespace glissade
