#include "widgets/sequence/instruction_job.h"

#include <QDateTime>
#include <QLocale>
#include <QTemporaryDir>

#include <algorithm>
#include <utility>

#include "engine/documents/instruction/instruction_viewer.h"
#include "engine/documents/plan_graph.h"
#include "engine/documents/plan_report.h"
#include "engine/files/plan_glb.h"
#include "engine/files/product_name.h"
#include "engine/files/scenario_bodies.h"
#include "engine/sequence/exploded_view.h"
#include "widgets/controls/diagnostic_text.h"
#include "widgets/controls/length_text.h"
#include "widgets/controls/picture_file.h"
#include "widgets/controls/window_language.h"
#include "widgets/instruction/instruction_painter.h"
#include "widgets/instruction/report_file.h"
#include "widgets/sequence/access_texts.h"
#include "widgets/sequence/instruction_controller.h"
#include "widgets/sequence/plan_graph_view.h"
#include "widgets/sequence/sequence_controller.h"

namespace glissade {
namespace {

constexpr double kGraphScale = 1.5;
/// Share of the work that chooses views; the rest draws.
constexpr double kChoosingViews = 0.3;

SaveResult cancelled(const QString& file) {
  return notSaved({ErrorKind::Interrupted, file.toStdString(), "", GLISSADE_TEXT("the document was cancelled"), {}});
}

/// The check that the pages state: the known one, or a new one if some step was not judged yet.
PlanCheck checkFor(const AssemblyPlan& plan, const AssembledProduct& product, const PlanCheck& known,
                   const SequenceDemands& said, const StopToken& stop) {
  const auto& steps = known.steps;
  const bool all =
      steps.size() == plan.steps.size() && std::find(steps.begin(), steps.end(), StepCheck::NotAsked) == steps.end();
  if (all) return known;
  const PlanCheck check = checkOf(plan, product, said, {stop, {}});
  return stop.stopRequested() ? known : check;
}

LineTexts textsOf(const LineAccess& access, const std::vector<RigidBody>& bodies) {
  LineTexts texts;
  for (const MotionAccess& step : access.steps) texts.steps.push_back(accessText(step, bodies).toStdString());
  for (const LineAccess& line : access.lines) texts.lines.push_back(textsOf(line, bodies));
  return texts;
}

/// The date of making. Builds that are to be repeated state another one (reproducible-builds.org).
QString imprint(Language language) {
  bool isStated = false;
  const qint64 stated = qEnvironmentVariable("SOURCE_DATE_EPOCH").toLongLong(&isStated);
  const QDate date = isStated ? QDateTime::fromSecsSinceEpoch(stated, Qt::UTC).date() : QDate::currentDate();
  const QLocale locale(language == Language::French ? QLocale::French : QLocale::English);
  return locale.toString(date, QLocale::LongFormat);
}

bool isPdf(const QString& file) { return file.endsWith(QLatin1String(".pdf"), Qt::CaseInsensitive); }

}  // namespace

InstructionJob::InstructionJob(const Workbench& bench, SequenceController& sequence)
    : QObject(&sequence), bench_(bench), sequence_(sequence) {}

PlanWords InstructionJob::Content::words() const {
  return {language, [](double metres) { return lengthText(metres).toStdString(); }};
}

void InstructionJob::start(PlanDocument document, const QString& file, Finished finished) {
  const ShownPlan& shown = sequence_.shown();
  const auto content = std::make_shared<Content>();
  content->plan = shown.plan;
  content->product = shown.product;
  content->check = shown.check;
  content->said = sequence_.statedDemands(*shown.product);
  if (shown.access) content->access = textsOf(*shown.access, shown.product->bodies);
  const Scenario& scenario = bench_.document.scenario()->scenario;
  content->heading = {nameOfProduct(*bench_.document.scenario()), {}, shownLeftOut(scenario)};
  content->deviation = surfaceDeviation(*bench_.document.scenario());
  content->missing = bench_.document.scenario()->missing;
  content->times = sequence_.workTimes().times();
  content->look = sequence_.instructions().look();
  content->paper = sequence_.instructions().paper();
  content->language = windowLanguage();
  if (document == PlanDocument::Instruction) content->language = content->look.language.value_or(content->language);
  content->heading.imprint = imprint(content->language).toStdString();
  content->file = file;
  const QString what = document == PlanDocument::Instruction ? tr("Writing the work instruction")
                                                             : tr("Writing the report of the sequence");
  bench_.work.runToEnd(
      what,
      [this, document, content, finished = std::move(finished)](const WorkWatch& watch) -> BackgroundTask::Delivery {
        const SaveResult saved =
            document == PlanDocument::Instruction ? writeInstruction(*content, watch) : writeReport(*content, watch);
        return [this, content, saved, finished] {
          sequence_.note(content->plan, content->check, sequence_.shown().access);
          finished(saved);
        };
      });
}

SaveResult InstructionJob::writeInstruction(const Content& content, const WorkWatch& watch) const {
  const WorkInstruction instruction = workInstruction(*content.plan, *content.product, content.heading, content.words(),
                                                      watch.part(0.0, kChoosingViews));
  const WorkWatch drawing = watch.part(kChoosingViews, 1.0);
  const StepDrawer drawer(*content.product);
  if (isPdf(content.file)) {
    return writeInstructionPdf(instruction, content.look, content.paper, drawer, content.file, drawing);
  }
  const InstructionPictures pictures = instructionPictures(instruction, drawer, drawing);
  if (watch.stop.stopRequested()) return cancelled(content.file);
  const auto glb = planAsGlb(*content.plan, *content.product, PlanOrder::Assembly, content.heading.title);
  const auto scene = glb ? instructionScene(*glb) : Result<InstructionScene>(glb.error());
  const auto page = instructionHtml(instruction, content.look, pictures, scene ? &*scene : nullptr);
  if (!page) return notSaved(page.error());
  SaveResult saved = saveFile(content.file.toStdString(), *page);
  if (saved && !scene) saved.warnings.push_back(scene.error());
  return saved;
}

SaveResult InstructionJob::writeReport(Content& content, const WorkWatch& watch) const {
  const AssemblyPlan& plan = *content.plan;
  content.check = checkFor(plan, *content.product, content.check, content.said, watch.stop);
  const QTemporaryDir folder;
  const auto pathOf = [&](const QString& name) { return folder.filePath(name + QStringLiteral(".png")); };
  const PlanWords words = content.words();
  const WorkInstruction instruction =
      workInstruction(plan, *content.product, content.heading, words, watch.part(0.0, kChoosingViews));
  const StepDrawer drawer(*content.product);
  PlanReportContent report{
      plan, *content.product, content.heading.title, content.deviation, content.missing, content.check.steps};
  for (const Message& each : content.check.conditions) report.conditions.push_back(engineText(each).toStdString());
  report.access = content.access;
  const auto add = [&](const QImage& picture, const QString& name, std::string& file) {
    file = pathOf(name).toStdString();
    return savePicture(picture, pathOf(name));
  };
  const auto exploded = drawer.exploded(ExplodedView(*content.product, plan).at(1.0), kPagePicture);
  if (const auto drawn = add(exploded, QStringLiteral("exploded"), report.explodedPicture); !drawn) return drawn;
  const QImage graph = imageOfSvg(planGraphSvg(plan, *content.product, words.words()), kGraphScale);
  if (const auto drawn = add(graph, QStringLiteral("graph"), report.graphPicture); !drawn) return drawn;
  for (const InstructionPanel& panel : instruction.panels) {
    if (watch.stop.stopRequested()) return cancelled(content.file);
    if (panel.steps.empty() || !panel.subassembly.empty()) continue;
    const QString name = QString::number(report.pictures.size());
    report.pictures.emplace_back();
    if (const auto drawn = add(drawer.panel(panel, kPagePicture), name, report.pictures.back()); !drawn) return drawn;
    watch.report(static_cast<double>(report.pictures.size()) / static_cast<double>(plan.steps.size()));
  }
  if (const auto timing = planTiming(plan, *content.product, content.times)) report.timing = *timing;
  return saveReport(planReport(report, words), content.file);
}

}  // namespace glissade
