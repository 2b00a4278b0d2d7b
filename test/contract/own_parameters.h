// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "filter_fixture.h"

namespace test_support
{
/** Fixture for the parameters that are specific to one filter, with one point type. */
template <typename FilterT>
class OwnParameters : public FilterTest<FilterT>
{
protected:
  /** Expects a different result after \a set, and the original one after \a reset. */
  template <typename Set, typename Reset>
  void
  expectEffect (const Set& set, const Reset& reset)
  {
    FilterT filter;
    this->prepare (filter);
    reset (filter);
    const auto before = this->run (filter);
    set (filter);
    const auto changed = this->run (filter);
    bool differs = false;
    for (std::size_t i = 0; i < before.size (); ++i)
      differs = differs || !samePoint (before[i], changed[i]);
    EXPECT_TRUE (differs);
    reset (filter);
    expectSamePoints (this->run (filter), before);
  }

  void
  expectRefused (void (*set) (FilterT&), const std::string& value)
  {
    FilterT filter;
    this->prepare (filter);
    set (filter);
    this->expectError (filter, value);
  }
};
} // namespace test_support
