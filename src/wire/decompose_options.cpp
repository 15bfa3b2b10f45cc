// SPDX-License-Identifier: MIT
#include "wire/decompose_options.hpp"

#include "convexact/error.hpp"
#include "number/text.hpp"

namespace convexact {

ConcavityLimit parse_concavity(const std::string& option, const std::string& text) {
  const bool is_percent = text.ends_with('%'), is_share = is_percent || text.ends_with('d');
  try {
    Rational value = parse_rational(text.substr(0, text.size() - (is_share ? 1 : 0)));
    if (is_percent) value /= 100;
    if (value >= 0 && (!is_share || value <= 1)) return {std::move(value), is_share};
  } catch (const Error&) {  // told below
  }
  throw Error(ErrorCode::InvalidArgument,
              option +
                  ": expected a share of the diameter from 0 to 1, such as 3% or 0.03d, or a "
                  "length of at least 0, such as 0.05, found " +
                  in_quotes(text));
}

Rational parse_cosine(const std::string& option, const std::string& text) {
  try {
    Rational cosine = parse_rational(text);
    if (cosine > 0 && cosine <= 1) return cosine;
  } catch (const Error&) {  // told below
  }
  throw Error(ErrorCode::InvalidArgument,
              option +
                  ": expected the cosine of an angle, above 0 and at most 1, such as 0.99, found " +
                  in_quotes(text));
}

}  // namespace convexact
