#pragma once

#include <osg/GraphicsContext>
#include <osgUtil/SceneView>

#include <cstdint>

#include "widgets/openxr/eye_sight.h"
#include "widgets/openxr/picture_rate.h"

namespace glissade {

/// Amount of work for a picture of an eye.
struct EyeFigures {
  int drawCalls = 0;
  std::int64_t triangles = 0;
  double cullSeconds = 0.0;  ///< time in which the processor selects what to draw
  double drawSeconds = 0.0;  ///< time of OpenGL's calls; software drawing does a part of its work in them
};

/// Draws the view of an eye into textures. Used on the thread of its context, while the context is current.
class EyePainter {
 public:
  EyePainter(osg::GraphicsContext& context, osg::Node* scene);
  ~EyePainter();
  EyePainter(const EyePainter&) = delete;
  EyePainter& operator=(const EyePainter&) = delete;

  /// Sets the size and OpenGL's format of the textures from now on.
  void setTarget(int width, int height, std::int64_t format);
  /// Draws the picture. Precondition: the caller holds the graph's mutex.
  void draw(const EyeSight& sight, const EyeDetail& detail);
  /// Copies the picture into the texture, and waits for software drawing. The graph may change meanwhile.
  void copyTo(unsigned texture);
  /// Figures of the last picture. Precondition: the caller holds the graph's mutex.
  EyeFigures figures();

 private:
  void removeBuffers();
  void freeDeleted();

  osg::ref_ptr<osg::GraphicsContext> context_;
  osg::ref_ptr<osgUtil::SceneView> view_;
  int width_ = 0;
  int height_ = 0;
  unsigned smooth_ = 0;  ///< framebuffer of several samples for each pixel
  unsigned colour_ = 0;  ///< buffers of `smooth_`
  unsigned depth_ = 0;
  unsigned copied_ = 0;  ///< framebuffer of the texture
  double cullSeconds_ = 0.0;
  double drawSeconds_ = 0.0;
};

}  // namespace glissade
