// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "command_line/options.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace pcl_normal_smoothing
{
namespace tools
{
/** The options of a smoothing, as keys change them. */
class ViewerParameters
{
public:
  /** By their names, each with its text. */
  using Given = std::map<std::string, std::string>;

  /** \param[in] given the options of the command line
    * \param[in] known tells which words an option takes */
  ViewerParameters (const Given& given, const Options& known);

  /** Tells what the last smoothing used, as options: what there is to change. */
  void
  setUsed (const std::string& options);

  /** \param[in] key what it stands for, "k", "K", or its name in X, "Up", "BackSpace"
    * \return whether the options are others now; to select one changes none */
  bool
  press (const std::string& key);

  /** What to smooth with. */
  const Given&
  options () const
  {
    return options_;
  }

  /** Options as before a change that turned out to be none to smooth with. */
  void
  takeBack ()
  {
    options_ = before_;
  }

  /** A line each: what was used, the selected one marked ">", those that were set marked "*". */
  std::string
  text () const;

  /** What the keys do, a line each. */
  static const char*
  help ();

private:
  void
  select (const std::string& option);

  /** Makes the selected option larger, or smaller, or the next word. */
  void
  step (int direction);

  Given given_, options_, before_;
  std::map<std::string, std::vector<std::string>> words_;
  std::vector<std::pair<std::string, std::string>> used_;
  std::string selected_ = "-preset";
};
} // namespace tools
} // namespace pcl_normal_smoothing
