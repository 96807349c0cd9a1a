#include "app/window/main_window.h"

#include <QCloseEvent>
#include <QDialog>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QLocale>
#include <QMenuBar>
#include <QMimeData>
#include <QPainter>
#include <QScrollArea>
#include <QStatusBar>
#include <QStyle>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/window/device_controller.h"
#include "app/window/environment_controller.h"
#include "app/window/icons.h"
#include "app/window/keyboard_steering.h"
#include "app/window/replay_controller.h"
#include "app/window/status_text.h"
#include "app/window/study_controller.h"
#include "app/window/theme.h"
#include "engine/planning/smoothing/shortcuts.h"
#include "engine/scenario/path_io.h"
#include "engine/scenario/scenario_io.h"
#include "widgets/panels/counts_panel.h"
#include "widgets/panels/interaction_panel.h"
#include "widgets/panels/path_panel.h"
#include "widgets/panels/scene_panel.h"
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
  setDockNestingEnabled(true);
  setCentralWidget(scene_->widget());
  scene_->widget()->setMinimumSize(320, 240);
  scene_->widget()->setObjectName(QStringLiteral("scene"));
  scene_->widget()->installEventFilter(new KeyboardSteering(bridge_->hand()->keyboard.mailbox, this));
  scene_->onCameraMoved([this] { publishOperatorFrame(); });
  new LabelOverlay(scene_->view(), scene_->widget());
  environment_ = new EnvironmentController(*bridge_, *actions_, *scene_, this);
  studies_ = new StudyController(*this);
  devices_ = new DeviceController(*bridge_, *actions_, *scene_, this);
  connect(devices_, &DeviceController::cameraMoved, this, [this] { publishOperatorFrame(); });
  replay_ = new ReplayController(*bridge_, *actions_, this);
  addToolBar(Qt::BottomToolBarArea, replay_->bar());

  status_->setObjectName(QStringLiteral("status"));
  statusBar()->addWidget(status_, 1);
  devices_->addIndicators(*statusBar());
  statusBar()->addPermanentWidget(elapsed_);
  makePanels();
  makeMenus();
  connectActions();
  connectViewActions();
  connect(bridge_, &SessionBridge::snapshotChanged, this, [this](const SnapshotPtr& snapshot) {
    if (!replay_->isActive()) showSnapshot(snapshot);
  });

  welcome_->setAlignment(Qt::AlignCenter);
  welcome_->setText(
      tr("<h2>Glissade</h2><p>Open a scenario (Ctrl+O), or drop one here.</p>"
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

QDockWidget* MainWindow::addPanel(const QString& title, const char* id, QWidget* content, Qt::DockWidgetArea area,
                                  Scrolling scrolling) {
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(QLatin1String(id));
  addDockWidget(area, dock);
  if (scrolling == Scrolling::Own) {
    dock->setWidget(content);
    return dock;
  }
  auto* scroll = new QScrollArea(dock);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(content);
  const int bar = style()->pixelMetric(QStyle::PM_ScrollBarExtent);
  scroll->setMinimumWidth(content->minimumSizeHint().width() + 2 * bar);
  dock->setWidget(scroll);
  return dock;
}

void MainWindow::makePanels() {
  interaction_ = new InteractionPanel(*actions_, this);
  counts_ = new CountsPanel(this);
  sceneTree_ = new ScenePanel(this);
  path_ = new PathPanel(*actions_, this);
  QDockWidget* interaction = addPanel(tr("Interaction"), "interaction", interaction_, Qt::LeftDockWidgetArea);
  QDockWidget* scene = addPanel(tr("Scene"), "scene-tree", sceneTree_, Qt::RightDockWidgetArea);
  QDockWidget* counts = addPanel(tr("Run"), "run", counts_, Qt::RightDockWidgetArea);
  QDockWidget* path = addPanel(tr("Path"), "path", path_, Qt::RightDockWidgetArea);
  QDockWidget* semantics =
      addPanel(tr("Semantics"), "semantics", environment_->semanticsPanel(), Qt::RightDockWidgetArea, Scrolling::Own);
  QDockWidget* plan = addPanel(tr("Plan"), "plan", environment_->planPanel(), Qt::RightDockWidgetArea, Scrolling::Own);
  // What is looked at by turns shares a place: small screens have no room for six panels.
  tabifyDockWidget(scene, semantics);
  tabifyDockWidget(counts, plan);
  tabifyDockWidget(plan, path);
  setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
  const auto bringUp = [this](const char* id, QDockWidget* dock) {
    connect((*actions_)[QLatin1String(id)], &QAction::triggered, dock, [dock] {
      dock->show();
      dock->raise();
    });
  };
  bringUp("panel.scene", scene);
  bringUp("panel.semantics", semantics);
  bringUp("panel.run", counts);
  bringUp("panel.plan", plan);
  bringUp("panel.path", path);
  (*actions_)["panel.scene"]->trigger();
  (*actions_)["panel.run"]->trigger();
  resizeDocks({interaction, scene}, {270, 340}, Qt::Horizontal);
  resizeDocks({scene, counts}, {380, 240}, Qt::Vertical);
  connect(environment_, &EnvironmentController::wanted, this, [this] {
    (*actions_)["panel.semantics"]->trigger();
    (*actions_)["panel.plan"]->trigger();
  });
  connect(&environment_->document().undoStack(), &QUndoStack::cleanChanged, this, [this] { showTitle(); });
  connect(environment_, &EnvironmentController::failed, this, [this](const Diagnostic& why) {
    if (!batch_) showError(tr("The places cannot be found"), why);
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
  connect(path_, &PathPanel::poseShown, this, [this](const std::optional<Pose>& pose) {
    scene_->view().setPlaybackPose(pose);
    scene_->refresh();
  });
  connect(path_, &PathPanel::playbackEnded, this, [this] { (*actions_)["path.play"]->setChecked(false); });
}

void MainWindow::makeMenus() {
  const auto fill = [this](QMenu* menu, const char* prefix) {
    for (const ActionSpec& spec : actionSpecs()) {
      if (QLatin1String(spec.id).startsWith(QLatin1String(prefix)))
        menu->addAction((*actions_)[QLatin1String(spec.id)]);
    }
  };
  QMenu* file = menuBar()->addMenu(tr("&File"));
  fill(file, "file.");
  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  fill(edit, "edit.");
  edit->addSeparator();
  fill(edit, "environment.");
  fill(edit, "place.");
  fill(edit, "milestone.");
  edit->addSeparator();
  fill(edit, "attribute.");
  QMenu* run = menuBar()->addMenu(tr("&Run"));
  fill(run, "run.");
  run->addSeparator();
  fill(run, "replay.");
  run->addSeparator();
  fill(run, "object.");
  fill(run, "path.");
  fill(menuBar()->addMenu(tr("&Study")), "study.");
  fill(menuBar()->addMenu(tr("&Operator")), "operator.");
  QMenu* view = menuBar()->addMenu(tr("&View"));
  fill(view, "view.");
  fill(view->addMenu(tr("&Layers")), "layer.");
  QMenu* panels = view->addMenu(tr("&Panels"));
  fill(panels, "panel.");
  panels->addSeparator();
  for (QDockWidget* dock : findChildren<QDockWidget*>()) panels->addAction(dock->toggleViewAction());
  fill(menuBar()->addMenu(tr("&Help")), "help.");

  QToolBar* bar = addToolBar(tr("Tools"));
  bar->setObjectName(QStringLiteral("tools"));
  bar->setMovable(false);
  bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  for (const char* id :
       {"file.open", "file.save", "file.export", "", "edit.undo", "edit.redo", "", "run.start", "run.pause", "run.stop",
        "run.restart-new-seed", "", "view.fit", "view.isometric", "view.front", "view.left", "view.top"}) {
    if (id[0] == '\0') {
      bar->addSeparator();
    } else {
      bar->addAction((*actions_)[QLatin1String(id)]);
    }
  }
  // Cubes and arrows speak for themselves; words there would push other buttons off small screens.
  for (const char* id :
       {"edit.undo", "edit.redo", "view.fit", "view.isometric", "view.front", "view.left", "view.top"}) {
    auto* button = qobject_cast<QToolButton*>(bar->widgetForAction((*actions_)[QLatin1String(id)]));
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
  }
}

void MainWindow::connectActions() {
  const auto on = [this](const char* id, auto handler) {
    connect((*actions_)[QLatin1String(id)], &QAction::triggered, this, handler);
  };
  on("file.open", [this] { chooseScenario(); });
  on("file.export", [this] { chooseExport(); });
  on("file.open-recording", [this] { chooseRecording(); });
  on("file.save-recording", [this] { chooseSaveRecording(); });
  on("file.save", [this] { save(); });
  on("file.save-as", [this] { chooseSave(); });
  on("file.quit", [this] { close(); });
  on("run.start", [this] { bridge_->post(command::Start{}); });
  on("run.pause",
     [this](bool pause) { bridge_->post(pause ? Command(command::Pause{}) : Command(command::Resume{})); });
  on("run.stop", [this] { bridge_->post(command::Stop{}); });
  on("run.restart", [this] { restart(snapshot_->seed); });
  on("run.restart-new-seed", [this] { restart(snapshot_->seed + 1); });
  on("run.tuning", [this](bool tune) {
    bridge_->post(command::SetParameter{ParameterId::Tuning, tune ? 1.0 * kTunedAll : 0.0});
  });
  on("object.to-start", [this] { bridge_->post(command::SetDevicePose{scenario_->problem.start}); });
  connect((*actions_)["path.play"], &QAction::toggled, path_, &PathPanel::setPlaying);
  on("path.smooth", [this](bool smooth) { bridge_->post(command::SmoothPath{smooth ? kUsualShortcuts : 0}); });
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
}

void MainWindow::showTitle() {
  if (!scenario_) return;
  const std::string& name = scenario_->scenario.name;
  const QString file = QFileInfo(QString::fromStdString(scenario_->file)).completeBaseName();
  setWindowTitle(QStringLiteral("%1[*] — Glissade").arg(name.empty() ? file : QString::fromStdString(name)));
  setWindowModified(!environment_->document().undoStack().isClean());
}

std::optional<Diagnostic> MainWindow::openScenario(const QString& file, bool quiet) {
  if (!quiet && !mayDiscard()) return std::nullopt;
  auto loaded = loadScenario(file.toStdString());
  if (!loaded) {
    if (!quiet) showError(tr("The scenario cannot be opened"), loaded.error());
    return loaded.error();
  }
  scenario_ = std::make_shared<const LoadedScenario>(std::move(*loaded));
  welcome_->hide();
  scene_->view().setScenario(scenario_);
  sceneTree_->setScenario(*scenario_);
  interaction_->setScenario(*scenario_);
  interaction_->setDevice(bridge_->deviceId());
  replay_->openScenario(scenario_);
  bridge_->open(scenario_);
  environment_->open(scenario_);
  showTitle();
  publishOperatorFrame();
  scene_->widget()->setFocus();
  if (!quiet && !scenario_->warnings.empty()) {
    showError(tr("The scenario was opened, with a warning"), scenario_->warnings.front());
  }
  return std::nullopt;
}

void MainWindow::showSnapshot(const SnapshotPtr& snapshot) {
  if (!scenario_) return;
  scene_->view().setSnapshot(snapshot);
  scene_->refresh();
  interaction_->setSnapshot(*snapshot);
  interaction_->setDevice(bridge_->deviceId());
  counts_->setSnapshot(*snapshot, *scenario_);
  const bool justSolved = snapshot->path && (!snapshot_ || snapshot_->path != snapshot->path);
  if (justSolved && !snapshot->coarsePlan) (*actions_)["panel.path"]->trigger();
  path_->setPath(snapshot->path, *scenario_);
  snapshot_ = snapshot;
  environment_->showSnapshot(snapshot);
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
  enable("object.to-start", live);
  enable("path.play", open && snapshot->path != nullptr);
  enable("path.smooth", live && snapshot->path != nullptr);
  (*actions_)["path.smooth"]->setChecked(open && snapshot->smoothed);
  enable("file.save", open);
  enable("file.save-as", open);
  enable("file.export", open && snapshot->path != nullptr);
  (*actions_)["run.pause"]->setChecked(live && snapshot->state == SessionState::Paused);
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

std::optional<Diagnostic> MainWindow::saveScenarioAs(const QString& file) {
  Scenario scenario = scenario_->scenario;
  setSemanticEdits(environment_->document().edits(), scenario);
  scenario.environment = environment_->options();
  const SnapshotPtr live = bridge_->snapshot();  // not what a replay shows
  scenario.planner = live->plannerId;
  scenario.seed = live->seed;
  for (const ParameterSpec& spec : parameterTable()) {
    if (live->parameters[spec.id] != scenario_->parameters[spec.id]) {
      scenario.parameters[spec.id] = live->parameters[spec.id];
    }
  }
  const Outcome saved = saveScenario(scenario, file.toStdString());
  if (!saved) return saved.error();
  environment_->document().undoStack().setClean();
  showTitle();
  return std::nullopt;
}

std::optional<Diagnostic> MainWindow::exportPath(const QString& file) {
  if (!snapshot_ || !snapshot_->path) {
    return Diagnostic{ErrorKind::Usage, file.toStdString(), "", "there is no path to export", "Solve first."};
  }
  const std::string name = file.toStdString();
  Outcome outcome = Done{};
  if (file.endsWith(QLatin1String(".json"))) {
    outcome = writePathJson(*snapshot_->path, *scenario_, {snapshot_->plannerId, snapshot_->seed}, name);
  } else if (file.endsWith(QLatin1String(".path"))) {
    outcome = writePathOmpl(*snapshot_->path, name);
  } else {
    outcome = writePathCsv(*snapshot_->path, *scenario_, name);
  }
  if (!outcome) return outcome.error();
  return std::nullopt;
}

QImage MainWindow::picture() {
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

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const auto urls = event->mimeData()->urls();
  if (!urls.isEmpty()) openScenario(urls.front().toLocalFile());
}

void MainWindow::closeEvent(QCloseEvent* event) { event->setAccepted(mayDiscard()); }

}  // namespace glissade
