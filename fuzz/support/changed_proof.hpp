// SPDX-License-Identifier: MIT
// changed_proof.hpp - one change of a proof's text.
#pragma once
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "../../tests/check/proof_text.hpp"
#include "fuzz_input.hpp"

/// Swaps, repeats, leaves out or replaces a word, a line or a digit.
/// @param others  Words to put in the place of one.
inline void change_proof(ProofText& proof, std::span<const char* const> others, FuzzInput& in) {
  auto& lines = proof.lines;
  const std::size_t l = in.below(lines.size()), other = in.below(lines.size());
  const auto at_line = lines.begin() + static_cast<std::ptrdiff_t>(l);
  std::vector<std::string>& words = lines[l];
  if (words.empty()) return;
  const std::size_t w = in.below(words.size());
  const auto at_word = words.begin() + static_cast<std::ptrdiff_t>(w);
  switch (in.below(8)) {
    case 0:
      words[w] = others[in.below(others.size())];
      break;
    case 1:
      if (!lines[other].empty()) words[w] = lines[other][in.below(lines[other].size())];
      break;
    case 2:
      words.erase(at_word);
      break;
    case 3:
      words.insert(at_word, words[w]);
      break;
    case 4:
      std::swap(lines[l], lines[other]);
      break;
    case 5:
      lines.insert(at_line, lines[other]);
      break;
    case 6:
      if (lines.size() > 1) lines.erase(at_line);
      break;
    default:  // one digit
      words[w][in.below(words[w].size())] = static_cast<char>('0' + in.below(10));
  }
}
