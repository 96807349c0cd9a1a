#include "app/window/instruction_job.h"

#include <QTimer>

#include <algorithm>
#include <utility>

#include "app/window/report_file.h"
#include "app/window/sequence_controller.h"
#include "engine/scenario/judged_product.h"
#include "engine/sequence/step_view.h"
#include "engine/study/plan_graph.h"
#include "widgets/commands/length_text.h"
#include "widgets/commands/window_language.h"
#include "widgets/plots/picture_file.h"
#include "widgets/scene3d/camera_controller.h"
#include "widgets/studies/plan_graph_view.h"

namespace glissade {
namespace {

/// The part of a step is shown when so much of its way lies behind it, from where it is assembled.
constexpr double kShownShare = 0.35;
constexpr double kGraphScale = 1.5;

/// What the pages say of each step: as it is known, or judged now where a step was not judged yet.
std::vector<StepCheck> checksOf(const AssemblyPlan& plan, const AssembledProduct& product,
                                const std::vector<StepCheck>& known, const StopToken& stop) {
  const bool all =
      known.size() == plan.steps.size() && std::find(known.begin(), known.end(), StepCheck::NotAsked) == known.end();
  if (all) return known;
  const check::PlanVerdict verdict = judgePlan(plan, product, std::nullopt, stop);
  if (stop.stopRequested()) return known;
  std::vector<StepCheck> checks;
  for (const check::StepVerdict& step : verdict.steps) {
    checks.push_back(step.valid() ? StepCheck::Agrees : StepCheck::Disagrees);
  }
  return checks;
}

}  // namespace

InstructionJob::InstructionJob(const Workbench& bench, SequenceController& sequence)
    : QObject(&sequence), bench_(bench), sequence_(sequence) {}

void InstructionJob::start(const QString& file, Finished finished) {
  const ShownPlan& shown = sequence_.shown();
  content_ = std::make_shared<Content>();
  content_->plan = shown.plan;
  content_->product = shown.product;
  content_->checks = shown.checks;
  content_->name = sequence_.productName();
  content_->times = sequence_.workTimes().times();
  content_->deviation = surfaceDeviation(*bench_.document.scenario());
  content_->file = file;
  finished_ = std::move(finished);
  chooseViews();
}

void InstructionJob::chooseViews() {
  bench_.work.run(tr("Checking the steps and choosing the views"),
                  [this, content = content_](const WorkWatch& watch) -> BackgroundTask::Delivery {
                    const std::vector<StepCheck> checks =
                        checksOf(*content->plan, *content->product, content->checks, watch.stop);
                    const std::vector<Vector3> toEye = directionsToEye(*content->plan, *content->product, watch);
                    return [this, content, checks, toEye] {
                      if (content != content_) return;
                      content->checks = checks;
                      sequence_.noteChecks(content->plan, checks);
                      content->toEye = toEye;
                      takePictures();
                    };
                  });
}

/// The next one, and the others at later turns of the event loop.
void InstructionJob::takePictures() {
  const auto content = content_;
  do {
    if (const SaveResult taken = takeNextPicture(); !taken) {
      end(taken);
      return;
    }
    if (content_->pictures.size() == content_->plan->steps.size()) {
      write();
      return;
    }
  } while (bench_.work.isAtOnce());
  QTimer::singleShot(0, this, [this, content] {
    if (content == content_) takePictures();
  });
}

SaveResult InstructionJob::takeNextPicture() {
  if (sequence_.shown().plan != content_->plan) {
    return notSaved(
        {ErrorKind::Usage, content_->file.toStdString(), "", "the plan has changed meanwhile", "Save it again."});
  }
  CameraController& camera = bench_.scene.view().camera();
  const CameraController before = camera;
  camera.setAspect(static_cast<double>(kPagePicture.width()) / kPagePicture.height());
  const bool first = content_->exploded.empty();
  const std::size_t step = content_->pictures.size();
  if (first) {
    camera.setStandardView(StandardView::Isometric);
    sequence_.showScene(0.0, 1.0);
  } else {
    camera.lookFrom(content_->toEye[step]);
    sequence_.showScene(static_cast<double>(step) + kShownShare, 0.0);
  }
  bench_.scene.view().fit();
  std::string file;
  const SaveResult taken = takePicture(first ? QStringLiteral("exploded") : QString::number(step), file);
  if (first) {
    content_->exploded = file;
  } else {
    content_->pictures.push_back(file);
  }
  camera = before;
  sequence_.showPanelsScene();
  return taken;
}

SaveResult InstructionJob::takePicture(const QString& name, std::string& file) {
  const QString path = content_->folder.filePath(name + QStringLiteral(".png"));
  file = path.toStdString();
  return saveScenePicture(bench_.scene, path);
}

void InstructionJob::write() {
  const Language language = windowLanguage();
  bench_.work.run(tr("Writing the work instruction"),
                  [this, content = content_, language](const WorkWatch&) -> BackgroundTask::Delivery {
                    const auto finish = [this, content](const SaveResult& result) -> BackgroundTask::Delivery {
                      return [this, content, result] {
                        if (content == content_) end(result);
                      };
                    };
                    const QString graph = content->folder.filePath(QStringLiteral("graph.png"));
                    const std::string svg = planGraphSvg(*content->plan, *content->product, StudyWords(language));
                    if (const SaveResult drawn = savePicture(imageOfSvg(svg, kGraphScale), graph); !drawn) {
                      return finish(drawn);
                    }
                    const PlanWords words(language, [](double metres) { return lengthText(metres).toStdString(); });
                    const auto timing = planTiming(*content->plan, *content->product, content->times);
                    const StudyReport report =
                        workInstruction({*content->plan, *content->product, content->name, content->deviation,
                                         content->checks, content->exploded, graph.toStdString(), content->pictures,
                                         timing ? std::optional(*timing) : std::nullopt},
                                        words);
                    return finish(saveReport(report, content->file));
                  });
}

void InstructionJob::end(const SaveResult& result) {
  content_.reset();
  if (const auto finished = std::exchange(finished_, nullptr)) finished(result);
}

}  // namespace glissade
