// SPDX-License-Identifier: BSD-3-Clause
#include "options.h"

#include "files/tool_error.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
[[noreturn]] void
refuse (const std::string& text, const std::string& expected)
{
  throw UsageError ("'" + text + "' is not " + expected);
}

std::string
shortest (double number)
{
  char digits[40];
  return {digits, std::to_chars (digits, digits + sizeof digits, number).ptr};
}

/** \return NaN where the text is no finite number */
double
finiteNumber (const std::string& text)
{
  double number = 0;
  const char* end = text.data () + text.size ();
  const auto result = std::from_chars (text.data (), end, number);
  const bool valid = result.ptr == end && result.ec == std::errc () && std::isfinite (number);
  return valid ? number : std::nan ("");
}
} // namespace

std::string
version ()
{
  return PCL_NORMAL_SMOOTHING_VERSION;
}

OptionReader
integerOption (std::int64_t least, std::int64_t most, const std::function<void (std::int64_t)>& use)
{
  return [=] (const std::string& text) {
    std::int64_t number = 0;
    const char* end = text.data () + text.size ();
    const auto result = std::from_chars (text.data (), end, number);
    if (result.ptr != end || result.ec != std::errc () || number < least || number > most)
      refuse (text, "a whole number from " + std::to_string (least) + " to " + std::to_string (most));
    use (number);
  };
}

OptionReader
positiveOption (const std::function<void (double)>& use)
{
  return [=] (const std::string& text) {
    const double number = finiteNumber (text);
    if (!(static_cast<float> (number) > 0) || std::isinf (static_cast<float> (number))) // the work is done in float
      refuse (text, "a number above 0");
    use (number);
  };
}

OptionReader
numberOption (double least, double limit, const std::function<void (double)>& use)
{
  return [=] (const std::string& text) {
    const double number = finiteNumber (text);
    if (!(number >= least && static_cast<float> (number) < limit))
      refuse (text, "a number of at least " + shortest (least) +
                        (std::isinf (limit) ? std::string () : " and below " + shortest (limit)));
    if (number != 0 && static_cast<float> (number) == 0) // the work is done in float
      refuse (text, "0, or a number from 1e-38 on");
    use (number);
  };
}

OptionReader
switchOption (const std::function<void (bool)>& use)
{
  return wordOption ({"0", "1"}, [use] (std::size_t i) { use (i == 1); });
}

OptionReader
wordOption (const std::vector<std::string>& words, const std::function<void (std::size_t)>& use)
{
  return [=] (const std::string& text) {
    const auto found = std::find (words.begin (), words.end (), text);
    if (found == words.end ()) {
      std::string list;
      for (const std::string& word : words)
        list += (list.empty () ? "" : ", ") + word;
      refuse (text, "one of " + list);
    }
    use (static_cast<std::size_t> (found - words.begin ()));
  };
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
  options_.push_back ({name, value, help, standard, reader, false, {}});
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
  if (asked ("-h") || asked ("--help")) {
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
      throw UsageError ("unknown option " + words[i] + ": see " + tool + " -h");
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
  // The words and blanks by which help2man tells the parts of a man page.
  const std::string synopsis = "U" + usage (tool).substr (1);
  std::printf ("%s\n\n%s\n\nOptions, before or after the file names:\n", purpose_.c_str (), synopsis.c_str ());
  std::size_t width = 8; // of -version
  for (const Option& option : options_)
    width = std::max (width, option.name.size () + 1 + option.value.size ());
  for (const Option& option : options_)
    std::printf ("  %-*s  %s (default: %s)\n", static_cast<int> (width), (option.name + " " + option.value).c_str (),
                 option.help.c_str (), option.standard.c_str ());
  std::printf ("  %-*s  this help\n  %-*s  the version\n", static_cast<int> (width), "-h", static_cast<int> (width),
               "-version");
  std::printf (
      "\nexit status: 0 done, 1 wrong usage, 2 a file cannot be read or written, 3 the data cannot be worked on,\n"
      "130 or 143 interrupted; nothing is written then.\n");
}
} // namespace tools
} // namespace pcl_normal_smoothing
