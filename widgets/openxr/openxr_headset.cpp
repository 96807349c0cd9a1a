#include "widgets/openxr/openxr_headset.h"

#include "widgets/openxr/headset_thread.h"

namespace glissade {
namespace {

/// Longest wait for a runtime that does not answer; its thread is abandoned then.
constexpr std::chrono::milliseconds kLongestEnd{1000};

class OpenXrHeadset final : public Headset {
 public:
  explicit OpenXrHeadset(SceneView& view)
      : thread_(std::make_shared<HeadsetThread>(SharedGraph{view.root(), view.graphMutex()})) {}
  ~OpenXrHeadset() override {
    thread_->setListener({});
    thread_->setWanted(false);
    if (thread_->waitForEnd(kLongestEnd)) thread_->forgetScene();
  }

  void start() override { thread_->setWanted(true); }
  void stop() override { thread_->setWanted(false); }
  HeadsetStatus status() const override { return thread_->status(); }
  HeadsetFigures figures() const override { return thread_->figures(); }
  void setPlacement(const RoomPlacement& room) override { thread_->setPlacement(room); }
  void setBackground(const Colour& above, const Colour& below) override { thread_->setBackground(above, below); }
  void setHands(HandInputsPtr hands) override { thread_->setHands(std::move(hands)); }
  void setTools(HeadsetToolsPtr tools) override { thread_->setTools(std::move(tools)); }
  void onChanged(std::function<void()> callback) override { thread_->setListener(std::move(callback)); }

 private:
  std::shared_ptr<HeadsetThread> thread_;
};

}  // namespace

std::unique_ptr<Headset> makeHeadset(SceneView& view) { return std::make_unique<OpenXrHeadset>(view); }

}  // namespace glissade
