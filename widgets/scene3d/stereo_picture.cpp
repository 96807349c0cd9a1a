#include "widgets/scene3d/stereo_picture.h"

#include <QPainter>

namespace glissade {
namespace {

constexpr QRgb kRed = 0x00ff0000U;
constexpr QRgb kGreenAndBlue = 0x0000ffffU;
constexpr QRgb kOpaque = 0xff000000U;

/// Merges the pixels of both eyes.
template <class Merge>
QImage merged(const QImage& left, const QImage& right, Merge merge) {
  QImage picture(left.size(), QImage::Format_RGB32);
  for (int y = 0; y < picture.height(); ++y) {
    const auto* fromLeft = reinterpret_cast<const QRgb*>(left.constScanLine(y));
    const auto* fromRight = reinterpret_cast<const QRgb*>(right.constScanLine(y));
    auto* to = reinterpret_cast<QRgb*>(picture.scanLine(y));
    for (int x = 0; x < picture.width(); ++x) to[x] = merge(fromLeft[x], fromRight[x], x, y);
  }
  return picture;
}

QImage anaglyph(const QImage& left, const QImage& right) {
  return merged(left, right, [](QRgb l, QRgb r, int, int) { return kOpaque | (l & kRed) | (r & kGreenAndBlue); });
}

/// Takes the pixels of the left eye where `isLeft` is true for the column and the row of the screen.
template <class IsLeft>
QImage inTurn(const QImage& left, const QImage& right, const QPoint& corner, IsLeft isLeft) {
  return merged(left, right,
                [&](QRgb l, QRgb r, int x, int y) { return isLeft(corner.x() + x, corner.y() + y) ? l : r; });
}

QImage halves(const QImage& left, const QImage& right, const QSize& first, const QPoint& second) {
  QImage picture(left.size(), QImage::Format_RGB32);
  const QSize rest(second.x() == 0 ? first.width() : picture.width() - second.x(),
                   second.y() == 0 ? first.height() : picture.height() - second.y());
  QPainter painter(&picture);
  painter.drawImage(QPoint(), left.scaled(first, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
  painter.drawImage(second, right.scaled(rest, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
  return picture;
}

}  // namespace

QImage composeStereo(StereoMode mode, const QImage& left, const QImage& right, const QPoint& corner) {
  QImage l = left.convertToFormat(QImage::Format_RGB32);
  QImage r = right.convertToFormat(QImage::Format_RGB32);
  for (QImage* picture : {&l, &r}) picture->setDevicePixelRatio(1.0);
  const int halfWidth = (l.width() + 1) / 2;
  const int halfHeight = (l.height() + 1) / 2;
  switch (mode) {
    case StereoMode::Anaglyph: return anaglyph(l, r);
    case StereoMode::SideBySide: return halves(l, r, {halfWidth, l.height()}, {halfWidth, 0});
    case StereoMode::TopBottom: return halves(l, r, {l.width(), halfHeight}, {0, halfHeight});
    case StereoMode::Interlaced: return inTurn(l, r, corner, [](int, int y) { return y % 2 == 0; });
    case StereoMode::Checkerboard: return inTurn(l, r, corner, [](int x, int y) { return (x + y) % 2 == 0; });
    case StereoMode::RightEye: return r;
    case StereoMode::LeftEye:
    case StereoMode::Off:
    case StereoMode::QuadBuffer: break;
  }
  return l;
}

EyePoint eyePointAt(StereoMode mode, const QPointF& at, const QSizeF& size) {
  const bool isSecond = (mode == StereoMode::SideBySide && at.x() >= size.width() / 2.0) ||
                        (mode == StereoMode::TopBottom && at.y() >= size.height() / 2.0) ||
                        mode == StereoMode::RightEye;
  const Eye eye = isSecond ? Eye::Right : Eye::Left;
  return {eye, pointOfEye(mode, eye, at, size)};
}

QPointF pointOfEye(StereoMode mode, Eye eye, const QPointF& at, const QSizeF& size) {
  const double second = eye == Eye::Right ? 1.0 : 0.0;
  if (mode == StereoMode::SideBySide) return {2.0 * at.x() - second * size.width(), at.y()};
  if (mode == StereoMode::TopBottom) return {at.x(), 2.0 * at.y() - second * size.height()};
  return at;
}

}  // namespace glissade
