#pragma once

#include <set>

#include "engine/sequence/sequence_strategy.h"

namespace glissade {

/// Finds for every step the steps that have to be carried out before it: those of bodies that would block its motion,
/// and earlier ones that rules demand. After a stop: all earlier ones. The other steps may be carried out later: the
/// step also states its allowances against their bodies.
void addPrecedence(AssemblyPlan& plan, const SequenceQuestion& question, SequenceHost& host);

/// For each step, the numbers, from 1, of the steps that come before it in every order.
std::vector<std::set<std::size_t>> allBefore(const std::vector<AssemblyStep>& steps);

/// Lets each step depend on all earlier ones, without trials.
void demandAllEarlier(AssemblyPlan& plan);

}  // namespace glissade
