// SPDX-License-Identifier: MIT
#include "oracle/profiles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "io/json_text.hpp"
#include "number/text.hpp"
#include "scene/result_json.hpp"

namespace convexact {
namespace {

using nlohmann::json;

[[noreturn]] void fail_profile(const std::string& message) {
  throw Error(ErrorCode::Malformed, message);
}

Asks to_asks(const std::string& word) {
  if (const auto asks = value_in(kAsksNames, word)) return *asks;
  fail_profile("asks: expected enclosure, hull, inner or simplify, found " + in_quotes(word));
}

Precision to_precision(const std::string& word) {
  if (const auto precision = value_in(kPrecisionNames, word)) return *precision;
  fail_profile("numbers: expected binary64 or binary32, found " + in_quotes(word));
}

std::size_t to_cap(const json& number) {
  if (!number.is_number_unsigned()) fail_profile("expected a count, found " + number.dump());
  return number.get<std::size_t>();
}

Profile to_profile(const std::string& name, const json& entry) {
  Profile profile{name, entry.at("title").get<std::string>(), {}};
  Promise& promise = profile.promise;
  promise.asks = to_asks(entry.at("asks").get<std::string>());
  for (const auto& [key, value] : entry.items()) {
    if (key == "numbers") {
      promise.numbers = to_precision(value.get<std::string>());
    } else if (key == "tolerance") {
      promise.tolerance = parse_tolerance(value.get<std::string>());
    } else if (key == "allow_flat") {
      promise.allow_flat = value.get<bool>();
    } else if (key == "max_facets") {
      promise.max_facets = to_cap(value);
    } else if (key == "max_vertices") {
      promise.max_vertices = to_cap(value);
    } else if (key == "max_facet_vertices") {
      promise.max_facet_vertices = to_cap(value);
    } else if (key != "title" && key != "asks") {
      fail_profile("unknown key " + in_quotes(key));
    }
  }
  return profile;
}

}  // namespace

std::vector<Profile> read_profiles_bytes(std::string_view bytes) {
  std::vector<Profile> profiles;
  std::string name;
  try {
    const json document = parse_json(bytes);
    for (const auto& [key, entry] : document.at("profiles").items()) {
      name = key;
      profiles.push_back(to_profile(key, entry));
    }
  } catch (const std::exception& error) {
    fail_profile((name.empty() ? "" : "profile " + name + ": ") + error.what());
  }
  return profiles;
}

const Profile& profile_of_name(const std::vector<Profile>& profiles, const std::string& name) {
  std::string names;
  for (const Profile& profile : profiles) {
    if (profile.name == name) return profile;
    names += (names.empty() ? "" : ", ") + profile.name;
  }
  throw Error(ErrorCode::InvalidArgument,
              fmt::format("--profile {}: expected one of {}", in_quotes(name), names));
}

}  // namespace convexact
