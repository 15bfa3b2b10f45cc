// SPDX-License-Identifier: MIT
#include "cli/claim_list.hpp"

#include <CLI/CLI.hpp>

#include "convexact/error.hpp"

namespace convexact::cli {

std::vector<ClaimCode> parse_claims(const std::string& text) {
  std::vector<ClaimCode> claims;
  // A comma behind each word, since the splitter ignores an empty last word.
  for (const std::string& word : CLI::detail::split(text + ",", ',')) {
    const auto code = claim_of_name(word);
    if (!code) {
      std::string names;
      for (const ClaimCode known : kAllClaims) {
        names += (names.empty() ? "" : ", ") + std::string(name_of(known));
      }
      throw Error(ErrorCode::InvalidArgument,
                  "--claims: expected names out of " + names + "; found '" + word + "'");
    }
    claims.push_back(*code);
  }
  return claims;
}

}  // namespace convexact::cli
