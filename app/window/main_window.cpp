#include "app/window/main_window.h"

#include <QCloseEvent>
#include <QSignalBlocker>
#include <QStatusBar>

#include "app/window/context_menus.h"
#include "app/window/eyes_controller.h"
#include "app/window/icons.h"
#include "app/window/menus.h"
#include "app/window/preferences_controller.h"
#include "app/window/theme.h"
#include "app/window/window_actions.h"
#include "app/window/window_script.h"
#include "app/window/workspace_controller.h"
#include "widgets/arrange/arrange_controller.h"
#include "widgets/arrange/workspace_notice.h"
#include "widgets/contacts/fits_controller.h"
#include "widgets/contacts/joints_controller.h"
#include "widgets/devices/device_controller.h"
#include "widgets/devices/device_script.h"
#include "widgets/devices/keyboard_steering.h"
#include "widgets/files/welcome_controller.h"
#include "widgets/help/help_controller.h"
#include "widgets/help/log_controller.h"
#include "widgets/help/manual_controller.h"
#include "widgets/help/tour_controller.h"
#include "widgets/measure/measure_controller.h"
#include "widgets/paths/kept_paths_controller.h"
#include "widgets/paths/sweep_controller.h"
#include "widgets/places/environment_controller.h"
#include "widgets/product/assembly_controller.h"
#include "widgets/product/body_visibility.h"
#include "widgets/product/box_selection.h"
#include "widgets/product/document_controller.h"
#include "widgets/product/variants_controller.h"
#include "widgets/run/counts_panel.h"
#include "widgets/run/difficulty_controller.h"
#include "widgets/run/recording_controller.h"
#include "widgets/run/refusal_controller.h"
#include "widgets/run/run_controller.h"
#include "widgets/section/section_controller.h"
#include "widgets/sequence/revision_controller.h"
#include "widgets/sequence/sequence_controller.h"
#include "widgets/sequence/step_camera.h"
#include "widgets/sequence/times_controller.h"
#include "widgets/studies/paper_comparison.h"
#include "widgets/studies/study_controller.h"
#include "widgets/view/display_controller.h"
#include "widgets/view/named_views_controller.h"
#include "widgets/view/view_controller.h"
#include "widgets/workbench/editor_in_use.h"

namespace glissade {

MainWindow::MainWindow(const SceneWidgetFactory& makeScene, SessionClock clock)
    : scene_(makeScene(this)),
      actions_(*new ActionCatalogue(windowActions(), this)),
      messages_(*this),
      dialogs_(*this, [this] { return files_->folder(); }),
      document_(new WorkbenchDocument(this)),
      session_(new SessionBridge(clock, this)),
      bench_{*document_, *session_, *new ShownRun(*document_, *session_, this),
             *scene_,    actions_,  *new WorkController(*session_, actions_, *statusBar()),
             messages_,  scripts_,  dialogs_,
             *this},
      docks_(*this, actions_),
      room_(*this, docks_) {
  setWindowTitle(QStringLiteral("Glissade"));
  setAcceptDrops(true);
  setDockNestingEnabled(true);
  setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
  commitBefore(actions_);
  setCentralWidget(scene_->widget());
  scene_->widget()->setMinimumSize(280, 160);
  scene_->widget()->setObjectName(QStringLiteral("scene"));
  auto* keys = new KeyboardSteering(session_->hand()->keyboard.mailbox, actions_["operator.frame"], this);
  scene_->widget()->installEventFilter(keys);
  addParts();
  connectActions();
  addWindowCommands(bench_);
}

MainWindow::~MainWindow() {
  // The scene widget is a child of the window and owned by scene_, so it is taken out before either is destroyed.
  scene_->widget()->setParent(nullptr);
}

/// Makes the controllers. Each panel adds one line to the docks.
void MainWindow::addParts() {
  // The first observer of the document: others raise panels in the workspace that it shows.
  new WorkspaceController(bench_, docks_);
  new DocumentController(bench_);
  auto* view = new ViewController(bench_);
  new DisplayController(bench_);
  views_ = new NamedViewsController(bench_);
  connect(views_, &NamedViewsController::cameraMoved, view, &ViewController::publishOperatorFrame);
  auto* eyes = new EyesController(bench_);
  auto* fits = new FitsController(bench_);
  auto* joints = new JointsController(bench_);
  auto* environment = new EnvironmentController(bench_);
  auto* parts = new PartImport(bench_);
  auto* assembly = new AssemblyController(bench_, *parts);
  new BodyVisibility(bench_, *assembly->scenePanel());
  auto* path = new PathController(bench_);
  auto* difficulty = new DifficultyController(bench_);
  connect(difficulty, &DifficultyController::cameraMoved, view, &ViewController::publishOperatorFrame);
  files_ = new FileController(bench_, *parts, *path);
  new WelcomeController(bench_, *files_);
  auto* replay = new ReplayController(bench_);
  replayBar_ = replay->bar();
  recordings_ = new RecordingController(bench_, *replay, *files_);
  preferences_ =
      new PreferencesController(bench_, [this](int seconds) { files_->saves().setAutosaveSeconds(seconds); });
  studies_ = new StudyController(bench_, *files_);
  auto* devices = new DeviceController(*session_, actions_, *scene_, this);
  devices->addIndicators(*statusBar());
  connect(devices, &DeviceController::cameraMoved, view, &ViewController::publishOperatorFrame);
  addDeviceCommands(bench_, *devices);
  auto* run = new RunController(bench_);
  connect(new PaperComparison(bench_), &PaperComparison::compared, run->countsPanel(), &CountsPanel::setComparison);
  auto* refusal = new RefusalController(bench_);
  auto* measure = new MeasureController(bench_);
  connect(measure, &MeasureController::framePicked, assembly, &AssemblyController::placeByFrame);
  new ArrangeController(bench_, *assembly, *measure);
  auto* sections = new SectionController(bench_, *measure);
  new WorkspaceNotice(bench_);
  new VariantsController(bench_);
  new SweepController(bench_);
  auto* kept = new KeptPathsController(bench_);
  auto* sequence = new SequenceController(bench_);
  auto* stepCamera = new StepCamera(bench_, *sequence);
  connect(stepCamera, &StepCamera::cameraMoved, view, &ViewController::publishOperatorFrame);
  eyes->addTools(*refusal, *sequence, {*sections, *measure}, *path->panel(), *views_);
  new TimesController(bench_, *sequence);
  new RevisionController(bench_, *sequence);
  new ManualController(bench_);
  new BoxSelection(bench_);
  remember_ = [this, path, sequence, eyes] {
    path->remember(*memory_);
    sequence->remember(*memory_);
    eyes->remember(*memory_);
  };

  using enum Workspace;
  docks_.addDock({tr("Interaction"), "interaction", DockPlace::Left, {Planning, Study}});
  docks_.addDock({tr("Product"), "product", DockPlace::UpperRight, {Assembly, Study}, DockPlace::Left});
  docks_.addDock({tr("Run"), "run", DockPlace::UpperRight, {Planning, Study}});
  docks_.addDock({tr("Path"), "path", DockPlace::LowerRight, {Planning, Study}});
  docks_.addDock({tr("Sequence"), "sequence", DockPlace::LowerRight, {Assembly}});
  docks_.addDock({tr("Contacts"), "contacts", DockPlace::UpperRight, {Assembly}, DockPlace::LowerRight, true});
  docks_.addDock({tr("Log"), "log", DockPlace::LowerRight, {Study}});
  docks_.add({"interaction", tr("Interaction"), "interaction", run->interactionPanel()});
  docks_.add({"product", tr("Bodies"), "scene-tree", assembly->panel(), "panel.scene"});
  docks_.add({"product", tr("Places"), "semantics", environment->semanticsPanel(), "panel.semantics", Scrolling::Own});
  docks_.add({"contacts", tr("Fits"), "fits", fits->panel(), "panel.fits", Scrolling::Table});
  docks_.add({"contacts", tr("Joints"), "joints", joints->panel(), "panel.joints", Scrolling::Table});
  docks_.add({"run", tr("Figures"), "run", run->countsPanel(), "panel.run"});
  docks_.add({"run", tr("Coarse plan"), "plan", environment->planPanel(), "panel.plan", Scrolling::Own});
  docks_.add({"path", tr("This path"), "path", path->panel(), "panel.path"});
  docks_.add({"path", tr("Kept paths"), "paths", kept->panel(), "panel.paths", Scrolling::Table});
  docks_.add({"path", tr("Why not"), "difficulty", difficulty->panel(), "panel.difficulty", Scrolling::Own});
  docks_.add({"sequence", tr("Sequence"), "sequence", sequence->panel(), "panel.sequence", Scrolling::Table});
  docks_.add({"log", tr("Log"), "log", (new LogController(bench_))->panel(), "panel.log", Scrolling::Own});
  docks_.orderTabStops();
  resize(1280, 720);  // the docks share the width that the window has at this moment
  docks_.arrange();
  makeMenus(*this, actions_, {files_->recentMenu(), files_->saves().versionsMenu(), views_->menu()});
  new ContextMenus(bench_);
  new HelpController(bench_);
  new TourController(bench_);
}

void MainWindow::connectActions() {
  bench_.onAction("file.quit", this, [this] { close(); });
  bench_.onAction("file.close", this, [this] { closesToWelcomePage_ = close(); });
  bench_.onAction("view.reset-layout", this, [this] { docks_.arrange(); });
  connect(actions_["view.dark"], &QAction::toggled, this,
          [this](bool dark) { setTheme(dark ? Theme::Dark : Theme::Light); });
  connect(&bench_.work, &WorkController::failed, this,
          [this](const Diagnostic& why) { messages_.showError(tr("Not possible"), why); });
}

std::optional<Diagnostic> MainWindow::openScenario(const QString& file, bool quiet) {
  if (isStudyRunFile(file.toStdString())) return studies_->openRun(file, quiet);
  return files_->openScenario(file, quiet, FindFits::LaterIfLarge);
}

void MainWindow::importParts(const QStringList& files) { files_->openFiles(files, PartsDialog::Purpose::NewScenario); }

void MainWindow::setTheme(Theme theme) {
  applyTheme(theme);
  applyIcons(actions_, palette().color(QPalette::ButtonText));
  scene_->view().setTheme(theme);
  scene_->refresh();
  const QSignalBlocker block(actions_["view.dark"]);
  actions_["view.dark"]->setChecked(theme == Theme::Dark);
}

void MainWindow::setBatch(bool batch) {
  messages_.setQuiet(batch);
  bench_.work.setAtOnce(batch);
  document_->setAtOnce(batch || session_->clock() == SessionClock::Lockstep);
}

void MainWindow::remember(std::unique_ptr<WindowMemory> memory, bool sizeToo) {
  memory_ = std::move(memory);
  files_->setMemory(memory_.get());
  dialogs_.setMemory(memory_.get());
  views_->setMemory(memory_.get());
  remember_();
  if (sizeToo) restoreGeometry(memory_->windowGeometry());
  docks_.setLayouts(memory_->layouts(), docks_.workspace());
  room_.fit(room_.room());
  memory_->restoreChoices(actions_);
  preferences_->remember(*memory_);
  replayBar_->setVisible(!bench_.run.isLive());
}

void MainWindow::keepUnsavedEdits(const QString& folder) { files_->saves().keepUnsavedEdits(folder); }
void MainWindow::keepJournals(const QString& folder) { recordings_->keepJournals(folder); }

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) { files_->drop(*event->mimeData()); }

void MainWindow::closeEvent(QCloseEvent* event) {
  commitEditorInUse();
  event->setAccepted(files_->mayDiscard());
  if (!event->isAccepted() || !memory_) return;
  memory_->saveLayouts(docks_.layouts(), saveGeometry());
  memory_->saveChoices(actions_);
}

}  // namespace glissade
