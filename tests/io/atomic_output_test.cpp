// SPDX-License-Identifier: MIT
// Outputs that appear together or not at all. The folder is listed after every attempt.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <set>

#include "convexact/io.hpp"
#include "expect_error.hpp"

namespace {
int refused_links = 0;  // the errno of link(), if it is to fail
}

// Takes the place of the system's, which some file systems and WebAssembly refuse.
extern "C" int link(const char* from, const char* to) noexcept {
  errno = refused_links;
  return refused_links != 0 ? -1 : ::linkat(AT_FDCWD, from, AT_FDCWD, to, 0);
}

using namespace convexact;
namespace fs = std::filesystem;

namespace {

// A folder of its own, gone at the end.
struct Folder {
  Folder() {
    std::string pattern = (fs::temp_directory_path() / "convexact-test-XXXXXX").string();
    path = ::mkdtemp(pattern.data());
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  std::string operator/(const std::string& name) const { return (path / name).string(); }
  std::set<std::string> names() const {
    std::set<std::string> all;
    for (const auto& entry : fs::directory_iterator(path)) all.insert(entry.path().filename());
    return all;
  }
  fs::path path;
};

using Names = std::set<std::string>;

void write(const std::string& path, const std::string& bytes) {
  AtomicOutput output;
  output.add(path, bytes);
  output.commit();
}

}  // namespace

TEST_CASE("AtomicOutput: nothing is there before commit, everything after") {
  const Folder folder;
  write(folder / "b", "old");
  {
    AtomicOutput output;
    output.add(folder / "a", std::string("\0\xFF\n", 3));
    output.add(folder / "b", "new");
    output.add(folder / "c", "");
    CHECK_FALSE(fs::exists(folder / "a"));
    CHECK(read_bytes(folder / "b") == "old");
    output.commit();
    CHECK(folder.names() == Names{"a", "b", "c"});
  }
  CHECK(folder.names() == Names{"a", "b", "c"});
  CHECK(read_bytes(folder / "a") == std::string("\0\xFF\n", 3));
  CHECK(read_bytes(folder / "b") == "new");
}

TEST_CASE("AtomicOutput: without commit nothing remains") {
  const Folder folder;
  write(folder / "b", "old");
  {
    AtomicOutput output;
    output.add(folder / "a", "x");
    output.add(folder / "b", "new");
  }
  CHECK(folder.names() == Names{"b"});
  CHECK(read_bytes(folder / "b") == "old");
}

TEST_CASE("AtomicOutput: a target that cannot be written is refused, the others vanish") {
  const Folder folder;
  fs::create_directory(folder / "folder");
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  for (const std::string& bad :
       {folder / "folder", folder / "none/x", folder / "pipe", folder / "a/x", std::string()}) {
    CAPTURE(bad);
    AtomicOutput output;
    output.add(folder / "a", "x");
    const Error error = error_of([&] {
      output.add(bad, "y");
      output.commit();
      return 0;
    });
    CHECK(error.code() == ErrorCode::Unwritable);
    CHECK(std::string(error.what()).find("cannot be written: ") != std::string::npos);
    CHECK(folder.names() == Names{"folder", "pipe"});
    output.commit();  // forgot what was added before the error
    CHECK(folder.names() == Names{"folder", "pipe"});
  }
}

TEST_CASE("AtomicOutput: a move that fails undoes those before it") {
  const Folder folder;
  write(folder / "old", "old");
  AtomicOutput output;
  output.add(folder / "new", "x");
  output.add(folder / "old", "y");
  output.add(folder / "last", "z");
  fs::create_directory(folder / "last");  // now the third move cannot succeed
  CHECK(error_of([&] {
          output.commit();
          return 0;
        }).code() == ErrorCode::Unwritable);
  CHECK(folder.names() == Names{"last", "old"});
  CHECK(read_bytes(folder / "old") == "old");
}

TEST_CASE("AtomicOutput: a last step that fails undoes every move (#13)") {
  const Folder folder;
  write(folder / "old", "old");
  for (const bool several : {false, true}) {
    CAPTURE(several);
    AtomicOutput output;
    if (several) output.add(folder / "new", "x");
    output.add(folder / "old", "y");
    CHECK(error_of([&] {
            output.commit([&]() -> void {
              CHECK(read_bytes(folder / "old") == "y");
              throw Error(ErrorCode::Stopped, "told to a closed pipe");
            });
            return 0;
          }).code() == ErrorCode::Stopped);
    CHECK(folder.names() == Names{"old"});
    CHECK(read_bytes(folder / "old") == "old");
  }
  AtomicOutput output;
  output.add(folder / "old", "y");
  output.commit([] {});
  CHECK(folder.names() == Names{"old"});
  CHECK(read_bytes(folder / "old") == "y");
}

TEST_CASE(
    "AtomicOutput: where hard links are refused, files are written and replaced all the same") {
  for (const int reason : {EPERM, ENOSYS, EOPNOTSUPP, EXDEV, EMLINK, EACCES}) {
    CAPTURE(reason);
    const Folder folder;
    write(folder / "old", "old");
    refused_links = reason;
    AtomicOutput output;
    output.add(folder / "new", "x");
    output.add(folder / "old", "y");
    output.add(folder / "last", "z");
    output.commit([] {});
    CHECK(folder.names() == Names{"last", "new", "old"});
    CHECK(read_bytes(folder / "new") == "x");
    CHECK(read_bytes(folder / "old") == "y");
    output.add(folder / "newer", "x");
    output.add(folder / "old", "z");
    CHECK(error_of([&] {
            output.commit([]() -> void { throw Error(ErrorCode::Stopped, "at last"); });
            return 0;
          }).code() == ErrorCode::Stopped);
    refused_links = 0;
    CHECK(folder.names() == Names{"last", "new", "old"});
    CHECK(read_bytes(folder / "old") == "y");
  }
}

TEST_CASE("AtomicOutput: one file twice, under two names") {
  const Folder folder;
  AtomicOutput output;
  output.add(folder / "a", "x");
  const Error error = error_of([&] {
    output.add(folder / "./a", "y");
    return 0;
  });
  CHECK(error.code() == ErrorCode::InvalidArgument);
  CHECK(folder.names().empty());
}

TEST_CASE("AtomicOutput: permissions and symbolic links stay") {
  const Folder folder;
  write(folder / "a", "old");
  fs::permissions(folder / "a", fs::perms(0640));
  fs::create_symlink("a", folder / "link");
  write(folder / "link", "new");
  CHECK(fs::is_symlink(folder / "link"));
  CHECK(read_bytes(folder / "a") == "new");
  CHECK(fs::status(folder / "a").permissions() == fs::perms(0640));
}
