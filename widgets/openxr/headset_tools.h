#pragma once

#include <atomic>
#include <memory>

#include "widgets/openxr/flat_picture.h"
#include "widgets/openxr/pointer_mailbox.h"

namespace glissade {

/// The panel and the texts of a person with a headset. The window, which paints them and carries out requests, shares
/// them with the thread of the headset.
struct HeadsetTools {
  Mailbox<FlatPicturePtr> panel;          ///< the panel in the scene; null: there is none
  PointerMailbox pointer;                 ///< the hand that points at the panel
  std::atomic<bool> panelInFront{false};  ///< the panel stays before the person instead of in the other hand
  Mailbox<FlatPicturePtr> note;           ///< a text at the main hand; null: there is none
  Mailbox<FlatLabelsPtr> labels;          ///< texts of the scene; null: there are none
};
using HeadsetToolsPtr = std::shared_ptr<HeadsetTools>;

}  // namespace glissade
