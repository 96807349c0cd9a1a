#include "engine/import/step_edited_text.h"

#include <algorithm>
#include <vector>

namespace glissade {

StepEditedText::StepEditedText(const StepEntities& entities) : entities_(entities) {
  if (!entities.all().empty()) next_ = entities.all().back().id + 1;
}

void StepEditedText::replace(std::uint64_t id, const std::string& entity) {
  replaced_[id] = stepName(id) + "=" + entity + ";";
}

std::string StepEditedText::add(const std::string& entity) {
  const std::string name = stepName(next_++);
  added_ += name + "=" + entity + ";\n";
  return name;
}

std::string StepEditedText::text() const {
  std::vector<std::pair<const StepEntities::Entity*, const std::string*>> inOrder;
  for (const auto& [id, entity] : replaced_) inOrder.emplace_back(entities_.find(id), &entity);
  std::sort(inOrder.begin(), inOrder.end(),
            [](const auto& a, const auto& b) { return a.first->begin < b.first->begin; });
  std::string text;
  std::size_t at = 0;
  for (const auto& [replaced, entity] : inOrder) {
    text.append(entities_.text(), at, replaced->begin - at);
    text += *entity;
    at = replaced->end;
  }
  text.append(entities_.text(), at, entities_.endOfData() - at);
  text += added_;
  text.append(entities_.text(), entities_.endOfData());
  return text;
}

}  // namespace glissade
