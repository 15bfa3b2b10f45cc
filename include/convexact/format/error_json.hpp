// SPDX-License-Identifier: MIT
// error_json.hpp - errors as JSON, the same wherever they are told.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "convexact/error.hpp"

namespace convexact {

/// {"code": "malformed", "message": one sentence, "exit": 3} and, if it is known, "line".
[[nodiscard]] nlohmann::ordered_json error_json(const Error& error);

}  // namespace convexact
