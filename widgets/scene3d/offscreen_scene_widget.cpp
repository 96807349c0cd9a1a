#include <QPaintEvent>
#include <QPainter>

#include "widgets/scene3d/camera_controller.h"
#include "widgets/scene3d/mouse_navigation.h"
#include "widgets/scene3d/offscreen_context.h"
#include "widgets/scene3d/scene_renderer.h"
#include "widgets/scene3d/scene_widget.h"

namespace glissade {
namespace {

/// Factor of smoothing: pictures are rendered larger by this factor, then scaled down.
constexpr int kOversampling = 2;

class OffscreenSceneWidget final : public QWidget, public SceneWidget {
 public:
  explicit OffscreenSceneWidget(QWidget* parent) : QWidget(parent), context_(makeOsMesaContext()), renderer_(view_) {
    view_.setPixelScale(kOversampling);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
  }

  SceneView& view() override { return view_; }
  QWidget* widget() override { return this; }
  /// The scene is drawn when a picture of it is taken, because nobody sees the window.
  void refresh() override { stale_ = true; }
  QImage picture() override {
    if (stale_ || image_.size() != size()) {
      image_ = draw(size());
      stale_ = false;
    }
    return image_;
  }
  QImage picture(const QSize& pixels) override {
    const EyePlace before = view_.camera().eyePlace();
    view_.camera().setEyePlace({});
    QImage image = draw(pixels);
    view_.camera().setEyePlace(before);
    return image;
  }
  std::vector<QImage> picturesFrom(const std::vector<EyePlace>& eyePlaces) override {
    const EyePlace before = view_.camera().eyePlace();
    std::vector<QImage> pictures;
    for (const EyePlace& eyePlace : eyePlaces) {
      view_.camera().setEyePlace(eyePlace);
      pictures.push_back(draw(size()));
    }
    view_.camera().setEyePlace(before);
    covering_ = pictures.back();
    return pictures;
  }
  void setCovered(bool covered) override { covered_ = covered; }
  std::unique_ptr<QuadBuffer> makeQuadBuffer(QWidget* /*parent*/) override { return nullptr; }
  Headset* headset() override { return nullptr; }
  void setNavigationStyle(NavigationStyle style) override { mouse_.setStyle(style); }
  void onCameraMoved(std::function<void()> callback) override { cameraMoved_ = std::move(callback); }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override { QPainter(this).drawImage(0, 0, covered_ ? covering_ : picture()); }
  void resizeEvent(QResizeEvent* /*event*/) override {
    view_.camera().setAspect(double(width()) / std::max(1, height()));
  }

  void mousePressEvent(QMouseEvent* event) override { mouse_.press(*event); }
  void mouseMoveEvent(QMouseEvent* event) override { moved(mouse_.move(*event, *this, view_)); }
  void mouseDoubleClickEvent(QMouseEvent* /*event*/) override { moved(mouse_.doubleClick(view_)); }
  void wheelEvent(QWheelEvent* event) override { moved(mouse_.wheel(*event, *this, view_)); }

 private:
  QImage draw(const QSize& pixels) {
    const CameraController before = view_.camera();
    const QSize rendered = pixels.expandedTo(QSize(1, 1)) * kOversampling;
    context_->makeCurrent(rendered.width(), rendered.height());
    renderer_.resize(rendered.width(), rendered.height());
    renderer_.render(0);
    view_.camera() = before;
    return context_->read().scaled(pixels, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  }

  void moved(bool camera) {
    if (!camera) return;
    if (cameraMoved_) cameraMoved_();
    refresh();
  }

  std::unique_ptr<OffscreenContext> context_;
  SceneView view_;
  SceneRenderer renderer_;
  MouseNavigation mouse_;
  QImage image_;
  bool stale_ = true;
  bool covered_ = false;
  QImage covering_;  ///< last picture given to the covering widget
  std::function<void()> cameraMoved_;
};

}  // namespace

std::unique_ptr<SceneWidget> makeOffscreenSceneWidget(QWidget* parent) {
  return std::make_unique<OffscreenSceneWidget>(parent);
}

}  // namespace glissade
