#include "widgets/instruction/report_file.h"

#include "engine/documents/report_html.h"
#include "widgets/controls/picture_file.h"
#include "widgets/instruction/report_pdf.h"

namespace glissade {

SaveResult saveReport(const Report& report, const QString& file) {
  if (file.endsWith(QLatin1String(".pdf"), Qt::CaseInsensitive)) return writeReportPdf(report, file);
  const auto page = reportHtml(report);
  return page ? saveFile(file.toStdString(), *page) : notSaved(page.error());
}

SaveResult saveScenePicture(SceneWidget& scene, const QString& file) {
  return savePicture(scene.picture(kPagePicture), file);
}

}  // namespace glissade
