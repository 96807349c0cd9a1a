#pragma once

#include <osg/Image>
#include <osg/MatrixTransform>
#include <osg/Texture2D>
#include <osg/ref_ptr>

#include "widgets/headset/shown_hands.h"

namespace glissade {

/// A flat picture in the scene, seen from its front only. It is given to the graphics card when it is another one.
class PanelModel {
 public:
  /// It is drawn after everything in the bins before, also after what shows through bodies. What is nearer hides it.
  static constexpr int kBin = 1000;

  enum class Kind {
    Panel,  ///< opaque, and hidden by what is nearer
    Text    ///< over everything but the panel
  };

  explicit PanelModel(Kind kind);

  osg::Node* node() const { return placed_; }
  /// Before a picture. `metre`: so much is a metre of the room in the world.
  void show(const ShownPicture& shown, double metre);

 private:
  osg::ref_ptr<osg::MatrixTransform> placed_;
  osg::ref_ptr<osg::Texture2D> texture_;
  FlatPicturePtr picture_;  ///< of the texture
};

}  // namespace glissade
