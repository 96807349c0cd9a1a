// A headset whose answers the test sets.
#pragma once

#include <QCoreApplication>

#include <functional>

#include "widgets/openxr/headset.h"

namespace glissade::test {

class SaidHeadset final : public Headset {
 public:
  void start() override { ++starts_; }
  void stop() override { ++stops_; }
  HeadsetStatus status() const override { return status_; }
  HeadsetFigures figures() const override { return figures_; }
  void setPlacement(const RoomPlacement& room) override { room_ = room; }
  void setBackground(const Colour& /*above*/, const Colour& /*below*/) override {}
  void setHands(HandInputsPtr hands) override { hands_ = std::move(hands); }
  void setTools(HeadsetToolsPtr tools) override { tools_ = std::move(tools); }
  void onChanged(std::function<void()> callback) override { callback_ = std::move(callback); }

  void say(const HeadsetStatus& status) {
    status_ = status;
    callback_();
    QCoreApplication::processEvents();
  }
  void setFigures(const HeadsetFigures& figures) { figures_ = figures; }
  int starts() const { return starts_; }
  int stops() const { return stops_; }
  const RoomPlacement& room() const { return room_; }
  const HandInputsPtr& hands() const { return hands_; }
  HeadsetTools& tools() const { return *tools_; }

 private:
  HeadsetStatus status_;
  HeadsetFigures figures_;
  RoomPlacement room_;
  HandInputsPtr hands_;
  HeadsetToolsPtr tools_;
  std::function<void()> callback_;
  int starts_ = 0;
  int stops_ = 0;
};

}  // namespace glissade::test
