// SPDX-License-Identifier: MIT

#include "io/halfspace_formats.hpp"
#include "io/output_buffer.hpp"
#include "io/text_cursor.hpp"
#include "number/text.hpp"

namespace convexact {
namespace {

class IneReader {
 public:
  IneReader(std::string_view bytes, Decimal decimal)
      : cursor_(bytes, {.comment = '*'}), decimal_(decimal) {}

  HalfspaceList read() {
    for (auto token = cursor_.expect_line("begin"); token != "begin";
         token = cursor_.expect_line("begin")) {
      check_option(token);
    }
    const std::uint32_t rows = read_sizes();
    for (std::uint32_t row = 0; row < rows; ++row) read_row(row);
    if (const auto token = cursor_.expect_line("end"); token != "end") {
      cursor_.fail_expected("end", token);
    }
    while (cursor_.next_line()) check_option(cursor_.token());
    return std::move(list_);
  }

 private:
  // Lines outside of begin ... end hold names and requests. Only those that change the meaning of
  // rows matter.
  void check_option(std::string_view option) {
    if (option == "V-representation") {
      cursor_.fail_expected("H-representation", option);
    }
    const bool changes_rows = option == "linearity" || option == "equality" ||
                              option == "partial_enumeration" || option == "strict_inequality";
    if (changes_rows && cursor_.token() != "0") {
      cursor_.fail("expected inequalities only, found " + in_quotes(option));
    }
  }

  // m n type
  std::uint32_t read_sizes() {
    const std::uint32_t rows =
        cursor_.to_count(cursor_.expect_line("the number of rows"), "the number of rows");
    const std::string_view columns = cursor_.token();
    if (columns != "4") cursor_.fail_expected("4 columns for three dimensions", columns);
    const std::string_view type = cursor_.token();
    takes_decimals_ = type == "real";
    if (type != "integer" && type != "rational" && type != "real") {
      cursor_.fail_expected("integer, rational or real", type);
    }
    cursor_.expect_line_end();
    if (rows == 0) cursor_.fail("expected rows b a1 a2 a3, found none");
    constexpr std::uint64_t kShortestRow = 8;  // "0 0 0 0\n"
    if (rows * kShortestRow > cursor_.remaining() + 1) {
      cursor_.fail("expected " + std::to_string(rows) + " rows, found a file too short for them");
    }
    return rows;
  }

  void read_row(std::uint32_t row) {
    const Rational b = to_number(cursor_.expect_line("halfspace", row));
    RationalVector3 a;
    for (Rational& x : a) x = to_number(cursor_.expect_token("four numbers"));
    cursor_.expect_line_end();
    list_.add(-a, -b);
  }

  Rational to_number(std::string_view token) const {
    const bool is_decimal = token.find_first_not_of("+-0123456789/") != std::string_view::npos;
    if (is_decimal && !takes_decimals_) cursor_.fail_expected("an integer or a fraction", token);
    try {
      return parse_number(token, decimal_);
    } catch (const Error& error) {
      cursor_.fail(error.what(), error.code());
    }
  }

  TextCursor cursor_;
  Decimal decimal_;
  bool takes_decimals_ = false;
  HalfspaceList list_;
};

OutputBuffer begin_ine(std::size_t rows, std::string_view type) {
  OutputBuffer out;
  out.text("H-representation\nbegin\n").number(rows).text(" 4 ").text(type).text("\n");
  return out;
}

}  // namespace

HalfspaceList read_ine(std::string_view bytes, Decimal decimal) {
  return IneReader(bytes, decimal).read();
}

std::string write_ine(std::span<const Halfspace> halfspaces) {
  OutputBuffer out = begin_ine(halfspaces.size(), "integer");
  for (const Halfspace& h : halfspaces) {
    out.text(to_string(Integer(-h.offset())));
    for (const Integer& n : h.normal()) out.text(" ").text(to_string(Integer(-n)));
    out.text("\n");
  }
  return out.text("end\n").finish();
}

std::string write_ine(std::span<const BinaryHalfspace> halfspaces) {
  OutputBuffer out = begin_ine(halfspaces.size(), "real");
  for (const auto& [n1, n2, n3, d] : halfspaces) {
    out.number(-d);
    for (const double n : {n1, n2, n3}) out.text(" ").number(-n);
    out.text("\n");
  }
  return out.text("end\n").finish();
}

}  // namespace convexact
