// SPDX-License-Identifier: MIT
// program_output.hpp - reads what another program left as its output.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "convexact/number.hpp"
#include "convexact/verify.hpp"

namespace convexact {

/// The candidate in a file that another program made: a mesh without points if it is empty or
/// blank, nothing if there is no file. A file that is none (a FIFO, a folder, a device, also behind
/// a link) is not opened for reading, and one of more than `most` bytes is not read: both are the
/// error of the candidate, as is what its bytes do not spell.
[[nodiscard]] std::optional<Candidate> read_program_output(const std::string& path, Decimal decimal,
                                                           std::uint64_t most);

}  // namespace convexact
