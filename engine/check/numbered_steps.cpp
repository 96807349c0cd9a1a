#include "engine/check/numbered_steps.h"

#include <algorithm>
#include <set>

namespace glissade::check {
namespace {

void takeAway(const Group& group, Present& present) {
  for (const std::size_t body : group) present[body] = false;
}

/// Indices of the motions that are carried out before this one in every order: those of the steps that come before its
/// step, and the earlier ones of its step. `earlier`: those of the motions before it in the list.
std::set<std::size_t> predecessorsOf(const std::vector<Step>& steps, const std::vector<std::set<std::size_t>>& earlier,
                                     NumberedStep& numbered) {
  const std::size_t number = numbered.step->number;
  std::set<std::size_t> stated{number};
  for (const std::size_t each : numbered.step->after) {
    if (each == 0 || each >= number) {
      numbered.wrong.push_back(
          {GLISSADE_TEXT("it states \"after\": %1, and %2 {2|step comes|steps come} before it"), {each, number - 1}});
    } else {
      stated.insert(each);
    }
  }
  std::set<std::size_t> before;
  for (std::size_t motion = 0; motion < earlier.size(); ++motion) {
    if (stated.count(steps[motion].number) == 0) continue;
    before.insert(motion);
    before.insert(earlier[motion].begin(), earlier[motion].end());
  }
  return before;
}

/// Only a step of a flexible body, which leaves alone, may state that it is not certified.
void checkProof(NumberedStep& numbered) {
  const Step& step = *numbered.step;
  if (step.certified == !step.flexible) return;
  numbered.wrong.emplace_back(step.certified
                                  ? GLISSADE_TEXT("it is of a flexible body, and says that it is certified")
                                  : GLISSADE_TEXT("it says that it is not certified, and its body is not flexible"));
}

void numberBodies(const Product& product, const StepList& list, Present& left, NumberedStep& numbered) {
  for (const BodyId& id : numbered.step->bodies) {
    const Body* body = product.find(id);
    const bool stays = std::find(list.staying.begin(), list.staying.end(), id) != list.staying.end();
    if (body == nullptr) {
      numbered.wrong.push_back({GLISSADE_TEXT("it moves '%1', which is not a body of the product"), {id.text()}});
      continue;
    }
    const auto index = static_cast<std::size_t>(body - product.bodies.data());
    if (stays) numbered.wrong.push_back({GLISSADE_TEXT("it moves '%1', which is fixed as base"), {id.text()}});
    if (left[index]) numbered.wrong.push_back({GLISSADE_TEXT("it moves '%1', which was removed before"), {id.text()}});
    if (!list.there[index])
      numbered.wrong.push_back({GLISSADE_TEXT("it moves '%1', which is not in the group"), {id.text()}});
    left[index] = true;
    numbered.group.push_back(index);
  }
  if (numbered.step->bodies.empty()) numbered.wrong.emplace_back(GLISSADE_TEXT("it moves no body"));
  checkProof(numbered);
  std::sort(numbered.group.begin(), numbered.group.end());
}

}  // namespace

std::vector<NumberedStep> numberedSteps(const Product& product, const StepList& list) {
  std::vector<NumberedStep> steps;
  std::vector<std::set<std::size_t>> before;
  Present there = list.there;
  Present left(product.bodies.size(), false);
  for (const Step& step : list.steps) {
    NumberedStep numbered{&step, {}, there, list.there, {}};
    numberBodies(product, list, left, numbered);
    before.push_back(predecessorsOf(list.steps, before, numbered));
    for (const std::size_t each : before.back()) takeAway(steps[each].group, numbered.mayBeThere);
    takeAway(numbered.group, there);
    steps.push_back(std::move(numbered));
  }
  return steps;
}

}  // namespace glissade::check
