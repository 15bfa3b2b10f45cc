// SPDX-License-Identifier: MIT
// Tables of cdd and lrs, and the halfspaces in one.
#include "io/halfspace_formats.hpp"
#include "io/output_buffer.hpp"
#include "io/polyhedron_table.hpp"
#include "io/text_cursor.hpp"
#include "number/text.hpp"

namespace convexact {
namespace {

class TableReader {
 public:
  TableReader(std::string_view bytes, Decimal decimal, Representation wanted)
      : cursor_(bytes, {.comment = kComment}), decimal_(decimal), wanted_(wanted) {}

  PolyhedronTable read() {
    for (auto token = cursor_.expect_line("begin"); token != "begin";
         token = cursor_.expect_line("begin")) {
      check_option(token);
    }
    const std::optional<std::uint32_t> rows = read_sizes();
    std::uint32_t row = 0;
    std::string_view token = expect_row_or_end(row);
    for (; rows ? row < *rows : token != "end"; token = expect_row_or_end(++row)) {
      read_row(token);
    }
    if (token != "end") cursor_.fail_expected("end", token);
    if (table_.rows.empty()) cursor_.fail("expected rows b a1 a2 a3, found none");
    while (cursor_.next_line()) check_option(cursor_.token());
    for (const std::size_t linear : table_.linear) {
      if (linear >= table_.rows.size()) {
        cursor_.fail("expected linearity to name one of " + std::to_string(table_.rows.size()) +
                     " rows, found " + std::to_string(linear + 1));
      }
    }
    return std::move(table_);
  }

 private:
  static constexpr char kComment = '*';

  std::string_view expect_row_or_end(std::uint32_t row) {
    // As many as announced were read.
    if (expected_ && row == *expected_) return cursor_.expect_line("end");
    return cursor_.expect_line(wanted_ == Representation::H ? "halfspace" : "row", row);
  }

  // Lines outside of begin ... end hold names and requests. Only those that change the meaning of
  // rows matter.
  void check_option(std::string_view option) {
    const bool is_h = wanted_ == Representation::H;
    if (option == (is_h ? "V-representation" : "H-representation")) {
      cursor_.fail_expected(
          is_h ? "H-representation (points are read from a .ext)" : "V-representation", option);
    }
    if (option == "linearity" || option == "equality") return read_linearity();
    const bool changes_rows = option == "partial_enumeration" || option == "strict_inequality";
    if (changes_rows && cursor_.token() != "0") {
      cursor_.fail("expected inequalities and equations only, found " + in_quotes(option));
    }
  }

  // k i1 ... ik, from 1.
  void read_linearity() {
    const auto next = [&] {
      return cursor_.to_count(cursor_.expect_token("as many rows as announced"), "a row, from 1");
    };
    for (std::uint32_t k = next(); k > 0; --k) {
      const std::uint32_t row = next();
      if (row == 0) cursor_.fail("expected a row, from 1, found 0");
      table_.linear.push_back(row - 1);
    }
  }

  // m n type; lrs writes ***** for an m that it does not know.
  std::optional<std::uint32_t> read_sizes() {
    cursor_.set_comment('\0');
    std::string_view first = cursor_.expect_line("the number of rows");
    while (first.front() == kComment && first != "*****") {
      first = cursor_.expect_line("the number of rows");
    }
    cursor_.set_comment(kComment);
    if (first != "*****") expected_ = cursor_.to_count(first, "the number of rows");
    const std::string_view columns = cursor_.token();
    if (columns != "4") cursor_.fail_expected("4 columns for three dimensions", columns);
    const std::string_view type = cursor_.token();
    takes_decimals_ = type == "real";
    if (type != "integer" && type != "rational" && type != "real") {
      cursor_.fail_expected("integer, rational or real", type);
    }
    cursor_.expect_line_end();
    if (expected_ == 0u) cursor_.fail("expected rows b a1 a2 a3, found none");
    constexpr std::uint64_t kShortestRow = 8;  // "0 0 0 0\n"
    if (expected_ && *expected_ * kShortestRow > cursor_.remaining() + 1) {
      cursor_.fail("expected " + std::to_string(*expected_) +
                   " rows, found a file too short for them");
    }
    return expected_;
  }

  void read_row(std::string_view first) {
    std::array<Rational, 4>& row = table_.rows.emplace_back();
    row[0] = to_number(first);
    for (std::size_t k = 1; k < 4; ++k) row[k] = to_number(cursor_.expect_token("four numbers"));
    cursor_.expect_line_end();
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
  Representation wanted_;
  bool takes_decimals_ = false;
  std::optional<std::uint32_t> expected_;  // rows
  PolyhedronTable table_;
};

OutputBuffer begin_ine(std::size_t rows, std::string_view type) {
  OutputBuffer out;
  out.text("H-representation\nbegin\n").number(rows).text(" 4 ").text(type).text("\n");
  return out;
}

}  // namespace

PolyhedronTable read_polyhedron_table(std::string_view bytes, Decimal decimal,
                                      Representation wanted) {
  return TableReader(bytes, decimal, wanted).read();
}

HalfspaceList read_ine(std::string_view bytes, Decimal decimal) {
  const PolyhedronTable table = read_polyhedron_table(bytes, decimal, Representation::H);
  HalfspaceList list;
  for (const auto& [b, x, y, z] : table.rows) list.add(-RationalVector3(x, y, z), -b);
  // An equation is two halfspaces; the second ones follow all rows.
  for (const std::size_t row : table.linear) {
    const auto& [b, x, y, z] = table.rows[row];
    list.add(RationalVector3(x, y, z), b);
  }
  return list;
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
