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

/// The two trees, growing: segments live in preallocated chunks of which only the last is uploaded
/// again; operator and contact nodes are points besides. Lines and points fade where they would cover much of what lies
/// behind them, the older ones first.
class RoadmapLayer {
 public:
  /// What is drawn of the trees.
  struct Content {
    bool startTree = false;
    bool goalTree = false;
    bool operatorNodes = false;
    bool contactNodes = false;
  };

  RoadmapLayer();

  osg::Group* node() const { return root_; }
  void setPalette(const ScenePalette& palette);
  /// Takes in what is new; another run begins anew, and so does one that is shown at an earlier step.
  void update(const SessionSnapshot& snapshot);
  void clear();
  /// Faint lines: something else is the picture.
  void setFaded(bool faded);

  /// The scale of the next picture: lines have a width in pixels.
  void setScale(double pixelsPerMetre);

  const Content& content() const { return content_; }
  std::size_t segments() const { return segmentsDrawn_; }
  /// 1: these lines cover what is behind them; 0: they are not drawn. Batches are ordered by age, the oldest first.
  std::vector<float> opacities() const { return opacitiesOf(lines_); }
  /// The same of the points.
  std::vector<float> pointOpacities() const { return opacitiesOf(points_); }
  /// How many chunk uploads there have been: grows with what is new, not with what is there.
  std::size_t uploads() const { return uploads_; }

 private:
  /// A preallocated geometry that fills up.
  struct Batch {
    osg::ref_ptr<osg::Geometry> geometry;
    osg::ref_ptr<osg::Vec3Array> vertices;
    osg::ref_ptr<osg::Vec4ubArray> colours;
    osg::ref_ptr<osg::DrawArrays> range;
    int used = 0;
    double length = 0.0;  ///< of the lines, metres
    float opacity = 1.0F;
  };

  bool isPrefixOf(const SessionSnapshot& snapshot) const;
  void takeNode(const RoadmapNode& node);
  void takeEdge(const RoadmapEdge& edge);
  void drop(const RoadmapEdge& edge);
  void fade();
  /// `pixelsOf` a batch: what its lines or points cover, were they side by side.
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
  std::size_t chunksTaken_ = 0;  ///< whole ones, and what they held:
  std::size_t nodesBefore_ = 0;
  std::size_t edgesBefore_ = 0;
  std::size_t droppedTaken_ = 0;
  std::size_t segmentsDrawn_ = 0;
  std::size_t uploads_ = 0;
  bool faded_ = false;
  double pixelsPerMetre_ = 0.0;             ///< 0: not known yet
  Box3 box_;                                ///< of the nodes
  Vector3 sum_ = Vector3::Zero();           ///< of the nodes' positions, metres
  Vector3 sumOfSquares_ = Vector3::Zero();  ///< of each coordinate
  Content content_;
  std::vector<RoadmapNode> nodes_;
  std::vector<RoadmapEdge> edges_;  ///< in the order drawn
  std::vector<Batch> lines_;
  std::vector<Batch> points_;
};

}  // namespace glissade
