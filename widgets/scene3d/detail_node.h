#pragma once

#include <osg/Array>
#include <osg/Group>
#include <osg/ref_ptr>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "widgets/scene3d/late_details.h"

namespace glissade {

/// Draws one of its children: the coarsest whose error is within the picture's tolerance, which is the LOD scale of the
/// camera in device pixels. A tolerance of 0 draws the first child. A finer child is replaced only when the coarser
/// one's error is below three quarters of the tolerance, so that bodies do not flicker between two.
class DetailNode : public osg::Group {
 public:
  /// Adds a child, the finest first. Its error in metres is greater than that of the child before.
  void addDetail(osg::Node* child, double error);
  /// Calls `add` for each of the details once they are made and a picture may be coarse. `details` may be null.
  void addLater(const std::shared_ptr<LateDetails>& details, std::function<void(const ShapeDetail&)> add);
  /// Measures the distance to this sphere instead of the bound.
  void measureAt(const osg::BoundingSphere& sphere) { measured_ = sphere; }
  void traverse(osg::NodeVisitor& visitor) override;
  osg::BoundingSphere computeBound() const override;

 protected:
  /// Prepares the child that is drawn next, with the size of a metre on the screen in device pixels. False if nothing
  /// is to be drawn.
  virtual bool prepare(unsigned detail, double pixelsPerMetre);

 private:
  unsigned coarsestWithin(double tolerance, double pixelsPerMetre) const;

  void addMade();

  std::shared_ptr<LateDetails> late_;  ///< null: no more details will be added
  std::function<void(const ShapeDetail&)> add_;
  std::vector<double> errors_;
  std::optional<osg::BoundingSphere> measured_;
  unsigned drawn_ = 0;
};

/// Edges of a body. They fade if they would cover its faces, and are not drawn if they have faded too far.
class FadingEdges final : public DetailNode {
 public:
  /// All lines have this colour. `width`: device pixels.
  FadingEdges(const osg::ref_ptr<osg::Vec4Array>& colour, double width);
  /// `density`: metres of edges for each square metre of faces.
  void addEdges(osg::Node* lines, double error, double density);

 private:
  bool prepare(unsigned detail, double pixelsPerMetre) override;

  osg::ref_ptr<osg::Vec4Array> colour_;
  float opacity_;
  double width_;
  std::vector<double> densities_;
};

}  // namespace glissade
