#include "widgets/scene3d/scene_legend.h"

#include "widgets/controls/author_colour.h"
#include "widgets/controls/complexity_colour.h"
#include "widgets/scene3d/scene_view_impl.h"

namespace glissade {
namespace {

constexpr int kHardestPlace = 5;

Colour colourOf(const osg::Vec4& colour) { return {colour.r(), colour.g(), colour.b()}; }

Colour colourOf(const osg::Vec4ub& colour) { return {colour.r() / 255.0, colour.g() / 255.0, colour.b() / 255.0}; }

/// Collects the rows of the drawn things, in the order of the legend.
class LegendMaker {
 public:
  explicit LegendMaker(const SceneView::Impl& impl) : impl_(impl), palette_(impl.palette) {}

  std::vector<LegendRow> rows() {
    if (!impl_.scenario) return {};
    if (impl_.sequence.bodies.empty()) {
      addEnds();
      addRoadmap();
      addPath();
      addContact();
    } else {
      addSequence();
    }
    addEnvironment();
    addPlan();
    addTroubles();
    if (isDrawn(SceneLayer::Sweep)) add(LegendItem::Sweep, LegendMark::Fill, palette_.contact);
    if (!impl_.reach.parts.empty()) {
      const bool isFree = impl_.reach.isFree;
      add(isFree ? LegendItem::Reach : LegendItem::ReachBlocked, LegendMark::Fill, reachColour(isFree, palette_));
    }
    if (!impl_.sequence.forbidden.empty() && isDrawn(SceneLayer::Selection)) {
      add(LegendItem::ForbiddenDirection, LegendMark::Fill, palette_.penetration);
    }
    if (hasSelection()) add(LegendItem::Selected, LegendMark::Fill, palette_.selection);
    return std::move(rows_);
  }

 private:
  template <class... Colours>
  void add(LegendItem item, LegendMark mark, const Colours&... colours) {
    rows_.push_back({item, mark, {colourOf(colours)...}});
  }
  void add(LegendItem item, LegendMark mark, const Colour& colour) { rows_.push_back({item, mark, {colour}}); }

  /// Whether the layer is visible and has content.
  bool isDrawn(SceneLayer id) const {
    return impl_.visible(id) && impl_.layers[static_cast<std::size_t>(id)]->getNumChildren() > 0;
  }

  void addEnds() {
    if (isDrawn(SceneLayer::Object)) add(LegendItem::Object, LegendMark::Fill, bodyColour(*impl_.object));
    if (isDrawn(SceneLayer::StartAndGoal)) {
      add(LegendItem::Start, LegendMark::Fill, palette_.start);
      if (std::holds_alternative<Pose>(impl_.scenario->problem.goal)) {
        add(LegendItem::Goal, LegendMark::Fill, palette_.goal);
      }
    }
    if (isDrawn(SceneLayer::Workspace)) add(LegendItem::Workspace, LegendMark::Line, palette_.lines);
  }

  void addRoadmap() {
    if (!impl_.visible(SceneLayer::Roadmap)) return;
    const RoadmapLayer::Content& content = impl_.roadmap.content();
    if (content.startTree) add(LegendItem::StartTree, LegendMark::Line, palette_.startTree);
    if (content.goalTree) add(LegendItem::GoalTree, LegendMark::Line, palette_.goalTree);
    if (content.operatorNodes) add(LegendItem::OperatorNodes, LegendMark::Dot, palette_.operatorNode);
    if (content.contactNodes) add(LegendItem::ContactNodes, LegendMark::Dot, palette_.contactNode);
  }

  void addPath() {
    if (!impl_.visible(SceneLayer::Path)) return;
    if (impl_.drawnRefusal) {
      add(LegendItem::RefusedPath, LegendMark::Line, palette_.path);
      add(LegendItem::Blocked, LegendMark::Line, palette_.penetration);
    }
    if (!impl_.drawnPath) return;
    if (impl_.snapshot && impl_.snapshot->coarsePlan) {
      add(LegendItem::PathByStep, LegendMark::Line, colourOfStep(0), colourOfStep(1), colourOfStep(2));
    } else if (impl_.pathByAuthor) {
      addAuthors();
    } else if (impl_.pathProfile && impl_.pathProfile->samples.size() > 1) {
      add(LegendItem::PathByClearance, LegendMark::Line, clearanceColour(0.0), clearanceColour(0.25),
          clearanceColour(0.5), clearanceColour(0.75), clearanceColour(1.0));
    } else {
      add(LegendItem::Path, LegendMark::Line, palette_.path);
    }
    if (impl_.ghosts.by != PathSpacing::By::None) add(LegendItem::ObjectOnPath, LegendMark::Fill, palette_.path);
  }

  void addAuthors() {
    PerAuthor<bool> made{};
    const auto& points = impl_.drawnPath->points;
    for (std::size_t i = 1; i < points.size(); ++i) made[static_cast<std::size_t>(points[i].segmentAuthor)] = true;
    constexpr std::pair<Author, LegendItem> kAuthors[] = {{Author::Computer, LegendItem::PathOfComputer},
                                                          {Author::Operator, LegendItem::PathOfOperator},
                                                          {Author::Contact, LegendItem::PathOfContact}};
    for (const auto& [author, item] : kAuthors) {
      if (made[static_cast<std::size_t>(author)]) add(item, LegendMark::Line, authorColour(author));
    }
  }

  void addContact() {
    if (isDrawn(SceneLayer::Contact) && impl_.snapshot) {
      switch (contactShown(*impl_.snapshot)) {
        case ContactShown::Nothing: break;
        case ContactShown::Nearest: add(LegendItem::Nearest, LegendMark::Line, palette_.nearest); break;
        case ContactShown::Contact: add(LegendItem::Contact, LegendMark::Line, palette_.contact); break;
      }
    }
    if (impl_.hand && impl_.hand->getNodeMask() != 0U) add(LegendItem::Hand, LegendMark::Fill, palette_.lines);
    if (isDrawn(SceneLayer::Guidance)) add(LegendItem::Guidance, LegendMark::Line, palette_.guidance);
  }

  void addSequence() {
    const auto& bodies = impl_.sequence.bodies;
    if (std::any_of(bodies.begin(), bodies.end(), [](const SequenceBody& body) { return body.marked && body.shown; })) {
      add(LegendItem::MovingPart, LegendMark::Fill, palette_.stepPart);
    }
    if (impl_.sequence.way.size() > 1) add(LegendItem::WayOfPart, LegendMark::Line, palette_.stepWay);
  }

  void addEnvironment() {
    const osg::Vec4& lines = palette_.lines;
    if (isDrawn(SceneLayer::FreeCells)) add(LegendItem::FreeCells, LegendMark::Line, cellColour(CellKind::Free, lines));
    if (isDrawn(SceneLayer::MobileCells)) {
      add(LegendItem::MobileCells, LegendMark::Line, cellColour(CellKind::Mobile, lines));
    }
    if (isDrawn(SceneLayer::StaticCells)) {
      add(LegendItem::StaticCells, LegendMark::Line, cellColour(CellKind::Static, lines));
    }
    if (isDrawn(SceneLayer::Places)) addPlaces();
    if (isDrawn(SceneLayer::Borders)) add(LegendItem::Borders, LegendMark::Fill, kBorderColour);
  }

  void addPlaces() {
    const std::vector<Colour>& drawn = impl_.environment.placeColours;
    const auto has = [&drawn](const Colour& colour) {
      return std::find(drawn.begin(), drawn.end(), colour) != drawn.end();
    };
    LegendRow row{LegendItem::Places, LegendMark::Fill, {}};
    for (int complexity = 1; complexity <= kHardestPlace; ++complexity) {
      const Colour colour = complexityColour(complexity, false);
      if (has(colour)) row.colours.push_back(colour);
    }
    if (!row.colours.empty()) rows_.push_back(row);
    const Colour cluttered = complexityColour(1, true);
    if (has(cluttered)) add(LegendItem::ClutteredPlaces, LegendMark::Fill, cluttered);
  }

  void addPlan() {
    if (!impl_.drawnPlan) return;
    const CoarsePlan& plan = *impl_.drawnPlan;
    if (isDrawn(SceneLayer::Graph)) add(LegendItem::Graph, LegendMark::Line, palette_.nearest);
    if (isDrawn(SceneLayer::CoarsePath) && !plan.nodes.empty()) {
      add(LegendItem::CoarsePath, LegendMark::Line, kCoarsePathColour);
    }
    const bool milestones = std::any_of(plan.steps.begin(), plan.steps.end(), isMilestoneDrawn);
    if (isDrawn(SceneLayer::Milestones) && milestones) add(LegendItem::Milestones, LegendMark::Fill, kMilestoneColour);
    if (isDrawn(SceneLayer::Region)) add(LegendItem::Region, LegendMark::Fill, palette_.contact);
  }

  void addTroubles() {
    if (impl_.difficulty && isDrawn(SceneLayer::Difficulty)) {
      add(LegendItem::InTheWay, LegendMark::Fill, palette_.penetration);
      if (impl_.difficulty->tightest) add(LegendItem::TightestPlace, LegendMark::Fill, palette_.nearest);
      if (impl_.difficulty->frontier) add(LegendItem::TreeGap, LegendMark::Line, palette_.nearest);
    }
    if (impl_.help.places && isDrawn(SceneLayer::Help)) add(LegendItem::Help, LegendMark::Fill, palette_.guidance);
    if (!impl_.refusal || !isDrawn(SceneLayer::Refusal)) return;
    add(LegendItem::Overlap, LegendMark::Fill, palette_.penetration);
    add(LegendItem::RefusedEnd, LegendMark::Fill, palette_.path);
  }

  bool hasSelection() const { return impl_.visible(SceneLayer::Selection) && impl_.showsSelected(); }

  const SceneView::Impl& impl_;
  const ScenePalette& palette_;
  std::vector<LegendRow> rows_;
};

}  // namespace

std::vector<LegendRow> SceneView::legend() const { return LegendMaker(*impl_).rows(); }

}  // namespace glissade
