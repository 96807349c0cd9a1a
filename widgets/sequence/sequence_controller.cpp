#include "widgets/sequence/sequence_controller.h"

#include <QFileInfo>
#include <QScopedValueRollback>

#include <algorithm>
#include <utility>

#include "engine/documents/plan_graph.h"
#include "engine/files/plan_file.h"
#include "engine/files/product_file.h"
#include "engine/files/product_name.h"
#include "engine/files/scenario_bodies.h"
#include "engine/files/sequence_knowledge.h"
#include "engine/sequence/plan_bodies.h"
#include "widgets/controls/diagnostic_text.h"
#include "widgets/controls/window_language.h"
#include "widgets/film/film_dialog.h"
#include "widgets/sequence/instruction_controller.h"
#include "widgets/sequence/plan_graph_view.h"
#include "widgets/sequence/sequence_output.h"
#include "widgets/sequence/sequence_script.h"
#include "widgets/sequence/step_turns.h"
#include "widgets/sequence/stuck_marks.h"
#include "widgets/workbench/proposed_file.h"

namespace glissade {
namespace {

constexpr const char* kStays = "stays";

std::vector<Vector3> wayOf(const StepMotion& motion, const RigidBody& body) {
  const Pose X_PB = inverse(motion.path.front().q) * body.X_WB;
  std::vector<Vector3> way;
  for (const PathPoint& point : motion.path) way.push_back((point.q * X_PB).position);
  return way;
}

/// The plan with the ids of the product's bodies; the same object if the ids are equal. Null if it belongs to another
/// product.
PlanPtr planOf(const AssembledProduct& product, const PlanPtr& plan) {
  const auto ours = planAbout(product, *plan);
  if (!ours) return nullptr;
  return ours->bodies == plan->bodies ? plan : std::make_shared<const AssemblyPlan>(*ours);
}

/// The plan before the first step is found.
AssemblyPlan emptyPlan(const AssembledProduct& product, const BodySet& staying) {
  AssemblyPlan plan;
  plan.end = PlanEnd::Interrupted;
  plan.bodies = idsOf(product.bodies);
  for (const std::size_t body : bodiesIn(staying)) plan.staying.push_back(plan.bodies[body]);
  return plan;
}

/// Makes the job one that goes on from the shown plan.
void goOnWith(const ShownPlan& shown, SequenceJob& job) {
  job.product = shown.product;
  job.resumed = shown.plan;
  job.seed = shown.plan->seed;
  job.strategy = shown.plan->strategy;
  job.demands = shown.plan->demands;
  std::fill(job.staying.begin(), job.staying.end(), false);
  for (const std::size_t body : shown.product->indicesOf(shown.plan->staying)) job.staying[body] = true;
}

}  // namespace

SequenceController::SequenceController(const Workbench& bench)
    : QObject(&bench.window),
      bench_(bench),
      panel_(new SequencePanel(bench.actions, &bench.window)),
      planner_(bench.finder),
      instructions_(new InstructionController(bench, *this)),
      film_(
          bench.work, [&bench] { return bench.scene.picture(kFilmPicture); }, bench.scene.view().camera()),
      edits_(new SequenceEdits(bench, *this)),
      hand_(new SequenceHand(bench, *this)) {
  connect(&planner_, &SequencePlanner::grown, this, [this](const GrownPlan& grown) { takeGrown(grown, true); });
  connect(&planner_, &SequencePlanner::planned, this, [this](const GrownPlan& grown) { takeGrown(grown, false); });
  connect(&planner_, &SequencePlanner::tried, panel_, &SequencePanel::setTried);
  connect(&planner_, &SequencePlanner::judged, this,
          [this](const PlanPtr& plan, const PlanCheck& check) { note(plan, check, shown().access); });
  connect(&planner_, &SequencePlanner::reordered, this, &SequenceController::takeMoved);
  connect(&planner_, &SequencePlanner::orderRefused, this, &SequenceController::refuseMove);
  connect(&planner_, &SequencePlanner::failed, &bench.work, &WorkController::reportFailure);
  connect(&planner_.task(), &BackgroundTask::started, this, &SequenceController::enableActions);
  connect(&planner_.task(), &BackgroundTask::ended, this, &SequenceController::enableActions);
  bench.work.show(
      planner_.task(),
      [this] {
        return planner_.isReordering() ? tr("Moving the step")
               : planner_.isPlanning() ? tr("Planning the sequence")
                                       : tr("Certifying the sequence again");
      },
      [this] { planner_.stop(); });
  connect(panel_, &SequencePanel::sceneChanged, this, &SequenceController::showPanelsScene);
  connect(panel_, &SequencePanel::selectionChanged, this, &SequenceController::showPanelsScene);
  new StuckMarks(bench.document.semantics(), *panel_);
  connect(panel_, &SequencePanel::playbackEnded, this, [this] { bench_.actions["sequence.play"]->setChecked(false); });
  connect(&bench.document, &WorkbenchDocument::changed, this, &SequenceController::followDocument);
  connect(&bench.document.semantics(), &SemanticDocument::selectionChanged, this, [this] {
    panel_->showBodies(bench_.document.semantics().selectedBodies());
    enableActions();
  });
  connect(hand_, &SequenceHand::activityChanged, this, &SequenceController::enableActions);
  constexpr int kSettlingMilliseconds = 4000;
  settling_.setSingleShot(true);
  settling_.setInterval(kSettlingMilliseconds);
  connect(&settling_, &QTimer::timeout, this, [this] { startPlanning(false, std::nullopt); });
  connectActions();
  enableActions();
  new StepTurns(bench, *this);
  addSequenceCommands(bench, *this);
}

void SequenceController::connectActions() {
  bench_.onAction("sequence.plan", this, [this] { plan(false); });
  bench_.onAction("sequence.resume", this, [this] { plan(true); });
  bench_.onAction("sequence.open", this, [this] { chooseFile(); });
  bench_.onAction("sequence.export", this, [this] { chooseExport(); });
  bench_.onAction("sequence.film", this, [this] { chooseFilm(); });
  bench_.onAction("sequence.graph", this, [this] { showGraph(); });
  bench_.onAction("sequence.stays", this, [this] { toggleStays(); });
  bench_.onAction("sequence.show-product", this, [this] {
    panel_->showExploded(0.0);
    panel_->showTime(0.0);
  });
  connect(bench_.actions["sequence.play"], &QAction::toggled, panel_, &SequencePanel::setPlaying);
  bench_.onAction("sequence.previous-step", this, [this] { panel_->stepBy(-1); });
  bench_.onAction("sequence.next-step", this, [this] { panel_->stepBy(1); });
  connect(bench_.actions["sequence.assembly-order"], &QAction::toggled, this,
          [this](bool assembly) { panel_->setOrder(assembly ? PlanOrder::Assembly : PlanOrder::Removal); });
  bench_.actions["sequence.assembly-order"]->setChecked(true);
  connect(bench_.actions["sequence.aside"], &QAction::toggled, this, &SequenceController::showPanelsScene);
}

void SequenceController::toggleStays() {
  SemanticDocument& semantics = bench_.document.semantics();
  SemanticSelection bodies;
  bodies.bodies = semantics.selection().bodies;
  const QString& first = *bodies.bodies.begin();
  const bool stays = semantics.bodyValue(first, kStays).value == AttributeValue(true);
  if (const Outcome set = semantics.setAttribute(bodies, kStays, AttributeValue(!stays)); !set) {
    bench_.messages.showError(tr("The bodies cannot be marked"), set.error());
  }
  semantics.endGesture();
}

void SequenceController::plan(bool resume, std::optional<std::size_t> mostSteps) {
  if (!bench_.document.scenario()) return;
  bringToFront();
  startPlanning(resume, mostSteps);
}

/// The plan before the present one was begun, as long as that is not complete.
PlanPtr SequenceController::earlierPlan() const {
  return shown().growing && shown().before ? shown().before : shown().plan;
}

std::optional<SequenceJob> SequenceController::jobWith(const SequenceDemands& demands) {
  SequenceJob job;
  job.product = presentProduct();
  Scenario scenario = bench_.document.current();
  scenario.sequence.places = demands.places;
  scenario.sequence.motions = demands.motions;
  const auto known = knownDemands(scenario, *job.product);
  const auto staying = known ? stayingBodies(*job.product, known->stay) : Result<BodySet>(known.error());
  if (!staying) {
    bench_.messages.showError(tr("The sequence cannot be planned"), staying.error());
    return std::nullopt;
  }
  job.demands = *known;
  job.staying = *staying;
  job.classes = classesOf(*bench_.document.edits(), job.product->bodies);
  job.seed = bench_.document.settings().seed;
  job.strategy = kUsualStrategy;
  return job;
}

void SequenceController::startPlanning(bool resume, std::optional<std::size_t> mostSteps) {
  settling_.stop();
  auto job = jobWith(bench_.document.demands());
  if (!job) return;
  job->mostSteps = mostSteps;
  if (resume && shown().plan && shown().product) {
    goOnWith(shown(), *job);
  } else {
    const PlanPtr earlier = shown().product == job->product ? earlierPlan() : nullptr;
    if (earlier && !earlier->steps.empty()) job->known = earlier;
    const auto empty = std::make_shared<const AssemblyPlan>(emptyPlan(*job->product, job->staying));
    setPlan({job->product, empty, true, {}, {}, {}, earlier});
  }
  planner_.plan(*job, bench_.work.isAtOnce());
  enableActions();
}

void SequenceController::moveStep(StepMove move) {
  auto job = jobWith(move.demands);
  if (!job) return;
  const SequenceDemands demands = job->demands;
  goOnWith(shown(), *job);
  job->demands = demands;
  move_ = std::move(move);
  planner_.reorder({*job, move_.order}, bench_.work.isAtOnce());
  enableActions();
}

/// The document has the demands of the new order, and the plan is known for them: nothing is planned.
void SequenceController::takeMoved(const PlanPtr& plan) {
  const ShownPlan& before = shown();
  const ShownPlan moved{before.product, plan, false, before.foundAfter, {}, {}, nullptr, before.held};
  {
    const QScopedValueRollback<bool> adopting(adopting_, true);
    bench_.document.setDemands(move_.text, move_.demands);
  }
  keepPlan(moved);
  remember();
  panel_->chooseBody(move_.body);
  planner_.judge(moved.product, plan, statedDemands(*moved.product), bench_.work.isAtOnce());
}

void SequenceController::refuseMove(const OrderConflict& why) {
  const std::size_t steps = shown().plan->steps.size();
  const bool assembly = panel_->order() == PlanOrder::Assembly;
  const auto number = [&](std::size_t step) { return assembly ? steps - step : step + 1; };
  QString reason = engineText(why.reason);
  if (why.first != why.then) {
    const auto [earlier, later] = assembly ? std::pair(why.then, why.first) : std::pair(why.first, why.then);
    reason = tr("Step %1 has to come after step %2: %3").arg(number(later)).arg(number(earlier)).arg(reason);
  }
  const QString text = tr("%1. The order is as before.").arg(reason);
  if (bench_.messages.isWanted(tr("The step cannot be moved there"), text, tr("&Search other motions"))) {
    chosenLater_ = move_.body;
    bench_.document.setDemands(move_.text, move_.demands);
  }
}

void SequenceController::takeGrown(const GrownPlan& grown, bool growing) {
  if (!grown.plan) return;
  ShownPlan next = shown();
  next.plan = grown.plan;
  next.growing = growing;
  next.held = grown.held;
  if (!growing) next.before = nullptr;
  next.access = nullptr;
  next.views.clear();
  for (const auto& [body, seconds] : grown.foundAfter) next.foundAfter[body] = seconds;
  next.check = {};
  const bool unfinished = growing || next.plan->end == PlanEnd::Interrupted;
  if (unfinished && next.plan->steps.empty()) {
    setPlan(next);
  } else {
    keepPlan(next);
  }
  if (growing) return;
  remember();
  panel_->chooseBody(std::exchange(chosenLater_, {}));
  if (!bench_.work.isAtOnce()) bench_.messages.showUntilAction(tr("Sequence: %1").arg(panel_->resultText()));
}

void SequenceController::note(const PlanPtr& plan, const PlanCheck& check, const PlanAccessPtr& access) {
  if (plan != shown().plan || (check == shown().check && access == shown().access)) return;
  ShownPlan next = shown();
  next.check = check;
  next.access = access;
  setPlan(next);
  remember();
}

void SequenceController::noteViews(const PlanPtr& plan, const std::vector<Viewpoint>& views) {
  if (plan != shown().plan || shown().growing) return;
  ShownPlan next = shown();
  next.views = views;
  setPlan(next);
  remember();
}

void SequenceController::keepPlan(const ShownPlan& shown) {
  setPlan(shown);
  bench_.document.setPlan(shown.plan);
}

void SequenceController::setPlan(const ShownPlan& shown) {
  film_.cancel();
  const bool there = shown.product && shown.plan;
  if (shown.product != this->shown().product || shown.plan != this->shown().plan) exploded_.reset();
  playback_ = there ? PlanPlayback(*shown.product, *shown.plan) : PlanPlayback();
  panel_->setAtOnce(bench_.work.isAtOnce());
  panel_->setPlan(shown);
  updateGraph();
  enableActions();
  emit planShown();
}

void SequenceController::showGraph() {
  if (graph_ == nullptr) graph_ = new PlanGraphView(&bench_.window);
  graph_->show();
  graph_->raise();
  updateGraph();
}

void SequenceController::updateGraph() {
  if (graph_ == nullptr || !graph_->isVisible() || !shown().plan || shown().plan->bodies.empty()) return;
  graph_->setPicture(planGraphSvg(*shown().plan, *shown().product, DocumentWords(windowLanguage()),
                                  graphColours(bench_.window.palette())));
}

void SequenceController::followDocument(Changes what) {
  if (what & (Change::Scenario | Change::Arrangement)) {
    followArrangement((what & Change::Scenario) != 0);
    (void)knowsOtherDemands();
  } else if ((what & (Change::Sequence | Change::Semantics | Change::Joints)) && knowsOtherDemands() && !adopting_) {
    followDemands((what & Change::Sequence) ? Settling::AtOnce : Settling::Later);
  }
}

/// Follows a changed arrangement. If bodies have moved, the plan is judged again; if they are other bodies, it is
/// removed. The plan of an opened scenario is judged too.
void SequenceController::followArrangement(bool another) {
  settling_.stop();
  planner_.drop();
  panel_->setCost(bench_.document.demands().cost);
  if (another) memory_.clear();
  const ProductPtr product =
      another ? std::make_shared<const AssembledProduct>(productOf(*bench_.document.scenario())) : presentProduct();
  if (another) {
    const PlanPtr& kept = bench_.document.plan();
    setPlan({product, kept ? planOf(*product, kept) : nullptr, false, {}, {}});
  } else if (hand_->isAway()) {
    setPlan({product, nullptr, false, {}, {}});
    return;
  } else if (const auto known = rememberedPlan(product)) {
    keepPlan(*known);
    return;
  } else {
    keepPlan({product, shown().plan ? planOf(*product, shown().plan) : nullptr, false, shown().foundAfter, {}});
  }
  if (shown().plan) planner_.judge(product, shown().plan, statedDemands(*product), bench_.work.isAtOnce());
}

SequenceDemands SequenceController::statedDemands(const AssembledProduct& product) const {
  const auto demands = knownDemands(bench_.document.current(), product);
  return demands ? *demands : SequenceDemands();
}

/// Shows a known plan for the changed demands, or plans anew. Decisions about joints come one after another, so that
/// planning begins when they have settled; the rows of the earlier plan are grey until then.
void SequenceController::followDemands(Settling settling) {
  panel_->setCost(bench_.document.demands().cost);
  if (!shown().plan) return;
  settling_.stop();
  planner_.drop();
  BodyId chosen = std::exchange(chosenLater_, {});
  if (chosen.empty()) chosen = panel_->chosenBody();
  if (const auto known = rememberedPlan(shown().product)) {
    keepPlan(*known);
    panel_->chooseBody(chosen);
  } else {
    chosenLater_ = chosen;
    if (settling == Settling::AtOnce || bench_.work.isAtOnce()) return startPlanning(false, std::nullopt);
    const BodySet none(shown().product->bodies.size(), false);
    const auto empty = std::make_shared<const AssemblyPlan>(emptyPlan(*shown().product, none));
    setPlan({shown().product, empty, true, {}, {}, {}, earlierPlan(), {}, true});
    settling_.start();
  }
}

/// Whether the demands have changed since the last call. They include those from classes and attributes of bodies.
bool SequenceController::knowsOtherDemands() {
  const ScenarioPtr& scenario = bench_.document.scenario();
  if (!scenario || !shown().product) return false;
  const auto demands = knownDemands(bench_.document.current(), *shown().product);
  const std::optional<SequenceDemands> now = demands ? std::make_optional(*demands) : std::nullopt;
  return std::exchange(knownDemands_, now) != now;
}

void SequenceController::adoptDemands(const AssemblyPlan& plan) {
  const auto known = knownDemands(bench_.document.current(), *shown().product);
  if (!known) return;
  SequenceDemands demands = bench_.document.demands();
  demands.places = plan.demands.places;
  demands.motions = plan.demands.motions;
  demands.forbidden = plan.demands.forbidden;
  if (plan.demands.before != known->before) demands.before = plan.demands.before;
  if (plan.demands.together != known->together) demands.together = plan.demands.together;
  if (plan.demands.cost != known->cost) demands.cost = plan.demands.cost;
  const QScopedValueRollback<bool> adopting(adopting_, true);
  bench_.document.setDemands(tr("Constraints of the opened sequence"), demands);
  panel_->setCost(demands.cost);
}

ProductPtr SequenceController::presentProduct() const {
  const auto product = std::make_shared<const AssembledProduct>(productOf(*bench_.document.scenario()));
  const auto isSame = [&](const ProductPtr& other) { return other && isSameProduct(*other, *product); };
  if (isSame(shown().product)) return shown().product;
  for (const ShownPlan& known : memory_) {
    if (isSame(known.product)) return known.product;
  }
  return product;
}

std::optional<ShownPlan> SequenceController::rememberedPlan(const ProductPtr& product) const {
  const auto demands = knownDemands(bench_.document.current(), *product);
  if (!demands) return std::nullopt;
  for (auto known = memory_.rbegin(); known != memory_.rend(); ++known) {
    if (known->product == product && known->plan->demands == *demands) return *known;
  }
  return std::nullopt;
}

void SequenceController::remember() {
  constexpr std::size_t kMost = 16;
  const ShownPlan& plan = shown();
  if (!plan.plan || plan.growing || plan.plan->end == PlanEnd::Interrupted) return;
  std::erase_if(memory_, [&](const ShownPlan& known) {
    return known.product == plan.product && known.plan->demands == plan.plan->demands;
  });
  memory_.push_back(plan);
  if (memory_.size() > kMost) memory_.erase(memory_.begin());
}

bool SequenceController::isEditable() const {
  return shown().plan && shown().product && !shown().plan->bodies.empty() && !planner_.isPlanning() && !shown().growing;
}

void SequenceController::bringToFront() { bench_.bringToFront(Workspace::Assembly, "panel.sequence"); }

std::optional<Diagnostic> SequenceController::open(const QString& file) {
  const std::string name = file.toStdString();
  const ScenarioPtr& scenario = bench_.document.scenario();
  if (!scenario) {
    return Diagnostic{ErrorKind::Usage, name, "", GLISSADE_TEXT("no product is open"),
                      GLISSADE_TEXT("Open the product first.")};
  }
  const auto plan = readPlan(name);
  if (!plan) return plan.error();
  const ProductPtr product = presentProduct();
  const PlanPtr ours = planOf(*product, std::make_shared<const AssemblyPlan>(*plan));
  if (!ours) return checkSameBodies(*plan, *product, name).error();
  settling_.stop();
  planner_.drop();
  bringToFront();
  // The demands of the document are read before the file's demands replace them.
  const SequenceDemands said = statedDemands(*product);
  keepPlan({product, ours, false, {}, {}});
  adoptDemands(*ours);
  planner_.judge(product, shown().plan, said, bench_.work.isAtOnce());
  return std::nullopt;
}

void SequenceController::showPanelsScene() {
  const double exploded = panel_->exploded();
  SequencePicture picture = pictureAt(panel_->time(), exploded);
  picture.forbidden = edits_->forbiddenCones(picture.bodies);
  bench_.scene.view().setSequence(picture);
  if (std::exchange(isExploded_, exploded > 0.0) != isExploded_) fitExploded();
  bench_.scene.refresh();
}

/// Fits the view to the whole exploded view when it begins, and to the product when it has ended.
void SequenceController::fitExploded() {
  SceneView& view = bench_.scene.view();
  if (!isExploded_ || !exploded_) return view.fit();
  const LoadedScenario& scenario = *bench_.document.scenario();
  const std::vector<Pose> apart = exploded_->at(1.0);
  Box3 box;
  for (std::size_t i = 0; i < apart.size(); ++i) {
    const RigidBody& body = rigidBodyAt(i, scenario);
    box.extend(boundingBox(*body.mesh, apart[i] * body.X_WB));
  }
  view.camera().zoomTo(box);
}

SequencePicture SequenceController::pictureAt(double time, double exploded) {
  const ShownPlan& plan = shown();
  SequencePicture picture;
  if (plan.plan && !plan.plan->steps.empty() && (time > 0.0 || exploded > 0.0)) {
    const std::vector<PlayedBody> played = playback_.at(time);
    if (exploded > 0.0 && !exploded_) exploded_.emplace(*plan.product, *plan.plan);
    const std::vector<Pose> apart = exploded > 0.0 ? exploded_->at(exploded) : std::vector<Pose>();
    const bool aside = bench_.actions["sequence.aside"]->isChecked();
    const LoadedScenario& scenario = *bench_.document.scenario();
    for (std::size_t i = 0; i < played.size(); ++i) {
      // In the exploded view, a body of a later step stays at its exploded pose.
      const Pose& moved = played[i].left || exploded == 0.0 ? played[i].moved : apart[i];
      const Pose X_WB = moved * rigidBodyAt(i, scenario).X_WB;
      picture.bodies.push_back({X_WB, aside || !played[i].left, played[i].moves});
    }
    const bool onItsWay = std::any_of(played.begin(), played.end(), [](const PlayedBody& body) { return body.moves; });
    if (onItsWay && exploded == 0.0) {
      const PlayedMotion at = playedMotionAt(time, *plan.plan);
      const StepMotion& moving = plan.plan->steps[at.step].motions[at.motion];
      picture.way = wayOf(moving, plan.product->body(moving.body));
    }
  }
  return picture;
}

void SequenceController::remember(WindowMemory& memory) {
  workTimes_.remember(memory);
  instructions_->remember(memory);
}

void SequenceController::exportTo(const QString& file, const InstructionJob::Finished& finished) {
  if (isDocument(file)) {
    instructions_->write(PlanDocument::Instruction, file, finished);
  } else if (!shown().plan || shown().plan->steps.empty()) {
    finished(notSaved({ErrorKind::Usage, file.toStdString(), "", GLISSADE_TEXT("there is no plan to write"),
                       GLISSADE_TEXT("Plan the sequence first.")}));
  } else if (isFilm(file)) {
    film(file, finished);
  } else {
    const LoadedScenario& scenario = *bench_.document.scenario();
    const std::string name = nameOfProduct(scenario);
    finished(writeSequence(shown(), panel_->order(), scenario.file.empty() ? name : scenario.file, name, file));
  }
}

void SequenceController::film(const QString& file, const FilmJob::Finished& finished) {
  bench_.actions["sequence.play"]->setChecked(false);
  const auto show = [this](double share) {
    bench_.scene.view().setSequence(pictureAt(panel_->timeAt(panel_->slider().playedShare(share)), panel_->exploded()));
  };
  const auto restore = [this] { showPanelsScene(); };
  film_.start({panel_->slider().playedSeconds(), show, restore}, file, finished);
}

void SequenceController::chooseFile() {
  const QString file = bench_.dialogs.open(FilePurpose::Sequence, tr("Open an assembly plan of this product"),
                                           tr("Assembly plans (*.json);;All files (*)"));
  if (file.isEmpty()) return;
  if (const auto why = open(file)) bench_.messages.showError(tr("The assembly plan cannot be opened"), *why);
}

void SequenceController::chooseExport() {
  const QString file = bench_.dialogs.save(
      FilePurpose::Sequence, tr("Save the assembly plan"),
      proposedFile(*bench_.document.scenario(), QStringLiteral("plan.json")),
      tr("Assembly plan (*.json);;Work instruction (*.html);;Work instruction (*.pdf);;Table of steps (*.csv);;"
         "Animation (*.glb)") +
          QStringLiteral(";;") + filmFilter());
  if (!file.isEmpty()) exportAndReport(file);
}

void SequenceController::chooseFilm() {
  const QString file = chooseFilmFile(bench_, tr("Film the sequence"), QStringLiteral("sequence"));
  if (!file.isEmpty()) exportAndReport(file);
}

void SequenceController::exportAndReport(const QString& file) {
  exportTo(file, [this, file](const SaveResult& saved) { tell(file, saved); });
}

void SequenceController::tell(const QString& file, const SaveResult& saved) {
  if (!saved && saved.why.kind == ErrorKind::Interrupted) {
    bench_.messages.showStatus(tr("%1 was cancelled").arg(QFileInfo(file).fileName()));
  } else if (!saved) {
    bench_.messages.showError(tr("The assembly plan cannot be saved"), saved.why);
  } else {
    QStringList text{tr("%1 was saved").arg(file)};
    for (const Diagnostic& warning : saved.warnings) text << diagnosticText(warning);
    bench_.messages.showSaved(text.join(QStringLiteral(". ")), file);
  }
}

Outcome SequenceController::written(const std::string& file,
                                    const std::function<void(const InstructionJob::Finished&)>& write) {
  if (!bench_.work.isAtOnce()) {
    write([this, file](const SaveResult& saved) { tell(QString::fromStdString(file), saved); });
    return Done{};
  }
  SaveResult result =
      notSaved({ErrorKind::Usage, file, "", GLISSADE_TEXT("is not written yet"), GLISSADE_TEXT("Wait.")});
  write([&result](const SaveResult& saved) { result = saved; });
  if (result) tell(QString::fromStdString(file), result);
  return outcomeOf(result);
}

void SequenceController::enableActions() {
  const bool product = bench_.document.scenario() != nullptr && !bench_.document.scenario()->obstacles.empty();
  const bool busy = planner_.isPlanning();
  const PlanPtr& plan = shown().plan;
  const bool steps = plan && !plan->steps.empty();
  const bool open =
      plan && !plan->bodies.empty() && (plan->end == PlanEnd::Interrupted || plan->end == PlanEnd::TimeLimit);
  bench_.enable("sequence.plan", product && !busy && !hand_->isActive());
  bench_.enable("sequence.resume", open && !busy && !shown().growing);
  bench_.enable("sequence.open", product && !busy && !hand_->isActive());
  bench_.enable("sequence.export", steps && !busy);
  bench_.enable("sequence.film", steps && !busy);
  for (const char* id : {"sequence.play", "sequence.previous-step", "sequence.next-step", "sequence.show-product"}) {
    bench_.enable(id, steps);
  }
  bench_.enable("sequence.graph", steps || (plan && !plan->stuck.empty()));
  instructions_->enableActions();
  bench_.enable("sequence.stays", !bench_.document.semantics().selection().bodies.empty());
}

}  // namespace glissade
