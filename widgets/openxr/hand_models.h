#pragma once

#include <osg/Group>
#include <osg/MatrixTransform>
#include <osg/ref_ptr>

#include <array>

#include "widgets/openxr/shown_hands.h"

namespace glissade {

/// Models of the controllers: a handle in each hand, and a ray from it. A ray that meets the object ends in a ball; a
/// squeeze then takes the object. A hand that holds the object has another colour, and no ray. A disc on the floor
/// marks the place where the person would stand.
class HandModels {
 public:
  /// Length of a ray that meets nothing, metres of the room.
  static constexpr double kRayLength = 1.0;

  HandModels();

  osg::Node* node() const { return group_; }
  /// Shows the hands, before a picture.
  void show(const ShownHands& hands);

 private:
  struct Model {
    osg::ref_ptr<osg::MatrixTransform> grip;
    osg::ref_ptr<osg::Node> open;    ///< the handle of a hand that holds nothing
    osg::ref_ptr<osg::Node> closed;  ///< the handle of a hand that holds the object
    osg::ref_ptr<osg::MatrixTransform> ray;
    osg::ref_ptr<osg::MatrixTransform> hit;
  };

  static Model makeModel();
  static void show(const Model& model, const ShownController& controller);

  osg::ref_ptr<osg::Group> group_;
  std::array<Model, 2> models_;
  osg::ref_ptr<osg::MatrixTransform> target_;
};

}  // namespace glissade
