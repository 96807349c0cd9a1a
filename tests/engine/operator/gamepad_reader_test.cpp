// Tests the reader with SDL's virtual game controllers.
#include "engine/operator/gamepad_reader.h"

#include <SDL.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <iostream>
#include <new>

#include "tests/engine/operator/process_load.h"

namespace glissade {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

/// A virtual gamepad that is connected while this object lives.
class VirtualPad {
 public:
  VirtualPad() {
    SDL_LockJoysticks();
    index_ = SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER, SDL_CONTROLLER_AXIS_MAX,
                                       SDL_CONTROLLER_BUTTON_MAX, 0);
    joystick_ = SDL_JoystickOpen(index_);
    SDL_UnlockJoysticks();
  }
  ~VirtualPad() {
    SDL_LockJoysticks();
    SDL_JoystickClose(joystick_);
    SDL_JoystickDetachVirtual(index_);
    SDL_UnlockJoysticks();
  }
  VirtualPad(const VirtualPad&) = delete;
  VirtualPad& operator=(const VirtualPad&) = delete;

  void deflect(SDL_GameControllerAxis axis, double share) {
    SDL_JoystickSetVirtualAxis(joystick_, axis, static_cast<Sint16>(share * 32767.0));
  }
  void setButton(SDL_GameControllerButton button, bool down) {
    SDL_JoystickSetVirtualButton(joystick_, button, down ? SDL_PRESSED : SDL_RELEASED);
  }

 private:
  int index_ = -1;
  SDL_Joystick* joystick_ = nullptr;
};

/// Starts SDL before the reader begins and ends it after the reader, because SDL's start and end are not thread-safe.
struct SdlIsUp {
  SdlIsUp() { SDL_InitSubSystem(SDL_INIT_JOYSTICK); }
  ~SdlIsUp() { SDL_QuitSubSystem(SDL_INIT_JOYSTICK); }
};

class Gamepad : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(eventually([this] { return reader.wakeUps() > 0; }));
  }

  InputReading now() const { return hand->gamepad.mailbox.reading(); }
  static bool eventually(const std::function<bool()>& condition) {
    const auto end = Clock::now() + milliseconds(15000);
    while (!condition() && Clock::now() < end) SDL_Delay(2);
    return condition();
  }
  bool comes() const {
    return eventually([&] { return now().connected; });
  }
  bool goes() const {
    return eventually([&] { return !now().connected; });
  }

  SdlIsUp sdl;
  HandInputsPtr hand = std::make_shared<HandInputs>();
  GamepadReader reader{hand};
};

TEST_F(Gamepad, WithoutOneNothingMovesAndNothingSpins) {
  const auto before = reader.wakeUps();
  SDL_Delay(1000);
  EXPECT_FALSE(now().connected);
  EXPECT_LE(reader.wakeUps() - before, 20U);
}

TEST_F(Gamepad, SticksTriggersAndShouldersAreTheSixAxes) {
  VirtualPad pad;
  ASSERT_TRUE(comes());
  EXPECT_FALSE(now().name.empty());
  pad.deflect(SDL_CONTROLLER_AXIS_LEFTX, 1.0);
  EXPECT_TRUE(eventually([&] { return now().axes[0] == 1.0; }));
  pad.deflect(SDL_CONTROLLER_AXIS_LEFTY, -1.0);
  pad.deflect(SDL_CONTROLLER_AXIS_RIGHTX, -1.0);
  EXPECT_TRUE(eventually([&] { return now().axes[1] == 1.0 && now().axes[4] == -1.0; }));
  pad.setButton(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER, true);
  EXPECT_TRUE(eventually([&] { return now().axes[5] == -1.0; }));
  EXPECT_EQ(now().axes[3], 0.0);
}

TEST_F(Gamepad, PressesAreCounted) {
  VirtualPad pad;
  ASSERT_TRUE(comes());
  for (std::uint32_t i = 1; i <= 3; ++i) {
    pad.setButton(SDL_CONTROLLER_BUTTON_A, true);
    ASSERT_TRUE(eventually([&] { return now().presses[0] == i; }));
    pad.setButton(SDL_CONTROLLER_BUTTON_A, false);
    SDL_Delay(30);
  }
}

TEST_F(Gamepad, PulledOutWhileDeflectedIsRest) {
  {
    VirtualPad pad;
    ASSERT_TRUE(comes());
    pad.deflect(SDL_CONTROLLER_AXIS_LEFTX, 1.0);
    ASSERT_TRUE(eventually([&] { return !now().atRest(); }));
  }
  ASSERT_TRUE(goes());
  EXPECT_TRUE(now().atRest());
}

TEST_F(Gamepad, UnplugsLeakNothing) {
  std::ptrdiff_t files = 0;
  std::ptrdiff_t bytes = 0;
  const int rounds = stressRounds(12);
  for (int round = -5; round < rounds; ++round) {
    if (round == 0) {
      files = openFiles();
      bytes = allocatedBytes();
    }
    {
      const VirtualPad pad;
      ASSERT_TRUE(comes()) << round;
    }
    ASSERT_TRUE(goes()) << round;
  }
  EXPECT_LE(openFiles(), files);
  // SDL 2.26 itself keeps about 2,080 bytes of every virtual joystick (measured without the reader).
  EXPECT_LE(allocatedBytes() - bytes, 16384 + 2500 * rounds);
  std::cout << rounds << " unplugs: " << openFiles() - files << " files, " << allocatedBytes() - bytes << " bytes\n";
}

TEST_F(Gamepad, AnExceptionIsToldAndTheGamepadIsConnectedAgain) {
  std::atomic<int> calls{0};
  std::atomic<bool> notified{false};
  hand->gamepad.mailbox.setListener([&] {
    if (++calls == 1) throw std::bad_alloc();
    const auto problem = reader.problem();
    notified = notified || (problem && problem->kind == ErrorKind::LimitReached);
  });
  VirtualPad pad;
  EXPECT_TRUE(eventually([&] { return notified.load(); }));
  EXPECT_TRUE(eventually([&] { return now().connected && !reader.problem(); }));
  hand->gamepad.mailbox.setListener({});
}

}  // namespace
}  // namespace glissade
