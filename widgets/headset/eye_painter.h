#pragma once

#include <osg/GraphicsContext>
#include <osgUtil/SceneView>

#include <cstdint>

#include "widgets/headset/eye_sight.h"
#include "widgets/headset/picture_rate.h"

namespace glissade {

/// What a graphics card is given for a picture of an eye.
struct EyeFigures {
  int drawCalls = 0;
  std::int64_t triangles = 0;
  double cullSeconds = 0.0;  ///< of the processor's choice of what is drawn
  double drawSeconds = 0.0;  ///< of OpenGL's calls; with software drawing, part of the drawing is in them
};

/// Draws what an eye sees into textures. Used on the thread of its context, while that is current.
class EyePainter {
 public:
  EyePainter(osg::GraphicsContext& context, osg::Node* scene);
  ~EyePainter();
  EyePainter(const EyePainter&) = delete;
  EyePainter& operator=(const EyePainter&) = delete;

  /// The size and OpenGL's format of the textures from now on.
  void setTarget(int width, int height, std::int64_t format);
  /// The graph's mutex is held.
  void draw(const EyeSight& sight, const EyeDetail& detail);
  /// What was drawn; waits for it where drawing is in software. The graph may change meanwhile.
  void copyTo(unsigned texture);
  /// Of the last picture. The graph's mutex is held.
  EyeFigures figures();

 private:
  void removeBuffers();
  void freeDeleted();

  osg::ref_ptr<osg::GraphicsContext> context_;
  osg::ref_ptr<osgUtil::SceneView> view_;
  int width_ = 0;
  int height_ = 0;
  unsigned smooth_ = 0;  ///< framebuffer of several samples for each pixel
  unsigned colour_ = 0;  ///< its buffers
  unsigned depth_ = 0;
  unsigned copied_ = 0;  ///< framebuffer of the texture
  double cullSeconds_ = 0.0;
  double drawSeconds_ = 0.0;
};

}  // namespace glissade
