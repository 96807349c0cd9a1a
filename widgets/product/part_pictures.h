#pragma once

#include <QIcon>
#include <QImage>
#include <QObject>

#include <array>
#include <map>
#include <tuple>

#include "widgets/document/sequence_planner.h"

namespace glissade {

/// A small picture of a body in its pose in the product, from a corner above, on a transparent background. The
/// processor draws it without OpenGL, so that any thread can call this. `pixels`: width and height.
QImage partPicture(const RigidBody& body, int pixels);

/// The icon of a picture, which is not tinted if its row is selected.
QIcon iconOf(const QImage& picture);

/// Pictures of the bodies of a product, drawn on a worker and cached. Bodies with the same mesh, orientation and colour
/// share one.
class PartPictures final : public QObject {
  Q_OBJECT

 public:
  explicit PartPictures(QObject* parent = nullptr) : QObject(parent) {}

  /// Draws missing pictures; drawn() announces them. `atOnce`: they are drawn before this function returns. `pixels`:
  /// width and height.
  void draw(const ProductPtr& product, int pixels, bool atOnce);
  /// Empty if it is not drawn yet.
  QIcon of(const RigidBody& body) const;

 signals:
  void drawn();

 private:
  using Key = std::tuple<MeshPtr, std::array<double, 4>, Colour>;
  static Key keyOf(const RigidBody& body);

  std::map<Key, QIcon> icons_;
  BackgroundTask task_;
};

}  // namespace glissade
