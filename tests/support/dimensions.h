// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_support_dimensions_h
#define tests_support_dimensions_h

#include <gtest/gtest.h>
#include <type_traits>

/// For typed tests in two and three dimensions: `TypeParam::value` is dim.
using Dimensions = testing::Types<std::integral_constant<int, 2>,
                                  std::integral_constant<int, 3>>;

#endif
