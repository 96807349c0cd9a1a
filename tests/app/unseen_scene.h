#pragma once

#include <functional>

#include "widgets/scene3d/scene_widget.h"

namespace glissade::test {

/// A scene that nobody draws.
class UnseenScene final : public SceneWidget {
 public:
  SceneView& view() override { return view_; }
  QWidget* widget() override { return &widget_; }
  void refresh() override {}
  QImage picture() override { return {}; }
  QImage picture(const QSize& /*pixels*/) override { return {}; }
  void setNavigationStyle(NavigationStyle /*style*/) override {}
  void onCameraMoved(std::function<void()>) override {}

 private:
  SceneView view_;
  QWidget widget_;
};

}  // namespace glissade::test
