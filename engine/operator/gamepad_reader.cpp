#include "engine/operator/gamepad_reader.h"

#include <SDL.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "engine/base/guarded.h"

namespace glissade {
namespace {

using std::chrono::milliseconds;

/// Period of reading a connected gamepad (125 Hz), and period of searching for one.
constexpr milliseconds kTick{8};
constexpr milliseconds kLook{250};

/// SDL's controllers without a window. SDL leaves signals to the program, and events come without focus (the window's
/// focus is handled elsewhere).
class Sdl {
 public:
  Sdl() {
    SDL_SetMainReady();
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
    works_ = SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) == 0;
  }
  ~Sdl() {
    if (works_) SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
  }
  Sdl(const Sdl&) = delete;
  Sdl& operator=(const Sdl&) = delete;

  bool works() const { return works_; }

 private:
  bool works_ = false;
};

/// One gamepad, or none.
class Pad {
 public:
  explicit Pad(InputMailbox& mailbox) : mailbox_(mailbox) {}
  ~Pad() { closeController(); }
  Pad(const Pad&) = delete;
  Pad& operator=(const Pad&) = delete;

  bool isOpen() const { return controller_ != nullptr; }

  void handleEvents() {
    SDL_Event event{};
    while (SDL_PollEvent(&event) != 0) {
      if (!isOpen()) continue;
      const bool ours = event.cdevice.which == id_;
      if (event.type == SDL_CONTROLLERDEVICEREMOVED && ours) close();
      if (event.type == SDL_CONTROLLERBUTTONDOWN && event.cbutton.which == id_) mailbox_.press(event.cbutton.button);
    }
    if (!isOpen()) openFirst();
  }

  void publishAxes() {
    const RawAxes axes{axis(SDL_CONTROLLER_AXIS_LEFTX),
                       -axis(SDL_CONTROLLER_AXIS_LEFTY),
                       axis(SDL_CONTROLLER_AXIS_TRIGGERLEFT) - axis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT),
                       axis(SDL_CONTROLLER_AXIS_RIGHTY),
                       axis(SDL_CONTROLLER_AXIS_RIGHTX),
                       button(SDL_CONTROLLER_BUTTON_LEFTSHOULDER) - button(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER)};
    if (axes == last_) return;
    last_ = axes;
    mailbox_.setAxes(axes);
  }

 private:
  void openFirst() {
    for (int i = 0; i < SDL_NumJoysticks() && !isOpen(); ++i) {
      if (SDL_IsGameController(i) == SDL_TRUE) controller_ = SDL_GameControllerOpen(i);
    }
    if (!isOpen()) return;
    id_ = SDL_JoystickInstanceID(SDL_GameControllerGetJoystick(controller_));
    last_ = RawAxes{};
    const char* name = SDL_GameControllerName(controller_);
    mailbox_.connect(name != nullptr && name[0] != '\0' ? name : "Gamepad");
  }

  void close() {
    if (!isOpen()) return;
    closeController();
    mailbox_.disconnect();
  }

  void closeController() {
    if (isOpen()) SDL_GameControllerClose(controller_);
    controller_ = nullptr;
  }

  double axis(SDL_GameControllerAxis which) const {
    return std::max(-1.0, SDL_GameControllerGetAxis(controller_, which) / 32767.0);
  }
  double button(SDL_GameControllerButton which) const { return SDL_GameControllerGetButton(controller_, which); }

  InputMailbox& mailbox_;
  SDL_GameController* controller_ = nullptr;
  SDL_JoystickID id_ = -1;
  RawAxes last_{};
};

}  // namespace

GamepadReader::GamepadReader(HandInputsPtr hand) : hand_(std::move(hand)) {
  thread_ = std::thread([this] { run(); });
}

GamepadReader::~GamepadReader() {
  {
    const std::lock_guard lock(mutex_);
    quit_ = true;
  }
  quitWanted_.notify_all();
  thread_.join();
}

void GamepadReader::run() {
  const Sdl sdl;
  if (!sdl.works()) return;
  do {
    auto why = guarded(GLISSADE_TEXT("reading the gamepad"), [this] { readPads(); });
    if (why) problem_.set(std::move(why));
    // A listener that fails is notified again at the next change.
    (void)guarded(GLISSADE_TEXT("disconnecting the gamepad"), [this] { hand_->gamepad.mailbox.disconnect(); });
  } while (!quitWithin(kLook));
}

/// Reads gamepads until this object is destroyed.
void GamepadReader::readPads() {
  Pad pad(hand_->gamepad.mailbox);
  do {
    ++wakeUps_;
    pad.handleEvents();
    if (pad.isOpen()) {
      problem_.set(std::nullopt);
      pad.publishAxes();
    }
  } while (!quitWithin(pad.isOpen() ? kTick : kLook));
}

/// Waits; returns true where the destruction of this object has begun.
bool GamepadReader::quitWithin(milliseconds patience) {
  std::unique_lock lock(mutex_);
  return quitWanted_.wait_for(lock, patience, [this] { return quit_; });
}

}  // namespace glissade
