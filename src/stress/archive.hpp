// SPDX-License-Identifier: MIT
// archive.hpp - values as bytes and back, within one build of the program.
#pragma once
#include <cstring>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/halfspace.hpp"

namespace convexact {

/// Numbers, enumerations and ids: their bytes are their value.
template <class T>
concept Plain = std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>;

/// A struct is written by its `fields(archive, value)`, which names each field once for both ways.
class ArchiveWriter {
 public:
  template <class... Fields>
  void operator()(const Fields&... fields) {
    (put(fields), ...);
  }
  std::string bytes;

 private:
  template <class T>
  void put(const T& x) {
    if constexpr (Plain<T>) {
      bytes.append(reinterpret_cast<const char*>(&x), sizeof x);
    } else {
      fields(*this, const_cast<T&>(x));  // a writer changes nothing
    }
  }
  void put(const std::string& x) {
    put(x.size());
    bytes += x;
  }
  void put(const Integer& x) {
    put(x.sign() < 0);
    put(Integer(abs(x)).str(0, std::ios::hex | std::ios::showbase));
  }
  void put(const Rational& x) {
    put(Integer(numerator(x)));
    put(Integer(denominator(x)));
  }
  void put(const Halfspace& x) {
    for (int k = 0; k < 3; ++k) put(x.normal()[k]);
    put(x.offset());
  }
  template <class T>
  void put(const std::vector<T>& list) {
    put(list.size());
    for (const T& x : list) put(x);
  }
};

class ArchiveReader {
 public:
  explicit ArchiveReader(const std::string& bytes) : bytes_(bytes) {}

  template <class... Fields>
  void operator()(Fields&... fields) {
    ((fields = get(Type<Fields>())), ...);
  }
  bool is_at_end() const { return at_ == bytes_.size(); }

 private:
  template <class T>
  struct Type {};

  std::string take(std::size_t count) {
    if (count > bytes_.size() - at_) throw Error(ErrorCode::Malformed, "an answer is cut off");
    at_ += count;
    return bytes_.substr(at_ - count, count);
  }
  template <class T>
  T get(Type<T>) {
    T x{};
    if constexpr (Plain<T>) {
      std::memcpy(&x, take(sizeof x).data(), sizeof x);
    } else {
      fields(*this, x);
    }
    return x;
  }
  std::string get(Type<std::string>) { return take(get(Type<std::size_t>())); }
  Integer get(Type<Integer>) {
    const bool is_negative = get(Type<bool>());
    const Integer x(get(Type<std::string>()));
    return is_negative ? Integer(-x) : x;
  }
  Rational get(Type<Rational>) {
    const Integer p = get(Type<Integer>()), q = get(Type<Integer>());
    return Rational(p, q);
  }
  Halfspace get(Type<Halfspace>) {
    IntegerVector3 normal;
    for (int k = 0; k < 3; ++k) normal[k] = get(Type<Integer>());
    return {normal, get(Type<Integer>())};
  }
  template <class T>
  std::vector<T> get(Type<std::vector<T>>) {
    std::vector<T> list;
    for (std::size_t left = get(Type<std::size_t>()); left > 0; --left) {
      list.push_back(get(Type<T>()));
    }
    return list;
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
};

}  // namespace convexact
