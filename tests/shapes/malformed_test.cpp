// SPDX-License-Identifier: MIT
// Malformed files: each is refused for its one mistake, and is valid without it.
#include <doctest/doctest.h>

#include <map>
#include <set>

#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "convexact/shapes.hpp"
using namespace convexact;
using shapes::malformed_files;
using shapes::MalformedFile;

namespace {

void read(const std::string& bytes, std::string_view extension) {
  const std::string name = "a." + std::string(extension);
  if (const auto format = halfspace_format_of_path(name)) {
    (void)read_halfspaces_bytes(bytes, *format, Decimal::Nearest);
  } else {
    (void)read_mesh_bytes(bytes, {.format = mesh_format_of_path(name)});
  }
}

}  // namespace

TEST_CASE("malformed files: every reader refuses each, with the code that its mistake has") {
  for (const MalformedFile& file : malformed_files()) {
    CAPTURE(file.name);
    try {
      read(file.bytes, file.extension());
      FAIL_CHECK("was accepted");
    } catch (const Error& error) {
      CHECK(error.code() == (file.not_finite ? ErrorCode::NotFinite : ErrorCode::Malformed));
      CHECK(exit_code(error.code()) == 3);
    }
  }
}

TEST_CASE("malformed files: names are unique and say the format") {
  std::set<std::string> names;
  std::map<std::string_view, int> count;
  for (const MalformedFile& file : malformed_files()) {
    CAPTURE(file.name);
    CHECK(names.insert(file.name).second);
    CHECK(file.name.starts_with("malformed-" + std::string(file.extension()) + "-"));
    CHECK(!file.description.empty());
    ++count[file.extension()];
  }
  CHECK(count.size() == 8);
  for (const auto& [extension, files] : count) CHECK(files >= 6);
}

// With the announced mistake mended, the file must be read: else it was refused for another reason.
TEST_CASE("malformed files: there is no other mistake") {
  struct Mended {
    const char* name;
    const char* mistake;
    const char* mended;
  };
  const Mended cases[] = {{"obj-truncated-point", "v 1 2", ""},
                          {"obj-nan", "nan", "1"},
                          {"obj-overflow", "1e400", "1"},
                          {"obj-not-a-number", "1.0.0", "1"},
                          {"obj-index-zero", "f 0", "f 3"},
                          {"obj-index-out-of-range", "5", "4"},
                          {"obj-index-before-first", "-5", "-4"},
                          {"obj-index-beyond-32-bits", "4294967297", "1"},
                          {"obj-unknown-statement", "vertex", "v"},
                          {"off-count-too-small", "3 4 6", "4 4 6"},
                          {"off-count-too-large", "4 5 6", "4 4 6"},
                          {"off-count-hostile", "4294967295", "4"},
                          {"off-count-negative", "-4", "4"},
                          {"off-infinity", "-inf", "1"},
                          {"off-index-out-of-range", "2 4", "2 3"},
                          {"off-index-negative", "-1", "1"},
                          {"off-no-corners", "0 0 1 2", "3 0 1 2"},
                          {"ply-unknown-format", "9.0", "1.0"},
                          {"ply-count-too-small", "face 3", "face 4"},
                          {"ply-count-too-large", "face 5", "face 4"},
                          {"ply-count-hostile", "4294967295", "4"},
                          {"ply-nan", "nan", "1"},
                          {"ply-index-out-of-range", "2 4", "2 3"},
                          {"ply-binary-trailing", "more", ""},
                          {"stl-four-corners", "vertex 1 1 0\n", ""},
                          {"stl-nan", "nan", "0"},
                          {"json-three-numbers", "1,1,1]", "1,1,1,-1]"},
                          {"json-five-numbers", "-1,0]", "-1]"},
                          {"json-null", "null", "1"},
                          {"json-division-by-zero", "1/0", "1"},
                          {"json-overflow", "1e400", "1"},
                          {"ine-count-too-small", "3 4", "4 4"},
                          {"ine-count-too-large", "5 4", "4 4"},
                          {"ine-count-hostile", "4294967295", "4"},
                          {"ine-not-an-integer", "1.5", "1"},
                          {"ine-division-by-zero", "1/0", "1"},
                          {"ine-vertices", "V-", "H-"},
                          {"xyz-truncated", "1 2", ""},
                          {"xyz-overflow", "1e400", "1"},
                          {"txt-truncated", "\n0 1", ""},
                          {"txt-three-numbers", "1 1 1\n", "1 1 1 -1\n"},
                          {"txt-five-numbers", "1 -1 0\n", "1 -1\n"},
                          {"txt-not-a-number", "one", "1"},
                          {"txt-overflow", "1e400", "1"}};
  for (const Mended& c : cases) {
    CAPTURE(std::string(c.name));
    const auto files = malformed_files();
    const auto file = std::find_if(files.begin(), files.end(), [&](const MalformedFile& f) {
      return f.name == "malformed-" + std::string(c.name);
    });
    REQUIRE(file != files.end());
    std::string bytes = file->bytes;
    const std::size_t at = bytes.find(c.mistake);
    REQUIRE(at != std::string::npos);
    bytes.replace(at, std::string(c.mistake).size(), c.mended);
    CHECK_NOTHROW(read(bytes, file->extension()));
  }
}
