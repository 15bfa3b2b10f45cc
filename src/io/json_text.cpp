// SPDX-License-Identifier: MIT
#include "io/json_text.hpp"

#include <algorithm>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "number/text.hpp"

namespace {

// The numbers of a row in their order, as compilers evaluate arguments in any: of several faults
// the first one is told.
template <class Number>
convexact::RationalVector3 three(const Number& number) {
  const auto x = number(0), y = number(1), z = number(2);
  return {x, y, z};
}

}  // namespace

convexact::Rational nlohmann::adl_serializer<convexact::Rational>::from_json(
    const nlohmann::json& json) {
  return convexact::parse_rational(json.get_ref<const std::string&>());
}

convexact::Halfspace nlohmann::adl_serializer<convexact::Halfspace>::from_json(
    const nlohmann::json& json) {
  const auto number = [&json](std::size_t i) { return json.at(i).get<convexact::Rational>(); };
  return {three(number), number(3)};
}

namespace convexact {

using nlohmann::json;

bool JsonEvents::parse_error(std::size_t byte, const std::string& token,
                             const json::exception& why) {
  constexpr int kNumberOverflow = 406;
  if (why.id == kNumberOverflow) {
    throw Error(ErrorCode::NotFinite,
                "expected a number within the doubles (or an integer or fraction as a string), "
                "found " +
                    in_quotes(token),
                line_);
  }
  throw Error(ErrorCode::Malformed,
              "expected JSON, found " + (token.empty() ? "the end" : in_quotes(token)) +
                  " at byte " + std::to_string(byte),
              line_);
}

void JsonEvents::open() {
  if (++depth_ <= kMaxJsonDepth) return;
  throw Error(ErrorCode::Malformed,
              "expected at most " + std::to_string(kMaxJsonDepth) +
                  " lists and objects within each other, found more",
              line_);
}

bool JsonDocument::take_spelled(std::string_view text) {
  return take(json::binary({text.begin(), text.end()}));
}

// Minus zero is the only zero that the parser reports as signed.
bool JsonDocument::number_integer(std::int64_t value) {
  if (spelled_depth_ == 0) return take(value);
  return take_spelled(value == 0 ? "-0" : std::to_string(value));
}

bool JsonDocument::number_unsigned(std::uint64_t value) {
  return spelled_depth_ == 0 ? take(value) : take_spelled(std::to_string(value));
}

bool JsonDocument::number_float(double value, const std::string& spelling) {
  return spelled_depth_ == 0 ? take(value) : take_spelled(spelling);
}

bool JsonDocument::key(std::string& name) {
  if (open_.back()->contains(name)) {
    throw Error(ErrorCode::Malformed,
                "expected the key " + in_quotes(name) + " once, found it twice", line_);
  }
  if (spelled_depth_ == 0 || depth_ <= spelled_depth_) {
    const bool is_spelled = std::find(spelled_.begin(), spelled_.end(), name) != spelled_.end();
    spelled_depth_ = is_spelled ? depth_ : 0;
  }
  key_ = std::move(name);
  return true;
}

json& JsonDocument::put(json value) {
  if (open_.empty()) return document = std::move(value);
  if (open_.back()->is_object()) return (*open_.back())[key_] = std::move(value);
  open_.back()->push_back(std::move(value));
  return open_.back()->back();
}

bool JsonDocument::open_with(json container) {
  open();
  open_.push_back(&put(std::move(container)));
  return true;
}

bool JsonDocument::close_last() {
  close();
  open_.pop_back();
  if (depth_ < spelled_depth_) spelled_depth_ = 0;
  return true;
}

void parse_json_events(std::string_view bytes, JsonDocument& events) {
  parse_json_events<JsonDocument>(bytes, events);
}

std::string dump_json(const json& value) { return value.dump(); }

json parse_json(std::string_view bytes) {
  JsonDocument reader;
  parse_json_events(bytes, reader);
  return std::move(reader.document);
}

std::string_view spelling_of(const json& value) {
  if (value.is_string()) return value.get_ref<const std::string&>();
  if (!value.is_binary()) return {};
  const json::binary_t& text = value.get_binary();
  return {reinterpret_cast<const char*>(text.data()), text.size()};
}

namespace {

[[noreturn]] void reject_row(const std::string& expected) {
  throw Error(ErrorCode::Malformed, "expected " + expected);
}

const json& row_of(const json& rows, std::size_t row, std::size_t length, const char* what) {
  const json& numbers = rows[row];
  if (!numbers.is_array() || numbers.size() != length) {
    reject_row(std::string(what) + " " + std::to_string(row) + " as an array of " +
               std::to_string(length));
  }
  return numbers;
}

}  // namespace

PointSet points_of_json(const json& rows, const char* what, const JsonNumber& number) {
  if (!rows.is_array()) reject_row(std::string("an array with a row for each ") + what);
  std::vector<RationalPoint> list;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const json& x = row_of(rows, r, 3, what);
    list.push_back(three([&](std::size_t k) { return number(x[k]); }));
  }
  return PointSet(std::move(list));
}

HalfspaceList halfspaces_of_json(const json& rows, const JsonNumber& number) {
  if (!rows.is_array()) reject_row("an array with a row for each plane");
  HalfspaceList list;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const json& x = row_of(rows, r, 4, "plane");
    const RationalVector3 normal = three([&](std::size_t k) { return number(x[k]); });
    list.add(normal, number(x[3]));
  }
  return list;
}

std::vector<std::vector<std::uint32_t>> polygons_of_json(const json& rows, std::size_t points) {
  if (!rows.is_array()) reject_row("an array with a row for each face");
  std::vector<std::vector<std::uint32_t>> polygons;
  for (const json& row : rows) {
    if (!row.is_array() || row.size() < 3) {
      reject_row("a face as an array of three corners or more");
    }
    std::vector<std::uint32_t>& polygon = polygons.emplace_back();
    for (const json& corner : row) {
      if (!corner.is_number_unsigned() || corner.get<std::uint64_t>() >= points) {
        reject_row("the index of one of " + std::to_string(points) + " vertices, found " +
                   in_quotes(dump_json(corner)));
      }
      polygon.push_back(corner.get<std::uint32_t>());
    }
  }
  return polygons;
}

}  // namespace convexact
