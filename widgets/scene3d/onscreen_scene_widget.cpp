#include <QElapsedTimer>
#include <QOpenGLFramebufferObject>
#include <QOpenGLWidget>
#include <QTimer>
#include <utility>

#include "widgets/openxr/openxr_headset.h"
#include "widgets/scene3d/camera_controller.h"
#include "widgets/scene3d/detail_control.h"
#include "widgets/scene3d/mouse_navigation.h"
#include "widgets/scene3d/scene_renderer.h"
#include "widgets/scene3d/scene_widget.h"

namespace glissade {
namespace {

constexpr int kSamples = 4;  ///< samples of a pixel, against jagged edges
/// Milliseconds after a picture at which a finer one is drawn, unless something changes.
constexpr int kRefineAfter = 150;

/// A framebuffer with depth. Precondition: the context is current.
std::unique_ptr<QOpenGLFramebufferObject> makeBuffer(const QSize& size, int samples) {
  QOpenGLFramebufferObjectFormat format;
  format.setSamples(samples);
  format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
  return std::make_unique<QOpenGLFramebufferObject>(size, format);
}

class OnscreenSceneWidget final : public QOpenGLWidget, public SceneWidget {
 public:
  explicit OnscreenSceneWidget(QWidget* parent) : QOpenGLWidget(parent), renderer_(view_) {
    QSurfaceFormat format;
    format.setProfile(QSurfaceFormat::CompatibilityProfile);
    setFormat(format);
    setFocusPolicy(Qt::StrongFocus);
    refine_.setSingleShot(true);
    connect(&refine_, &QTimer::timeout, this, [this] { update(); });
  }

  ~OnscreenSceneWidget() override {
    makeCurrent();
    smoothBuffer_.reset();
    quickBuffer_.reset();
    doneCurrent();
  }

  SceneView& view() override { return view_; }
  QWidget* widget() override { return this; }
  /// Updates the widgets over this one, too, because they are not painted with an OpenGL widget.
  void refresh() override {
    changed_ = true;
    update();
    for (QWidget* over : findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) over->update();
  }
  QImage picture() override {
    exact_ = true;
    QImage image = grabFramebuffer();
    exact_ = false;
    return image;
  }
  QImage picture(const QSize& pixels) override {
    const CameraController before = view_.camera();
    makeCurrent();
    // Widths of lines and sizes of texts are those of this screen; for another scale the scene would have to be built
    // again.
    const auto buffer = makeBuffer(pixels.expandedTo(QSize(1, 1)) * devicePixelRatioF(), kSamples);
    QOpenGLFramebufferObject& target = *buffer;
    target.bind();
    view_.camera().setEyePlace({});
    renderer_.resize(target.width(), target.height());
    renderer_.render(target.handle());
    const QImage image = target.toImage().scaled(pixels, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    view_.camera() = before;
    resizeGL(width(), height());
    doneCurrent();
    return image;
  }
  std::vector<QImage> picturesFrom(const std::vector<EyePlace>& eyePlaces) override {
    const EyePlace before = view_.camera().eyePlace();
    QElapsedTimer timer;
    timer.start();
    const PictureDetail detail = detail_.begin(!std::exchange(changed_, false));
    makeCurrent();
    std::vector<QImage> pictures;
    for (const EyePlace& eyePlace : eyePlaces) {
      view_.camera().setEyePlace(eyePlace);
      pictures.push_back(draw(detail).toImage().scaled(shownSize(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
      pictures.back().setDevicePixelRatio(devicePixelRatioF());
    }
    doneCurrent();
    view_.camera().setEyePlace(before);
    const double each = static_cast<double>(timer.nsecsElapsed()) / 1e9 / static_cast<double>(eyePlaces.size());
    if (detail_.end(each)) refine_.start(kRefineAfter);
    return pictures;
  }
  void setCovered(bool covered) override { covered_ = covered; }
  std::unique_ptr<QuadBuffer> makeQuadBuffer(QWidget* parent) override { return makeQuadBufferWindow(parent); }
  Headset* headset() override { return headset_.get(); }
  void setNavigationStyle(NavigationStyle style) override { mouse_.setStyle(style); }
  void onCameraMoved(std::function<void()> callback) override { cameraMoved_ = std::move(callback); }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    changed_ = true;
    QOpenGLWidget::resizeEvent(event);
  }
  void resizeGL(int width, int height) override {
    view_.setPixelScale(devicePixelRatioF());
    renderer_.resize(qRound(width * devicePixelRatioF()), qRound(height * devicePixelRatioF()));
  }
  void paintGL() override {
    if (covered_ && !exact_) {
      if (drawn_ != nullptr) show(*drawn_);
      return;
    }
    if (exact_) {
      paint(PictureDetail());
      return;
    }
    QElapsedTimer timer;
    timer.start();
    paint(detail_.begin(!std::exchange(changed_, false)));
    glFinish();
    if (detail_.end(static_cast<double>(timer.nsecsElapsed()) / 1e9)) refine_.start(kRefineAfter);
  }

  void mousePressEvent(QMouseEvent* event) override { mouse_.press(*event); }
  void mouseMoveEvent(QMouseEvent* event) override { moved(mouse_.move(*event, *this, view_)); }
  void mouseDoubleClickEvent(QMouseEvent* /*event*/) override { moved(mouse_.doubleClick(view_)); }
  void wheelEvent(QWheelEvent* event) override { moved(mouse_.wheel(*event, *this, view_)); }

 private:
  void moved(bool camera) {
    if (!camera) return;
    if (cameraMoved_) cameraMoved_();
    refresh();
  }

  QSize shownSize() const { return {qRound(width() * devicePixelRatioF()), qRound(height() * devicePixelRatioF())}; }

  void paint(const PictureDetail& detail) { show(draw(detail)); }

  /// Draws into a separate buffer, because this widget has one sample for each pixel.
  QOpenGLFramebufferObject& draw(const PictureDetail& detail) {
    const QSize drawn = (QSizeF(shownSize()) * detail.resolution).toSize().expandedTo(QSize(1, 1));
    std::unique_ptr<QOpenGLFramebufferObject>& buffer = detail.smooth ? smoothBuffer_ : quickBuffer_;
    if (!buffer || buffer->size() != drawn) buffer = makeBuffer(drawn, detail.smooth ? kSamples : 0);
    buffer->bind();  // OSG binds its target only after passes into other buffers
    renderer_.render(buffer->handle(), drawn.width(), drawn.height(), detail);
    drawn_ = buffer.get();
    return *buffer;
  }

  void show(QOpenGLFramebufferObject& buffer) {
    const QRect drawn(QPoint(), buffer.size());
    const QRect shown(QPoint(), shownSize());
    QOpenGLFramebufferObject::blitFramebuffer(nullptr, shown, &buffer, drawn, GL_COLOR_BUFFER_BIT,
                                              drawn == shown ? GL_NEAREST : GL_LINEAR);
    QOpenGLFramebufferObject::bindDefault();
  }

  SceneView view_;
  SceneRenderer renderer_;
  MouseNavigation mouse_;
  DetailControl detail_;
  std::unique_ptr<QOpenGLFramebufferObject> smoothBuffer_;  ///< with several samples for each pixel
  std::unique_ptr<QOpenGLFramebufferObject> quickBuffer_;   ///< with one sample, often smaller than the picture
  QOpenGLFramebufferObject* drawn_ = nullptr;               ///< the buffer that was drawn last
  bool covered_ = false;
  bool exact_ = false;   ///< the next picture has full detail
  bool changed_ = true;  ///< the next picture shows something new
  QTimer refine_;
  std::function<void()> cameraMoved_;
  std::unique_ptr<Headset> headset_ = makeHeadset(view_);
};

}  // namespace

std::unique_ptr<SceneWidget> makeOnscreenSceneWidget(QWidget* parent) {
  return std::make_unique<OnscreenSceneWidget>(parent);
}

}  // namespace glissade
