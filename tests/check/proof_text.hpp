// SPDX-License-Identifier: MIT
// proof_text.hpp - a proof as lines of words, to be changed.
#pragma once
#include <cctype>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

struct ProofText {
  std::vector<std::vector<std::string>> lines;

  explicit ProofText(const std::string& text) {
    std::istringstream all(text);
    for (std::string line; std::getline(all, line);) {
      std::istringstream words(line);
      lines.emplace_back();
      for (std::string word; words >> word;) lines.back().push_back(word);
    }
  }

  /// The text again; with `renumbered` the last line counts its lines again.
  std::string text(bool renumbered = false) const {
    std::string all;
    for (std::size_t l = 0; l < lines.size(); ++l) {
      for (std::size_t w = 0; w < lines[l].size(); ++w) {
        if (w > 0) all += ' ';
        const bool is_count = renumbered && l + 1 == lines.size() && w == 1;
        all += is_count ? std::to_string(lines.size()) : lines[l][w];
      }
      all += '\n';
    }
    return all;
  }

  /// Positions of the lines with this keyword.
  std::vector<std::size_t> all(const std::string& keyword) const {
    std::vector<std::size_t> found;
    for (std::size_t l = 0; l < lines.size(); ++l) {
      if (lines[l][0] == keyword) found.push_back(l);
    }
    return found;
  }

  /// Calls f with each keyword of each kind of line left out, and spelt otherwise.
  template <class F>
  void for_each_keyword_changed(F f) const {
    std::set<std::pair<std::string, std::string>> seen;
    for (std::size_t l = 0; l < lines.size(); ++l) {
      for (std::size_t w = 0; w < lines[l].size(); ++w) {
        const std::string& word = lines[l][w];
        const bool is_keyword = std::isalpha(static_cast<unsigned char>(word[0])) != 0;
        if (!is_keyword || !seen.emplace(lines[l][0], word).second) continue;
        ProofText changed = *this;
        changed.lines[l][w] += 's';
        f(changed);
        changed.lines[l].erase(changed.lines[l].begin() + static_cast<std::ptrdiff_t>(w));
        f(changed);
      }
    }
  }
};
