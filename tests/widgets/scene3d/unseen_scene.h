#pragma once

#include <functional>

#include "widgets/scene3d/scene_widget.h"

namespace glissade::test {

/// A scene that is not drawn.
class UnseenScene final : public SceneWidget {
 public:
  /// `headset` may be null; it must outlive the scene.
  explicit UnseenScene(Headset* headset = nullptr) : headset_(headset) {}
  SceneView& view() override { return view_; }
  QWidget* widget() override { return &widget_; }
  void refresh() override {}
  QImage picture() override { return {}; }
  QImage picture(const QSize& /*pixels*/) override { return {}; }
  std::vector<QImage> picturesFrom(const std::vector<EyePlace>& eyePlaces) override {
    QImage picture(widget_.size(), QImage::Format_RGB32);
    picture.fill(Qt::black);
    return std::vector<QImage>(eyePlaces.size(), picture);
  }
  void setCovered(bool /*covered*/) override {}
  std::unique_ptr<QuadBuffer> makeQuadBuffer(QWidget* /*parent*/) override { return nullptr; }
  Headset* headset() override { return headset_; }
  void setNavigationStyle(NavigationStyle /*style*/) override {}
  void onCameraMoved(std::function<void()>) override {}

 private:
  Headset* headset_;
  SceneView view_;
  QWidget widget_;
};

}  // namespace glissade::test
