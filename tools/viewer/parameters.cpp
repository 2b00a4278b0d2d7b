// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/parameters.h"

#include "files/field_values.h"

#include <core/limits.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <sstream>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
/** Keys that change an option, whichever is selected: a small letter makes it smaller, a capital larger. */
const std::map<char, std::string> letters {
    {'k', "-k"},           {'i', "-point_iterations"}, {'n', "-normal_iterations"},
    {'s', "-noise_sigma"}, {'t', "-sheet_distance"},   {'d', "-max_displacement"}};
const std::array<std::string, 3> presets {"default", "fast", "paper"};

/** Options that are not shown: nobody would try other values. */
const std::vector<std::string> hidden {"-seed", "-oriented", "-max_radius"};

constexpr double factor = 1.25;

std::string
shortText (double number)
{
  std::ostringstream text;
  text.precision (3);
  text << number;
  return text.str ();
}

std::string
integerStep (const std::string& option, const std::string& text, int direction, bool rounds)
{
  const long number = std::atol (text.c_str ());
  if (option != "-k")
    return std::to_string (std::clamp (number + direction, 0L, rounds ? core::max_rounds : 1000L));
  return std::to_string (
      std::clamp (number + direction * std::max (1L, number / 4), rounds ? core::min_fit_points : 3L, 256L));
}

bool
isInteger (const std::string& option)
{
  return option == "-k" || option.find ("_iterations") != std::string::npos;
}

std::string
numberStep (const std::string& option, const std::string& text, int direction)
{
  const double number = std::strtod (text.c_str (), nullptr);
  if (option == "-threshold")
    return shortText (std::clamp (number + 0.05 * direction, 0.0, 0.95));
  return shortText (direction > 0 ? number * factor : number / factor);
}
} // namespace

ViewerParameters::ViewerParameters (const Given& given, const Options& known)
: given_ (given), options_ (given), before_ (given)
{
  for (const std::string option :
       {"-preset", "-normals", "-weights", "-mixed", "-update", "-noise_varies", "-widen_neighborhoods"}) {
    std::istringstream words (known.valueOf (option));
    for (std::string word; std::getline (words, word, '|');)
      words_[option].push_back (word);
  }
}

void
ViewerParameters::setUsed (const std::string& options)
{
  used_.clear ();
  std::istringstream words (options);
  for (std::string name, value; words >> name >> value;)
    if (std::find (hidden.begin (), hidden.end (), name) == hidden.end ())
      used_.emplace_back (name, value);
  select (selected_);
}

void
ViewerParameters::select (const std::string& option)
{
  const auto same = [&] (const auto& used) { return used.first == option; };
  if (std::any_of (used_.begin (), used_.end (), same))
    selected_ = option;
  else if (!used_.empty ())
    selected_ = used_.front ().first;
}

bool
ViewerParameters::press (const std::string& key)
{
  before_ = options_;
  const auto here = std::find_if (used_.begin (), used_.end (), [&] (const auto& u) { return u.first == selected_; });
  if (here == used_.end ())
    return false;
  const auto letter = key.size () == 1 ? letters.find (static_cast<char> (std::tolower (key[0]))) : letters.end ();
  if (key == "Up" && here != used_.begin ())
    selected_ = std::prev (here)->first;
  else if (key == "Down" && std::next (here) != used_.end ())
    selected_ = std::next (here)->first;
  else if (key == "Left" || key == "Right")
    step (key == "Left" ? -1 : 1);
  else if (key == "BackSpace")
    options_.erase (selected_);
  else if (key == "0")
    options_ = given_;
  else if (key == "1" || key == "2" || key == "3")
    options_ = {{"-preset", presets[static_cast<std::size_t> (key[0] - '1')]}};
  else if (letter != letters.end ()) {
    select (letter->second);
    if (selected_ == letter->second)
      step (std::isupper (key[0]) ? 1 : -1);
  }
  return options_ != before_;
}

void
ViewerParameters::step (int direction)
{
  const auto here = std::find_if (used_.begin (), used_.end (), [&] (const auto& u) { return u.first == selected_; });
  const std::string& text = here->second;
  const bool rounds =
      std::any_of (used_.begin (), used_.end (), [] (const auto& used) { return used.first == "-noise_sigma"; });
  const auto words = words_.find (selected_);
  if (words != words_.end ()) {
    const auto& list = words->second;
    const auto at = std::find (list.begin (), list.end (), text) - list.begin ();
    const auto count = static_cast<std::ptrdiff_t> (list.size ());
    const std::string& word = list[static_cast<std::size_t> ((at + direction + count) % count)];
    if (selected_ == "-preset") // options set for one preset do not suit another, and may choose the chain
      options_ = {};
    options_[selected_] = word;
  }
  else if (isInteger (selected_))
    options_[selected_] = integerStep (selected_, text, direction, rounds);
  else if (text == "inf") // from no limit back to the default
    options_.erase (selected_);
  else
    options_[selected_] = numberStep (selected_, text, direction);
  // Given alone, -noise_sigma would make the noise even.
  const std::pair<std::string, std::string> varies ("-noise_varies", "1");
  if (selected_ == "-noise_sigma" && std::find (used_.begin (), used_.end (), varies) != used_.end ())
    options_.insert (varies);
}

std::string
ViewerParameters::text () const
{
  std::ostringstream lines;
  for (const auto& [name, value] : used_) {
    const bool number = words_.find (name) == words_.end () && value != "inf";
    lines << (name == selected_ ? "> " : "  ") << name.substr (1)
          << std::string (22 - std::min<std::size_t> (21, name.size ()), ' ')
          << (number ? shortText (std::strtod (value.c_str (), nullptr)) : value)
          << (options_.count (name) > 0 ? " *" : "") << "\n";
  }
  return lines.str ();
}

const char*
ViewerParameters::help ()
{
  return "  1 2 3        preset default, fast, paper: all parameters as it has them\n"
         "  Up Down      select a parameter (>)\n"
         "  Left Right   make it smaller, larger\n"
         "  Backspace    let the cloud or the preset decide it (no *)\n"
         "  0            all parameters as on the command line\n"
         "  k K i I n N  fewer, more: neighbours, iterations, normal iterations\n"
         "  s S t T d D  smaller, larger: noise sigma, sheet distance, displacement cap\n";
}
} // namespace tools
} // namespace pcl_normal_smoothing
