#pragma once

#include <osg/Group>
#include <osg/ref_ptr>
#include <set>
#include <string>
#include <vector>

#include "engine/planning/coarse/scene_knowledge.h"
#include "widgets/scene3d/body_shape.h"
#include "widgets/scene3d/palette.h"

namespace glissade {

inline const osg::Vec4 kBorderColour(0.80F, 0.47F, 0.65F, 0.55F);
inline const osg::Vec4 kCoarsePathColour(0.0F, 0.38F, 0.85F, 0.9F);
inline const osg::Vec4 kMilestoneColour(0.84F, 0.15F, 0.15F, 1.0F);

/// What the layers of the environment model are drawn from, beyond the model itself.
struct EnvironmentPicture {
  SceneKnowledgePtr knowledge;
  std::vector<Colour> placeColours;     ///< per place
  std::vector<std::string> placeNames;  ///< per place
  std::set<int> selectedPlaces;
  std::set<std::string> selectedBodies;  ///< ids
  int finestCellLevel = 6;               ///< cells of finer levels are not drawn
};

/// Cells of one kind as boxes of lines, the coarsest first; at most some thousands.
osg::ref_ptr<osg::Group> makeCells(const Octree& octree, CellKind kind, int finestLevel, const ScenePalette& palette);
/// Of the lines of these cells; `lines` is the palette's.
osg::Vec4 cellColour(CellKind kind, const osg::Vec4& lines);
/// Places as transparent solids in their colours.
osg::ref_ptr<osg::Group> makePlaces(const EnvironmentPicture& picture, const ScenePalette& palette);
/// The selected places, outlined.
osg::ref_ptr<osg::Group> makeSelection(const EnvironmentPicture& picture, const ScenePalette& palette);
/// Borders: the faces that two places share.
osg::ref_ptr<osg::Group> makeBorders(const TopologicalMap& map, const ScenePalette& palette);
/// The topological graph: nodes in the borders, edges through the places, darker where they cost less.
osg::ref_ptr<osg::Group> makeGraph(const TopologicalGraph& graph, const ScenePalette& palette);
/// The coarse path through the graph.
osg::ref_ptr<osg::Group> makeCoarsePath(const CoarsePlan& plan, const ScenePalette& palette);
/// The object is drawn at the end of this step.
bool isMilestoneDrawn(const TopologicalStep& step);
/// The milestones: the object in the configurations to pass through.
osg::ref_ptr<osg::Group> makeMilestones(const CoarsePlan& plan, const BodyShape& object, const ScenePalette& palette);
/// The area that a local planner explores.
osg::ref_ptr<osg::Group> makeRegion(const SamplingRegion& region, const ScenePalette& palette);
/// The path in the colours of its topological steps, and ghosts of the object at the milestones.
osg::ref_ptr<osg::Group> makeSteppedPath(const CoarsePlan& plan, const ScenePalette& palette);

/// The colour of a topological step in path, table and region.
osg::Vec4 colourOfStep(std::size_t step);

}  // namespace glissade
