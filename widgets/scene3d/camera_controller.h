#pragma once

#include <optional>

#include "engine/geometry/pose.h"

namespace glissade {

/// Standard views, looking along an axis of the world (z up) or from a corner.
enum class StandardView { Front, Back, Left, Right, Top, Bottom, Isometric };

/// From where something is looked at.
struct CameraPose {
  Vector3 focus = Vector3::Zero();
  Quaternion R_WV = Quaternion::Identity();
  double distance = 1.0;  ///< from the eye to the focus
  bool orthographic = false;
};

/// From where the picture is seen, where it is not from straight before its middle: by one of two eyes, or by a head
/// that moves before the screen. In heights of the picture: x right, y up, z from the picture to the person.
struct EyePlace {
  Vector3 head = Vector3::Zero();  ///< the middle between the eyes, from straight before the middle of the picture
  Vector3 eye = Vector3::Zero();   ///< the eye, from the middle between the eyes
  /// The picture is a window in the scene, in the plane of the view through this point, or through the focus.
  std::optional<Vector3> plane_W = std::nullopt;
};

/// A camera that orbits a focus, as CAD users expect: drag left to orbit, middle (or Shift+left) to
/// pan, wheel to zoom about the pointer. Plain geometry, no OSG, no Qt.
class CameraController {
 public:
  /// The whole box in view, direction kept; until the camera is moved it stays so whatever shape the view takes.
  void fit(const Box3& box);
  /// The box in the middle of the view, as large as it can be; what is fitted stays what it was.
  void zoomTo(const Box3& box);
  void setStandardView(StandardView view);
  /// Looks at the focus from this direction (not zero), the horizon level.
  void lookFrom(const Vector3& towardsEye);
  /// The distance is that of the usual field of view: what is seen does not depend on the person's screen.
  CameraPose pose() const;
  void setPose(const CameraPose& pose);
  /// Radians, between 0 and pi; the view's height at the focus stays.
  void setFieldOfView(double vertical);
  static double usualFieldOfView();
  /// Metres that the view's height measures at the focus.
  void setViewHeight(double metres);
  void setEyePlace(const EyePlace& eyePlace) { eyePlace_ = eyePlace; }
  const EyePlace& eyePlace() const { return eyePlace_; }
  /// Without perspective: parallel lines stay parallel, lengths across the view are to scale everywhere.
  void setOrthographic(bool orthographic);
  bool isOrthographic() const { return orthographic_; }
  /// It shows the whole of what was fitted last: it was not moved since then.
  bool isFitted() const { return fitted_.has_value(); }
  /// Near and far plane enclose this box, too; what is looked at stays.
  void enclose(const Box3& box);
  /// Pointer moved by (dx, dy), as fractions of the view's height, y down.
  void orbit(double dx, double dy);
  /// The same about the view's own axes: the horizon does not stay level.
  void tumble(double dx, double dy);
  /// Turns the picture clockwise about the line of sight, radians; standard views level it again.
  void roll(double angle);
  void pan(double dx, double dy);
  /// factor > 1 comes nearer; (x, y) is the pointer, in fractions of the height from the centre, y down.
  void zoom(double factor, double x = 0.0, double y = 0.0);
  /// A point that is looked after went from one place to another: the eye goes with it, and the focus comes nearer to
  /// it, so that a point at the side is in the middle after some pictures.
  void follow(const Vector3& from, const Vector3& to);
  void setAspect(double widthOverHeight);

  /// Orientation of the view frame V: x right, y up, z from the scene to the eye.
  Quaternion R_WV() const;
  /// Of the place that was set.
  Vector3 eye() const;
  Vector3 focus() const { return focus_; }
  double distance() const { return distance_; }
  double verticalFieldOfView() const { return fieldOfView_; }  ///< radians, from straight before the picture
  /// What the view's height measures at the focus, metres.
  double viewHeight() const;
  /// The same in the plane of the view through a point, metres; at the eye and behind it that of the near plane.
  double viewHeightAt(const Vector3& p_W) const;
  double aspect() const { return aspect_; }
  /// The size of things in the picture, by that which they have for an eye that is straight before it and is not nearer
  /// or farther.
  double magnification() const;
  /// How far the picture is shifted against one of an eye straight before it, in heights of the picture; without
  /// perspective for each metre of depth from the eye. x right, y up.
  Eigen::Vector2d shift() const;
  /// Near and far plane that enclose the fitted box from where the eye is now; an orthographic near plane may lie
  /// behind the eye.
  double nearPlane() const;
  double farPlane() const;
  /// Where a point is drawn: x to the right and y down, in fractions of the view's height from its centre. Nothing
  /// behind the near plane.
  std::optional<Eigen::Vector2d> project(const Vector3& p_W) const;

 private:
  void showFitted();
  double distanceFor(const Box3& box) const;
  double toCentre() const;
  Vector3 middleEye() const;
  double pictureDistance() const;
  double pictureHeight() const;
  Vector3 eyeOffset() const;

  Vector3 focus_ = Vector3::Zero();
  Quaternion orientation_ = Quaternion::Identity();
  double distance_ = 10.0;
  double fieldOfView_ = usualFieldOfView();
  EyePlace eyePlace_;
  double sceneRadius_ = 5.0;
  Vector3 sceneCentre_ = Vector3::Zero();
  double aspect_ = 16.0 / 9.0;
  bool orthographic_ = false;
  std::optional<Box3> fitted_;  ///< what is kept in view; nothing once the camera was moved
};

}  // namespace glissade
