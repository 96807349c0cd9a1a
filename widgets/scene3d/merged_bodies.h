#pragma once

#include <osg/Group>
#include <osg/MatrixTransform>
#include <osg/ref_ptr>

#include <vector>

#include "widgets/scene3d/mergeable_body.h"

namespace glissade {

/// Bodies, each with its transform. A headset draws neighbours that do not move as one, because a thousand bodies are
/// thousands of draw calls, and its pictures have no time for them. A window draws each of them. Children are added and
/// changed as in any group.
class MergedBodies final : public osg::Group {
 public:
  /// Pictures of an eye without a change of a cell before its bodies are merged.
  static constexpr int kStill = 20;
  /// Fewer bodies are never merged.
  static constexpr std::size_t kFewest = 50;
  /// Largest number of bodies that are drawn as one.
  static constexpr std::size_t kTogether = 32;

  void traverse(osg::NodeVisitor& visitor) override;
  bool setChild(unsigned place, osg::Node* body) override;
  void releaseGLObjects(osg::State* state) const override;
  void resizeGLObjectBuffers(unsigned size) override;

 private:
  /// The properties of a body that can change while the group contains it.
  struct Seen {
    osg::Matrix X_WB;
    osg::Vec4 colour;
    NodeMask mask = 0;

    bool operator==(const Seen&) const = default;
  };
  struct Cell {
    std::vector<osg::MatrixTransform*> bodies;
    std::vector<Seen> seen;
    int stillFor = 0;                 ///< pictures without a change
    osg::ref_ptr<osg::Group> merged;  ///< null: each body is drawn alone
  };

  void childInserted(unsigned place) override;
  void childRemoved(unsigned place, unsigned number) override;
  void divide();
  void divide(std::vector<osg::MatrixTransform*> bodies);
  void look(Cell& cell);
  static osg::ref_ptr<osg::Group> merge(const Cell& cell);

  bool isDivided_ = false;
  std::vector<osg::Node*> single_;  ///< children that are never merged
  std::vector<Cell> cells_;
  bool mayMerge_ = false;  ///< limits merging to one cell for each picture, so that no picture is late
};

}  // namespace glissade
