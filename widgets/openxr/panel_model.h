#pragma once

#include <osg/Image>
#include <osg/MatrixTransform>
#include <osg/Texture2D>
#include <osg/ref_ptr>

#include "widgets/openxr/shown_hands.h"

namespace glissade {

/// A flat picture in the scene, visible from its front only. A new picture is uploaded to the graphics card.
class PanelModel {
 public:
  /// Render bin of the panel, after all bins of the scene, also after those of things that show through bodies. Nearer
  /// things hide the panel.
  static constexpr int kBin = 1000;

  enum class Kind {
    Panel,  ///< opaque, and hidden by nearer things
    Text    ///< drawn over everything but the panel
  };

  explicit PanelModel(Kind kind);

  osg::Node* node() const { return placed_; }
  /// Shows the picture from the next drawing on. `metre`: length of a metre of the room in the world.
  void show(const ShownPicture& shown, double metre);

 private:
  osg::ref_ptr<osg::MatrixTransform> placed_;
  osg::ref_ptr<osg::Texture2D> texture_;
  FlatPicturePtr picture_;  ///< the picture in the texture
};

}  // namespace glissade
