#include "engine/import/step_external_files.h"

#include <STEPConstruct_ExternRefs.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include "engine/base/printable_text.h"
#include "engine/import/cad_kind.h"

namespace glissade {

ExternalFiles externalFilesOf(STEPCAFControl_Reader& reader) {
  const Handle(XSControl_WorkSession) session = reader.Reader().WS();
  const Handle(Transfer_TransientProcess) process = session->TransferReader()->TransientProcess();
  STEPConstruct_ExternRefs references(session);
  references.LoadExternRefs();
  ExternalFiles files;
  for (int i = 1; i <= references.NbExternRefs(); ++i) {
    const Handle(StepBasic_ProductDefinition) product = references.ProdDef(i);
    const char* name = references.FileName(i);
    if (product.IsNull() || name == nullptr || *name == '\0') continue;
    const TopoDS_Shape shape = TransferBRep::ShapeResult(process, product);
    if (shape.IsNull()) continue;
    std::string& file = files[shape.TShape().get()];
    if (file.empty() || (!hasStepEnding(file) && hasStepEnding(name))) file = printableLine(name);
  }
  return files;
}

}  // namespace glissade
