// SPDX-License-Identifier: MIT
// build_info.hpp - what the program was built from, and how.
#pragma once

namespace convexact::cli {

extern const char* const kCommit;    ///< "unknown" if it was built outside of a repository.
extern const char* const kFlags;     ///< Of the compiler, as far as they change what is measured.
extern const char* const kCompiler;  ///< With its version.

}  // namespace convexact::cli
