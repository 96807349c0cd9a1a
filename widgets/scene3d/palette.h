#pragma once

#include <osg/Vec4>
#include <osg/Vec4ub>

#include <cmath>

#include "engine/planning/roadmap.h"
#include "widgets/controls/dark_ground.h"
#include "widgets/scene3d/osg_convert.h"
#include "widgets/scene3d/scene_view.h"

namespace glissade {

/// The colours of the scene. Colours that must be distinguishable are from Okabe and Ito's palette (2008), which does
/// not rely on red against green.
struct ScenePalette {
  float pixelScale = 1.0F;  ///< device pixels per pixel: line widths and point sizes follow
  osg::Vec4 backgroundTop;
  osg::Vec4 backgroundBottom;
  osg::Vec4 lines;  ///< feature edges and the workspace
  osg::Vec4ub startTree;
  osg::Vec4ub goalTree;
  osg::Vec4ub operatorNode;
  osg::Vec4ub contactNode;
  osg::Vec4 path;
  osg::Vec4 selection;
  osg::Vec4 stepPart;  ///< bodies that a step of the plan moves
  osg::Vec4 stepWay;   ///< their motion
  osg::Vec4 start;
  osg::Vec4 goal;
  osg::Vec4 contact;
  osg::Vec4 nearest;
  osg::Vec4 penetration;  ///< bodies in the way
  osg::Vec4 guidance;
};

inline osg::Vec4ub bytesOf(const osg::Vec4& colour) {
  const auto byte = [](float share) { return static_cast<unsigned char>(std::lround(255.0F * share)); };
  return {byte(colour.r()), byte(colour.g()), byte(colour.b()), 255};
}

inline bool isDark(const osg::Vec4& ground) { return isDarkGround(ground.r(), ground.g(), ground.b()); }

inline ScenePalette paletteOf(Theme theme) {
  ScenePalette palette;
  const bool dark = theme == Theme::Dark;
  palette.backgroundTop = dark ? osg::Vec4(0.17f, 0.19f, 0.22f, 1) : osg::Vec4(0.93f, 0.95f, 0.97f, 1);
  palette.backgroundBottom = dark ? osg::Vec4(0.09f, 0.10f, 0.12f, 1) : osg::Vec4(0.80f, 0.84f, 0.89f, 1);
  palette.lines = dark ? osg::Vec4(0.75f, 0.78f, 0.82f, 0.55f) : osg::Vec4(0.12f, 0.14f, 0.18f, 0.65f);
  palette.startTree = dark ? osg::Vec4ub(86, 180, 233, 255) : osg::Vec4ub(0, 96, 160, 255);
  palette.goalTree = dark ? osg::Vec4ub(240, 228, 66, 255) : osg::Vec4ub(190, 120, 0, 255);
  palette.operatorNode = osg::Vec4ub(204, 121, 167, 255);
  palette.contactNode = osg::Vec4ub(0, 158, 115, 255);
  palette.path = osg::Vec4(0.84f, 0.37f, 0.0f, 1);
  palette.selection = dark ? osg::Vec4(0.45f, 1.0f, 0.95f, 1) : osg::Vec4(0.0f, 0.68f, 0.94f, 1);
  palette.stepPart = dark ? osg::Vec4(0.94f, 0.89f, 0.26f, 1) : osg::Vec4(0.90f, 0.62f, 0.0f, 1);
  palette.stepWay = dark ? osg::Vec4(0.84f, 0.37f, 0.0f, 1) : osg::Vec4(0.0f, 0.45f, 0.70f, 1);
  palette.start = dark ? osg::Vec4(0.34f, 0.71f, 0.91f, 1) : osg::Vec4(0.0f, 0.38f, 0.63f, 1);
  palette.goal = dark ? osg::Vec4(0.94f, 0.89f, 0.26f, 1) : osg::Vec4(0.75f, 0.47f, 0.0f, 1);
  palette.contact = osg::Vec4(0.0f, 0.62f, 0.45f, 1);
  palette.nearest = dark ? osg::Vec4(0.90f, 0.90f, 0.92f, 1) : osg::Vec4(0.15f, 0.15f, 0.18f, 1);
  palette.penetration = dark ? osg::Vec4(0.76f, 0.58f, 1.0f, 1) : osg::Vec4(0.45f, 0.15f, 0.75f, 1);
  palette.guidance = dark ? osg::Vec4(1.0f, 0.35f, 0.60f, 1) : osg::Vec4(0.78f, 0.05f, 0.38f, 1);
  return palette;
}

/// Replaces the theme's colours by those that a person has chosen.
inline void applyColours(const SceneColours& chosen, ScenePalette& palette) {
  if (chosen.background) {
    palette.backgroundTop = palette.backgroundBottom = toOsg(*chosen.background);
    const ScenePalette suited = paletteOf(isDark(palette.backgroundTop) ? Theme::Dark : Theme::Light);
    palette.lines = suited.lines;
    palette.nearest = suited.nearest;
  }
  if (chosen.path) palette.path = toOsg(*chosen.path);
  if (chosen.start) palette.startTree = bytesOf(palette.start = toOsg(*chosen.start));
  if (chosen.goal) palette.goalTree = bytesOf(palette.goal = toOsg(*chosen.goal));
}

/// Colour of a node: its author if a person took part in it, else its tree.
inline osg::Vec4ub colourOf(const RoadmapNode& node, const ScenePalette& palette) {
  if (node.author == Author::Operator || (node.author == Author::Computer && node.side == TreeSide::Hand))
    return palette.operatorNode;
  if (node.author == Author::Contact) return palette.contactNode;
  return node.side == TreeSide::Start ? palette.startTree : palette.goalTree;
}

}  // namespace glissade
