#include "widgets/scene3d/body_layer.h"

#include <osg/ColorMask>
#include <osg/CullFace>
#include <osg/Depth>
#include <osg/LineStipple>
#include <osg/PolygonOffset>

#include <algorithm>

#include "engine/places/rigid_body.h"
#include "widgets/scene3d/detail_node.h"
#include "widgets/scene3d/geometry_builder.h"
#include "widgets/scene3d/mergeable_body.h"
#include "widgets/scene3d/osg_convert.h"

namespace glissade {
namespace {

/// A ghost of more edges fades, because it would hide the bodies beside it.
constexpr double kPlainEdges = 400.0;
constexpr double kLeastShown = 0.03;
constexpr double kLeastFilled = 0.25;
constexpr float kGhostFill = 0.16F;
/// Ghosts fade if there are more than kPlainGhosts.
constexpr double kPlainGhosts = 6.0;
constexpr double kFaintestGhost = 0.12;
/// Opacities of the hidden part of the moved object, and of a ghost.
constexpr float kHiddenFill = 0.45F;
constexpr float kHiddenGhostFill = 0.40F;
constexpr float kHiddenEdges = 0.30F;
/// Render bins. OSG draws bins by their number: opaque bodies are in 0, transparent ones in 10.
constexpr int kHiddenSilhouetteBin = 1;
constexpr int kMovedBodyBin = 2;
/// Size of the halo of the moved object, as a multiple of the object.
constexpr double kHalo = 1.25;
constexpr float kEdgeWidth = 1.2F;
constexpr float kHighlightFill = 0.55F;
constexpr float kHighlightEdges = 2.0F;
constexpr unsigned short kDashes = 0x3333;

osg::Vec4 withOpacity(const osg::Vec4& colour, float opacity) { return {colour.r(), colour.g(), colour.b(), opacity}; }

osg::ref_ptr<osg::Geode> geodeOf(const osg::ref_ptr<osg::Geometry>& geometry) {
  osg::ref_ptr<osg::Geode> geode = new osg::Geode;
  geode->addDrawable(geometry);
  return geode;
}

/// The surface with all details, in one colour.
osg::ref_ptr<osg::Group> surfaceOf(const BodyShape& shape, const osg::Vec4& colour) {
  osg::ref_ptr<DetailNode> surface = new DetailNode;
  osg::ref_ptr<osg::Geometry> finest = makeSurface(shape, colour);
  surface->addDetail(geodeOf(finest), 0.0);
  const osg::ref_ptr<osg::Array> colours = finest->getColorArray();
  surface->addLater(shape.coarser, [surface = surface.get(), colours, colour](const ShapeDetail& detail) {
    osg::ref_ptr<osg::Geometry> geometry = makeSurface(detail, colour);
    geometry->setColorArray(colours, osg::Array::BIND_OVERALL);
    surface->addDetail(geodeOf(geometry), detail.error);
  });
  return surface;
}

/// The surface is pushed back, so that edges on it are drawn whole.
osg::ref_ptr<osg::Group> pushedBackSurfaceOf(const BodyShape& shape, const osg::Vec4& colour) {
  osg::ref_ptr<osg::Group> surface = surfaceOf(shape, colour);
  surface->getOrCreateStateSet()->setAttributeAndModes(new osg::PolygonOffset(1.0F, 1.0F));
  return surface;
}

osg::ref_ptr<osg::Group> edgesOf(const BodyShape& shape, const osg::Vec4& colour, float width) {
  osg::ref_ptr<osg::Vec4Array> colours = new osg::Vec4Array(1, &colour);
  osg::ref_ptr<FadingEdges> edges = new FadingEdges(colours, width);
  const auto add = [edges = edges.get(), colours, colour, width](const ShapeDetail& detail) {
    osg::ref_ptr<osg::Geometry> lines = makeLines(detail.edges, LineKind::Segments, colour, width);
    lines->setColorArray(colours, osg::Array::BIND_OVERALL);
    edges->addEdges(geodeOf(lines), detail.error, detail.edgeDensity);
  };
  add(shape);
  edges->addLater(shape.coarser, add);
  return edges;
}

/// The edges that the surface hides, dashed.
osg::ref_ptr<osg::Geode> hiddenEdgesOf(const BodyShape& shape, const ScenePalette& palette) {
  const osg::Vec4 colour = withOpacity(palette.lines, 0.5F * palette.lines.a());
  osg::ref_ptr<osg::Geometry> lines = makeLines(shape.edges, LineKind::Segments, colour, palette.pixelScale);
  osg::StateSet* state = lines->getOrCreateStateSet();
  state->setAttributeAndModes(new osg::LineStipple(std::max(1, static_cast<int>(palette.pixelScale)), kDashes));
  state->setAttributeAndModes(new osg::Depth(osg::Depth::GREATER, 0.0, 1.0, false));
  return geodeOf(lines);
}

/// The part of a body that other bodies hide: flat, drawn before the body's own surface.
osg::ref_ptr<osg::Group> hiddenSilhouetteOf(const BodyShape& shape, const osg::Vec4& colour,
                                            const ScenePalette& palette, float opacity = kHiddenFill) {
  osg::ref_ptr<osg::Group> group = new osg::Group;
  osg::ref_ptr<osg::Group> fill = surfaceOf(shape, withOpacity(colour, opacity));
  fill->getOrCreateStateSet()->setAttributeAndModes(new osg::CullFace(osg::CullFace::BACK));
  group->addChild(fill);
  group->addChild(edgesOf(shape, withOpacity(palette.lines, kHiddenEdges), palette.pixelScale));
  for (unsigned i = 0; i < group->getNumChildren(); ++i) {
    makeUnlit(*group->getChild(i));
    osg::StateSet* state = group->getChild(i)->getOrCreateStateSet();
    constexpr auto kOver = osg::StateAttribute::ON | osg::StateAttribute::OVERRIDE;
    state->setAttributeAndModes(new osg::Depth(osg::Depth::GREATER, 0.0, 1.0, false), kOver);
    state->setRenderBinDetails(kHiddenSilhouetteBin, "RenderBin", osg::StateSet::OVERRIDE_RENDERBIN_DETAILS);
  }
  return group;
}

/// Marks the pixels close around the body, too, so that marks of a search leave its outline free. It draws nothing.
osg::ref_ptr<osg::MatrixTransform> haloOf(const BodyShape& shape) {
  const osg::ref_ptr<osg::Group> surface = surfaceOf(shape, osg::Vec4(1.0F, 1.0F, 1.0F, 1.0F));
  const osg::Vec3d centre(surface->getBound().center());
  osg::ref_ptr<osg::MatrixTransform> halo = new osg::MatrixTransform(
      osg::Matrixd::translate(-centre) * osg::Matrixd::scale(kHalo, kHalo, kHalo) * osg::Matrixd::translate(centre));
  halo->addChild(surface);
  osg::StateSet* state = halo->getOrCreateStateSet();
  state->setAttributeAndModes(new osg::ColorMask(false, false, false, false));
  state->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 0.0, 1.0, false));
  state->setRenderBinDetails(kMovedBodyBin, "RenderBin");
  return halo;
}

/// The array of colours that all details share.
osg::Vec4Array* coloursOf(osg::Group& surface) {
  return static_cast<osg::Vec4Array*>(surface.getChild(0)->asGeode()->getDrawable(0)->asGeometry()->getColorArray());
}

/// Null if the body is drawn alone: it is see-through, or has coarser details, which depend on its own distance.
osg::ref_ptr<MergeableBody> mergeableOf(const BodyShape& shape, osg::Group& surface, DisplayMode mode,
                                        const ScenePalette& palette) {
  const bool isOpaque = mode == DisplayMode::Shaded || mode == DisplayMode::ShadedWithEdges;
  if (!isOpaque || shape.corners->size() >= 3 * kFewestTrianglesOfDetails) return nullptr;
  osg::ref_ptr<MergeableBody> body = new MergeableBody;
  body->shape = static_cast<const ShapeDetail&>(shape);  // the arrays of the whole mesh
  body->colour = coloursOf(surface);
  if (mode == DisplayMode::ShadedWithEdges) body->edgeColour = palette.lines;
  body->edgeWidth = kEdgeWidth * palette.pixelScale;
  return body;
}

osg::ref_ptr<osg::Group> ghostOf(const BodyShape& shape, const osg::Vec4& colour, const ScenePalette& palette) {
  const double edges = 0.5 * static_cast<double>(shape.edges->size());
  const double shown = kPlainEdges / std::max(kPlainEdges, edges);
  const auto fill = static_cast<float>(std::max(kLeastFilled, shown));
  osg::ref_ptr<osg::Group> ghost = new osg::Group;
  osg::ref_ptr<osg::Group> surface = pushedBackSurfaceOf(shape, withOpacity(colour, kGhostFill * fill * colour.a()));
  makeTransparent(*surface);
  ghost->addChild(surface);
  const auto opacity = static_cast<float>(std::max(kLeastShown, shown));
  ghost->addChild(edgesOf(shape, withOpacity(colour, colour.a() * opacity), 1.5F * palette.pixelScale));
  return ghost;
}

}  // namespace

osg::ref_ptr<osg::MatrixTransform> makeBody(const BodyShape& shape, const Pose& X_WB, const osg::Vec4& colour,
                                            DisplayMode mode, const ScenePalette& palette) {
  osg::ref_ptr<osg::MatrixTransform> transform = new osg::MatrixTransform(toOsg(X_WB));
  const float opacity = mode == DisplayMode::SeeThrough ? static_cast<float>(kObstacleOpacity) : 1.0F;
  osg::ref_ptr<osg::Group> surface = pushedBackSurfaceOf(shape, withOpacity(colour, opacity));
  if (mode == DisplayMode::SeeThrough) makeTransparent(*surface);
  if (mode == DisplayMode::Wireframe) {
    surface->getOrCreateStateSet()->setAttribute(new osg::ColorMask(false, false, false, false));
  }
  transform->addChild(surface);
  transform->setUserData(mergeableOf(shape, *surface, mode, palette));
  if (mode == DisplayMode::Shaded) return transform;
  transform->addChild(edgesOf(shape, palette.lines, kEdgeWidth * palette.pixelScale));
  if (mode == DisplayMode::Wireframe) transform->addChild(hiddenEdgesOf(shape, palette));
  return transform;
}

osg::ref_ptr<osg::MatrixTransform> makeGhost(const BodyShape& shape, const Pose& X_WB, const osg::Vec4& colour,
                                             const ScenePalette& palette) {
  osg::ref_ptr<osg::MatrixTransform> transform = new osg::MatrixTransform(toOsg(X_WB));
  transform->addChild(ghostOf(shape, colour, palette));
  return transform;
}

osg::ref_ptr<osg::MatrixTransform> makeSeenGhost(const BodyShape& shape, const Pose& X_WB, const osg::Vec4& colour,
                                                 const ScenePalette& palette) {
  osg::ref_ptr<osg::MatrixTransform> transform = makeGhost(shape, X_WB, colour, palette);
  transform->addChild(hiddenSilhouetteOf(shape, colour, palette, kHiddenGhostFill));
  return transform;
}

osg::ref_ptr<osg::Group> makeGhosts(const BodyShape& shape, const std::vector<Pose>& poses, const osg::Vec4& colour,
                                    const ScenePalette& palette) {
  const double share = kPlainGhosts / std::max(kPlainGhosts, static_cast<double>(poses.size()));
  osg::Vec4 faded = colour;
  faded.a() *= static_cast<float>(std::max(kFaintestGhost, share));
  const osg::ref_ptr<osg::Group> ghost = ghostOf(shape, faded, palette);
  osg::ref_ptr<osg::Group> group = new osg::Group;
  for (const Pose& X_WB : poses) {
    osg::ref_ptr<osg::MatrixTransform> transform = new osg::MatrixTransform(toOsg(X_WB));
    transform->addChild(ghost);
    group->addChild(transform);
  }
  return group;
}

osg::ref_ptr<osg::MatrixTransform> makeHighlight(const BodyShape& shape, const Pose& X_WB, const osg::Vec4& colour,
                                                 const ScenePalette& palette) {
  osg::ref_ptr<osg::MatrixTransform> transform = new osg::MatrixTransform(toOsg(X_WB));
  // The skin is not pushed back, because it lies before the body's own surface.
  osg::ref_ptr<osg::Group> skin = surfaceOf(shape, withOpacity(colour, kHighlightFill));
  makeTransparent(*skin);
  transform->addChild(skin);
  transform->addChild(edgesOf(shape, colour, kHighlightEdges * palette.pixelScale));
  transform->addChild(hiddenSilhouetteOf(shape, colour, palette));
  return transform;
}

osg::ref_ptr<osg::MatrixTransform> makeMovedBody(const BodyShape& shape, const Pose& X_WB, const osg::Vec4& colour,
                                                 const ScenePalette& palette) {
  osg::ref_ptr<osg::MatrixTransform> transform = makeBody(shape, X_WB, colour, DisplayMode::ShadedWithEdges, palette);
  transform->getChild(0)->getOrCreateStateSet()->setRenderBinDetails(kMovedBodyBin, "RenderBin");
  transform->addChild(hiddenSilhouetteOf(shape, colour, palette));
  transform->addChild(haloOf(shape));
  makeMarking(*transform);
  return transform;
}

osg::Vec4 bodyColour(osg::MatrixTransform& body) { return coloursOf(*body.getChild(0)->asGroup())->front(); }

void setBodyColour(osg::MatrixTransform& body, const osg::Vec4& colour) {
  osg::Group* details = body.getChild(0)->asGroup();
  const auto geometryOf = [&](unsigned i) { return details->getChild(i)->asGeode()->getDrawable(0)->asGeometry(); };
  osg::Vec4Array* colours = coloursOf(*details);
  const osg::Vec4 tint(colour.r(), colour.g(), colour.b(), colours->front().a());
  if (colours->front() == tint) return;
  colours->front() = tint;
  colours->dirty();
  for (unsigned i = 0; i < details->getNumChildren(); ++i) geometryOf(i)->dirtyGLObjects();
}

}  // namespace glissade
