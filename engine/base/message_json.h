#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "engine/base/message.h"

namespace glissade {

/// The message as data: {"text": ..., "arguments": [...]}. An argument is a text, {"length": metres}, {"depth": metres}
/// or a message.
nlohmann::json toJson(const Message& message);

/// Reads toJson()'s form. Nothing where it is another one, or nested more than 16 deep.
std::optional<Message> messageFrom(const nlohmann::json& json);

}  // namespace glissade
