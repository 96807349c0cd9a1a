#pragma once

#include <osg/Geode>
#include <osg/Geometry>
#include <osg/Group>
#include <osg/ref_ptr>

#include <functional>
#include <vector>

#include "engine/session/session.h"
#include "widgets/scene3d/palette.h"

namespace glissade {

/// The two growing trees. Segments are in preallocated chunks, of which only the last one is uploaded again; operator
/// and contact nodes are also drawn as points. Lines and points fade if they would cover much of the scene behind them,
/// the older ones first.
class RoadmapLayer {
 public:
  /// The parts of the trees that are drawn.
  struct Content {
    bool startTree = false;
    bool goalTree = false;
    bool operatorNodes = false;
    bool contactNodes = false;
  };

  RoadmapLayer();

  osg::Group* node() const { return root_; }
  void setPalette(const ScenePalette& palette);
  /// Draws new nodes and edges. It begins anew for another run, and for an earlier step of a replay.
  void update(const SessionSnapshot& snapshot);
  void clear();
  /// Draws faint lines, because the path is the main content.
  void setFaded(bool faded);

  /// Sets the scale of the next picture, because lines have a width in pixels.
  void setScale(double pixelsPerMetre);

  const Content& content() const { return content_; }
  std::size_t segments() const { return segmentsDrawn_; }
  /// Opacities of the batches of lines: 1 hides the scene behind them, 0 is not drawn. Batches are ordered by age, the
  /// oldest first.
  std::vector<float> opacities() const { return opacitiesOf(lines_); }
  /// Opacities of the batches of points.
  std::vector<float> pointOpacities() const { return opacitiesOf(points_); }
  /// Number of chunk uploads, which grows with new nodes and edges only.
  std::size_t uploads() const { return uploads_; }

 private:
  /// A preallocated geometry that fills up.
  struct Batch {
    osg::ref_ptr<osg::Geometry> geometry;
    osg::ref_ptr<osg::Vec3Array> vertices;
    osg::ref_ptr<osg::Vec4ubArray> colours;
    osg::ref_ptr<osg::DrawArrays> range;
    int used = 0;
    double length = 0.0;  ///< total length of the lines, metres
    float opacity = 1.0F;
  };

  bool isPrefixOf(const SessionSnapshot& snapshot) const;
  void takeNode(const RoadmapNode& node);
  void takeEdge(const RoadmapEdge& edge);
  void drop(const RoadmapEdge& edge);
  void fade();
  /// `pixelsOf` a batch: the area of its lines or points if they did not overlap.
  void fade(std::vector<Batch>& batches, const std::function<double(const Batch&)>& pixelsOf);
  double pixelsOfTrees() const;
  static std::vector<float> opacitiesOf(const std::vector<Batch>& batches);
  static void setOpacity(Batch& batch, float opacity);
  void addVertex(std::vector<Batch>& batches, GLenum mode, const Vector3& position, const osg::Vec4ub& colour);
  Batch makeBatch(GLenum mode);

  osg::ref_ptr<osg::Group> root_;
  osg::ref_ptr<osg::Geode> geode_;
  ScenePalette palette_;
  std::uint64_t run_ = 0;
  std::size_t chunksTaken_ = 0;  ///< number of chunks that are complete
  std::size_t nodesBefore_ = 0;
  std::size_t edgesBefore_ = 0;
  std::size_t droppedTaken_ = 0;
  std::size_t segmentsDrawn_ = 0;
  std::size_t uploads_ = 0;
  bool faded_ = false;
  double pixelsPerMetre_ = 0.0;             ///< 0: not known yet
  Box3 box_;                                ///< box of the nodes
  Vector3 sum_ = Vector3::Zero();           ///< sum of the nodes' positions, metres
  Vector3 sumOfSquares_ = Vector3::Zero();  ///< sum of squares for each coordinate
  Content content_;
  std::vector<RoadmapNode> nodes_;
  std::vector<RoadmapEdge> edges_;  ///< in the order of drawing
  std::vector<Batch> lines_;
  std::vector<Batch> points_;
};

}  // namespace glissade
