#pragma once

#include <optional>

#include "engine/geometry/pose.h"

namespace glissade {

/// Standard views, looking along an axis of the world (z up) or from a corner.
enum class StandardView { Front, Back, Left, Right, Top, Bottom, Isometric };

/// The viewpoint of a camera.
struct CameraPose {
  Vector3 focus = Vector3::Zero();
  Quaternion R_WV = Quaternion::Identity();
  double distance = 1.0;  ///< from the eye to the focus
  bool orthographic = false;
};

/// The place of an eye that is not straight before the middle of the picture: one of two eyes, or a head that moves
/// before the screen. In heights of the picture: x right, y up, z from the picture to the person.
struct EyePlace {
  Vector3 head = Vector3::Zero();  ///< the middle between the eyes, from straight before the middle of the picture
  Vector3 eye = Vector3::Zero();   ///< the eye, from the middle between the eyes
  /// The picture is a window in the scene, in the plane of the view through this point, or through the focus if there
  /// is none.
  std::optional<Vector3> plane_W = std::nullopt;
};

/// A camera that orbits a focus, as CAD users expect: drag left to orbit, middle (or Shift+left) to pan, wheel to zoom
/// about the pointer. It is plain geometry, without OSG and Qt.
class CameraController {
 public:
  /// Brings the whole box into view and keeps the direction. The box stays in view for each shape of the view, until
  /// the camera is moved.
  void fit(const Box3& box);
  /// Shows the box in the middle of the view, as large as possible; the fitted box stays the same. `coveredBelow`:
  /// share of the view's height, at its lower border, that something else covers.
  void zoomTo(const Box3& box, double coveredBelow = 0.0);
  void setStandardView(StandardView view);
  /// Looks at the focus from this direction (not zero), with a level horizon.
  void lookFrom(const Vector3& towardsEye);
  /// The pose with the distance for the usual field of view, so that it does not depend on the person's screen.
  CameraPose pose() const;
  void setPose(const CameraPose& pose);
  /// Sets the angle in radians, between 0 and pi; the view's height at the focus stays.
  void setFieldOfView(double vertical);
  static double usualFieldOfView();
  /// Sets the height of the view at the focus, metres.
  void setViewHeight(double metres);
  void setEyePlace(const EyePlace& eyePlace) { eyePlace_ = eyePlace; }
  const EyePlace& eyePlace() const { return eyePlace_; }
  /// Switches perspective off: parallel lines stay parallel, lengths across the view are to scale everywhere.
  void setOrthographic(bool orthographic);
  bool isOrthographic() const { return orthographic_; }
  /// Whether the camera was not moved since the last fit, so that the whole fitted box is in view.
  bool isFitted() const { return fitted_.has_value(); }
  /// Near and far plane enclose this box, too; the view stays.
  void enclose(const Box3& box);
  /// Turns the camera by a motion (dx, dy) of the pointer, as fractions of the view's height, y down.
  void orbit(double dx, double dy);
  /// Turns as orbit() does, but about the view's own axes: the horizon does not stay level.
  void tumble(double dx, double dy);
  /// Turns the picture clockwise about the line of sight, radians; standard views level it again.
  void roll(double angle);
  void pan(double dx, double dy);
  /// Comes nearer if factor > 1; (x, y) is the pointer, in fractions of the height from the centre, y down.
  void zoom(double factor, double x = 0.0, double y = 0.0);
  /// Follows a point that moves from one place to another: the eye moves with it, and the focus comes nearer to it, so
  /// that a point at the side is in the middle after some pictures.
  void follow(const Vector3& from, const Vector3& to);
  void setAspect(double widthOverHeight);

  /// Orientation of the view frame V: x right, y up, z from the scene to the eye.
  Quaternion R_WV() const;
  /// The eye at the place that was set.
  Vector3 eye() const;
  Vector3 focus() const { return focus_; }
  double distance() const { return distance_; }
  double verticalFieldOfView() const { return fieldOfView_; }  ///< radians, from straight before the picture
  /// Height of the view at the focus, metres.
  double viewHeight() const;
  /// Height of the view in its plane through a point, metres. For a point at the eye or behind it, the height at the
  /// near plane is returned.
  double viewHeightAt(const Vector3& p_W) const;
  double aspect() const { return aspect_; }
  /// Size of things in the picture, as a multiple of their size for an eye straight before the picture at the usual
  /// distance.
  double magnification() const;
  /// Shift of the picture against that of an eye straight before it, in heights of the picture; without perspective for
  /// each metre of depth from the eye. x right, y up.
  Eigen::Vector2d shift() const;
  /// Distances of the planes that enclose the fitted box from the present eye; an orthographic near plane may lie
  /// behind the eye.
  double nearPlane() const;
  double farPlane() const;
  /// The place of a point in the picture: x to the right and y down, in fractions of the view's height from its centre.
  /// Nothing if the point is before the near plane or behind the eye.
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
  std::optional<Box3> fitted_;  ///< box that is kept in view; nothing once the camera was moved
};

}  // namespace glissade
