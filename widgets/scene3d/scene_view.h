#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/base/work_watch.h"
#include "engine/geometry/plane_section.h"
#include "engine/planning/path_spacing.h"
#include "engine/scenario/scenario.h"
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

/// What only the window draws of the scene, because it belongs to its picture and not to the space: a bit of node
/// masks. The cull mask of another picture leaves it out.
inline constexpr unsigned kWindowOnly = 1U;
/// Likewise what only a headset draws, because it needs depth.
inline constexpr unsigned kHeadsetOnly = 2U;

/// Light or dark window; the scene follows.
enum class Theme { Light, Dark };

/// Colours of the scene that a person has chosen; those of the theme where there is none.
struct SceneColours {
  std::optional<Colour> background;
  std::optional<Colour> path;   ///< the path, and what is selected
  std::optional<Colour> start;  ///< the ghost of the start and its tree
  std::optional<Colour> goal;   ///< the ghost of the goal and its tree

  friend bool operator==(const SceneColours& a, const SceneColours& b) {
    return a.background == b.background && a.path == b.path && a.start == b.start && a.goal == b.goal;
  }
};

/// One concept drawn, shown and hidden by itself.
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
  bool below = false;                           ///< written under the point, so that another text has room on it
  std::optional<double> number = std::nullopt;  ///< written instead of the text, as the user's language writes numbers
  bool small = false;                           ///< written small, and only where there is room for it at its point
  std::optional<double> length = std::nullopt;  ///< metres: written instead of the text, in the unit that fits it
};

/// A length at a point of the scene.
SceneLabel lengthLabel(const Vector3& p_W, double metres, bool strong);

/// A path that is shown beside others: its reference points in one colour.
struct KeptPathPicture {
  std::vector<Vector3> way;
  Colour colour;
  std::string name;
};

/// What is measured: lines and points over everything, with their texts.
struct MeasurePicture {
  std::vector<Vector3> points;
  std::vector<Vector3> segments;  ///< ends, two per segment
  std::vector<SceneLabel> labels;
};

/// Places where a person can help the search.
struct HelpPicture {
  std::shared_ptr<const std::vector<HelpPlace>> places;  ///< null: none is shown; else at least one
  std::size_t chosen = 0;
  bool taken = false;  ///< the hand was taken to the chosen one
};

/// A body of the product while an assembly plan is shown.
struct SequenceBody {
  Pose X_WB;
  bool shown = true;
  bool marked = false;  ///< it moves
};

/// A direction in which a part may not move, and all directions near to it (tolerance::kForbiddenCone).
struct ForbiddenCone {
  Vector3 apex_W;
  Vector3 direction;    ///< unit, world frame
  double length = 0.0;  ///< metres
};

/// What is drawn of an assembly plan.
struct SequencePicture {
  std::vector<SequenceBody> bodies;  ///< the obstacles in their order, then the object; empty: no plan is shown
  std::vector<Vector3> way;          ///< of the body that moves: points in the world
  std::vector<ForbiddenCone> forbidden{};
};

/// A hand with its forearm and its tool where they hold something.
struct ReachPicture {
  struct Part {
    MeshPtr mesh;
    Pose X_WM;
    bool isTool = false;
  };
  std::vector<Part> parts;  ///< empty: nothing is shown
  bool isFree = true;       ///< it gets there
};

/// The 3D picture of one scenario and its session: an OSG scene graph and a camera. No Qt; used on
/// the GUI thread only, by the on-screen and the offscreen widget alike. Another thread may draw the graph while it
/// holds its mutex; every function here that changes the graph holds it, too.
class SceneView {
 public:
  SceneView();
  ~SceneView();
  SceneView(const SceneView&) = delete;
  SceneView& operator=(const SceneView&) = delete;

  /// Replaces everything by this scenario (null: an empty scene) and fits the camera.
  void setScenario(std::shared_ptr<const LoadedScenario> scenario);
  /// The same scenario with its bodies, its object or its ends elsewhere: what is looked at, and from where, stays. A
  /// camera that shows the whole fits bodies that are added.
  void rearrange(std::shared_ptr<const LoadedScenario> scenario);
  /// Draws an obstacle elsewhere while it is in somebody's hand: until rearrange(). Index into the scenario's.
  void placeObstacle(std::size_t obstacle, const Pose& X_WB);
  /// Draws the obstacles where the scenario has them again.
  void putBackObstacles();
  /// As placeObstacle() for the ghosts of the object at its start and at its goal, where there are any.
  void placeStart(const Pose& X_WB);
  void placeGoal(const Pose& X_WB);
  /// The parts in view, with both ends of the object and the path; direction kept. The workspace does not count: it may
  /// be much larger.
  void fit();
  /// Shows the session's state; only what is new in the roadmap is uploaded.
  void setSnapshot(SnapshotPtr snapshot);
  /// Places, cells and selection; without knowledge these layers are empty.
  void setEnvironment(const EnvironmentPicture& picture);
  /// Obstacles, by id, that are not drawn; none when a scenario is opened.
  void setHiddenBodies(const std::set<std::string>& bodyIds);
  const std::set<std::string>& hiddenBodies() const;
  /// How obstacles are drawn; the mode stays when another scenario is opened. While places, borders or cells are shown,
  /// shaded obstacles are see-through.
  void setDisplayMode(DisplayMode mode);
  DisplayMode displayMode() const;
  /// Corners, holes and gaps are darker; on at first. Not in a wireframe.
  void setDepthShading(bool shaded);
  bool depthShading() const;
  /// Obstacles, by id, that have a display mode of their own; none when a scenario is opened.
  void setBodyDisplayModes(const std::map<std::string, DisplayMode>& modes);
  const std::map<std::string, DisplayMode>& bodyDisplayModes() const;
  /// Cuts obstacles open: what lies on the side of a section's normal is not drawn, and the cut faces are filled. The
  /// object is never cut. None when a scenario is opened; at most kMostSections.
  void setSections(const std::vector<Plane>& sections);
  const std::vector<Plane>& sections() const;
  /// Called when cut faces of large bodies are left to be made by capsWork().
  void onCapsLeft(std::function<void()> callback);
  /// Makes the cut faces that are left on any thread; what it returns is to be called on the GUI thread, before this
  /// view ends. Null: none is left.
  std::function<std::function<void()>(const WorkWatch&)> capsWork();
  /// The box of what is drawn: bodies, both ends of the object, and the path. Empty without a scenario.
  Box3 extent() const;
  /// The coarse plan that is shown: that of the run, or one made for the user's edits. May be null.
  void setCoarsePlan(const CoarsePlanPtr& plan);
  /// The topological step whose region is shown; nothing: the one that is running.
  void setShownStep(const std::optional<std::size_t>& step);
  /// Marks the object where it is refused, and the bodies that it meets there; null: nothing.
  void setRefusal(std::shared_ptr<const glissade::EndConflicts> conflicts);
  /// Paths that are shown beside the run's.
  void setKeptPaths(std::vector<KeptPathPicture> paths);
  void setMeasure(MeasurePicture measure);
  /// What the object covers along the path; null: nothing is shown.
  void setSweep(std::shared_ptr<const SweptVolume> sweep);
  /// The box of these bodies where they are drawn, by id; the object is where it is shown. Empty: none is there.
  Box3 extentOf(const std::set<std::string>& bodyIds) const;
  /// The obstacles that are drawn, where they are drawn; while a plan is shown, the object is the last one of them.
  std::vector<RigidBody> drawnObstacles() const;
  /// Where the object is drawn.
  Pose objectPose() const;
  /// Why the run that is shown found no path; null: nothing is known.
  void setDifficulty(std::shared_ptr<const glissade::Difficulty> difficulty);
  /// Leads the hand to where it can help.
  void setHelp(HelpPicture help);
  /// Texts of the visible layers: names of places, costs of the graph.
  std::vector<SceneLabel> labels() const;
  /// What is drawn now beside the bodies, in the colours that it is drawn in.
  std::vector<LegendRow> legend() const;
  /// Draws the roadmap as it is while a path is shown, too; else it is faint then.
  void setRoadmapKept(bool kept);
  /// Colours the path by its clearance, from tight to wide; null: one colour.
  void setPathProfile(std::shared_ptr<const ClearanceProfile> profile);
  /// A person's hand at what moves. None when a scenario is opened.
  void setReach(ReachPicture reach);
  /// Where the object is drawn along the path.
  void setGhosts(const PathSpacing& spacing);
  /// The spacing of the grid is a round number of this unit, metres.
  void setGridUnit(double metres);
  /// Metres between two lines of the grid; nothing where it is not drawn.
  std::optional<double> gridSpacing() const;
  /// Colours the path's segments by who made them, instead of all alike.
  void setPathByAuthor(bool byAuthor);
  /// The pose shown for the object while a path is played back; nothing: q_device is shown.
  void setPlaybackPose(const std::optional<Pose>& X_WB);
  /// Draws the product as a plan has it: until an empty picture is set, or another scenario or arrangement. What is
  /// about the motion of the object alone is not drawn meanwhile. A camera that was moved stays; its planes hold all
  /// bodies.
  void setSequence(const SequencePicture& picture);
  /// A plan is shown.
  bool showsSequence() const;
  void setTheme(Theme theme);
  /// In the place of the theme's colours, in every theme.
  void setColours(const SceneColours& colours);
  /// Device pixels per pixel, so that lines keep their width on fine displays and when oversampled.
  void setPixelScale(double scale);
  double pixelScale() const;
  void setLayerVisible(SceneLayer layer, bool visible);
  bool layerVisible(SceneLayer layer) const;

  CameraController& camera();
  const CameraController& camera() const;
  /// Before each picture, of this size in device pixels. A coarse one, while the camera moves, has no depth shading.
  void beginPicture(int width, int height, const PictureDetail& detail);
  /// Root of the scene graph, for the widget that renders it.
  osg::Group* root() const;
  /// Of the scene graph; it may outlive this view.
  std::shared_ptr<GraphMutex> graphMutex() const;
  /// Clear colour, sRGB.
  Colour background() const;
  /// The lower end of the gradient behind the scene, sRGB.
  Colour backgroundBelow() const;
  /// Texts and lines on it are to be light.
  bool hasDarkBackground() const;

  struct Impl;

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace glissade
