// SPDX-License-Identifier: MIT
// A tie that shrinks, against lists that are searched: the first, the size, the members, and
// whether one class is left.
#include "fast/tie_set.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <set>

using namespace convexact;

TEST_CASE("tie set: as lists say, while random members are dropped") {
  std::mt19937_64 random(1);
  constexpr std::size_t kHalfspaces = 40;
  const int classes[3] = {};  // only their addresses count
  TieSet tie(kHalfspaces);
  CHECK(tie.size() == 0);
  for (int round = 0; round < 200; ++round) {
    CAPTURE(round);
    std::vector<HalfspaceId> ids;
    std::vector<TieSet::Class> of;
    for (std::size_t i = 0; i < kHalfspaces; ++i) {
      if (random() % 3 == 0) ids.emplace_back(i);
    }
    if (ids.empty()) continue;
    std::shuffle(ids.begin(), ids.end(), random);  // the canonical order need not be that of ids
    if (ids.size() > 1) {
      for (std::size_t k = 0; k < ids.size(); ++k) of.push_back(&classes[random() % 3]);
    }
    tie.assign(ids, of);
    std::vector<std::size_t> left(ids.size());
    for (std::size_t k = 0; k < left.size(); ++k) left[k] = k;
    while (!left.empty()) {
      CHECK(tie.size() == left.size());
      CHECK(tie.first() == ids[left.front()]);
      std::vector<HalfspaceId> members;
      std::set<TieSet::Class> kinds;
      for (const std::size_t k : left) {
        members.push_back(ids[k]);
        if (!of.empty()) kinds.insert(of[k]);
      }
      CHECK(tie.list() == members);
      CHECK(tie.is_one_class() == (kinds.size() == 1));
      const HalfspaceId other(random() % kHalfspaces);
      CHECK(tie.contains(other) ==
            (std::find(members.begin(), members.end(), other) != members.end()));
      if (!tie.contains(other)) tie.drop(other);  // changes nothing
      const std::size_t at = random() % left.size();
      tie.drop(ids[left[at]]);
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
    }
    CHECK(tie.size() == 0);
  }
  tie.clear();
  CHECK(tie.list().empty());
}
