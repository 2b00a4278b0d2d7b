// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "option_readers.h"

#include <map>
#include <string>
#include <vector>

namespace pcl_normal_smoothing
{
namespace tools
{
/** This project's version. */
std::string
version ();

/** The command line of a tool: file names, and single-dash options with a value, in any order. */
class Options
{
public:
  /** \param[in] purpose what the tool does, for the help
    * \param[in] files names for its file arguments, in order; the last may end in "..." for any number of files,
    *            including none, or be in brackets for an optional file */
  void
  describe (const std::string& purpose, const std::vector<std::string>& files);

  /** Begins a section of the help for the options that are added from now on.
    * \param[in] heading without its colon; empty: the first section, for options that belong to no other */
  void
  section (const std::string& heading);

  /** \param[in] name with its dash
    * \param[in] value placeholder for its value in the help
    * \param[in] help with the unit, if there is one
    * \param[in] standard the default, for the help */
  void
  add (const std::string& name,
       const std::string& value,
       const std::string& help,
       const std::string& standard,
       const OptionReader& reader);

  /** \return false if the help or the version was asked for, and has been printed
    * \throw UsageError for an unknown option, a missing or invalid value, a missing or superfluous file name */
  bool
  parse (int argc, char** argv);

  /** Names options that, given all together, replace the file names. */
  void
  replaceFilesBy (const std::vector<std::string>& names);

  /** Whether the option was on the command line. */
  bool
  given (const std::string& name) const;

  /** The options on the command line, each with the text of its value. */
  std::map<std::string, std::string>
  given () const;

  /** The placeholder that add() was given for an option's value; empty if there is no such option. */
  std::string
  valueOf (const std::string& name) const;

  /** File name \a i of the command line; empty if there is none, or before parse(). */
  std::string
  file (std::size_t i) const
  {
    return i < files_.size () ? files_[i] : std::string ();
  }

private:
  struct Option
  {
    std::string name, value, help, standard, section;
    OptionReader reader;
    bool given;
    std::string text;
  };

  Option*
  find (const std::string& name);

  /** \throw UsageError always; it suggests the option that was perhaps meant */
  [[noreturn]] void
  refuseUnknown (const std::string& word, const std::string& tool) const;

  /** "usage: ..." */
  std::string
  usage (const std::string& tool) const;

  void
  printHelp (const std::string& tool) const;

  /** \param[in] width of the column of names */
  void
  printOptions (const std::string& section, std::size_t width) const;

  /** \throw UsageError if there are too few or too many file names */
  void
  checkFiles (const std::string& tool) const;

  /** \return whether options replace the file names
    * \throw UsageError if only some of them are given, or file names too */
  bool
  filesReplaced (const std::string& tool) const;

  std::string purpose_;
  std::vector<std::string> file_roles_;
  std::vector<std::string> files_;
  std::vector<std::string> file_options_;
  std::string section_; // for the options to be added
  std::vector<Option> options_;
};
} // namespace tools
} // namespace pcl_normal_smoothing
