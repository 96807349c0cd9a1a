#include "widgets/workbench/script_commands.h"

#include <utility>

namespace glissade {

void ScriptCommands::add(const std::string& name, std::size_t words, Handler handler) {
  commands_[name] = {words, std::move(handler)};
}

std::optional<std::size_t> ScriptCommands::wordCount(const std::string& name) const {
  const auto found = commands_.find(name);
  return found == commands_.end() ? std::nullopt : std::make_optional(found->second.words);
}

std::string ScriptCommands::names() const {
  std::string names;
  for (const auto& [name, entry] : commands_) names += (names.empty() ? "" : ", ") + name;
  return names;
}

}  // namespace glissade
