// SPDX-License-Identifier: BSD-3-Clause
#include "option_readers.h"

#include "files/tool_error.h"

#include <algorithm>
#include <charconv>
#include <cmath>

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

/** \return NaN if the text is not a finite number */
double
finiteNumber (const std::string& text)
{
  double number = 0;
  const char* end = text.data () + text.size ();
  const auto result = std::from_chars (text.data (), end, number);
  const bool valid = result.ptr == end && result.ec == std::errc () && std::isfinite (number);
  return valid ? number : std::nan ("");
}

/** \throw UsageError always; it explains how to write numbers if \a text begins like one, but is not one */
[[noreturn]] void
refuseNumber (const std::string& text, const std::string& expected)
{
  const bool begins_so = !text.empty () && text.find_first_of ("+-.0123456789") == 0;
  refuse (text, expected + (begins_so && std::isnan (finiteNumber (text))
                                ? ", written as 0.005: with a point, and without a unit"
                                : ""));
}
} // namespace

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
      refuseNumber (text, "a number above 0");
    use (number);
  };
}

OptionReader
numberOption (double least, double limit, const std::function<void (double)>& use)
{
  return [=] (const std::string& text) {
    const double number = finiteNumber (text);
    if (!(number >= least && static_cast<float> (number) < limit))
      refuseNumber (text, "a number of at least " + shortest (least) +
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
} // namespace tools
} // namespace pcl_normal_smoothing
