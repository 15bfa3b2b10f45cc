// SPDX-License-Identifier: MIT
// cli.hpp - the headers that nearly every subcommand includes, compiled once (-Db_pch=false turns
// this off).
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "convexact/number.hpp"
