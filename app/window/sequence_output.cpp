#include "app/window/sequence_output.h"

#include <QFileInfo>
#include <QImage>

#include "app/window/sequence_controller.h"
#include "engine/scenario/plan_file.h"
#include "engine/scenario/plan_glb.h"
#include "engine/sequence/step_view.h"
#include "engine/study/plan_graph.h"
#include "engine/study/plan_table.h"
#include "engine/study/report_html.h"
#include "engine/study/work_instruction.h"
#include "widgets/commands/length_text.h"
#include "widgets/plots/picture_file.h"
#include "widgets/scene3d/camera_controller.h"
#include "widgets/studies/plan_graph_view.h"
#include "widgets/studies/report_pdf.h"

namespace glissade {
namespace {

/// The part of a step is shown when so much of its way is left to its place.
constexpr double kShownShare = 0.35;
/// Pictures of a step have this width, pixels: what a page needs.
constexpr int kPictureWidth = 900;

SaveResult saved(const Outcome& outcome) { return outcome ? SaveResult{SaveStatus::Saved, {}, {}, {}} : notSaved(outcome.error()); }

}  // namespace

std::string SequenceOutput::productName() const {
  const ScenarioPtr& scenario = bench_.document.scenario();
  if (!scenario->scenario.name.empty()) return scenario->scenario.name;
  return QFileInfo(QString::fromStdString(scenario->file)).completeBaseName().toStdString();
}

SaveResult SequenceOutput::write(const QString& file) {
  const std::string name = file.toStdString();
  const ShownPlan& shown = sequence_.shown();
  const QString ending = QFileInfo(file).suffix().toLower();
  const PlanOrder order = sequence_.panel()->order();
  if (ending == QLatin1String("json")) {
    const std::string& product = bench_.document.scenario()->file;
    return saved(savePlan(*shown.plan, product.empty() ? productName() : product, name));
  }
  if (ending == QLatin1String("csv")) return saveFile(name, planAsCsv(*shown.plan, *shown.product, order));
  if (ending == QLatin1String("glb")) {
    const auto content = planAsGlb(*shown.plan, *shown.product, order, productName());
    return content ? saveFile(name, *content) : notSaved(content.error());
  }
  if (ending != QLatin1String("html") && ending != QLatin1String("pdf")) {
    return notSaved({ErrorKind::Usage, name, "", "assembly plans are not written in this format",
                     "Choose one of: .json, .csv, .glb, .html, .pdf."});
  }
  const QTemporaryDir folder;
  const auto report = instruction(folder);
  if (!report) return notSaved(report.error());
  if (ending == QLatin1String("pdf")) return saved(writeReportPdf(*report, file));
  const auto page = reportHtml(*report);
  return page ? saveFile(name, *page) : notSaved(page.error());
}

Result<StudyReport> SequenceOutput::instruction(const QTemporaryDir& folder) {
  const ShownPlan& shown = sequence_.shown();
  std::string exploded;
  std::vector<std::string> pictures;
  if (const Outcome taken = takePictures(folder, exploded, pictures); !taken) return taken.error();
  const QString graph = folder.filePath(QStringLiteral("graph.png"));
  if (const Outcome drawn = drawGraph(graph); !drawn) return drawn.error();
  const PlanWords words(windowLanguage(), [](double metres) { return lengthText(metres).toStdString(); });
  return workInstruction({*shown.plan, *shown.product, productName(), surfaceDeviation(*bench_.document.scenario()),
                          shown.checks, exploded, graph.toStdString(), pictures},
                         words);
}

Outcome SequenceOutput::drawGraph(const QString& file) const {
  const ShownPlan& shown = sequence_.shown();
  constexpr double kScale = 1.5;
  return savePicture(imageOfSvg(planGraphSvg(*shown.plan, *shown.product, StudyWords(windowLanguage())), kScale), file);
}

Outcome SequenceOutput::takePicture(const QString& file) {
  bench_.scene.refresh();
  QImage picture = bench_.scene.picture();
  if (picture.width() > kPictureWidth) picture = picture.scaledToWidth(kPictureWidth, Qt::SmoothTransformation);
  return savePicture(picture, file);
}

Outcome SequenceOutput::takePictures(const QTemporaryDir& folder, std::string& exploded,
                                     std::vector<std::string>& steps) {
  const ShownPlan& shown = sequence_.shown();
  CameraController& camera = bench_.scene.view().camera();
  const CameraController before = camera;
  const auto restored = [&camera, &before](Outcome outcome) {
    camera = before;
    return outcome;
  };
  camera.setStandardView(StandardView::Isometric);
  sequence_.showScene(0.0, 1.0);
  bench_.scene.view().fit();
  const QString explodedFile = folder.filePath(QStringLiteral("exploded.png"));
  if (const Outcome taken = takePicture(explodedFile); !taken) return restored(taken);
  exploded = explodedFile.toStdString();
  StepView view(*shown.product);
  BodySet present(shown.product->bodies.size(), true);
  for (std::size_t i = 0; i < shown.plan->steps.size(); ++i) {
    const AssemblyStep& step = shown.plan->steps[i];
    camera.setDirection(view.directionToEye(step, present));
    sequence_.showScene(static_cast<double>(i) + kShownShare, 0.0);
    bench_.scene.view().fit();
    const QString file = folder.filePath(QStringLiteral("step-%1.png").arg(i));
    if (const Outcome taken = takePicture(file); !taken) return restored(taken);
    steps.push_back(file.toStdString());
    for (const std::size_t body : bodiesOf(step, *shown.product)) present[body] = false;
  }
  return restored(Done{});
}

}  // namespace glissade
