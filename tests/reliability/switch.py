# SPDX-License-Identifier: MIT
"""Puts a fault behind a switch: the source says both what is right and what is wrong, and the environment of the
program decides. So all faults are in one build, and each costs a run of the tests that get to its place.

Only the text is looked at: a condition becomes a choice between two conditions, a declaration between two values,
any other statement between two statements. What this cannot do, such as changing a constant of the compiler, is left
to one build for each fault; the compiler says which (see switched())."""
import re

from definitions import blank

HEADER = r'''// What is right or what is wrong, by the environment: made by tests/reliability/switch.py.
#pragma once
#include <atomic>
#include <cstdio>
#include <cstdlib>

namespace campaign {

inline constexpr int kMost = 4096;
inline constexpr unsigned char kReached = 1, kDiffered = 2;
inline std::atomic<unsigned char> seen[kMost];

inline int active() {
  static const int id = [] {
    const char* text = std::getenv("CONVEXACT_FAULT");
    return text == nullptr ? -1 : std::atoi(text);
  }();
  return id;
}

// Appends what was seen to the file that the environment names: "id seen" in each line.
inline void write_seen(const char* variable, const char* head) {
  const char* path = std::getenv(variable);
  if (path == nullptr) return;
  std::FILE* file = std::fopen(path, "a");
  if (file == nullptr) return;
  std::fputs(head, file);
  for (int id = 0; id < kMost; ++id) {
    if (seen[id] != 0) std::fprintf(file, " %d:%d", id, int(seen[id]));
  }
  std::fputs("\n", file);
  std::fclose(file);
}
// What other programs, such as those that a test starts, have seen.
inline void read_seen(const char* variable) {
  const char* path = std::getenv(variable);
  std::FILE* file = path == nullptr ? nullptr : std::fopen(path, "r");
  if (file == nullptr) return;
  char word[64];
  while (std::fscanf(file, "%63s", word) == 1) {
    int id = 0, bits = 0;
    if (std::sscanf(word, "%d:%d", &id, &bits) == 2 && id >= 0 && id < kMost) seen[id] |= static_cast<unsigned char>(bits);
  }
  std::fclose(file);
  std::remove(path);
}
struct AtExit {
  ~AtExit() { write_seen("CONVEXACT_FAULT_SEEN", "exit"); }
};
inline const AtExit at_exit;

inline bool is(int id) {
  seen[id] |= kReached;
  return id == active();
}

// Both are evaluated only where the fault is active.
template <class Right, class Wrong>
bool condition(int id, const Right& right, const Wrong& wrong) {
  if (!is(id)) return right();
  const bool is_right = right(), is_wrong = wrong();
  if (is_right != is_wrong) seen[id] |= kDiffered;
  return is_wrong;
}
template <class Value, class Right, class Wrong>
Value value(int id, const Right& right, const Wrong& wrong) {
  if (!is(id)) return Value(right());
  Value of_right = Value(right()), of_wrong = Value(wrong());
  if constexpr (requires { bool(of_right == of_wrong); }) {
    if (!bool(of_right == of_wrong)) seen[id] |= kDiffered;
  }
  return of_wrong;
}

}  // namespace campaign
'''

# In the campaign's build of the tests: which places each test case got to, and how long it took.
LISTENER = r'''
#include <chrono>
#include <string>
namespace {
struct PlacesOfCases : doctest::IReporter {
  explicit PlacesOfCases(const doctest::ContextOptions&) {}
  void report_query(const doctest::QueryData&) override {}
  void test_run_start() override {}
  void test_run_end(const doctest::TestRunStats&) override {}
  void test_case_start(const doctest::TestCaseData& test) override {
    name = test.m_name;
    for (auto& place : campaign::seen) place = 0;
    begun = std::chrono::steady_clock::now();
  }
  void test_case_reenter(const doctest::TestCaseData&) override {}
  void test_case_end(const doctest::CurrentTestCaseStats&) override {
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begun;
    if (std::getenv("CONVEXACT_FAULT_CASES") != nullptr) campaign::read_seen("CONVEXACT_FAULT_SEEN");
    campaign::write_seen("CONVEXACT_FAULT_CASES", (name + "\t" + std::to_string(seconds.count()) + "\t").c_str());
  }
  void test_case_exception(const doctest::TestCaseException&) override {}
  void subcase_start(const doctest::SubcaseSignature&) override {}
  void subcase_end() override {}
  void log_assert(const doctest::AssertData&) override {}
  void log_message(const doctest::MessageData&) override {}
  void test_case_skipped(const doctest::TestCaseData&) override {}
  std::string name;
  std::chrono::steady_clock::time_point begun;
};
REGISTER_LISTENER("places", 1, PlacesOfCases);
}  // namespace
'''

_VALUE = re.compile(r'((?:static\s+)?(?:const\s+)?(?:bool|double|float|int|long|std::size_t|std::uint\d+_t|Rational|Integer|Sign))'
                    r'\s+(\w+)\s*=\s*')


def _statement(code, at, end):
    """The statement, or the statements, of a function that a stretch of its text belongs to: (start, end), without what
    is between the braces of a block that only begins in it."""
    depth, start = 0, at
    while start > 0:
        char = code[start - 1]
        depth += (char in ')]') - (char in '([')
        if depth <= 0 and char in ';{}' and not (depth < 0 and char == ';'):
            break
        if depth < 0:  # the stretch is within parentheses that begin before it
            depth = 0
        start -= 1
    depth, stop = 0, start
    while stop < len(code):
        char = code[stop]
        depth += (char in '([') - (char in ')]')
        if stop >= end - 1 and depth == 0 and (char == ';' or char == '{' and stop >= end):
            break
        if char == '{' and stop < end - 1 and depth == 0:  # a block that the stretch holds
            level = 0
            while True:
                level += (code[stop] == '{') - (code[stop] == '}')
                if level == 0:
                    break
                stop += 1
            if stop >= end - 1:
                break
        stop += 1
    return start, stop + (stop < len(code) and code[stop] in ';}')


def _difference(at, old, new):
    """The place and the text where two texts differ, in whole words, without the blanks around it."""
    def common(a, b):
        count = 0
        while count < min(len(a), len(b)) and a[count] == b[count]:
            count += 1
        return count
    first = common(old, new)
    while first > 0 and (old[first - 1:first].isalnum() or old[first - 1] in '_.:>') and first < len(old):
        first -= 1
    last = common(old[first:][::-1], new[first:][::-1])
    while last > 0 and (old[len(old) - last].isalnum() or old[len(old) - last] in '_.:'):
        last -= 1
    old, new, at = old[first:len(old) - last], new[first:len(new) - last], at + first
    blanks = len(old) - len(old.lstrip())
    if old.strip():
        at, old = at + blanks, old.strip()
    return at, old, new.strip() if old else new


def _closing(code, opening):
    depth = 0
    for at in range(opening, len(code)):
        depth += (code[at] in '([{') - (code[at] in ')]}')
        if depth == 0:
            return at
    return len(code)


def switched(text, at, old, new, number):
    """The text with a choice between `old`, which stands at `at`, and `new`; None if this cannot be done."""
    at, old, new = _difference(at, old, new)
    code = blank(text)
    end = at + len(old)
    start, stop = _statement(code, at, end)
    while start < at and code[start].isspace():
        start += 1
    head = re.match(r'(?:\}?\s*else\s+)?(if|while)\s*(?:constexpr\s*)?\(', code[start:])
    if head and 'constexpr' not in head.group(0):
        opening = start + head.end() - 1
        closing = _closing(code, opening)
        if at > opening and end <= closing:
            right = text[opening + 1:closing]
            if ';' in blank(right) or re.match(r'\s*(const\s+)?auto\b', right):
                return None
            wrong = text[opening + 1:at] + new + text[end:closing]
            choice = f'campaign::condition({number}, [&] {{ return bool({right}); }}, [&] {{ return bool({wrong}); }})'
            return text[:opening + 1] + choice + text[closing:]
    whole, faulty = text[start:stop], text[start:at] + new + text[end:stop]
    value = _VALUE.match(code[start:])
    if value and code[stop - 1] == ';' and start + value.end() <= at and end < stop and code.count(';', start, stop) == 1:
        right, wrong = text[start + value.end():stop - 1], faulty[value.end():-1]
        kind = value.group(1).replace('static ', '').replace('const ', '').strip()
        choice = f'campaign::value<{kind}>({number}, [&] {{ return {kind}({right}); }}, [&] {{ return {kind}({wrong}); }})'
        return text[:start + value.end()] + choice + text[stop - 1:]
    if re.match(r'(do|switch|case|default|using|static|constexpr|template|struct|class|:)\b', code[start:]):
        return None
    if re.match(r'(?:const\s+)?(?:auto|[\w:<>]+(?:\s*[&*])?)\s+\w+\s*(?:=|\{|;)', code[start:]) and not whole.startswith('return'):
        return None  # the declaration of something else
    if code[stop - 1] not in ';}' or code.count('{', start, stop) != code.count('}', start, stop):
        return None
    return f'{text[:start]}if (campaign::is({number})) {{ {faulty} }} else {{ {whole} }}{text[stop:]}'
