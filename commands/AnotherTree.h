// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/Recipe.h"
#include "model/document/PreparedTree.h"

#include <atomic>
#include <memory>

namespace espalier {

/// The seed of the tree number @p number that is like one of seed @p seed: another one for each number from 0
/// on, and for each seed.
std::uint64_t seedOfAnother(std::uint64_t seed, int number);

/// The tree that the gestures of @p recipe make with another seed, at the moment with which the recipe ends,
/// and its history. What an operation does not find is left out. Null if @p isCancelled became true
/// meanwhile. May run on any thread.
std::unique_ptr<PreparedTree> anotherTree(Recipe recipe, std::uint64_t seed,
                                          const std::atomic<bool>& isCancelled);

} // namespace espalier
