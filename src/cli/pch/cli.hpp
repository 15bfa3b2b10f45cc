// SPDX-License-Identifier: MIT
// cli.hpp - what nearly every subcommand includes, compiled once (-Db_pch=false does without).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "convexact/number.hpp"
