#include "widgets/scene3d/scene_view.h"

#include <osg/BlendFunc>
#include <osg/ColorMask>
#include <osg/LightModel>

#include "widgets/scene3d/detail_control.h"
#include "widgets/scene3d/merged_bodies.h"
#include "widgets/scene3d/scene_view_impl.h"

namespace glissade {
namespace {

/// Largest error in pixels of a picture of a resting camera.
constexpr double kQuickTolerance = 1.0;

Colour sRgbOf(const osg::Vec4& colour) { return {colour.r(), colour.g(), colour.b()}; }

}  // namespace

SceneView::SceneView() : impl_(std::make_unique<Impl>()) {
  osg::StateSet* state = impl_->root->getOrCreateStateSet();
  osg::ref_ptr<osg::LightModel> lightModel = new osg::LightModel;
  lightModel->setTwoSided(true);
  state->setAttributeAndModes(lightModel);
  state->setAttributeAndModes(new osg::BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA));
  // Alpha is not written, because blending would leave it below one and the picture whitish.
  state->setAttribute(new osg::ColorMask(true, true, true, false));
  state->setMode(GL_NORMALIZE, osg::StateAttribute::ON);
  state->setMode(GL_LINE_SMOOTH, osg::StateAttribute::ON);
  impl_->root->addChild(impl_->backdrop);
  for (auto& layer : impl_->layers) layer = new osg::Group;
  impl_->layers[static_cast<std::size_t>(SceneLayer::Bodies)] = new MergedBodies;
  for (int id = 0; id < kSceneLayerCount; ++id) {
    const auto which = static_cast<SceneLayer>(id);
    if (which == SceneLayer::StartAndGoal) impl_->root->addChild(impl_->motionLayers);
    const bool isMotion =
        (which >= SceneLayer::StartAndGoal && which <= SceneLayer::Guidance) || which == SceneLayer::Help;
    osg::Group& parent = isMotion ? *impl_->motionLayers : *impl_->root;
    parent.addChild(&impl_->layer(which));
  }
  impl_->root->addChild(impl_->sectionClip.node());
  impl_->root->addChild(impl_->caps.node());
  impl_->root->addChild(impl_->depthShading.node());
  impl_->layer(SceneLayer::Roadmap).addChild(impl_->roadmap.node());
  for (const SceneLayer id :
       {SceneLayer::FreeCells, SceneLayer::MobileCells, SceneLayer::StaticCells, SceneLayer::Places,
        SceneLayer::Borders, SceneLayer::Graph, SceneLayer::Region, SceneLayer::Grid}) {
    impl_->layer(id).setNodeMask(0U);
  }
  impl_->camera.setStandardView(StandardView::Isometric);
  impl_->rebuild();
}

SceneView::~SceneView() = default;

void SceneView::setScenario(std::shared_ptr<const LoadedScenario> scenario) {
  const std::lock_guard lock(*impl_->graphMutex);
  impl_->environment = {};
  impl_->hidden.clear();
  impl_->ownModes.clear();
  impl_->sections.clear();
  impl_->keptPaths.clear();
  rearrange(std::move(scenario));
  impl_->camera.setStandardView(StandardView::Isometric);
  fit();
}

void SceneView::rearrange(std::shared_ptr<const LoadedScenario> scenario) {
  const std::lock_guard lock(*impl_->graphMutex);
  const std::size_t before = impl_->scenario ? impl_->scenario->obstacles.size() : 0;
  impl_->scenario = std::move(scenario);
  impl_->shapes.dropUnused();
  impl_->snapshot.reset();
  impl_->playback.reset();
  impl_->drawnPlan.reset();
  impl_->shownStep.reset();
  impl_->difficulty.reset();
  impl_->help = {};
  impl_->helpLead.reset();
  impl_->obstacleBoxes.clear();
  impl_->beforeHand.clear();
  impl_->refusal.reset();
  impl_->measure = {};
  impl_->reach = {};
  impl_->inHand.clear();
  impl_->sequence = {};
  impl_->motionLayers->setNodeMask(~0U);
  impl_->roadmap.clear();
  impl_->rebuild();
  if (!impl_->scenario) return;
  if (impl_->camera.isFitted() && impl_->scenario->obstacles.size() > before) fit();
  impl_->camera.enclose(impl_->extent());
}

void SceneView::placeObstacle(std::size_t obstacle, const Pose& X_WB) {
  const std::lock_guard lock(*impl_->graphMutex);
  impl_->place(SceneLayer::Bodies, obstacle, X_WB);
  if (!impl_->inHand.insert(obstacle).second) return;
  impl_->showSelection();
  impl_->showSections();
}

void SceneView::restoreObstacles() {
  const std::lock_guard lock(*impl_->graphMutex);
  for (const std::size_t obstacle : impl_->inHand) {
    impl_->place(SceneLayer::Bodies, obstacle, impl_->poseOf(obstacle));
  }
  impl_->inHand.clear();
  impl_->showHidden();
}

void SceneView::placeStart(const Pose& X_WB) {
  const std::lock_guard lock(*impl_->graphMutex);
  impl_->place(SceneLayer::StartAndGoal, 0, X_WB);
}

void SceneView::placeGoal(const Pose& X_WB) {
  const std::lock_guard lock(*impl_->graphMutex);
  impl_->place(SceneLayer::StartAndGoal, 1, X_WB);
}

void SceneView::fit() {
  impl_->camera.fit(impl_->extent());
  if (impl_->scenario) impl_->camera.enclose(impl_->scenario->scenario.workspace);
  if (impl_->grid) impl_->camera.enclose(Impl::boxOf(*impl_->grid));
}

void SceneView::setSnapshot(SnapshotPtr snapshot) {
  const std::lock_guard lock(*impl_->graphMutex);
  impl_->snapshot = std::move(snapshot);
  impl_->showSnapshot();
}

void SceneView::setEnvironment(const EnvironmentPicture& picture) {
  const std::lock_guard lock(*impl_->graphMutex);
  const EnvironmentPicture& drawn = impl_->environment;
  const bool onlySelection = picture.knowledge == drawn.knowledge && picture.placeColours == drawn.placeColours &&
                             picture.finestCellLevel == drawn.finestCellLevel;
  impl_->environment = picture;
  if (onlySelection) {
    impl_->showSelection();
  } else {
    impl_->showEnvironment();
  }
}

void SceneView::setHiddenBodies(const std::set<BodyId>& bodyIds) {
  const std::lock_guard lock(*impl_->graphMutex);
  impl_->hidden = bodyIds;
  impl_->showHidden();
}

const std::set<BodyId>& SceneView::hiddenBodies() const { return impl_->hidden; }

void SceneView::setDisplayMode(DisplayMode mode) {
  const std::lock_guard lock(*impl_->graphMutex);
  if (mode == impl_->mode) return;
  impl_->mode = mode;
  impl_->showModes();
}

DisplayMode SceneView::displayMode() const { return impl_->mode; }

void SceneView::setDepthShading(bool shaded) {
  const std::lock_guard lock(*impl_->graphMutex);
  impl_->depthShadingWanted = shaded;
  impl_->showDepthShading();
}

bool SceneView::depthShading() const { return impl_->depthShadingWanted; }

void SceneView::beginPicture(int width, int height, const PictureDetail& detail) {
  const std::lock_guard lock(*impl_->graphMutex);
  impl_->quick = detail.tolerance > kQuickTolerance;
  // Smooth lines are off in pictures with one sample for each pixel, because they would take longer than the bodies.
  impl_->root->getStateSet()->setMode(GL_LINE_SMOOTH,
                                      detail.smooth ? osg::StateAttribute::ON : osg::StateAttribute::OFF);
  impl_->showDepthShading();
  const CameraController& camera = impl_->camera;
  impl_->roadmap.setScale(height / camera.viewHeight());
  if (camera.viewHeight() != impl_->markedViewHeight) impl_->showMarks();
  const double across = camera.isOrthographic() ? camera.viewHeight()
                                                : camera.viewHeight() / (camera.distance() * camera.magnification());
  impl_->depthShading.prepare(width, height, camera.nearPlane(), camera.farPlane(), camera.isOrthographic(),
                              height / across, pixelScale());
}

void SceneView::setBodyDisplayModes(const std::map<BodyId, DisplayMode>& modes) {
  const std::lock_guard lock(*impl_->graphMutex);
  impl_->ownModes = modes;
  impl_->showModes();
}

const std::map<BodyId, DisplayMode>& SceneView::bodyDisplayModes() const { return impl_->ownModes; }

void SceneView::setSections(const std::vector<Plane>& sections) {
  const std::lock_guard lock(*impl_->graphMutex);
  impl_->sections = sections;
  impl_->showSections();
}

void SceneView::onCapsLeft(std::function<void()> callback) { impl_->capsLeft = std::move(callback); }

std::function<std::function<void()>(const WorkWatch&)> SceneView::capsWork() {
  auto work = impl_->caps.work();
  if (!work) return nullptr;
  return [work = std::move(work), mutex = impl_->graphMutex](const WorkWatch& watch) -> std::function<void()> {
    return [finish = work(watch), mutex] {
      const std::lock_guard lock(*mutex);
      finish();
    };
  };
}

const std::vector<Plane>& SceneView::sections() const { return impl_->sections; }

Box3 SceneView::extent() const { return impl_->extent(); }

void SceneView::setCoarsePlan(const CoarsePlanPtr& plan) {
  const std::lock_guard lock(*impl_->graphMutex);
  if (plan == impl_->drawnPlan) return;
  impl_->drawnPlan = plan;
  if (impl_->scenario) impl_->showPlan();
}

void SceneView::setShownStep(const std::optional<std::size_t>& step) {
  const std::lock_guard lock(*impl_->graphMutex);
  impl_->shownStep = step;
  if (impl_->scenario) impl_->showPlan();
}

void SceneView::setDifficulty(std::shared_ptr<const Difficulty> difficulty) {
  const std::lock_guard lock(*impl_->graphMutex);
  impl_->difficulty = std::move(difficulty);
  impl_->showDifficulty();
}

void SceneView::setHelp(HelpPicture help) {
  const std::lock_guard lock(*impl_->graphMutex);
  impl_->help = std::move(help);
  impl_->showHelp();
  impl_->showMarks();
}

void SceneView::setHelpLead(const std::optional<Pose>& to) {
  if (to == impl_->helpLead) return;
  const std::lock_guard lock(*impl_->graphMutex);
  impl_->helpLead = to;
  if (!impl_->scenario || !impl_->snapshot) return;
  impl_->showMarks();
  impl_->showBeforeHand();
}

void SceneView::setRefusal(std::shared_ptr<const EndConflicts> conflicts) {
  const std::lock_guard lock(*impl_->graphMutex);
  impl_->refusal = std::move(conflicts);
  impl_->showRefusal();
}

void SceneView::setKeptPaths(std::vector<KeptPathPicture> paths) {
  const std::lock_guard lock(*impl_->graphMutex);
  impl_->keptPaths = std::move(paths);
  impl_->showOverlays();
}

void SceneView::setSweep(std::shared_ptr<const SweptVolume> sweep) {
  const std::lock_guard lock(*impl_->graphMutex);
  impl_->sweep = std::move(sweep);
  impl_->showOverlays();
}

void SceneView::setReach(ReachPicture reach) {
  const std::lock_guard lock(*impl_->graphMutex);
  impl_->reach = std::move(reach);
  impl_->showReach();
}

void SceneView::setMeasure(MeasurePicture measure) {
  const std::lock_guard lock(*impl_->graphMutex);
  impl_->measure = std::move(measure);
  impl_->showOverlays();
}

Box3 SceneView::extentOf(const std::set<BodyId>& bodyIds) const {
  Box3 box;
  if (!impl_->scenario) return box;
  for (const RigidBody& body : impl_->scenario->obstacles) {
    if (bodyIds.count(body.id) != 0) box.extend(boundingBox(*body.mesh, body.X_WB));
  }
  const LoadedScenario& scenario = *impl_->scenario;
  const Pose moved = objectPose() * inverse(scenario.object.X_WB);
  for (const RigidBody& body : scenario.objectBodies) {
    if (bodyIds.count(body.id) != 0) box.extend(boundingBox(*body.mesh, moved * body.X_WB));
  }
  return box;
}

std::vector<RigidBody> SceneView::drawnObstacles() const {
  std::vector<RigidBody> bodies;
  if (!impl_->scenario) return bodies;
  const auto add = [&bodies](const RigidBody& body, const Pose& X_WB) {
    bodies.push_back(body);
    bodies.back().X_WB = X_WB;
  };
  const std::vector<RigidBody>& obstacles = impl_->scenario->obstacles;
  for (std::size_t i = 0; layerVisible(SceneLayer::Bodies) && i < obstacles.size(); ++i) {
    if (impl_->isDrawn(i)) add(obstacles[i], impl_->poseOf(i));
  }
  if (!showsSequence() || !layerVisible(SceneLayer::Object)) return bodies;
  for (std::size_t i = 0; i < impl_->scenario->objectBodies.size(); ++i) {
    const SequenceBody& shown = impl_->sequence.bodies[obstacles.size() + i];
    if (shown.shown) add(impl_->scenario->objectBodies[i], shown.X_WB);
  }
  return bodies;
}

Pose SceneView::objectPose() const {
  if (impl_->playback) return *impl_->playback;
  if (impl_->snapshot) return impl_->snapshot->device.q_device;
  return impl_->scenario ? impl_->scenario->object.X_WB : Pose::identity();
}

void SceneView::setRoadmapKept(bool kept) {
  const std::lock_guard lock(*impl_->graphMutex);
  impl_->roadmapKept = kept;
  impl_->showSnapshot();
}

void SceneView::setPathProfile(std::shared_ptr<const ClearanceProfile> profile) {
  const std::lock_guard lock(*impl_->graphMutex);
  impl_->pathProfile = std::move(profile);
  impl_->drawnPath.reset();
  impl_->showSnapshot();
}

void SceneView::setGhosts(const PathSpacing& spacing) {
  const std::lock_guard lock(*impl_->graphMutex);
  if (spacing == impl_->ghosts) return;
  impl_->ghosts = spacing;
  impl_->drawnPath.reset();
  impl_->showSnapshot();
}

void SceneView::setGridUnit(double metres) {
  const std::lock_guard lock(*impl_->graphMutex);
  impl_->gridUnit = metres;
  impl_->showGrid();
}

std::optional<double> SceneView::gridSpacing() const {
  return impl_->grid ? std::make_optional(impl_->grid->spacing) : std::nullopt;
}

void SceneView::setPathByAuthor(bool byAuthor) {
  const std::lock_guard lock(*impl_->graphMutex);
  impl_->pathByAuthor = byAuthor;
  impl_->drawnPath.reset();
  impl_->showSnapshot();
}

void SceneView::setPlaybackPose(const std::optional<Pose>& X_WB) {
  const std::lock_guard lock(*impl_->graphMutex);
  impl_->playback = X_WB;
  impl_->placeObject();
  impl_->showMarks();
}

void SceneView::setSequence(const SequencePicture& picture) {
  const std::lock_guard lock(*impl_->graphMutex);
  const bool entersOrLeaves = impl_->sequence.bodies.empty() != picture.bodies.empty();
  impl_->sequence = picture;
  impl_->showSequence();
  if (entersOrLeaves && impl_->scenario && impl_->camera.isFitted()) fit();
}

bool SceneView::showsSequence() const { return !impl_->sequence.bodies.empty(); }

void SceneView::setTheme(Theme theme) {
  const std::lock_guard lock(*impl_->graphMutex);
  impl_->theme = theme;
  impl_->makePalette();
}

void SceneView::setColours(const SceneColours& colours) {
  const std::lock_guard lock(*impl_->graphMutex);
  if (colours == impl_->colours) return;
  impl_->colours = colours;
  impl_->makePalette();
}

void SceneView::setPixelScale(double scale) {
  const std::lock_guard lock(*impl_->graphMutex);
  if (static_cast<float>(scale) == impl_->palette.pixelScale) return;
  impl_->palette.pixelScale = static_cast<float>(scale);
  impl_->roadmap.setPalette(impl_->palette);
  impl_->rebuild();
}

double SceneView::pixelScale() const { return impl_->palette.pixelScale; }

void SceneView::setLayerVisible(SceneLayer layer, bool visible) {
  const std::lock_guard lock(*impl_->graphMutex);
  if (visible == layerVisible(layer)) return;
  impl_->layer(layer).setNodeMask(visible ? ~0U : 0U);
  if (layer == SceneLayer::Bodies) impl_->showSections();
  if (layer == SceneLayer::Grid) {
    impl_->showGrid();
  } else if (layer >= SceneLayer::Graph) {
    if (impl_->scenario) impl_->showPlan();
  } else if (layer >= SceneLayer::FreeCells) {
    impl_->showEnvironment();
  } else if (layer == SceneLayer::Guidance) {
    impl_->showGuidance();
  }
}

bool SceneView::layerVisible(SceneLayer layer) const { return impl_->layer(layer).getNodeMask() != 0U; }

CameraController& SceneView::camera() { return impl_->camera; }
const CameraController& SceneView::camera() const { return impl_->camera; }
osg::Group* SceneView::root() const { return impl_->root; }
std::shared_ptr<GraphMutex> SceneView::graphMutex() const { return impl_->graphMutex; }

bool SceneView::hasDarkBackground() const { return isDark(impl_->palette.backgroundTop); }

Colour SceneView::background() const { return sRgbOf(impl_->palette.backgroundTop); }

Colour SceneView::backgroundBelow() const { return sRgbOf(impl_->palette.backgroundBottom); }

}  // namespace glissade
