// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace pcl_normal_smoothing
{
namespace tools
{
/** This project's version. */
std::string
version ();

/** Takes the text behind an option. \throw UsageError that says what would have been right */
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

/** One of several words, given by its number. */
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

/** The command line of a tool: file names, and single-dash options with a value, in any order. */
class Options
{
public:
  /** \param[in] purpose what the tool does, for the help
    * \param[in] files names of the files that it is given, in order; a last one that ends in "..." stands for any
    *            number of files, none as well, one in brackets for a file that may be missing */
  void
  describe (const std::string& purpose, const std::vector<std::string>& files);

  /** \param[in] name with its dash
    * \param[in] value what to write in its place in the help
    * \param[in] help with the unit, if there is one
    * \param[in] standard what holds without the option */
  void
  add (const std::string& name,
       const std::string& value,
       const std::string& help,
       const std::string& standard,
       const OptionReader& reader);

  /** \return false where the help or the version was asked for, and has been printed
    * \throw UsageError for an unknown option, a missing or bad value, a missing or needless file name */
  bool
  parse (int argc, char** argv);

  /** Options that, all together, stand in place of the file names. */
  void
  replaceFilesBy (const std::vector<std::string>& names);

  /** The option was on the command line. */
  bool
  given (const std::string& name) const;

  /** The options of the command line, each with its text. */
  std::map<std::string, std::string>
  given () const;

  /** What add() was told to write for the value of an option; empty where there is no such option. */
  std::string
  valueOf (const std::string& name) const;

  /** A file name of the command line; empty before parse() has found it. */
  std::string
  file (std::size_t i) const
  {
    return i < files_.size () ? files_[i] : std::string ();
  }

private:
  struct Option
  {
    std::string name, value, help, standard;
    OptionReader reader;
    bool given;
    std::string text;
  };

  Option*
  find (const std::string& name);

  /** "usage: ..." */
  std::string
  usage (const std::string& tool) const;

  void
  printHelp (const std::string& tool) const;

  /** \throw UsageError where there are too few or too many file names */
  void
  checkFiles (const std::string& tool) const;

  /** \return whether options stand in place of the file names \throw UsageError where only some of them do */
  bool
  filesReplaced (const std::string& tool) const;

  std::string purpose_;
  std::vector<std::string> file_roles_;
  std::vector<std::string> files_;
  std::vector<std::string> file_options_;
  std::vector<Option> options_;
};
} // namespace tools
} // namespace pcl_normal_smoothing
