// SPDX-License-Identifier: MIT
// What JavaScript calls: texts go in and out as bytes in the module's memory, in UTF-8.
#include <emscripten.h>
#include <gmp.h>

#include <cstdlib>
#include <new>
#include <string>
#include <string_view>
#include <system_error>

#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "io/json.hpp"
#include "pages/answers.hpp"
#include "teach/lesson_request.hpp"
#include "wire/mesh_file.hpp"

namespace {

using namespace convexact;

// The last answer, which stays until the next call.
std::string& answer() {
  static std::string text;
  return text;
}

// GMP would end the module; thrown, the exception passes through its frames, and what they hold is
// lost. The caller ends the module after such an answer.
[[noreturn]] void throw_out_of_memory() { throw std::bad_alloc(); }

void* allocate(std::size_t size) {
  void* block = std::malloc(size);
  if (block == nullptr) throw_out_of_memory();
  return block;
}

void* reallocate(void* old, std::size_t, std::size_t size) {
  void* block = std::realloc(old, size);
  if (block == nullptr) throw_out_of_memory();
  return block;
}

void release(void* block, std::size_t) { std::free(block); }

// An answer in any case: whatever is thrown becomes an error.
template <class Find>
void keep(const Find& find) {
  std::string& text = answer();
  text = std::string();  // gives its memory back before the work
  const auto fail = [&text](const Error& error) {
    text = write_json(Json{{"error", error_json(error)}});
  };
  try {
    text = find();
  } catch (const Error& error) {
    fail(error);
  } catch (const std::bad_alloc&) {
    fail(Error(ErrorCode::Stopped, "out of memory: a module has 4 GB at most"));
  } catch (const std::system_error&) {
    fail(Error(ErrorCode::InvalidArgument,
               "time_limit needs a thread, which a module has not: end its worker instead"));
  } catch (const std::exception& error) {
    fail(Error(ErrorCode::Internal, error.what()));
  }
}

}  // namespace

extern "C" {

/// The answer to a request: answer_line_of(kind, line); of `teach`, answer_lesson_request(line).
EMSCRIPTEN_KEEPALIVE void convexact_answer(const char* kind, const char* line, std::size_t size) {
  mp_set_memory_functions(allocate, reallocate, release);
  const std::string_view asked = kind, request(line, size);
  keep([&] {
    return asked == "teach" ? answer_lesson_request(request) : answer_line_of(asked, request);
  });
}

/// The shape in the bytes of a file, as a request has it: shape_in_file(name, bytes).
EMSCRIPTEN_KEEPALIVE void convexact_read(const char* name, const char* bytes, std::size_t size) {
  mp_set_memory_functions(allocate, reallocate, release);
  keep([&] { return shape_in_file(name, {bytes, size}); });
}

/// The last answer.
EMSCRIPTEN_KEEPALIVE const char* convexact_text() { return answer().data(); }
EMSCRIPTEN_KEEPALIVE std::size_t convexact_size() { return answer().size(); }
}
