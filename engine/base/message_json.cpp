#include "engine/base/message_json.h"

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "engine/base/overloaded.h"

namespace glissade {
namespace {

constexpr int kDeepestMessage = 16;

nlohmann::json toJson(const MessageArgument& argument) {
  return std::visit(Overloaded{[](const std::string& text) { return nlohmann::json(text); },
                               [](const Length& length) {
                                 return nlohmann::json{{"length", length.metres}};
                               },
                               [](const Depth& depth) {
                                 return nlohmann::json{{"depth", depth.metres}};
                               },
                               [](const Message& message) { return glissade::toJson(message); }},
                    argument.value);
}

std::optional<Message> messageAt(const nlohmann::json& json, int deepest);

std::optional<MessageArgument> argumentFrom(const nlohmann::json& json, int deepest) {
  if (json.is_string()) return MessageArgument(json.get<std::string>());
  if (!json.is_object()) return std::nullopt;
  const auto isNumber = [&](const char* key) { return json.contains(key) && json[key].is_number(); };
  if (isNumber("length")) return MessageArgument(Length{json["length"].get<double>()});
  if (isNumber("depth")) return MessageArgument(Depth{json["depth"].get<double>()});
  auto message = messageAt(json, deepest - 1);
  if (!message) return std::nullopt;
  return MessageArgument(std::move(*message));
}

std::optional<Message> messageAt(const nlohmann::json& json, int deepest) {
  if (deepest == 0 || !json.is_object() || !json.contains("text") || !json["text"].is_string()) return std::nullopt;
  Message message;
  message.text = json["text"].get<std::string>();
  const auto arguments = json.find("arguments");
  if (arguments == json.end()) return message;
  if (!arguments->is_array()) return std::nullopt;
  for (const nlohmann::json& each : *arguments) {
    auto argument = argumentFrom(each, deepest);
    if (!argument) return std::nullopt;
    message.arguments.push_back(std::move(*argument));
  }
  return message;
}

}  // namespace

nlohmann::json toJson(const Message& message) {
  nlohmann::json json{{"text", message.text}};
  for (const MessageArgument& each : message.arguments) json["arguments"].push_back(toJson(each));
  return json;
}

std::optional<Message> messageFrom(const nlohmann::json& json) { return messageAt(json, kDeepestMessage); }

}  // namespace glissade
