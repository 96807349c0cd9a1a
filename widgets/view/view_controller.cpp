#include "widgets/view/view_controller.h"

#include <QActionGroup>
#include <QEvent>

#include "widgets/controls/body_id_text.h"
#include "widgets/controls/length_text.h"
#include "widgets/scene3d/camera_controller.h"
#include "widgets/scene3d/label_overlay.h"
#include "widgets/scene3d/legend_overlay.h"
#include "widgets/scene3d/navigation_style.h"
#include "widgets/scene3d/scale_bar.h"
#include "widgets/scene3d/view_cube.h"

namespace glissade {
namespace {

/// Actions that need a scenario.
constexpr const char* kCameraActions[] = {"view.fit",   "view.zoom-selection", "view.isometric", "view.front",
                                          "view.back",  "view.left",           "view.right",     "view.top",
                                          "view.bottom"};

}  // namespace

ViewController::ViewController(const Workbench& bench) : QObject(&bench.window), bench_(bench) {
  QWidget* widget = bench.scene.widget();
  addNavigationAids();
  connectNavigationStyles();
  widget->installEventFilter(this);
  showGridUnit();
  bench.scene.onCameraMoved([this] { publishOperatorFrame(); });
  connect(&bench.document, &WorkbenchDocument::changedForView, this, &ViewController::updateView);
  // A failed edit puts a dragged body back.
  connect(&bench.document, &WorkbenchDocument::editFailed, this, [this] { updateView(Change::Arrangement); });
  connect(&bench.run, &ShownRun::changed, this, [this](const SnapshotPtr& snapshot) {
    bench_.scene.view().setSnapshot(snapshot);
    bench_.scene.refresh();
  });
  connectActions();
  for (const char* id : kCameraActions) bench.enable(id, false);
}

/// Adds the navigation aids. View cube and scale bar are hidden until a scenario is open.
void ViewController::addNavigationAids() {
  auto* cube = new ViewCube(bench_.scene.view(), bench_.scene.widget());
  auto* scale = new ScaleBar(bench_.scene.view(), bench_.scene.widget());
  auto* legend = new LegendOverlay(bench_.scene.view(), bench_.scene.widget());
  new LabelOverlay(bench_.scene.view(), *legend, bench_.scene.widget());
  connect(bench_.actions["layer.legend"], &QAction::toggled, legend, &QWidget::setVisible);
  for (QWidget* aid : {static_cast<QWidget*>(cube), static_cast<QWidget*>(scale)}) {
    aid->hide();
    connect(&bench_.document, &WorkbenchDocument::changedForView, aid, [aid](Changes what) {
      if (what & Change::Scenario) aid->show();
    });
  }
  connect(cube, &ViewCube::lookFrom, this, [this](const Vector3& towardsEye) {
    bench_.scene.view().camera().lookFrom(towardsEye);
    showCamera();
  });
}

void ViewController::connectNavigationStyles() {
  auto* group = new QActionGroup(this);
  for (const NavigationStyleEntry& entry : kNavigationStyles) {
    QAction* action = group->addAction(bench_.actions[QLatin1String(entry.action)]);
    connect(action, &QAction::toggled, this, [&scene = bench_.scene, style = entry.style](bool chosen) {
      if (chosen) scene.setNavigationStyle(style);
    });
  }
  bench_.actions[QLatin1String(kNavigationStyles.front().action)]->setChecked(true);
}

bool ViewController::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::LocaleChange) showGridUnit();
  return QObject::eventFilter(watched, event);
}

void ViewController::showGridUnit() {
  bench_.scene.view().setGridUnit(roundLengthUnit());
  bench_.scene.refresh();
}

void ViewController::showCamera() {
  publishOperatorFrame();
  bench_.scene.refresh();
}

/// Shows the selected bodies, or everything if none is selected.
void ViewController::zoomToSelection() {
  std::set<BodyId> ids;
  for (const QString& id : bench_.document.semantics().selectedBodies()) ids.insert(toBodyId(id));
  const Box3 box = bench_.scene.view().extentOf(ids);
  if (box.isEmpty()) {
    bench_.scene.view().fit();
  } else {
    bench_.scene.view().camera().zoomTo(box);
  }
  showCamera();
}

void ViewController::updateView(Changes what) {
  const ScenarioPtr& scenario = bench_.document.scenario();
  if (what & Change::Scenario) {
    bench_.scene.view().setScenario(scenario);
    for (const char* id : kCameraActions) bench_.enable(id, true);
    bench_.scene.widget()->setFocus();
  } else if (what & Change::Arrangement) {
    bench_.scene.view().rearrange(scenario);
  } else {
    return;
  }
  publishOperatorFrame();
  bench_.scene.refresh();
}

void ViewController::publishOperatorFrame() {
  const ScenarioPtr& scenario = bench_.document.scenario();
  if (!scenario) return;
  const CameraController& camera = bench_.scene.view().camera();
  OperatorFrame frame;
  frame.R_WV = camera.R_WV();
  frame.speed = operatorSpeed(camera.viewHeight(), scenario->problem.world->objectRadius());
  bench_.session.setOperatorFrame(frame);
}

void ViewController::connectActions() {
  const auto look = [this](const char* id, StandardView view) {
    bench_.onAction(id, this, [this, view] {
      bench_.scene.view().camera().setStandardView(view);
      bench_.scene.view().fit();
      showCamera();
    });
  };
  look("view.isometric", StandardView::Isometric);
  look("view.front", StandardView::Front);
  look("view.back", StandardView::Back);
  look("view.left", StandardView::Left);
  look("view.right", StandardView::Right);
  look("view.top", StandardView::Top);
  look("view.bottom", StandardView::Bottom);
  bench_.onAction("view.fit", this, [this] {
    bench_.scene.view().fit();
    showCamera();
  });
  bench_.onAction("view.zoom-selection", this, [this] { zoomToSelection(); });
  connect(bench_.actions["view.orthographic"], &QAction::toggled, this, [this](bool orthographic) {
    bench_.scene.view().camera().setOrthographic(orthographic);
    showCamera();
  });
  connect(bench_.actions["view.path-authors"], &QAction::toggled, this, [this](bool byAuthor) {
    bench_.scene.view().setPathByAuthor(byAuthor);
    bench_.scene.refresh();
  });
  const auto layer = [this](const char* id, SceneLayer which) {
    QAction* action = bench_.actions[QLatin1String(id)];
    action->setChecked(bench_.scene.view().layerVisible(which));
    connect(action, &QAction::toggled, this, [this, which](bool visible) {
      bench_.scene.view().setLayerVisible(which, visible);
      bench_.scene.refresh();
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
  layer("layer.help", SceneLayer::Help);
  layer("layer.grid", SceneLayer::Grid);
}

}  // namespace glissade
