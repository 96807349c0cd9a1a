#pragma once

#include <osg/Group>

#include <array>
#include <memory>

#include "widgets/openxr/eye_painter.h"
#include "widgets/openxr/hand_models.h"
#include "widgets/openxr/horizon.h"
#include "widgets/openxr/panel_model.h"
#include "widgets/openxr/private_context.h"
#include "widgets/scene3d/scene_view.h"

namespace glissade {

/// The scene graph that the headset shares with the window.
struct SharedGraph {
  osg::ref_ptr<osg::Group> root;
  std::shared_ptr<GraphMutex> mutex;
};

/// The view of both eyes of the shared graph, and the OpenGL context that draws it. Used on one thread, on which the
/// context is current; locks the graph's mutex for a picture of both eyes.
class HeadsetScene {
 public:
  /// Throws HeadsetFailure.
  explicit HeadsetScene(SharedGraph graph);
  ~HeadsetScene();
  HeadsetScene(const HeadsetScene&) = delete;
  HeadsetScene& operator=(const HeadsetScene&) = delete;

  PrivateContext& context() { return context_; }
  void setBackground(const Colour& above, const Colour& below);
  /// Sets size and format of the textures of an eye; 0 is the left one.
  void setTarget(std::size_t eye, int width, int height, std::int64_t format);
  /// Draws one picture for each eye into textures of the context. Both show the scene at one moment.
  void draw(const std::array<EyeSight, 2>& eyes, const EyeDetail& detail, const ShownHands& hands,
            const std::array<unsigned, 2>& textures);
  /// Figures of the last picture of the left eye.
  EyeFigures figures();

 private:
  void showTexts(const ShownHands& hands);

  SharedGraph graph_;
  PrivateContext context_;
  Horizon horizon_;
  HandModels hands_;
  PanelModel panel_{PanelModel::Kind::Panel};
  std::vector<PanelModel> texts_;  ///< as many as the most texts shown at once
  osg::ref_ptr<osg::Group> lit_;
  std::array<std::unique_ptr<EyePainter>, 2> painters_;
};

}  // namespace glissade
