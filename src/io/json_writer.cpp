// SPDX-License-Identifier: MIT
// The text of documents that the program writes.
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "io/json_document.hpp"

namespace convexact {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

// How many bytes from `at` form a character of UTF-8 [Unicode, table 3-7], and whether it is
// complete: if not, they are the longest beginning of one, or a byte with which none begins.
struct Character {
  std::size_t length;
  bool is_complete;
};

Character character_at(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[at + k]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return {1, true};
  if (lead < 0xC2 || lead > 0xF4) return {1, false};
  // Overlong forms, surrogates and numbers beyond U+10FFFF are told by the second byte.
  const unsigned char least = lead == 0xE0 ? 0xA0 : lead == 0xF0 ? 0x90 : 0x80;
  const unsigned char most = lead == 0xED ? 0x9F : lead == 0xF4 ? 0x8F : 0xBF;
  const std::size_t length = lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  for (std::size_t k = 1; k < length; ++k) {
    if (at + k == text.size()) return {k, false};
    if (byte(k) < (k == 1 ? least : 0x80) || byte(k) > (k == 1 ? most : 0xBF)) return {k, false};
  }
  return {length, true};
}

void append_escaped(std::string& out, unsigned char control) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  switch (control) {
    case '\b':
      out += "\\b";
      return;
    case '\t':
      out += "\\t";
      return;
    case '\n':
      out += "\\n";
      return;
    case '\f':
      out += "\\f";
      return;
    case '\r':
      out += "\\r";
      return;
    default:
      out += "\\u00";
      out += kDigits[control >> 4];
      out += kDigits[control & 15];
  }
}

void append_text(std::string& out, std::string_view text) {
  out += '"';
  for (std::size_t at = 0; at < text.size();) {
    const auto [length, is_complete] = character_at(text, at);
    const auto first = static_cast<unsigned char>(text[at]);
    if (!is_complete) {
      out += kReplacement;
    } else if (first < 0x20) {
      append_escaped(out, first);
    } else {
      if (first == '"' || first == '\\') out += '\\';
      out += text.substr(at, length);
    }
    at += length;
  }
  out += '"';
}

// The shortest digits, with a point within them or up to 15 digits before it and 3 zeros after it,
// else as d.ddde+XX: a double never reads as an integer.
void append_double(std::string& out, double value) {
  if (!std::isfinite(value)) {
    out += "null";
    return;
  }
  if (std::signbit(value)) out += '-';
  constexpr int kMostBefore = std::numeric_limits<double>::digits10, kMostZeros = 3;
  std::array<char, 32> buffer;
  const char* end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), std::fabs(value),
                                  std::chars_format::scientific)
                        .ptr;
  const std::string_view spelled(buffer.data(), end);
  const std::size_t e = spelled.find('e');
  int exponent = 0;
  const std::size_t sign = spelled[e + 1] == '+' ? 1 : 0;  // from_chars reads no plus
  std::from_chars(spelled.data() + e + 1 + sign, end, exponent);
  std::string digits(1, spelled[0]);
  if (e > 1) digits += spelled.substr(2, e - 2);
  const int count = static_cast<int>(digits.size()), before = exponent + 1;
  if (before > kMostBefore || before < -kMostZeros) {
    if (count > 1) digits.insert(1, 1, '.');
    out += digits;
    out += spelled.substr(e);
  } else if (before <= 0) {
    out += "0." + std::string(static_cast<std::size_t>(-before), '0') + digits;
  } else if (before >= count) {
    out += digits + std::string(static_cast<std::size_t>(before - count), '0') + ".0";
  } else {
    out += digits.insert(static_cast<std::size_t>(before), 1, '.');
  }
}

}  // namespace

/// Writes values one after another, with the lists and objects that are open on a stack of its own.
class JsonWriter {
 public:
  explicit JsonWriter(int indent) : indent_(indent) {}

  static std::string write_lines(const Json& document);

  std::string write(const Json& document) {
    begin(document);
    while (!open_.empty()) {
      auto& [structure, next] = open_.back();
      if (next == structure->size()) {
        close(*structure);
        continue;
      }
      separate(next > 0);
      const std::size_t place = next++;
      if (structure->is_array()) {
        begin(structure->items()[place]);
      } else {
        const auto& [key, value] = structure->members()[place];
        append_text(out_, key);
        out_ += indent_ < 0 ? ":" : ": ";
        begin(value);
      }
    }
    return std::move(out_);
  }

 private:
  struct Open {
    const Json* structure;
    std::size_t next;
  };

  void begin(const Json& json) {
    std::visit([&](const auto& value) { begin(json, value); }, json.value_);
  }
  void begin(const Json& json, const std::unique_ptr<Json::Items>&) { open(json, "[]"); }
  void begin(const Json& json, const std::unique_ptr<Json::Members>&) { open(json, "{}"); }
  void begin(const Json&, std::nullptr_t) { out_ += "null"; }
  void begin(const Json&, bool value) { out_ += value ? "true" : "false"; }
  void begin(const Json&, std::int64_t value) { out_ += std::to_string(value); }
  void begin(const Json&, std::uint64_t value) { out_ += std::to_string(value); }
  void begin(const Json&, double value) { append_double(out_, value); }
  void begin(const Json&, const std::unique_ptr<std::string>& text) { append_text(out_, *text); }

  void open(const Json& json, std::string_view brackets) {
    out_ += json.empty() ? brackets : brackets.substr(0, 1);
    if (!json.empty()) open_.push_back({&json, 0});
  }

  void close(const Json& json) {
    open_.pop_back();
    separate(false);
    out_ += json.is_array() ? ']' : '}';
  }

  void separate(bool has_comma) {
    if (has_comma) out_ += ',';
    if (indent_ < 0) return;
    out_ += '\n';
    out_.append(static_cast<std::size_t>(indent_) * open_.size(), ' ');
  }

  int indent_;
  std::string out_;
  std::vector<Open> open_;
};

std::string write_json(const Json& document, int indent) {
  return JsonWriter(indent).write(document);
}

std::string JsonWriter::write_lines(const Json& document) {
  std::string text = "{";
  const char* comma = "\n";
  for (const auto& [key, value] : document.members()) {
    text += comma + write_json(key) + ": ";
    comma = ",\n";
    const bool is_list = value.is_array() && !value.empty() && value[0].is_structured();
    if (!is_list) {
      text += write_json(value);
      continue;
    }
    for (std::size_t k = 0; k < value.size(); ++k) {
      text += (k == 0 ? "[\n  " : ",\n  ") + write_json(value[k]);
    }
    text += "\n]";
  }
  return text + "\n}\n";
}

std::string write_lines(const Json& document) { return JsonWriter::write_lines(document); }

std::string as_utf8(std::string_view text) {
  std::string valid;
  for (std::size_t at = 0; at < text.size();) {
    const auto [length, is_complete] = character_at(text, at);
    valid += is_complete ? text.substr(at, length) : kReplacement;
    at += length;
  }
  return valid;
}

}  // namespace convexact
