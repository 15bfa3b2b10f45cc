// SPDX-License-Identifier: MIT
// library.hpp - the headers that nearly every source includes, compiled once (-Db_pch=false turns
// this off).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "convexact/number.hpp"
