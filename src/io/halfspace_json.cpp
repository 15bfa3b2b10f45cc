// SPDX-License-Identifier: MIT
#include "convexact/error.hpp"
#include "io/halfspace_formats.hpp"
#include "io/json_text.hpp"
#include "io/output_buffer.hpp"
#include "number/text.hpp"

namespace convexact {
namespace {

// Receives the events of the parser, which passes on numbers as they are spelled.
class HalfspaceEvents : public JsonEvents {
 public:
  explicit HalfspaceEvents(Decimal decimal) : decimal_(decimal) {}

  bool start_object(std::size_t) {
    expect_no_container();
    open();
    return true;
  }
  bool end_object() {
    close();
    return true;
  }
  bool key(const std::string& name) {
    if (depth_ != 1 || name != "halfspaces") return true;
    if (seen_) throw Error(ErrorCode::Malformed, "expected one key 'halfspaces', found two", line_);
    seen_ = list_is_next_ = true;
    return true;
  }
  bool start_array(std::size_t) {
    if (list_is_next_ || depth_ == 0) {
      list_depth_ = depth_ + 1;
      list_line_ = line_;
      list_is_next_ = false;
      seen_ = true;
    } else if (in_list() && depth_ == list_depth_) {
      row_.clear();
      row_line_ = line_;
    } else {
      expect_no_container();
    }
    open();
    return true;
  }
  bool end_array() {
    if (in_row()) end_row();
    if (depth_ == list_depth_) list_depth_ = 0;
    close();
    return true;
  }

  bool null() { return other_value("null"); }
  bool boolean(bool value) { return other_value(value ? "true" : "false"); }
  bool binary(std::vector<std::uint8_t>&) { return other_value("binary data"); }
  bool number_integer(std::int64_t value) { return number(std::to_string(value)); }
  bool number_unsigned(std::uint64_t value) { return number(std::to_string(value)); }
  bool number_float(double, const std::string& spelled) { return number(spelled); }
  bool string(const std::string& value) { return number(value); }

  HalfspaceList finish() {
    if (!seen_) {
      throw Error(ErrorCode::Malformed,
                  "expected an object with a key 'halfspaces', or an array of halfspaces");
    }
    // As in the other formats: it looks like the output of a program that failed.
    if (list_.row_count() == 0) {
      throw Error(ErrorCode::Malformed, "expected halfspaces [n1, n2, n3, d], found none",
                  list_line_);
    }
    return std::move(list_);
  }

 private:
  bool in_list() const { return list_depth_ > 0; }
  bool in_row() const { return in_list() && depth_ == list_depth_ + 1; }

  [[noreturn]] void fail_row(const std::string& message, ErrorCode code) const {
    throw Error(code, "halfspace " + std::to_string(list_.row_count()) + ": " + message, row_line_);
  }

  // An object, or an array that is neither the list nor a row of it.
  void expect_no_container() const {
    if (in_row()) fail_row("expected a number, found a list or object", ErrorCode::Malformed);
    if (in_list() || list_is_next_) fail_value("an object");
  }
  [[noreturn]] void fail_value(const std::string& found) const {
    throw Error(ErrorCode::Malformed,
                std::string("expected ") +
                    (list_is_next_ ? "an array of halfspaces" : "a halfspace [n1, n2, n3, d]") +
                    ", found " + found,
                line_);
  }

  bool number(const std::string& spelled) {
    if (!in_row()) return other_value(in_quotes(spelled));
    try {
      row_.push_back(parse_number(spelled, decimal_));
    } catch (const Error& error) {
      fail_row(error.what(), error.code());
    }
    return true;
  }
  bool other_value(const std::string& found) {
    if (in_row()) fail_row("expected a number, found " + found, ErrorCode::Malformed);
    if (in_list() || list_is_next_) fail_value(found);
    return true;
  }
  void end_row() {
    if (row_.size() != 4) {
      fail_row("expected 4 numbers, found " + std::to_string(row_.size()), ErrorCode::Malformed);
    }
    list_.add({row_[0], row_[1], row_[2]}, row_[3]);
  }

  Decimal decimal_;
  HalfspaceList list_;
  std::vector<Rational> row_;
  std::size_t row_line_ = 0, list_line_ = 0;
  std::size_t list_depth_ = 0;  // depth inside the array of halfspaces; 0: not in it
  bool list_is_next_ = false;   // the key has just been read
  bool seen_ = false;
};

}  // namespace

HalfspaceList read_halfspaces_json(std::string_view bytes, Decimal decimal) {
  HalfspaceEvents events(decimal);
  parse_json_events(bytes, events);
  return events.finish();
}

std::string write_halfspaces_json(std::span<const Halfspace> halfspaces) {
  OutputBuffer out;
  out.text("{\"halfspaces\": [");
  std::string_view separator = "\n";
  for (const Halfspace& h : halfspaces) {
    out.text(separator).text("[\"");
    for (const Integer& n : h.normal()) out.text(to_string(n)).text("\", \"");
    out.text(to_string(h.offset())).text("\"]");
    separator = ",\n";
  }
  return out.text("\n]}\n").finish();
}

std::string write_halfspaces_json(std::span<const BinaryHalfspace> halfspaces) {
  OutputBuffer out;
  out.text("{\"halfspaces\": [");
  std::string_view separator = "\n";
  for (const auto& [n1, n2, n3, d] : halfspaces) {
    out.text(separator).text("[");
    for (const double n : {n1, n2, n3}) out.number(n).text(", ");
    out.number(d).text("]");
    separator = ",\n";
  }
  return out.text("\n]}\n").finish();
}

}  // namespace convexact
