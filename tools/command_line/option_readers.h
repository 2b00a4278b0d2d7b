// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace pcl_normal_smoothing
{
namespace tools
{
/** Reads the value of an option from its text. \throw UsageError that says what is expected */
using OptionReader = std::function<void (const std::string& text)>;

/** A whole number from \a least to \a most. */
OptionReader
integerOption (std::int64_t least, std::int64_t most, const std::function<void (std::int64_t)>& use);

/** A number above 0. */
OptionReader
positiveOption (const std::function<void (double)>& use);

/** A number of at least \a least and below \a limit. */
OptionReader
numberOption (double least, double limit, const std::function<void (double)>& use);

/** 0 or 1. */
OptionReader
switchOption (const std::function<void (bool)>& use);

/** One of several words. */
template <typename T>
using Words = std::vector<std::pair<std::string, T>>;

/** One of several words; \a use gets its index. */
OptionReader
wordOption (const std::vector<std::string>& words, const std::function<void (std::size_t)>& use);

template <typename T>
OptionReader
choiceOption (const Words<T>& words, const std::function<void (T)>& use)
{
  std::vector<std::string> names;
  for (const auto& word : words)
    names.push_back (word.first);
  return wordOption (names, [words, use] (std::size_t i) { use (words[i].second); });
}

/** The word that stands for a value. */
template <typename T>
std::string
wordFor (const Words<T>& words, T value)
{
  for (const auto& [word, meaning] : words)
    if (meaning == value)
      return word;
  return {};
}

/** "a|b|c" for the help. */
template <typename T>
std::string
wordList (const Words<T>& words)
{
  std::string list;
  for (const auto& word : words)
    list += (list.empty () ? "" : "|") + word.first;
  return list;
}
} // namespace tools
} // namespace pcl_normal_smoothing
