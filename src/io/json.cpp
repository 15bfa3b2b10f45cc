// SPDX-License-Identifier: MIT
#include "io/json.hpp"

#include <cmath>

#include "io/names.hpp"

namespace convexact {
namespace {

constexpr auto kErrorNames =
    name_table<ErrorCode>({{ErrorCode::InvalidArgument, "invalid-argument"},
                           {ErrorCode::Unreadable, "unreadable"},
                           {ErrorCode::Malformed, "malformed"},
                           {ErrorCode::NotFinite, "not-finite"},
                           {ErrorCode::NoInterior, "no-interior"},
                           {ErrorCode::Unwritable, "unwritable"},
                           {ErrorCode::Unrepresentable, "unrepresentable"},
                           {ErrorCode::Stopped, "stopped"},
                           {ErrorCode::Internal, "internal"}});

}  // namespace

Json error_json(const Error& error) {
  Json json = {{"code", name_in(kErrorNames, error.code())},
               {"message", error.what()},
               {"exit", exit_code(error.code())}};
  if (error.line()) json["line"] = *error.line();
  return json;
}

Json measured_json(const Measured& x, int digits) {
  const std::optional<std::string> decimal = to_decimal(x.bounds, digits);
  if (!decimal) throw Error(ErrorCode::Internal, "the bounds of a measure are too wide to print");
  const double value = to_double(parse_rational(*decimal), Rounding::Nearest);
  Json json = {{"value", value_or_null(value)}, {"decimal", *decimal}};
  if (x.exact) json["exact"] = to_string(*x.exact);
  return json;
}

Json plane_json(const Halfspace& h) { return h; }

Json vector_json(const RationalVector3& v) {
  return {to_string(v[0]), to_string(v[1]), to_string(v[2])};
}

Json value_or_null(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

Json bounds_json(const Enclosure& x) {
  return {{"low", x.low_double()}, {"high", x.high_double()}};
}

Json quantity_json(const std::optional<Rational>& x) {
  if (!x) return nullptr;
  return measured_json({Enclosure(*x, kMeasureBits), *x}, kDigits);
}

}  // namespace convexact
