#include "widgets/openxr/headset_scene.h"

#include <osg/DisplaySettings>

#include <utility>

#include "widgets/scene3d/scene_lights.h"

namespace glissade {

HeadsetScene::HeadsetScene(SharedGraph graph) : graph_(std::move(graph)), lit_(makeLights()) {
  const std::lock_guard lock(*graph_.mutex);
  graph_.root->resizeGLObjectBuffers(osg::DisplaySettings::instance()->getMaxNumberOfGraphicsContexts());
  // Sets depth test and colours of materials, as a viewer sets them for its camera.
  lit_->getOrCreateStateSet()->setGlobalDefaults();
  lit_->addChild(horizon_.node());
  lit_->addChild(hands_.node());
  lit_->addChild(panel_.node());
  lit_->addChild(graph_.root);
  for (auto& painter : painters_) painter = std::make_unique<EyePainter>(context_.osgContext(), lit_);
}

/// Frees the objects of this context in the shared graph.
HeadsetScene::~HeadsetScene() {
  const std::lock_guard lock(*graph_.mutex);
  graph_.root->releaseGLObjects(context_.osgContext().getState());
  lit_->removeChild(graph_.root);
  for (auto& painter : painters_) painter.reset();
}

void HeadsetScene::setBackground(const Colour& above, const Colour& below) {
  const std::lock_guard lock(*graph_.mutex);
  horizon_.setColours(above, below);
}

void HeadsetScene::setTarget(std::size_t eye, int width, int height, std::int64_t format) {
  painters_[eye]->setTarget(width, height, format);
}

void HeadsetScene::draw(const std::array<EyeSight, 2>& eyes, const EyeDetail& detail, const ShownHands& hands,
                        const std::array<unsigned, 2>& textures) {
  {
    const std::lock_guard lock(*graph_.mutex);
    hands_.show(hands);
    panel_.show(hands.panel, 1.0 / hands.scale);
    showTexts(hands);
    for (std::size_t eye = 0; eye < painters_.size(); ++eye) {
      horizon_.moveTo(eyes[eye]);
      painters_[eye]->draw(eyes[eye], detail);
    }
  }
  for (std::size_t eye = 0; eye < painters_.size(); ++eye) painters_[eye]->copyTo(textures[eye]);
}

EyeFigures HeadsetScene::figures() {
  const std::lock_guard lock(*graph_.mutex);
  return painters_.front()->figures();
}

void HeadsetScene::showTexts(const ShownHands& hands) {
  while (texts_.size() < hands.texts.size()) {
    texts_.emplace_back(PanelModel::Kind::Text);
    lit_->addChild(texts_.back().node());
  }
  for (std::size_t i = 0; i < texts_.size(); ++i) {
    texts_[i].show(i < hands.texts.size() ? hands.texts[i] : ShownPicture(), 1.0 / hands.scale);
  }
}

}  // namespace glissade
