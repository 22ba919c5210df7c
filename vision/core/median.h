// The median of what is in a vector.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cassert>
#include <vector>

namespace spool {

// Of an even number the upper of the two in the middle. Of at least one value; reorders them.
template <class T>
[[nodiscard]] T median(std::vector<T>& values) {
  assert(!values.empty() && "of nothing there is no median");
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace spool
