#pragma once

#include <osg/Geode>
#include <osg/Geometry>
#include <osg/Group>
#include <osg/ref_ptr>
#include <vector>

#include "engine/session/session.h"
#include "widgets/scene3d/palette.h"

namespace glissade {

/// The two trees, growing: segments live in preallocated chunks of which only the last is uploaded
/// again; operator and contact nodes are points besides.
class RoadmapLayer {
 public:
  RoadmapLayer();

  osg::Group* node() const { return root_; }
  void setPalette(const ScenePalette& palette);
  /// Takes in what is new; another run begins anew, and so does one that is shown at an earlier step.
  void update(const SessionSnapshot& snapshot);
  void clear();
  /// Faint lines: something else is the picture.
  void setFaded(bool faded);

  std::size_t segments() const { return segmentsDrawn_; }
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
  };

  bool isPrefixOf(const SessionSnapshot& snapshot) const;
  void takeNode(const RoadmapNode& node);
  void takeEdge(const RoadmapEdge& edge);
  void drop(const RoadmapEdge& edge);
  void fade();
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
  float opacity_ = 1.0F;  ///< of the lines
  bool faded_ = false;
  std::vector<RoadmapNode> nodes_;
  std::vector<RoadmapEdge> edges_;  ///< in the order drawn
  std::vector<Batch> lines_;
  std::vector<Batch> points_;
};

}  // namespace glissade
