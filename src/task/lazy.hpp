// SPDX-License-Identifier: MIT
// lazy.hpp - values that are computed when they are first asked for.
#pragma once
#include <mutex>
#include <optional>

namespace convexact {

/// A value that may never be needed. Any threads may ask for it at the same time.
template <class Value>
class Lazy {
 public:
  /// @param make  Returns the value, the same whenever it is called; one thread calls it, once
  ///              unless it throws.
  template <class Make>
  const Value& get(const Make& make) const {
    std::call_once(once_, [&] { value_.emplace(make()); });
    return *value_;
  }

  /// Not while another thread asks.
  bool is_made() const { return value_.has_value(); }

 private:
  mutable std::once_flag once_;
  mutable std::optional<Value> value_;
};

}  // namespace convexact
