#include "app/window/main_window.h"

#include <QCloseEvent>
#include <QCoreApplication>
#include <QDialog>
#include <QFileInfo>
#include <QLocale>
#include <QPainter>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>

#include "app/window/assembly_controller.h"
#include "app/window/body_visibility.h"
#include "app/window/device_controller.h"
#include "app/window/difficulty_controller.h"
#include "app/window/editor_in_use.h"
#include "app/window/environment_controller.h"
#include "app/window/icons.h"
#include "app/window/keyboard_steering.h"
#include "app/window/part_import.h"
#include "app/window/path_controller.h"
#include "app/window/replay_controller.h"
#include "app/window/status_text.h"
#include "app/window/study_controller.h"
#include "app/window/theme.h"
#include "app/window/window_memory.h"
#include "app/window/work_controller.h"
#include "widgets/panels/counts_panel.h"
#include "widgets/panels/interaction_panel.h"
#include "widgets/scene3d/camera_controller.h"
#include "widgets/scene3d/label_overlay.h"

namespace glissade {
MainWindow::MainWindow(const SceneWidgetFactory& makeScene, SessionClock clock)
    : actions_(new ActionCatalogue(this)),
      bridge_(new SessionBridge(clock, this)),
      scene_(makeScene(this)),
      status_(new QLabel(this)),
      elapsed_(new QLabel(this)),
      welcome_(new QLabel(this)) {
  setWindowTitle(QStringLiteral("Glissade"));
  setAcceptDrops(true);
  commitBefore(*actions_);
  setDockNestingEnabled(true);
  setCentralWidget(scene_->widget());
  scene_->widget()->setMinimumSize(320, 240);
  scene_->widget()->setObjectName(QStringLiteral("scene"));
  scene_->widget()->installEventFilter(new KeyboardSteering(bridge_->hand()->keyboard.mailbox, this));
  scene_->onCameraMoved([this] { publishOperatorFrame(); });
  new LabelOverlay(scene_->view(), scene_->widget());
  environment_ = new EnvironmentController(*bridge_, *actions_, *scene_, this);
  assembly_ = new AssemblyController(environment_->document(), *actions_, *scene_, this);
  studies_ = new StudyController(*this);
  devices_ = new DeviceController(*bridge_, *actions_, *scene_, this);
  connect(devices_, &DeviceController::cameraMoved, this, [this] { publishOperatorFrame(); });
  replay_ = new ReplayController(*bridge_, *actions_, this);
  addToolBar(Qt::BottomToolBarArea, replay_->bar());

  status_->setObjectName(QStringLiteral("status"));
  statusBar()->addWidget(status_, 1);
  work_ = new WorkController(*bridge_, *actions_, *statusBar());
  parts_ = new PartImport(assembly_->document(), *work_, this);
  path_ = new PathController(*bridge_, *actions_, *scene_, this);
  difficulty_ = new DifficultyController(*actions_, *scene_, *work_, this);
  devices_->addIndicators(*statusBar());
  statusBar()->addPermanentWidget(elapsed_);
  makePanels();
  makeMenus();
  connectPanels();
  connectActions();
  connectViewActions();
  connect(bridge_, &SessionBridge::snapshotChanged, this, [this](const SnapshotPtr& snapshot) {
    if (!replay_->isActive()) showSnapshot(snapshot);
  });

  welcome_->setAlignment(Qt::AlignCenter);
  welcome_->setText(
      tr("<h2>Glissade</h2><p>Open a scenario (Ctrl+O), or make one of your parts (Ctrl+N). Or drop either here.</p>"
         "<p>The folder <i>samples</i> holds the papers' environments.</p>"));
  auto* over = new QVBoxLayout(scene_->widget());
  over->addWidget(welcome_, 0, Qt::AlignCenter);
  status_->setText(tr("No scenario is open."));
  enableActions(nullptr);
}

MainWindow::~MainWindow() {
  // The scene widget is a child of the window as well as ours: take it out before either goes.
  scene_->widget()->setParent(nullptr);
}

void MainWindow::connectPanels() {
  connect(difficulty_, &DifficultyController::found, this, [this] { (*actions_)["panel.difficulty"]->trigger(); });
  connect(environment_, &EnvironmentController::wanted, this, [this] {
    (*actions_)["panel.semantics"]->trigger();
    (*actions_)["panel.plan"]->trigger();
  });
  connect(&environment_->document().undoStack(), &QUndoStack::cleanChanged, this, [this] { showTitle(); });
  connect(environment_, &EnvironmentController::failed, this, [this](const Diagnostic& why) {
    if (!batch_) showError(tr("The places cannot be found"), why);
  });
  connect(&assembly_->document(), &AssemblyDocument::rearranged, this, &MainWindow::rearrange);
  connect(assembly_, &AssemblyController::failed, this, [this](const Diagnostic& why) {
    if (!batch_) showError(tr("This cannot be done"), why);
  });
  connect(assembly_, &AssemblyController::told, this,
          [this](const QString& text) { statusBar()->showMessage(text, 10000); });
  connect(assembly_, &AssemblyController::addPartsWanted, this,
          [this] { parts_->ask(PartsDialog::Purpose::AddParts); });
  connect(parts_, &PartImport::made, this, [this](const ScenarioPtr& scenario) {
    if (!mayDiscard()) return;
    openLoaded(scenario);
    environment_->document().undoStack().resetClean();  // it is saved nowhere
  });
  connect(parts_, &PartImport::failed, this, [this](const Diagnostic& why) {
    if (!batch_) showError(tr("The parts cannot be taken"), why);
  });
  connect(replay_, &ReplayController::shown, this, &MainWindow::showSnapshot);
  connect(replay_, &ReplayController::activeChanged, this, [this](bool active) {
    interaction_->setReplayed(active);
    if (!active && bridge_->snapshot()) showSnapshot(bridge_->snapshot());
  });
  connect(replay_, &ReplayController::notJournalled, this, [this](const Diagnostic& why) {
    statusBar()->showMessage(tr("No journal of this run on disk: %1").arg(QString::fromStdString(toString(why))),
                             10000);
  });
  connect(replay_, &ReplayController::failed, this, [this](const Diagnostic& why) {
    if (!batch_) showError(tr("The recording cannot be replayed"), why);
  });
  connect(interaction_, &InteractionPanel::commanded, bridge_, &SessionBridge::post);
  connect(interaction_, &InteractionPanel::deviceChosen, this,
          [this](const QString& id) { bridge_->setDevice(id.toStdString()); });
  connect(path_, &PathController::found, this, [this] { (*actions_)["panel.path"]->trigger(); });
  connect(path_, &PathController::told, this, [this](const QString& text) { statusBar()->showMessage(text, 10000); });
  connect(path_, &PathController::failed, this, [this](const Diagnostic& why) {
    if (!batch_) showError(tr("This cannot be done with the path"), why);
  });
}

void MainWindow::connectActions() {
  const auto on = [this](const char* id, auto handler) {
    connect((*actions_)[QLatin1String(id)], &QAction::triggered, this, handler);
  };
  on("file.new", [this] { newScenario({}); });
  on("file.open", [this] { chooseScenario(); });
  on("file.open-recording", [this] { chooseRecording(); });
  on("file.save-recording", [this] { chooseSaveRecording(); });
  on("file.save", [this] { save(); });
  on("file.save-as", [this] { chooseSave(); });
  on("file.quit", [this] { close(); });
  on("recent.forget", [this] { memory_->forgetFiles(); });
  (*actions_)["recent.forget"]->setEnabled(false);  // until the list is seen
  on("run.start", [this] {
    bridge_->post(command::Stop{});  // smoothing that may still go on
    bridge_->post(command::Start{});
  });
  on("run.pause",
     [this](bool pause) { bridge_->post(pause ? Command(command::Pause{}) : Command(command::Resume{})); });
  on("run.stop", [this] { bridge_->post(command::Stop{}); });
  on("run.restart", [this] { restart(snapshot_->seed); });
  on("run.restart-new-seed", [this] { restart(snapshot_->seed + 1); });
  on("run.tuning", [this](bool tune) {
    bridge_->post(command::SetParameter{ParameterId::Tuning, tune ? 1.0 * kTunedAll : 0.0});
  });
  on("object.to-start", [this] { bridge_->post(command::SetDevicePose{scenario_->problem.start}); });
  on("strategy.rules", [this] { editRules(); });
  on("view.reset-layout", [this] { arrangePanels(); });
  on("help.shortcuts", [this] { showShortcuts(); });
  on("help.about", [this] { showAbout(); });
}

void MainWindow::connectViewActions() {
  const auto look = [this](const char* id, StandardView view) {
    connect((*actions_)[QLatin1String(id)], &QAction::triggered, this, [this, view] {
      scene_->view().camera().setStandardView(view);
      scene_->view().fit();
      publishOperatorFrame();
      scene_->refresh();
    });
  };
  look("view.isometric", StandardView::Isometric);
  look("view.front", StandardView::Front);
  look("view.back", StandardView::Back);
  look("view.left", StandardView::Left);
  look("view.right", StandardView::Right);
  look("view.top", StandardView::Top);
  look("view.bottom", StandardView::Bottom);
  connect((*actions_)["view.fit"], &QAction::triggered, this, [this] {
    scene_->view().fit();
    publishOperatorFrame();
    scene_->refresh();
  });
  connect((*actions_)["view.path-authors"], &QAction::toggled, this, [this](bool byAuthor) {
    scene_->view().setPathByAuthor(byAuthor);
    scene_->refresh();
  });
  connect((*actions_)["view.dark"], &QAction::toggled, this,
          [this](bool dark) { setTheme(dark ? Theme::Dark : Theme::Light); });
  const auto layer = [this](const char* id, SceneLayer which) {
    QAction* action = (*actions_)[QLatin1String(id)];
    action->setChecked(scene_->view().layerVisible(which));
    connect(action, &QAction::toggled, this, [this, which](bool visible) {
      scene_->view().setLayerVisible(which, visible);
      scene_->refresh();
    });
  };
  layer("layer.bodies", SceneLayer::Bodies);
  layer("layer.object", SceneLayer::Object);
  layer("layer.ends", SceneLayer::StartAndGoal);
  layer("layer.workspace", SceneLayer::Workspace);
  layer("layer.roadmap", SceneLayer::Roadmap);
  layer("layer.path", SceneLayer::Path);
  layer("layer.contact", SceneLayer::Contact);
  layer("layer.force", SceneLayer::Guidance);
  layer("layer.free-cells", SceneLayer::FreeCells);
  layer("layer.mobile-cells", SceneLayer::MobileCells);
  layer("layer.static-cells", SceneLayer::StaticCells);
  layer("layer.places", SceneLayer::Places);
  layer("layer.borders", SceneLayer::Borders);
  layer("layer.graph", SceneLayer::Graph);
  layer("layer.coarse-path", SceneLayer::CoarsePath);
  layer("layer.milestones", SceneLayer::Milestones);
  layer("layer.region", SceneLayer::Region);
  layer("layer.difficulty", SceneLayer::Difficulty);
}

void MainWindow::setBatch(bool batch) {
  batch_ = batch;
  work_->setAtOnce(batch);
}

bool MainWindow::isModified() const {
  const Scenario& saved = scenario_->scenario;
  return !environment_->document().undoStack().isClean() || !(environment_->options() == saved.environment) ||
         bridge_->snapshot()->plannerId != saved.planner;
}

void MainWindow::showTitle() {
  if (!scenario_) return;
  const std::string& name = scenario_->scenario.name;
  const QString file = QFileInfo(QString::fromStdString(scenario_->file)).completeBaseName();
  setWindowTitle(QStringLiteral("%1[*] — Glissade").arg(name.empty() ? file : QString::fromStdString(name)));
  setWindowModified(isModified());
}

void MainWindow::openLoaded(const ScenarioPtr& scenario) {
  work_->cancel();
  scenario_ = scenario;
  welcome_->hide();
  scene_->view().setScenario(scenario_);
  interaction_->setScenario(*scenario_);
  interaction_->setDevice(bridge_->deviceId());
  replay_->openScenario(scenario_);
  bridge_->open(scenario_);
  difficulty_->open(scenario_);
  environment_->open(scenario_);
  assembly_->show(scenario_);
  bodies_->open(*scenario_);
  showTitle();
  publishOperatorFrame();
  scene_->widget()->setFocus();
}

void MainWindow::rearrange(const ScenarioPtr& scenario) {
  work_->cancel();
  scenario_ = scenario;
  scene_->view().rearrange(scenario_);
  interaction_->setScenario(*scenario_);
  replay_->rearrange(scenario_);
  bridge_->rearrange(scenario_);
  environment_->rearrange(scenario_);
  assembly_->show(scenario_);
  bodies_->rearrange(*scenario_);
  difficulty_->open(scenario_);
  publishOperatorFrame();
}

void MainWindow::showSnapshot(const SnapshotPtr& snapshot) {
  if (!scenario_) return;
  scene_->view().setSnapshot(snapshot);
  scene_->refresh();
  interaction_->setSnapshot(*snapshot);
  interaction_->setDevice(bridge_->deviceId());
  counts_->setSnapshot(*snapshot, *scenario_);
  path_->showSnapshot(snapshot, scenario_, !replay_->isActive());
  snapshot_ = snapshot;
  environment_->showSnapshot(snapshot);
  work_->showSnapshot(*snapshot);
  difficulty_->showSnapshot(snapshot, !replay_->isActive());
  setWindowModified(isModified());
  status_->setText(replay_->isActive() ? replay_->statusText() : statusText(*snapshot));
  elapsed_->setText(snapshot->run > 0 ? QLocale().toString(snapshot->virtualSeconds, 'f', 1) + QStringLiteral(" s")
                                      : QString());
  enableActions(snapshot.get());
}

void MainWindow::enableActions(const SessionSnapshot* snapshot) {
  const bool open = snapshot != nullptr;
  const bool live = open && !replay_->isActive();
  const bool running = live && isRunning(*snapshot);
  const auto enable = [this](const char* id, bool enabled) { (*actions_)[QLatin1String(id)]->setEnabled(enabled); };
  enable("run.start", live && !running);
  enable("run.pause", running);
  enable("run.stop", running);
  enable("run.restart", live);
  enable("run.restart-new-seed", live);
  enable("run.tuning", live);
  (*actions_)["run.tuning"]->setChecked(open && snapshot->parameters[ParameterId::Tuning] > 0.0);
  enable("strategy.rules", live && !running);
  enable("object.to-start", live);
  enable("file.save", open);
  enable("file.save-as", open);
  (*actions_)["run.pause"]->setChecked(live && snapshot->state == SessionState::Paused);
  assembly_->setState(live && !running, bridge_->snapshot());
}

void MainWindow::publishOperatorFrame() {
  if (!scenario_) return;
  const CameraController& camera = scene_->view().camera();
  OperatorFrame frame;
  frame.R_WV = camera.R_WV();
  frame.speed = operatorSpeed(camera.viewHeight(), scenario_->problem.world->objectRadius());
  bridge_->setOperatorFrame(frame);
}

void MainWindow::restart(std::uint64_t seed) {
  bridge_->post(command::Stop{});
  bridge_->post(command::SetSeed{seed});
  bridge_->post(command::Start{});
}

QImage MainWindow::picture() {
  QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);  // panels as they are going to be
  QPixmap whole = grab();
  QPainter painter(&whole);
  for (QDialog* dialog : findChildren<QDialog*>()) {
    if (dialog->isVisible()) painter.drawPixmap(dialog->geometry().topLeft() - geometry().topLeft(), dialog->grab());
  }
  return whole.toImage();
}

void MainWindow::setTheme(Theme theme) {
  applyTheme(theme);
  applyIcons(*actions_, palette().color(QPalette::ButtonText));
  scene_->view().setTheme(theme);
  scene_->refresh();
  const QSignalBlocker block((*actions_)["view.dark"]);
  (*actions_)["view.dark"]->setChecked(theme == Theme::Dark);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  commitEditorInUse();
  event->setAccepted(mayDiscard());
  if (event->isAccepted() && memory_) memory_->saveLayout(*this);
}

}  // namespace glissade
