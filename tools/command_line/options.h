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
    * \param[in] files names of the files that it is given, in order; a last one that ends in "..." stands for any
    *            number of files, none as well, one in brackets for a file that may be missing */
  void
  describe (const std::string& purpose, const std::vector<std::string>& files);

  /** The options that are added from now on stand under a heading of their own in the help.
    * \param[in] heading without its colon; empty: under the first one, with all that belong to no other */
  void
  section (const std::string& heading);

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
    std::string name, value, help, standard, section;
    OptionReader reader;
    bool given;
    std::string text;
  };

  Option*
  find (const std::string& name);

  /** \throw UsageError always, with the option that was perhaps meant */
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
  std::string section_; // of the options that are added
  std::vector<Option> options_;
};
} // namespace tools
} // namespace pcl_normal_smoothing
