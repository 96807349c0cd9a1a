#pragma once

#include <osg/Group>
#include <osg/MatrixTransform>
#include <osg/ref_ptr>

#include <vector>

#include "widgets/scene3d/mergeable_body.h"

namespace glissade {

/// Bodies, a transform each. A headset draws neighbours that stand still as one, because a thousand bodies are
/// thousands of draw calls, and its pictures have no time for them. A window draws each of them. Children are added and
/// changed as those of any group.
class MergedBodies final : public osg::Group {
 public:
  /// Pictures of an eye in which nothing of them changes, before bodies are merged.
  static constexpr int kStill = 20;
  /// Fewer bodies stay as they are.
  static constexpr std::size_t kFewest = 50;
  /// Bodies that are drawn as one.
  static constexpr std::size_t kTogether = 32;

  void traverse(osg::NodeVisitor& visitor) override;
  bool setChild(unsigned place, osg::Node* body) override;
  void releaseGLObjects(osg::State* state) const override;
  void resizeGLObjectBuffers(unsigned size) override;

 private:
  /// What of a body can change while the group has it.
  struct Seen {
    osg::Matrix X_WB;
    osg::Vec4 colour;
    NodeMask mask = 0;

    bool operator==(const Seen&) const = default;
  };
  struct Cell {
    std::vector<osg::MatrixTransform*> bodies;
    std::vector<Seen> seen;
    int stillFor = 0;                 ///< pictures
    osg::ref_ptr<osg::Group> merged;  ///< null: each is drawn
  };

  void childInserted(unsigned place) override;
  void childRemoved(unsigned place, unsigned number) override;
  void divide();
  void divide(std::vector<osg::MatrixTransform*> bodies);
  void look(Cell& cell);
  static osg::ref_ptr<osg::Group> merge(const Cell& cell);

  bool isDivided_ = false;
  std::vector<osg::Node*> single_;  ///< those that are never merged
  std::vector<Cell> cells_;
  bool mayMerge_ = false;  ///< one cell a picture, so that no picture is late
};

}  // namespace glissade
