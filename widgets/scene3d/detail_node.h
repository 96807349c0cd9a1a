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
/// camera in device pixels. A tolerance of 0 draws the first child. A child stays until another one is better by a
/// quarter, so that bodies do not flicker between two.
class DetailNode : public osg::Group {
 public:
  /// The finest child first. Error in metres, more than that of the child before.
  void addDetail(osg::Node* child, double error);
  /// Calls `add` for each of these once they are made and a picture may be coarse. `details` may be null.
  void addLater(const std::shared_ptr<LateDetails>& details, std::function<void(const ShapeDetail&)> add);
  /// Its distance is that of this sphere, and not of its bound.
  void measureAt(const osg::BoundingSphere& sphere) { measured_ = sphere; }
  void traverse(osg::NodeVisitor& visitor) override;
  osg::BoundingSphere computeBound() const override;

 protected:
  /// What is about to be drawn, with the size of a metre on the screen in device pixels. False: nothing is.
  virtual bool prepare(unsigned detail, double pixelsPerMetre);

 private:
  unsigned coarsestWithin(double tolerance, double pixelsPerMetre) const;

  void addMade();

  std::shared_ptr<LateDetails> late_;  ///< null: nothing is to be added any more
  std::function<void(const ShapeDetail&)> add_;
  std::vector<double> errors_;
  std::optional<osg::BoundingSphere> measured_;
  unsigned drawn_ = 0;
};

/// Edges of a body. They fade where they would cover its faces, and are not drawn where little of them is left.
class FadingEdges final : public DetailNode {
 public:
  /// Each child's lines have this colour as a whole. Width in device pixels.
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
