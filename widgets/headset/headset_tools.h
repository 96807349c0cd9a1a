#pragma once

#include <atomic>
#include <memory>

#include "widgets/headset/flat_picture.h"
#include "widgets/headset/pointer_mailbox.h"

namespace glissade {

/// What a person with a headset works with beside the object: shared by the window, which paints it and does what is
/// asked, and the thread of the headset.
struct HeadsetTools {
  Mailbox<FlatPicturePtr> panel;          ///< the panel in the scene; null: there is none
  PointerMailbox pointer;                 ///< what a hand does at it
  std::atomic<bool> panelInFront{false};  ///< it stays before the person, and not in the other hand
  Mailbox<FlatPicturePtr> note;           ///< a text at the main hand; null: there is none
  Mailbox<FlatLabelsPtr> labels;          ///< of the scene; null: there are none
};
using HeadsetToolsPtr = std::shared_ptr<HeadsetTools>;

}  // namespace glissade
