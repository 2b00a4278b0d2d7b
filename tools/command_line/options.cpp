// SPDX-License-Identifier: BSD-3-Clause
#include "options.h"

#include "files/tool_error.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <numeric>
#include <utility>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
/** Number of letters to insert, delete or change to turn one word into the other. */
std::size_t
editDistance (const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row (b.size () + 1);
  std::iota (row.begin (), row.end (), std::size_t {0});
  for (std::size_t i = 0; i < a.size (); ++i) {
    std::size_t diagonal = std::exchange (row[0], i + 1);
    for (std::size_t j = 0; j < b.size (); ++j) {
      const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = std::exchange (row[j + 1], std::min ({changed, row[j] + 1, row[j + 1] + 1}));
    }
  }
  return row.back ();
}

constexpr std::size_t line_width = 110, most_width = 30; // of a line and of the column of names in the help

/** Prints \a text from column \a indent on, where the output already is, and wraps it between words. */
void
printWrapped (const std::string& text, std::size_t indent)
{
  std::size_t column = indent;
  for (std::size_t begin = 0; begin < text.size ();) {
    const std::size_t end = std::min (text.find (' ', begin), text.size ());
    if (column > indent && column + 1 + end - begin > line_width) {
      std::printf ("\n%*s", static_cast<int> (indent), "");
      column = indent;
    }
    column += static_cast<std::size_t> (
        std::printf ("%s%s", column > indent ? " " : "", text.substr (begin, end - begin).c_str ()));
    begin = end + 1;
  }
  std::printf ("\n");
}
} // namespace

std::string
version ()
{
  return PCL_NORMAL_SMOOTHING_VERSION;
}

void
Options::describe (const std::string& purpose, const std::vector<std::string>& files)
{
  purpose_ = purpose;
  file_roles_ = files;
}

void
Options::add (const std::string& name,
              const std::string& value,
              const std::string& help,
              const std::string& standard,
              const OptionReader& reader)
{
  options_.push_back ({name, value, help, standard, section_, reader, false, {}});
}

void
Options::section (const std::string& heading)
{
  section_ = heading;
}

Options::Option*
Options::find (const std::string& name)
{
  const auto found = std::find_if (options_.begin (), options_.end (), [&] (const auto& o) { return o.name == name; });
  return found == options_.end () ? nullptr : &*found;
}

bool
Options::given (const std::string& name) const
{
  return std::any_of (options_.begin (), options_.end (), [&] (const auto& o) { return o.name == name && o.given; });
}

std::string
Options::valueOf (const std::string& name) const
{
  const auto found = std::find_if (options_.begin (), options_.end (), [&] (const auto& o) { return o.name == name; });
  return found == options_.end () ? std::string () : found->value;
}

std::map<std::string, std::string>
Options::given () const
{
  std::map<std::string, std::string> texts;
  for (const Option& option : options_)
    if (option.given)
      texts[option.name] = option.text;
  return texts;
}

void
Options::replaceFilesBy (const std::vector<std::string>& names)
{
  file_options_ = names;
}

bool
Options::parse (int argc, char** argv)
{
  const std::string tool = std::filesystem::path (argv[0]).filename ().string ();
  const std::vector<std::string> words (argv + 1, argv + argc);
  const auto asked = [&] (const char* word) { return std::find (words.begin (), words.end (), word) != words.end (); };
  if (asked ("-h") || asked ("-help") || asked ("--help")) {
    printHelp (tool);
    return false;
  }
  if (asked ("-version") || asked ("--version")) {
    std::printf ("%s %s\n", tool.c_str (), version ().c_str ());
    return false;
  }
  for (std::size_t i = 0; i < words.size (); ++i) {
    if (words[i].size () < 2 || words[i][0] != '-') {
      files_.push_back (words[i]);
      continue;
    }
    Option* option = find (words[i]);
    if (!option)
      refuseUnknown (words[i], tool);
    if (i + 1 == words.size () || find (words[i + 1]))
      throw UsageError ("option " + words[i] + " has no value: give " + words[i] + " " + option->value);
    try {
      option->text = words[++i];
      option->reader (option->text);
    }
    catch (const UsageError& error) {
      throw UsageError ("option " + option->name + ": " + error.what () + ": see " + tool + " -h");
    }
    option->given = true;
  }
  checkFiles (tool);
  return true;
}

void
Options::refuseUnknown (const std::string& word, const std::string& tool) const
{
  const std::size_t equals = word.find ('=');
  const std::string name = word.substr (0, equals);
  std::string hint = "see " + tool + " -h";
  for (const Option& option : options_)
    if (equals != std::string::npos && option.name == name)
      hint = "write " + name + " " + word.substr (equals + 1);
    else if (name.size () > 3 && editDistance (option.name, name) <= 2)
      hint = "did you mean " + option.name + "? " + "See " + tool + " -h";
  throw UsageError ("unknown option " + word + ": " + hint);
}

bool
Options::filesReplaced (const std::string& tool) const
{
  const auto count = static_cast<std::size_t> (std::count_if (file_options_.begin (), file_options_.end (),
                                                              [&] (const std::string& name) { return given (name); }));
  if (count == 0)
    return false;
  if (count < file_options_.size ())
    throw UsageError (file_options_.front () + " and " + file_options_.back () + " go together\n" + usage (tool));
  if (!files_.empty ())
    throw UsageError ("file names are given beside " + file_options_.front () + ": give one or the other\n" +
                      usage (tool));
  return true;
}

void
Options::checkFiles (const std::string& tool) const
{
  if (filesReplaced (tool))
    return;
  const std::string last = file_roles_.empty () ? "" : file_roles_.back ();
  const bool any_more = last.size () > 3 && last.substr (last.size () - 3) == "...";
  const bool one_more = !last.empty () && last.front () == '[';
  const std::size_t needed = file_roles_.size () - (any_more || one_more ? 1 : 0);
  const std::size_t most = any_more ? files_.size () : file_roles_.size ();
  if (files_.size () < needed || files_.size () > most)
    throw UsageError ("file names: " + std::to_string (needed) +
                      (any_more   ? " or more"
                       : one_more ? " or " + std::to_string (most)
                                  : "") +
                      " needed, " + std::to_string (files_.size ()) + " given\n" + usage (tool));
}

std::string
Options::usage (const std::string& tool) const
{
  std::string text = "usage: " + tool;
  for (const std::string& role : file_roles_)
    text += " " + role;
  text += " [options]";
  if (file_options_.empty ())
    return text;
  text += "\n  or:  " + tool; // as help2man expects it
  for (const Option& option : options_)
    if (std::find (file_options_.begin (), file_options_.end (), option.name) != file_options_.end ())
      text += " " + option.name + " " + option.value;
  return text + " [options]";
}

void
Options::printHelp (const std::string& tool) const
{
  // help2man recognises the parts of a man page by these words and blanks.
  const std::string synopsis = "U" + usage (tool).substr (1);
  std::printf ("%s\n\n%s\n\nOptions, before or after the file names:\n", purpose_.c_str (), synopsis.c_str ());
  std::size_t width = 8; // of -version
  for (const Option& option : options_)
    width = std::max (width, std::min (most_width, option.name.size () + 1 + option.value.size ()));
  printOptions ("", width);
  std::printf ("  %-*s  this help\n  %-*s  the version\n", static_cast<int> (width), "-h", static_cast<int> (width),
               "-version");
  std::vector<std::string> sections;
  for (const Option& option : options_)
    if (!option.section.empty () && std::find (sections.begin (), sections.end (), option.section) == sections.end ())
      sections.push_back (option.section);
  for (const std::string& section : sections) {
    std::printf ("\n%s:\n", section.c_str ());
    printOptions (section, width);
  }
  std::printf (
      "\nexit status: 0 done, 1 wrong usage, 2 a file cannot be read or written, 3 the data cannot be worked on,\n"
      "130 or 143 interrupted; nothing is written then.\n");
}

void
Options::printOptions (const std::string& section, std::size_t width) const
{
  const std::size_t indent = width + 4;
  for (const Option& option : options_) {
    if (option.section != section)
      continue;
    const std::string name = option.name + " " + option.value;
    if (name.size () > width)
      std::printf ("  %s\n%*s", name.c_str (), static_cast<int> (indent), "");
    else
      std::printf ("  %-*s  ", static_cast<int> (width), name.c_str ());
    printWrapped (option.help + " (default: " + option.standard + ")", indent);
  }
}
} // namespace tools
} // namespace pcl_normal_smoothing
