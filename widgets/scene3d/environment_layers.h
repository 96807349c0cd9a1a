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

/// The input of the layers of the environment model, besides the model itself.
struct EnvironmentPicture {
  SceneKnowledgePtr knowledge;
  std::vector<Colour> placeColours;     ///< per place
  std::vector<std::string> placeNames;  ///< per place
  std::set<int> selectedPlaces;
  std::set<BodyId> selectedBodies;
  int finestCellLevel = 6;  ///< cells of finer levels are not drawn
};

/// Draws cells of one kind as boxes of lines, the coarsest first; at most some thousands.
osg::ref_ptr<osg::Group> makeCells(const Octree& octree, CellKind kind, int finestLevel, const ScenePalette& palette);
/// The colour of the lines of such cells; `lines` is the palette's.
osg::Vec4 cellColour(CellKind kind, const osg::Vec4& lines);
/// Draws places as transparent solids in their colours.
osg::ref_ptr<osg::Group> makePlaces(const EnvironmentPicture& picture, const ScenePalette& palette);
/// Draws the outlines of the selected places.
osg::ref_ptr<osg::Group> makeSelection(const EnvironmentPicture& picture, const ScenePalette& palette);
/// Draws borders: the faces that two places share.
osg::ref_ptr<osg::Group> makeBorders(const TopologicalMap& map, const ScenePalette& palette);
/// Draws the topological graph: nodes in the borders, edges through the places, darker if they cost less.
osg::ref_ptr<osg::Group> makeGraph(const TopologicalGraph& graph, const ScenePalette& palette);
/// Draws the coarse path through the graph.
osg::ref_ptr<osg::Group> makeCoarsePath(const CoarsePlan& plan, const ScenePalette& palette);
/// Whether the object is drawn at the end of this step.
bool isMilestoneDrawn(const TopologicalStep& step);
/// Draws the milestones: the object in the configurations to pass through.
osg::ref_ptr<osg::Group> makeMilestones(const CoarsePlan& plan, const BodyShape& object, const ScenePalette& palette);
/// Draws the area that a local planner explores.
osg::ref_ptr<osg::Group> makeRegion(const SamplingRegion& region, const ScenePalette& palette);
/// Draws the path in the colours of its topological steps, and ghosts of the object at the milestones.
osg::ref_ptr<osg::Group> makeSteppedPath(const CoarsePlan& plan, const ScenePalette& palette);

/// The colour of a topological step in path, table and region.
osg::Vec4 colourOfStep(std::size_t step);

}  // namespace glissade
