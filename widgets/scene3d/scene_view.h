#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/base/work_watch.h"
#include "engine/files/scenario.h"
#include "engine/geometry/plane_section.h"
#include "engine/planning/path_spacing.h"
#include "engine/session/session.h"
#include "engine/sweep/swept_volume.h"
#include "widgets/scene3d/display_mode.h"
#include "widgets/scene3d/graph_mutex.h"
#include "widgets/scene3d/scene_legend.h"

namespace osg {
class Group;
}

namespace glissade {

class CameraController;
struct ClearanceProfile;
struct Difficulty;
struct EndConflicts;
struct HelpPlace;
struct PictureDetail;

/// Node mask of things that only the window draws, because they belong to its picture and not to the space. The cull
/// mask of another picture leaves them out.
inline constexpr unsigned kWindowOnly = 1U;
/// Node mask of things that only a headset draws, because they need depth.
inline constexpr unsigned kHeadsetOnly = 2U;

/// Theme of the window, which the scene follows.
enum class Theme { Light, Dark };

/// Colours of the scene that a person has chosen; the theme's colour where none is set.
struct SceneColours {
  std::optional<Colour> background;
  std::optional<Colour> path;   ///< the path and the selection
  std::optional<Colour> start;  ///< the ghost of the start and its tree
  std::optional<Colour> goal;   ///< the ghost of the goal and its tree

  friend bool operator==(const SceneColours& a, const SceneColours& b) {
    return a.background == b.background && a.path == b.path && a.start == b.start && a.goal == b.goal;
  }
};

/// A part of the scene that can be shown and hidden alone.
enum class SceneLayer {
  Bodies,
  Object,
  StartAndGoal,
  Workspace,
  Roadmap,
  Path,
  Sweep,
  Contact,
  Guidance,
  FreeCells,
  MobileCells,
  StaticCells,
  Places,
  Borders,
  Graph,
  CoarsePath,
  Milestones,
  Region,
  Selection,
  Difficulty,
  KeptPaths,
  Refusal,
  Measure,
  Grid,
  Help,
  Reach
};
inline constexpr int kSceneLayerCount = 26;

struct EnvironmentPicture;

/// A text at a point of the scene.
struct SceneLabel {
  Vector3 p_W;
  std::string text;
  bool strong = false;
  bool below = false;                           ///< written under the point, so that another text has room above it
  std::optional<double> number = std::nullopt;  ///< written instead of the text, in the user's language
  bool small = false;                           ///< written small, and only if there is room for it at its point
  std::optional<double> length = std::nullopt;  ///< metres: written instead of the text, in the unit that fits it
};

/// A length at a point of the scene.
SceneLabel lengthLabel(const Vector3& p_W, double metres, bool strong);

/// A path that is shown besides others: its reference points in one colour.
struct KeptPathPicture {
  std::vector<Vector3> way;
  Colour colour;
  std::string name;
};

/// A measurement: lines and points over everything, with their texts.
struct MeasurePicture {
  std::vector<Vector3> points;
  std::vector<Vector3> segments;  ///< ends, two per segment
  std::vector<SceneLabel> labels;
};

/// Places where a person can help the search.
struct HelpPicture {
  std::shared_ptr<const std::vector<HelpPlace>> places;  ///< null: none is shown; else at least one place
  std::size_t chosen = 0;
  bool taken = false;  ///< the hand was moved to the selected place
};

/// A body of the product while an assembly plan is shown.
struct SequenceBody {
  Pose X_WB;
  bool shown = true;
  bool marked = false;  ///< the body moves
};

/// A direction in which a part may not move, and all directions near to it (tolerance::kForbiddenCone).
struct ForbiddenCone {
  Vector3 apex_W;
  Vector3 direction;    ///< unit, world frame
  double length = 0.0;  ///< metres
};

/// The picture of an assembly plan.
struct SequencePicture {
  std::vector<SequenceBody> bodies;  ///< the obstacles in their order, then the object; empty: no plan is shown
  std::vector<Vector3> way;          ///< path of the body that moves: points in the world
  std::vector<ForbiddenCone> forbidden{};
};

/// A hand with its forearm and its tool, holding a part.
struct ReachPicture {
  struct Part {
    MeshPtr mesh;
    Pose X_WM;
    bool isTool = false;
  };
  std::vector<Part> parts;  ///< empty: nothing is shown
  bool isFree = true;       ///< the hand reaches its place
};

/// The 3D picture of one scenario and its session: an OSG scene graph and a camera, without Qt. The on-screen and the
/// offscreen widget use it on the GUI thread only. Another thread may draw the graph while it holds its mutex; every
/// function here that changes the graph holds it, too.
class SceneView {
 public:
  SceneView();
  ~SceneView();
  SceneView(const SceneView&) = delete;
  SceneView& operator=(const SceneView&) = delete;

  /// Replaces everything by this scenario (null: an empty scene) and fits the camera.
  void setScenario(std::shared_ptr<const LoadedScenario> scenario);
  /// Takes the same scenario with other poses of bodies, another object or other ends: viewpoint and shown parts stay.
  /// A camera that shows the whole fits bodies that are added.
  void rearrange(std::shared_ptr<const LoadedScenario> scenario);
  /// Draws an obstacle at another pose while it is dragged, until rearrange(). `obstacle`: index in the scenario.
  void placeObstacle(std::size_t obstacle, const Pose& X_WB);
  /// Draws the obstacles at the scenario's poses again.
  void restoreObstacles();
  /// Draws the ghost of the object at its start elsewhere, as placeObstacle() does; placeGoal() does so at its goal.
  /// Precondition: the ghost exists.
  void placeStart(const Pose& X_WB);
  void placeGoal(const Pose& X_WB);
  /// Fits the parts with both ends of the object and the path, and keeps the direction. The workspace does not count,
  /// because it may be much larger.
  void fit();
  /// Shows the session's state; only new parts of the roadmap are uploaded.
  void setSnapshot(SnapshotPtr snapshot);
  /// Sets places, cells and selection; without knowledge these layers are empty.
  void setEnvironment(const EnvironmentPicture& picture);
  /// Sets the obstacles, by id, that are not drawn; none when a scenario is opened.
  void setHiddenBodies(const std::set<BodyId>& bodyIds);
  const std::set<BodyId>& hiddenBodies() const;
  /// Sets how obstacles are drawn; the mode stays when another scenario is opened. While places, borders or cells are
  /// shown, shaded obstacles are see-through.
  void setDisplayMode(DisplayMode mode);
  DisplayMode displayMode() const;
  /// Darkens corners, holes and gaps, unless the scene has a wireframe; on by default.
  void setDepthShading(bool shaded);
  bool depthShading() const;
  /// Sets display modes of single obstacles, by id; none when a scenario is opened.
  void setBodyDisplayModes(const std::map<BodyId, DisplayMode>& modes);
  const std::map<BodyId, DisplayMode>& bodyDisplayModes() const;
  /// Cuts obstacles open: parts on the side of a section's normal are not drawn, and the cut faces are filled. The
  /// object is never cut. There are no sections when a scenario is opened, and at most kMostSections.
  void setSections(const std::vector<Plane>& sections);
  const std::vector<Plane>& sections() const;
  /// Sets a function that is called when cut faces of large bodies are left for capsWork().
  void onCapsLeft(std::function<void()> callback);
  /// The work that makes the remaining cut faces, on any thread; its result is called on the GUI thread, before this
  /// view ends. Null: none is left.
  std::function<std::function<void()>(const WorkWatch&)> capsWork();
  /// The box of the drawn scene: bodies, both ends of the object, and the path. Empty without a scenario.
  Box3 extent() const;
  /// Sets the coarse plan that is shown: the run's, or one made for the user's edits. May be null.
  void setCoarsePlan(const CoarsePlanPtr& plan);
  /// Sets the topological step whose region is shown; nothing: the running one.
  void setShownStep(const std::optional<std::size_t>& step);
  /// Marks the object at the refused end, and the bodies that it meets there; null: nothing.
  void setRefusal(std::shared_ptr<const glissade::EndConflicts> conflicts);
  /// Sets the paths that are shown besides the run's.
  void setKeptPaths(std::vector<KeptPathPicture> paths);
  void setMeasure(MeasurePicture measure);
  /// Shows the volume that the object sweeps along the path; null: nothing is shown.
  void setSweep(std::shared_ptr<const SweptVolume> sweep);
  /// The box of these bodies as they are drawn, by id; the object is at its shown pose. Empty: none of them exists.
  Box3 extentOf(const std::set<BodyId>& bodyIds) const;
  /// The obstacles at their drawn poses; while a plan is shown, the object is the last one of them.
  std::vector<RigidBody> drawnObstacles() const;
  /// The drawn pose of the object.
  Pose objectPose() const;
  /// Shows why the run found no path; null: nothing is known.
  void setDifficulty(std::shared_ptr<const glissade::Difficulty> difficulty);
  /// Shows the hand where it can help.
  void setHelp(HelpPicture help);
  /// Shows the motion from the hand to this pose, by arrows; nothing: none.
  void setHelpLead(const std::optional<Pose>& to);
  /// Texts of the visible layers: names of places, costs of the graph.
  std::vector<SceneLabel> labels() const;
  /// The kinds of things that are drawn now besides the bodies, with their colours.
  std::vector<LegendRow> legend() const;
  /// Draws the roadmap unfaded while a path is shown, too.
  void setRoadmapKept(bool kept);
  /// Colours the path by its clearance, from tight to wide; null: one colour.
  void setPathProfile(std::shared_ptr<const ClearanceProfile> profile);
  /// Shows a person's hand at the moving part. None when a scenario is opened.
  void setReach(ReachPicture reach);
  /// Sets the spacing of the object's ghosts along the path.
  void setGhosts(const PathSpacing& spacing);
  /// Sets the unit, in metres, in which the spacing of the grid is a round number.
  void setGridUnit(double metres);
  /// Metres between two lines of the grid; nothing if it is not drawn.
  std::optional<double> gridSpacing() const;
  /// Colours the path's segments by their authors, instead of all alike.
  void setPathByAuthor(bool byAuthor);
  /// Sets the pose of the object while a path is played back; nothing: q_device is shown.
  void setPlaybackPose(const std::optional<Pose>& X_WB);
  /// Draws the product as a plan has it, until an empty picture, another scenario or another arrangement is set. Layers
  /// about the object's motion are not drawn meanwhile. A camera that was moved stays; its planes enclose all bodies.
  void setSequence(const SequencePicture& picture);
  /// Whether a plan is shown.
  bool showsSequence() const;
  void setTheme(Theme theme);
  /// Replaces the theme's colours, in every theme.
  void setColours(const SceneColours& colours);
  /// Sets the device pixels per pixel, so that lines keep their width on fine displays and in oversampled pictures.
  void setPixelScale(double scale);
  double pixelScale() const;
  void setLayerVisible(SceneLayer layer, bool visible);
  bool layerVisible(SceneLayer layer) const;

  CameraController& camera();
  const CameraController& camera() const;
  /// Called before each picture, of this size in device pixels. A coarse picture, while the camera moves, has no depth
  /// shading.
  void beginPicture(int width, int height, const PictureDetail& detail);
  /// Root of the scene graph, for the widget that renders it.
  osg::Group* root() const;
  /// The mutex of the scene graph; it may outlive this view.
  std::shared_ptr<GraphMutex> graphMutex() const;
  /// Clear colour, sRGB.
  Colour background() const;
  /// The lower end of the gradient behind the scene, sRGB.
  Colour backgroundBelow() const;
  /// Whether texts and lines on the background have to be light.
  bool hasDarkBackground() const;

  struct Impl;

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace glissade
