#include "widgets/sequence/sequence_output.h"

#include <QFileInfo>

#include "engine/documents/plan_table.h"
#include "engine/files/plan_file.h"
#include "engine/files/plan_glb.h"

namespace glissade {
namespace {

QString endingOfFile(const QString& file) { return QFileInfo(file).suffix().toLower(); }

}  // namespace

SaveResult writeSequence(const ShownPlan& shown, PlanOrder order, const std::string& product, const std::string& name,
                         const QString& file) {
  const std::string path = file.toStdString();
  const QString ending = endingOfFile(file);
  if (ending == QLatin1String("json")) {
    const Outcome saved = savePlan(*shown.plan, product, path);
    return saved ? SaveResult{SaveStatus::Saved, {}, {}, {}} : notSaved(saved.error());
  }
  if (ending == QLatin1String("csv")) return saveFile(path, planAsCsv(*shown.plan, *shown.product, order));
  if (ending == QLatin1String("glb")) {
    const auto content = planAsGlb(*shown.plan, *shown.product, order, name);
    return content ? saveFile(path, *content) : notSaved(content.error());
  }
  return notSaved({ErrorKind::Usage, path, "", GLISSADE_TEXT("assembly plans are not written in this format"),
                   GLISSADE_TEXT("Choose one of: .json, .csv, .glb, .html, .pdf, .mp4, .webm, .png.")});
}

bool isDocument(const QString& file) {
  const QString ending = endingOfFile(file);
  return ending == QLatin1String("html") || ending == QLatin1String("pdf");
}

}  // namespace glissade
