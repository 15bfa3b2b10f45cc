// SPDX-License-Identifier: MIT
#include "io/json_document.hpp"

#include <algorithm>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"

namespace convexact {

Json::Json() : value_(nullptr) {}
Json::Json(std::nullptr_t) : value_(nullptr) {}
Json::Json(bool value) : value_(value) {}
Json::Json(int value) : value_(std::int64_t{value}) {}
Json::Json(long value) : value_(std::int64_t{value}) {}
Json::Json(long long value) : value_(std::int64_t{value}) {}
Json::Json(unsigned value) : value_(std::uint64_t{value}) {}
Json::Json(unsigned long value) : value_(std::uint64_t{value}) {}
Json::Json(unsigned long long value) : value_(std::uint64_t{value}) {}
Json::Json(double value) : value_(value) {}
Json::Json(const char* text) : Json(std::string(text)) {}
Json::Json(std::string text) : value_(std::make_unique<std::string>(std::move(text))) {}
Json::Json(std::string_view text) : Json(std::string(text)) {}
Json::Json(const Rational& value) : Json(to_string(value)) {}
Json::Json(const Halfspace& plane)
    : Json({to_string(plane.normal()[0]), to_string(plane.normal()[1]),
            to_string(plane.normal()[2]), to_string(plane.offset())}) {}

Json::Json(std::initializer_list<Json> items) {
  const bool is_object = std::all_of(items.begin(), items.end(), [](const Json& item) {
    return item.is_array() && item.size() == 2 && item[0].is_string();
  });
  if (is_object) {
    *this = object();
    for (const Json& item : items) {
      Items pair = std::move(*std::get<std::unique_ptr<Items>>(item.value_));
      if (!contains(pair[0].text())) (*this)[pair[0].text()] = std::move(pair[1]);
    }
  } else {
    *this = array(items);
  }
}

Json Json::array() {
  Json json;
  json.value_ = std::make_unique<Items>();
  return json;
}

Json Json::array(std::initializer_list<Json> items) {
  Json json = array();
  json.items().resize(items.size());
  std::transform(items.begin(), items.end(), json.items().begin(), [](const Json& item) {
    Json taken;
    taken.value_.swap(item.value_);
    return taken;
  });
  return json;
}

Json Json::object() {
  Json json;
  json.value_ = std::make_unique<Members>();
  return json;
}

Json::Json(const Json& other) {
  const auto copied = [](const auto& value) -> decltype(value_) {
    if constexpr (requires { *value; }) {
      return std::make_unique<std::decay_t<decltype(*value)>>(*value);
    } else {
      return value;
    }
  };
  value_ = std::visit(copied, other.value_);
}

Json::Json(Json&& other) noexcept : value_(std::exchange(other.value_, nullptr)) {}

Json& Json::operator=(const Json& other) { return *this = Json(other); }

// The old value goes last: the new one may be a part of it.
Json& Json::operator=(Json&& other) noexcept {
  Json taken(std::move(other));
  value_.swap(taken.value_);
  return *this;
}

// Deep documents must not need a deep stack: values that hold others are destroyed one by one.
Json::~Json() {
  if (!is_structured() || empty()) return;
  Items branches;
  take_branches(branches);
  while (!branches.empty()) {
    Json branch = std::move(branches.back());
    branches.pop_back();
    branch.take_branches(branches);
  }
}

void Json::take_branches(Items& into) {
  const auto take = [&into](Json& part) {
    if (part.is_structured() && !part.empty()) into.push_back(std::move(part));
  };
  if (is_array()) {
    for (Json& item : items()) take(item);
  } else {
    for (auto& [key, value] : members()) take(value);
  }
}

bool Json::is_null() const { return std::holds_alternative<std::nullptr_t>(value_); }
bool Json::is_string() const {
  return std::holds_alternative<std::unique_ptr<std::string>>(value_);
}
bool Json::is_array() const { return std::holds_alternative<std::unique_ptr<Items>>(value_); }
bool Json::is_object() const { return std::holds_alternative<std::unique_ptr<Members>>(value_); }
bool Json::is_double() const { return std::holds_alternative<double>(value_); }

Json::Items& Json::items() {
  if (is_null()) *this = array();
  return *std::get<std::unique_ptr<Items>>(value_);
}
const Json::Items& Json::items() const { return *std::get<std::unique_ptr<Items>>(value_); }

Json::Members& Json::members() {
  if (is_null()) *this = object();
  return *std::get<std::unique_ptr<Members>>(value_);
}
const Json::Members& Json::members() const { return *std::get<std::unique_ptr<Members>>(value_); }

void Json::push_back(Json item) { items().push_back(std::move(item)); }
Json& Json::emplace_back(Json item) { return items().emplace_back(std::move(item)); }
Json& Json::back() { return items().back(); }
const Json& Json::back() const { return items().back(); }
const Json& Json::operator[](std::size_t place) const { return items()[place]; }
Json& Json::operator[](std::size_t place) { return items()[place]; }
const Json* Json::begin() const { return items().data(); }
const Json* Json::end() const { return items().data() + items().size(); }

const Json* Json::find(std::string_view key) const {
  if (!is_object()) return nullptr;
  const auto found = std::find_if(members().begin(), members().end(),
                                  [key](const auto& member) { return member.first == key; });
  return found == members().end() ? nullptr : &found->second;
}

Json& Json::operator[](std::string_view key) {
  for (auto& [name, value] : members()) {
    if (name == key) return value;
  }
  return members().emplace_back(std::string(key), nullptr).second;
}

const Json& Json::operator[](std::string_view key) const {
  const Json* found = find(key);
  CONVEXACT_ASSERT(found != nullptr);
  return *found;
}

void Json::update(Json object) {
  for (auto& [key, value] : object.members()) (*this)[key] = std::move(value);
}

void Json::erase(std::string_view key) {
  std::erase_if(members(), [key](const auto& member) { return member.first == key; });
}

std::size_t Json::size() const {
  if (is_array()) return items().size();
  if (is_object()) return members().size();
  return is_null() ? 0 : 1;
}

const std::string& Json::text() const { return *std::get<std::unique_ptr<std::string>>(value_); }

double Json::number() const {
  if (const auto* value = std::get_if<std::int64_t>(&value_)) return static_cast<double>(*value);
  if (const auto* value = std::get_if<std::uint64_t>(&value_)) return static_cast<double>(*value);
  return std::get<double>(value_);
}

std::size_t Json::count() const {
  const auto* value = std::get_if<std::int64_t>(&value_);
  CONVEXACT_ASSERT(value == nullptr || *value >= 0);
  return static_cast<std::size_t>(value ? static_cast<std::uint64_t>(*value)
                                        : std::get<std::uint64_t>(value_));
}

bool operator==(const Json& a, const Json& b) {
  const auto equal = [&](const auto& x, const auto& y) {
    using X = std::decay_t<decltype(x)>;
    using Y = std::decay_t<decltype(y)>;
    constexpr bool are_numbers = std::is_arithmetic_v<X> && std::is_arithmetic_v<Y> &&
                                 !std::is_same_v<X, bool> && !std::is_same_v<Y, bool>;
    if constexpr (std::is_integral_v<X> && std::is_integral_v<Y> && are_numbers) {
      return std::cmp_equal(x, y);
    } else if constexpr (are_numbers) {
      return static_cast<double>(x) == static_cast<double>(y);
    } else if constexpr (!std::is_same_v<X, Y>) {
      return false;
    } else if constexpr (requires { *x; }) {
      return *x == *y;
    } else {
      return x == y;
    }
  };
  return std::visit(equal, a.value_, b.value_);
}

}  // namespace convexact
