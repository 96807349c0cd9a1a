#pragma once

#include <osg/Group>
#include <osg/MatrixTransform>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "engine/geometry/segment_box.h"
#include "engine/planning/path_spacing.h"
#include "widgets/scene3d/backdrop.h"
#include "widgets/scene3d/body_layer.h"
#include "widgets/scene3d/camera_controller.h"
#include "widgets/scene3d/cone_layer.h"
#include "widgets/scene3d/contact_layer.h"
#include "widgets/scene3d/depth_shading.h"
#include "widgets/scene3d/difficulty_layer.h"
#include "widgets/scene3d/environment_layers.h"
#include "widgets/scene3d/geometry_builder.h"
#include "widgets/scene3d/grid_layer.h"
#include "widgets/scene3d/guidance_layer.h"
#include "widgets/scene3d/help_layer.h"
#include "widgets/scene3d/kept_paths_layer.h"
#include "widgets/scene3d/measure_layer.h"
#include "widgets/scene3d/osg_convert.h"
#include "widgets/scene3d/path_layer.h"
#include "widgets/scene3d/reach_layer.h"
#include "widgets/scene3d/refusal_layer.h"
#include "widgets/scene3d/roadmap_layer.h"
#include "widgets/scene3d/scene_view.h"
#include "widgets/scene3d/section_caps.h"
#include "widgets/scene3d/section_layer.h"
#include "widgets/scene3d/sweep_layer.h"

namespace glissade {

/// Slack of SectionClip as a share of the scene's size, larger than the error of single precision.
inline constexpr double kSectionSlack = 1e-5;

/// Radius of a path in a headset, in radii of the object.
inline constexpr double kPathTubeRadii = 0.06;

/// State and drawing of a SceneView. Private to scene_view.cpp and scene_labels.cpp.
struct SceneView::Impl {
  std::shared_ptr<GraphMutex> graphMutex = std::make_shared<GraphMutex>();
  osg::ref_ptr<osg::Group> root = new osg::Group;
  osg::ref_ptr<osg::Group> backdrop = new osg::Group;
  std::array<osg::ref_ptr<osg::Group>, kSceneLayerCount> layers;
  osg::ref_ptr<osg::MatrixTransform> object;
  osg::ref_ptr<osg::MatrixTransform> hand;  ///< the object at the hand's pose
  RoadmapLayer roadmap;
  bool roadmapKept = false;
  CameraController camera;
  Theme theme = Theme::Light;
  SceneColours colours;
  ScenePalette palette = paletteOf(Theme::Light);
  std::shared_ptr<const LoadedScenario> scenario;
  SnapshotPtr snapshot;
  std::shared_ptr<const Path> drawnPath;
  std::shared_ptr<const PathExamination> drawnRefusal;
  bool pathByAuthor = false;
  PathSpacing ghosts;
  std::shared_ptr<const ClearanceProfile> pathProfile;
  std::optional<Pose> playback;
  double markedViewHeight = 0.0;  ///< view height for which the operator's marks were made
  EnvironmentPicture environment;
  CoarsePlanPtr drawnPlan;
  std::optional<std::size_t> shownStep;
  std::shared_ptr<const Difficulty> difficulty;
  HelpPicture help;
  osg::ref_ptr<osg::Group> helpArrow = new osg::Group;  ///< in the layer of help
  std::optional<Pose> helpLead;                         ///< pose to which the hand is led; nothing: no arrow
  std::vector<Box3> obstacleBoxes;                      ///< while the hand is led, in the order of the obstacles
  std::set<BodyId> beforeHand;                          ///< obstacles that hide where the hand is led, by id
  std::shared_ptr<const EndConflicts> refusal;
  std::vector<KeptPathPicture> keptPaths;
  MeasurePicture measure;
  std::shared_ptr<const SweptVolume> sweep;
  ReachPicture reach;
  BodyShapes shapes;
  DisplayMode mode = DisplayMode::ShadedWithEdges;
  std::vector<DisplayMode> drawnModes;     ///< drawn modes of the obstacles
  std::map<BodyId, DisplayMode> ownModes;  ///< set modes of obstacles
  DepthShading depthShading;
  bool depthShadingWanted = true;
  bool quick = false;  ///< the camera moves in the next picture
  SectionClip sectionClip;
  SectionCaps caps;
  std::function<void()> capsLeft;
  std::vector<Plane> sections;
  double gridUnit = 1.0;
  std::optional<GroundGrid> grid;  ///< nothing: it is not drawn
  std::set<BodyId> hidden;         ///< obstacles
  std::set<std::size_t> inHand;    ///< obstacles that are dragged
  SequencePicture sequence;
  osg::ref_ptr<osg::Group> plainObjects = new osg::Group;  ///< the object as bodies of the product, cut by sections
  osg::ref_ptr<osg::Group> motionLayers = new osg::Group;  ///< layers about the motion of the object

  osg::Group& layer(SceneLayer id) { return *layers[static_cast<std::size_t>(id)]; }

  void fill(SceneLayer id, const osg::ref_ptr<osg::Group>& content) {
    layer(id).removeChildren(0, layer(id).getNumChildren());
    if (content) layer(id).addChild(content);
  }

  bool visible(SceneLayer id) const { return layers[static_cast<std::size_t>(id)]->getNodeMask() != 0U; }

  /// Shows the visible layers. Hidden layers stay empty, because some take time to make.
  void showEnvironment() {
    const auto show = [&](SceneLayer id, const std::function<osg::ref_ptr<osg::Group>()>& make) {
      fill(id, environment.knowledge && visible(id) ? make() : nullptr);
    };
    const auto cells = [&](CellKind kind) {
      return makeCells(*environment.knowledge->environment->octree, kind, environment.finestCellLevel, palette);
    };
    show(SceneLayer::FreeCells, [&] { return cells(CellKind::Free); });
    show(SceneLayer::MobileCells, [&] { return cells(CellKind::Mobile); });
    show(SceneLayer::StaticCells, [&] { return cells(CellKind::Static); });
    show(SceneLayer::Places, [&] { return makePlaces(environment, palette); });
    show(SceneLayer::Borders, [&] { return makeBorders(environment.knowledge->environment->map, palette); });
    showModes();
    showSelection();
  }

  void showSelection() {
    fill(SceneLayer::Selection, environment.knowledge ? makeSelection(environment, palette) : nullptr);
    if (!scenario) return;
    for (std::size_t i = 0; i < scenario->obstacles.size(); ++i) {
      const RigidBody& body = scenario->obstacles[i];
      if (!isMarked(i) && !isSelected(body.id)) continue;
      if (!isDrawn(i) || inHand.count(i) != 0) continue;
      const osg::Vec4& colour = isMarked(i) ? palette.stepPart : palette.selection;
      layer(SceneLayer::Selection).addChild(makeHighlight(shapes.of(body.mesh), poseOf(i), colour, palette));
    }
    if (!sequence.forbidden.empty()) {
      layer(SceneLayer::Selection).addChild(makeForbiddenCones(sequence.forbidden, palette));
    }
    if (sequence.bodies.empty()) return;
    for (std::size_t i = 0; i < scenario->objectBodies.size(); ++i) {
      const bool isOfStep = isMarked(scenario->obstacles.size() + i);
      if (!isOfStep && !isSelected(scenario->objectBodies[i].id)) continue;
      const BodyShape& shape = shapes.of(scenario->objectBodies[i].mesh);
      const osg::Vec4& colour = isOfStep ? palette.stepPart : palette.selection;
      layer(SceneLayer::Selection).addChild(makeHighlight(shape, inSequence(i).X_WB, colour, palette));
    }
    if (sequence.way.size() > 1) layer(SceneLayer::Selection).addChild(makeWay());
  }

  bool isSelected(const BodyId& body) const { return environment.selectedBodies.count(body) != 0; }

  /// Whether a body is drawn in the colour of the selection.
  bool showsSelected() const {
    for (std::size_t i = 0; i < scenario->obstacles.size(); ++i) {
      if (isSelected(scenario->obstacles[i].id) && !isMarked(i) && isDrawn(i)) return true;
    }
    for (std::size_t i = 0; !sequence.bodies.empty() && i < scenario->objectBodies.size(); ++i) {
      if (isSelected(scenario->objectBodies[i].id) && !isMarked(scenario->obstacles.size() + i)) return true;
    }
    return false;
  }

  /// A body of the object as the plan has it.
  const SequenceBody& inSequence(std::size_t objectBody) const {
    return sequence.bodies[scenario->obstacles.size() + objectBody];
  }

  /// `body`: index of an obstacle, or of one of the object's bodies, which follow the obstacles.
  bool isMarked(std::size_t body) const { return body < sequence.bodies.size() && sequence.bodies[body].marked; }

  bool isDrawn(std::size_t obstacle) const {
    const bool left = obstacle < sequence.bodies.size() && !sequence.bodies[obstacle].shown;
    return !left && hidden.count(scenario->obstacles[obstacle].id) == 0;
  }

  const Pose& poseOf(std::size_t obstacle) const {
    return obstacle < sequence.bodies.size() ? sequence.bodies[obstacle].X_WB : scenario->obstacles[obstacle].X_WB;
  }

  osg::ref_ptr<osg::Geode> makeWay() const {
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    addLinesSeenThrough(sequence.way, LineKind::Strip, palette.stepWay, 2.5F * palette.pixelScale, *geode);
    makeUnlit(*geode);
    makeTransparent(*geode);
    return geode;
  }

  /// Places bodies as the plan has them, or as the scenario has them without a plan.
  void showSequence() {
    motionLayers->setNodeMask(sequence.bodies.empty() ? ~0U : 0U);
    if (!scenario) return;
    for (std::size_t i = 0; i < scenario->obstacles.size(); ++i) place(SceneLayer::Bodies, i, poseOf(i));
    if (!sequence.bodies.empty()) camera.enclose(extent());
    if (grid) camera.enclose(boxOf(*grid));
    showHidden();
    placeObject();
  }

  /// Precondition: the children of the layer are the bodies in their order.
  void place(SceneLayer id, std::size_t child, const Pose& X_WB) {
    auto* body = static_cast<osg::MatrixTransform*>(layer(id).getChild(static_cast<unsigned>(child)));
    body->setMatrix(toOsg(X_WB));
  }

  void showPlan() {
    const CoarsePlan* plan = drawnPlan.get();
    const auto show = [&](SceneLayer id, const std::function<osg::ref_ptr<osg::Group>()>& make) {
      fill(id, plan != nullptr && visible(id) ? make() : nullptr);
    };
    show(SceneLayer::Graph, [&] { return plan->graph ? makeGraph(*plan->graph, palette) : nullptr; });
    show(SceneLayer::CoarsePath, [&] { return plan->graph ? makeCoarsePath(*plan, palette) : nullptr; });
    show(SceneLayer::Milestones, [&] { return makeMilestones(*plan, shapes.of(scenario->object.mesh), palette); });
    show(SceneLayer::Region, [&]() -> osg::ref_ptr<osg::Group> {
      const TopologicalStep* step = stepShown(*plan);
      return step != nullptr && step->region ? makeRegion(*step->region, palette) : nullptr;
    });
  }

  void showDifficulty() {
    fill(SceneLayer::Difficulty, difficulty ? makeDifficulty(*difficulty, *scenario, shapes, palette) : nullptr);
  }

  void showHelp() {
    fill(SceneLayer::Help, help.places && scenario ? makeHelp(help, *scenario, shapes, palette) : nullptr);
    layer(SceneLayer::Help).addChild(helpArrow);
  }

  /// Shows where the hand is led while it is shown.
  void showHelpArrow(bool shown) {
    helpArrow->removeChildren(0, helpArrow->getNumChildren());
    if (!helpLead || !shown) return;
    helpArrow->addChild(makeGuideArrow(snapshot->device.q_device, *helpLead, markScale(), palette));
  }

  /// Draws the obstacles see-through whose boxes are between the eye and the hand, or where it is led.
  void showBeforeHand() {
    std::set<BodyId> before;
    const auto meets = [](const Box3& box, const Vector3& from, const Vector3& to) {
      return segmentMeets(box, from, to - from);
    };
    const std::vector<RigidBody>& obstacles = scenario->obstacles;
    if (!helpLead) obstacleBoxes.clear();
    if (helpLead && obstacleBoxes.empty()) {
      for (const RigidBody& body : obstacles) obstacleBoxes.push_back(boundingBox(*body.mesh, body.X_WB));
    }
    for (std::size_t i = 0; i < obstacleBoxes.size(); ++i) {
      const Vector3& hand = snapshot->device.q_device.position;
      const Vector3& lead = helpLead->position;
      const Box3& box = obstacleBoxes[i];
      const bool isBefore = meets(box, camera.eye(), hand) || meets(box, camera.eye(), lead) || meets(box, hand, lead);
      if (isBefore) before.insert(obstacles[i].id);
    }
    if (before == beforeHand) return;
    beforeHand = std::move(before);
    showModes();
  }

  const TopologicalStep* stepShown(const CoarsePlan& plan) const {
    if (shownStep) return *shownStep < plan.steps.size() ? &plan.steps[*shownStep] : nullptr;
    for (const TopologicalStep& step : plan.steps) {
      if (step.result == StepResult::Running) return &step;
    }
    return nullptr;
  }

  DisplayMode modeOf(const RigidBody& body) const {
    const auto own = ownModes.find(body.id);
    if (own != ownModes.end()) return own->second;
    const bool isSeenThrough = showsSpace() || beforeHand.count(body.id) != 0;
    return mode != DisplayMode::Wireframe && isSeenThrough ? DisplayMode::SeeThrough : mode;
  }

  /// Whether places or cells are shown. They lie behind obstacles and in their holes, so that opaque obstacles would
  /// hide them.
  bool showsSpace() const {
    constexpr std::array kSpace{SceneLayer::FreeCells, SceneLayer::MobileCells, SceneLayer::StaticCells,
                                SceneLayer::Places, SceneLayer::Borders};
    return environment.knowledge &&
           std::any_of(kSpace.begin(), kSpace.end(), [this](SceneLayer id) { return visible(id); });
  }

  /// Draws obstacles again whose display mode has changed.
  void showModes() {
    if (!scenario) return;
    osg::Group& bodies = layer(SceneLayer::Bodies);
    for (std::size_t i = 0; i < drawnModes.size(); ++i) {
      const DisplayMode wanted = modeOf(scenario->obstacles[i]);
      if (wanted == drawnModes[i]) continue;
      osg::ref_ptr<osg::MatrixTransform> drawn = drawBody(i);
      auto* before = static_cast<osg::MatrixTransform*>(bodies.getChild(static_cast<unsigned>(i)));
      drawn->setMatrix(before->getMatrix());  // it may be dragged
      drawn->setNodeMask(before->getNodeMask());
      bodies.setChild(static_cast<unsigned>(i), drawn);
      drawnModes[i] = wanted;
    }
    showDepthShading();
  }

  /// Depth shading is off in wireframes: their surfaces are invisible, but they are in the depth buffer.
  void showDepthShading() {
    const bool wires = std::count(drawnModes.begin(), drawnModes.end(), DisplayMode::Wireframe) > 0;
    depthShading.setEnabled(depthShadingWanted && !quick && mode != DisplayMode::Wireframe && !wires);
  }

  osg::ref_ptr<osg::MatrixTransform> drawBody(std::size_t obstacle) {
    const RigidBody& body = scenario->obstacles[obstacle];
    return makeBody(shapes.of(body.mesh), body.X_WB, toOsg(body.colour), modeOf(body), palette);
  }

  void showBodies() {
    osg::Group& bodies = layer(SceneLayer::Bodies);
    bodies.removeChildren(0, bodies.getNumChildren());
    drawnModes.clear();
    for (std::size_t i = 0; i < scenario->obstacles.size(); ++i) {
      bodies.addChild(drawBody(i));
      drawnModes.push_back(modeOf(scenario->obstacles[i]));
      place(SceneLayer::Bodies, i, poseOf(i));
    }
    showDepthShading();
    showHidden();
  }

  void showSections() {
    const double slack = kSectionSlack * std::max(0.0F, layer(SceneLayer::Bodies).getBound().radius());
    sectionClip.setSections(sections, {&layer(SceneLayer::Bodies), &layer(SceneLayer::Selection), plainObjects}, slack);
    const bool shown = scenario && visible(SceneLayer::Bodies);
    caps.show(shown ? sections : std::vector<Plane>(), shown ? capBodies() : std::vector<CapBody>(), palette);
    if (capsLeft && caps.hasLeft()) capsLeft();
  }

  /// The obstacles in their order; while a plan is shown, the object's bodies follow them. A body that is dragged has
  /// no caps.
  std::vector<CapBody> capBodies() const {
    std::vector<CapBody> bodies;
    for (std::size_t i = 0; i < scenario->obstacles.size(); ++i) {
      const RigidBody& body = scenario->obstacles[i];
      bodies.push_back({body.mesh, poseOf(i), toOsg(body.colour), isDrawn(i) && inHand.count(i) == 0});
    }
    for (std::size_t i = 0; !sequence.bodies.empty() && i < scenario->objectBodies.size(); ++i) {
      const RigidBody& body = scenario->objectBodies[i];
      bodies.push_back({body.mesh, inSequence(i).X_WB, toOsg(body.colour), inSequence(i).shown});
    }
    return bodies;
  }

  /// Shows or hides the layer's children, which are the obstacles in their order.
  void showHidden() {
    for (std::size_t i = 0; scenario && i < scenario->obstacles.size(); ++i) {
      layer(SceneLayer::Bodies).getChild(static_cast<unsigned>(i))->setNodeMask(isDrawn(i) ? ~0U : 0U);
    }
    showSelection();
    showSections();
  }

  /// Shows the grid under the arranged product.
  void showGrid() {
    grid.reset();
    Box3 box;
    if (scenario && visible(SceneLayer::Grid)) {
      for (const RigidBody& body : scenario->obstacles) box.extend(boundingBox(*body.mesh, body.X_WB));
      box.extend(boundingBox(*scenario->object.mesh, scenario->problem.start));
      grid = groundGridUnder(box, gridUnit);
    }
    fill(SceneLayer::Grid, grid ? makeGrid(*grid, palette) : nullptr);
    if (grid) camera.enclose(boxOf(*grid));
  }

  static Box3 boxOf(const GroundGrid& grid) {
    const Vector3 reach(grid.reach, grid.reach, 0.0);
    return {grid.centre - reach, grid.centre + reach};
  }

  void showRefusal() {
    const bool shown = refusal && scenario;
    fill(SceneLayer::Refusal, shown ? makeRefusal(*refusal, *scenario, shapes, palette) : nullptr);
  }

  void showOverlays() {
    fill(SceneLayer::KeptPaths, makeKeptPaths(keptPaths, palette));
    fill(SceneLayer::Measure, makeMeasure(measure, palette));
    fill(SceneLayer::Sweep, sweep ? makeSweep(sweep->surface_W, palette) : nullptr);
    showReach();
  }

  void showReach() {
    fill(SceneLayer::Reach, makeReach(reach, shapes, palette));
    if (!reach.parts.empty()) camera.enclose(extent());
  }

  void makePalette() {
    const float scale = palette.pixelScale;
    palette = paletteOf(theme);
    applyColours(colours, palette);
    palette.pixelScale = scale;
    roadmap.setPalette(palette);
    rebuild();
  }

  void rebuild() {
    backdrop->removeChildren(0, backdrop->getNumChildren());
    backdrop->addChild(makeBackdrop(palette));
    for (const SceneLayer id : {SceneLayer::Bodies, SceneLayer::Object, SceneLayer::StartAndGoal, SceneLayer::Workspace,
                                SceneLayer::Path, SceneLayer::Contact, SceneLayer::Guidance}) {
      layer(id).removeChildren(0, layer(id).getNumChildren());
    }
    object = hand = nullptr;
    plainObjects->removeChildren(0, plainObjects->getNumChildren());
    caps.forget();
    drawnPath.reset();
    drawnRefusal.reset();
    drawnModes.clear();
    showEnvironment();
    showGrid();
    showDifficulty();
    showHelp();
    showRefusal();
    showOverlays();
    if (!scenario) return;
    showPlan();
    showBodies();
    const RigidBody& moved = scenario->object;
    object = makeMovedBody(shapes.of(moved.mesh), moved.X_WB, toOsg(moved.colour), palette);
    layer(SceneLayer::Object).addChild(object);
    hand = makeGhost(shapes.of(moved.mesh), moved.X_WB, palette.lines, palette);
    hand->setNodeMask(0U);
    layer(SceneLayer::Object).addChild(hand);
    for (const RigidBody& body : scenario->objectBodies) {
      plainObjects->addChild(makeBody(shapes.of(body.mesh), body.X_WB, toOsg(body.colour), modeOf(body), palette));
    }
    layer(SceneLayer::Object).addChild(plainObjects);
    placeObject();
    osg::Group& ends = layer(SceneLayer::StartAndGoal);
    ends.addChild(makeGhost(shapes.of(moved.mesh), scenario->problem.start, palette.start, palette));
    if (const Pose* goal = std::get_if<Pose>(&scenario->problem.goal)) {
      ends.addChild(makeSeenGhost(shapes.of(moved.mesh), *goal, palette.goal, palette));
    }
    layer(SceneLayer::Workspace)
        .addChild(makeLines(boxEdges(scenario->scenario.workspace), LineKind::Segments,
                            osg::Vec4(palette.lines.r(), palette.lines.g(), palette.lines.b(), 0.35F),
                            palette.pixelScale));
    showSnapshot();
  }

  void showSnapshot() {
    if (!snapshot || !scenario) return;
    roadmap.update(*snapshot);
    roadmap.setFaded(snapshot->path && !roadmapKept);
    showPath();
    placeObject();
    showMarks();
  }

  MarkScale markScale() const { return {scenario->problem.world->objectRadius(), camera.viewHeight()}; }

  /// Shows the marks about the operator, whose size depends on the view.
  void showMarks() {
    if (!object || !snapshot) return;
    markedViewHeight = camera.viewHeight();
    const bool shown = !playback && !snapshot->path;
    fill(SceneLayer::Contact, shown ? makeContact(*snapshot, markScale(), palette) : nullptr);
    showHelpArrow(shown);
    showHand(shown);
    showGuidance();
  }

  /// Shows the object at the hand's pose besides its own pose, where obstacles keep it.
  void showHand(bool shown) {
    const std::optional<Pose>& q = snapshot->device.hand;
    hand->setNodeMask(shown && q && sequence.bodies.empty() ? ~0U : 0U);
    if (q) hand->setMatrix(toOsg(*q));
  }

  /// Shows the arrow of guidance and the object's tint, once the object has been taken in hand or a run has begun.
  void showGuidance() {
    if (!object || !snapshot) return;
    const bool rests = snapshot->state == SessionState::Idle && snapshot->device.q_device == scenario->problem.start;
    const bool shown = visible(SceneLayer::Guidance) && !playback && !snapshot->path && !rests;
    const bool helps = help.places && help.taken;  // one arrow at a time
    fill(SceneLayer::Guidance, shown && !helps ? makeGuidance(snapshot->device, markScale(), palette) : nullptr);
    const float strength = shown ? guidanceStrength(snapshot->device.guidance) : 0.0F;
    setBodyColour(*object, guidanceTint(toOsg(scenario->object.colour), strength, palette));
  }

  void showPath() {
    if (snapshot->path == drawnPath && snapshot->refused == drawnRefusal) return;
    drawnPath = snapshot->path;
    drawnRefusal = snapshot->refused;
    osg::Group& group = layer(SceneLayer::Path);
    group.removeChildren(0, group.getNumChildren());
    if (drawnRefusal) group.addChild(makeRefusedPath(*drawnRefusal, shapes.of(scenario->object.mesh), palette));
    if (!drawnPath) return;
    const std::vector<Pose> poses = posesAlong(drawnPath->configurations(), scenario->problem.metric(), ghosts);
    const BodyShape& shape = shapes.of(scenario->object.mesh);
    const double tube = kPathTubeRadii * scenario->problem.world->objectRadius();
    group.addChild(makePath({*drawnPath, shape, pathProfile.get(), poses, tube, pathByAuthor}, palette));
    if (snapshot->coarsePlan) group.addChild(makeSteppedPath(*snapshot->coarsePlan, palette));
  }

  void placeObject() {
    if (!object) return;
    const bool inPlan = !sequence.bodies.empty();
    object->setNodeMask(inPlan ? 0U : ~0U);
    plainObjects->setNodeMask(inPlan ? ~0U : 0U);
    if (inPlan) {
      for (std::size_t i = 0; i < scenario->objectBodies.size(); ++i) {
        auto* body = static_cast<osg::MatrixTransform*>(plainObjects->getChild(static_cast<unsigned>(i)));
        body->setMatrix(toOsg(inSequence(i).X_WB));
        body->setNodeMask(inSequence(i).shown ? ~0U : 0U);
      }
    } else if (snapshot) {
      object->setMatrix(toOsg(playback ? *playback : snapshot->device.q_device));
    }
  }

  /// The box of the bodies that the plan shows.
  Box3 extentOfSequence() const {
    Box3 box;
    for (std::size_t i = 0; i < scenario->obstacles.size(); ++i) {
      if (isDrawn(i)) box.extend(boundingBox(*scenario->obstacles[i].mesh, poseOf(i)));
    }
    for (std::size_t i = 0; i < scenario->objectBodies.size(); ++i) {
      if (inSequence(i).shown) box.extend(boundingBox(*scenario->objectBodies[i].mesh, inSequence(i).X_WB));
    }
    return box;
  }

  Box3 extent() const {
    if (!scenario) return Box3();
    Box3 box = boxOfReach(reach);
    if (!sequence.bodies.empty()) return box.merged(extentOfSequence());
    for (const RigidBody& body : scenario->obstacles) box.extend(boundingBox(*body.mesh, body.X_WB));
    box.extend(boundingBox(*scenario->object.mesh, scenario->problem.start));
    if (const Pose* goal = std::get_if<Pose>(&scenario->problem.goal)) {
      box.extend(boundingBox(*scenario->object.mesh, *goal));
    }
    const Vector3 reach = Vector3::Constant(scenario->problem.world->objectRadius());
    for (const PathPoint& point : drawnPath ? drawnPath->points : std::vector<PathPoint>()) {
      box.extend(Box3(point.q.position - reach, point.q.position + reach));
    }
    return box;
  }
};

}  // namespace glissade
