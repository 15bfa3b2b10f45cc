// SPDX-License-Identifier: MIT
// tests.hpp - the headers that nearly every test includes, compiled once for each program.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "convexact/number.hpp"
