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
/** The options of a smoothing, which keys change. */
class ViewerParameters
{
public:
  /** Options by name, each with the text of its value. */
  using Given = std::map<std::string, std::string>;

  /** \param[in] given the options of the command line
    * \param[in] known defines the words that an option accepts */
  ViewerParameters (const Given& given, const Options& known);

  /** Sets what the last smoothing used, as options: these can be selected and changed. */
  void
  setUsed (const std::string& options);

  /** \param[in] key its character ("k", "K") or its name in X ("Up", "BackSpace")
    * \return whether the options have changed; selecting one does not change them */
  bool
  press (const std::string& key);

  /** The options to smooth with. */
  const Given&
  options () const
  {
    return options_;
  }

  /** Undoes the last change, for when it turns out to be invalid. */
  void
  takeBack ()
  {
    options_ = before_;
  }

  /** What was used, one option per line; the selected one is marked ">", those that were set "*". */
  std::string
  text () const;

  /** What the keys do, one per line. */
  static const char*
  help ();

private:
  void
  select (const std::string& option);

  /** Makes the selected option larger or smaller, or takes its next or previous word. */
  void
  step (int direction);

  Given given_, options_, before_;
  std::map<std::string, std::vector<std::string>> words_;
  std::vector<std::pair<std::string, std::string>> used_;
  std::string selected_ = "-preset";
};
} // namespace tools
} // namespace pcl_normal_smoothing
