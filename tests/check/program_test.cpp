// SPDX-License-Identifier: MIT
// convexact-check as a program: its exit codes, its size and what it links.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "process.hpp"
#include "proofs.hpp"
#include "shapes/makers.hpp"

using namespace convexact;
using support::bytes_of;
using support::ScratchFolder;

namespace {

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  REQUIRE(value != nullptr);
  return value;
}

int run_checker(const std::string& arguments, const ScratchFolder& scratch) {
  const std::string command = "'" + environment("CONVEXACT_CHECK") + "' >" + scratch.file("out") +
                              " 2>" + scratch.file("err") + " " + arguments;
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

TEST_CASE("convexact-check: exit codes, and where it says what") {
  const ScratchFolder scratch;
  const std::string proof =
      proof_of(PointSet(shapes::cut_cube(4, 0.25)), Engine::Filtered, 6, Precision::Binary32);
  CHECK(run_checker(scratch.write("right", proof), scratch) == 0);
  CHECK(bytes_of(scratch.file("out")).starts_with("proven: 10 planes bound exactly the hull of"));
  CHECK(bytes_of(scratch.file("err")).empty());

  std::string wrong = proof;
  wrong.replace(wrong.find("\nsurvive "), 9, "\nsurvive 0 ");
  CHECK(run_checker(scratch.write("wrong", wrong), scratch) == 1);
  const auto lines = std::count(wrong.begin(), wrong.begin() + wrong.find("\nsurvive"), '\n');
  CHECK(bytes_of(scratch.file("err")) ==
        "convexact-check: line " + std::to_string(lines + 2) + ": not proven: others survive\n");
  CHECK(bytes_of(scratch.file("out")).empty());

  CHECK(run_checker(scratch.write("malformed", "solid cube\n"), scratch) == 3);
  CHECK(run_checker(scratch.write("empty", ""), scratch) == 3);
  CHECK(run_checker(scratch.file("absent"), scratch) == 3);
  CHECK(run_checker("", scratch) == 2);
  CHECK(run_checker("one two.obj three", scratch) == 2);
  CHECK(run_checker("--help", scratch) == 0);
  CHECK(bytes_of(scratch.file("out")).starts_with("usage: convexact-check PROOF [MESH]\n"));
  CHECK(run_checker(scratch.file("right") + " >/dev/full", scratch) == 5);
}

TEST_CASE("convexact-check: proofs that the program wrote") {
  const ScratchFolder scratch;
  std::string cube;
  for (const Point& p : shapes::cut_cube(4, 0.25)) {
    cube += "v " + std::to_string(p[0]) + " " + std::to_string(p[1]) + " " +
            std::to_string(p[2] + 0.1) + "\n";
  }
  const std::string input = scratch.write("cube.obj", cube), proof = scratch.file("proof");
  for (const std::string engine : {"exact", "filtered", "float"}) {
    for (const std::string more : {"", " --decimal exact", " --precision 32"}) {
      INFO(engine, more);
      const support::Ran ran = support::run_program("simplify " + input + " --faces 6 --engine " +
                                                    engine + more + " --proof " + proof);
      REQUIRE_MESSAGE(ran.exit == 0, ran.err);
      CHECK(ran.out.find("written     " + proof) != std::string::npos);
      CHECK(run_checker(proof, scratch) == 0);
    }
  }
}

TEST_CASE("convexact-check: by every measure, with a trace beside the proof") {
  const ScratchFolder scratch;
  std::string cube;
  for (const Point& p : shapes::cut_cube(4, 0.25)) {
    cube += "v " + std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) +
            "\n";
  }
  const std::string input = scratch.write("cube.obj", cube), proof = scratch.file("proof");
  const char* const cases[][3] = {
      {"volume", "greedy: each removal adds the least volume", "proven: each was the cheapest"},
      {"area", "greedy-area: each removal adds the least area", "proven: each was the cheapest"},
      {"mean-width", "costs-not-shown: the removals; neither what they add nor that it is least",
       "not claimed: what a removal adds, or that it was the cheapest"}};
  for (const auto& row : cases) {
    const std::string measure = row[0], claim = row[1], said = row[2];
    CAPTURE(measure);
    const std::string command = "simplify " + input + " --faces 6 --cost " + measure + " --proof " +
                                proof + " --trace " + scratch.file("trace.json");
    const support::Ran ran = support::run_program(command);
    REQUIRE_MESSAGE(ran.exit == 0, ran.err);
    CHECK(ran.out.find(std::string("  proof       ") + claim + "\n") != std::string::npos);
    const std::string kind = std::string(claim).substr(0, std::string(claim).find(':'));
    CHECK(support::run_program(command + " --json").out.find("\"proof\": \"" + kind + "\"") !=
          std::string::npos);
    CHECK(bytes_of(proof).starts_with("convexact-proof 2 " + kind + "\n"));
    CHECK(run_checker(proof + " " + input, scratch) == 0);
    CHECK(bytes_of(scratch.file("out")).find(said) != std::string::npos);
    CHECK(bytes_of(scratch.file("trace.json")).find(std::string("\"") + measure + "\"") !=
          std::string::npos);
  }
}

TEST_CASE("convexact-check: a mesh beside the proof, its exit codes and what it says (#13)") {
  const ScratchFolder scratch;
  const std::string mesh = scratch.write(
      "cut.obj", "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\nv 4 4 0\nv 4 0 4\nv 0 4 4\nv 3.9 4 4\n");
  const std::string proof = scratch.file("proof");
  REQUIRE(support::run_program("simplify " + mesh + " --faces 5 --proof " + proof).exit == 0);
  CHECK(run_checker(proof + " " + mesh, scratch) == 0);
  CHECK(bytes_of(scratch.file("out"))
            .ends_with("proven: the points are those of " + mesh +
                       ", decimals as the nearest doubles\n"));
  const std::string moved = scratch.write(
      "moved.obj", "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\nv 4 4 0\nv 4 0 4\nv 0 4 4\nv 3.8 4 4\n");
  CHECK(run_checker(proof + " " + moved, scratch) == 1);
  CHECK(bytes_of(scratch.file("out")).empty());
  CHECK(bytes_of(scratch.file("err")) ==
        "convexact-check: " + moved +
            ": not proven: that the proof is about this file: its point 8 is not in the proof\n");
  CHECK(run_checker(proof + " " + scratch.write("bad.obj", "v 0 0 0\nv 1 1\n"), scratch) == 3);
  CHECK(bytes_of(scratch.file("err")).find("bad.obj: line 2: malformed") != std::string::npos);
  CHECK(run_checker(proof + " " + scratch.file("absent.obj"), scratch) == 3);
  CHECK(run_checker(proof + " " + scratch.write("mesh.json", "[]"), scratch) == 3);
  CHECK(run_checker(proof + " --fast", scratch) == 2);
  // A folder opens like a file; an empty name is one that a script has lost.
  CHECK(run_checker(proof + " " + scratch.file(""), scratch) == 3);
  CHECK(run_checker(proof + " ''", scratch) == 3);
  CHECK(run_checker(scratch.file(""), scratch) == 3);
}

TEST_CASE("convexact-check: proofs of decompositions that the program wrote") {
  const ScratchFolder scratch;
  // The L of three unit cells, its floor and lid each a hexagon.
  const std::string points =
      "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\n"
      "v 0 0 1\nv 2 0 1\nv 2 1 1\nv 1 1 1\nv 1 2 1\nv 0 2 1\n";
  const std::string sides =
      "f 1 2 8 7\nf 2 3 9 8\nf 3 4 10 9\nf 4 5 11 10\nf 5 6 12 11\nf 6 1 7 12\n"
      "f 6 5 4 3 2 1\n";
  const std::string input = scratch.write("l.obj", points + sides + "f 7 8 9 10 11 12\n"),
                    proof = scratch.file("l.proof");
  for (const std::string engine : {"exact", "filtered", "float"}) {
    for (const std::string more : {"", " --precision 32", " --measure vertices", " --max-parts 1",
                                   " --connect touching", " --concavity 0.5"}) {
      INFO(engine, more);
      const support::Ran ran = support::run_program(
          "decompose --method hacd " + input + " --engine " + engine + more + " --proof " + proof);
      REQUIRE_MESSAGE(ran.exit == 0, ran.err);
      CHECK(ran.out.find("written     " + proof) != std::string::npos);
      CHECK(bytes_of(proof).starts_with("convexact-proof 4 decomposition\n"));
      CHECK(run_checker(proof + " " + input, scratch) == 0);
      CHECK(bytes_of(scratch.file("out"))
                .ends_with("proven: the faces are those of " + input +
                           ", 0 of them turned, decimals as the nearest doubles\n"));
    }
  }
  const std::string other = scratch.write("other.obj", points + sides + "f 7 8 9 11 10 12\n");
  CHECK(run_checker(proof + " " + other, scratch) == 1);
  CHECK(bytes_of(scratch.file("out")).empty());
  CHECK(bytes_of(scratch.file("err")) ==
        "convexact-check: " + other +
            ": not proven: that the proof is about this file: its face 8 is not the one of the "
            "proof\n");
  // Several objects have several proofs, or none.
  const std::string two =
      scratch.write("two.obj", points + "o one\n" + sides + "o two\nf 7 8 9 10 11 12\nf 1 2 8 7\n");
  const support::Ran ran =
      support::run_program("decompose --method hacd " + two + " --parts --proof " + proof + "2");
  CHECK(ran.exit == 2);
  CHECK(ran.err.find("--proof: it shows one object, but there are several") != std::string::npos);
}

TEST_CASE("convexact-check: files that include nothing of ours but each other") {
  const std::filesystem::path folder = environment("CONVEXACT_CHECK_SOURCE");
  REQUIRE(std::filesystem::exists(folder / "convexact_check.cpp"));
  bool has_gmp = false;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") continue;
    CAPTURE(entry.path().string());
    const std::string source = bytes_of(entry.path().string());
    has_gmp = has_gmp || source.find("#include <gmpxx.h>") != std::string::npos;
    std::istringstream lines(source);
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with("#include \"")) continue;
      const std::string name = line.substr(10, line.size() - 11);
      CAPTURE(name);
      CHECK(name.find('/') == std::string::npos);
      CHECK(std::filesystem::exists(folder / name));
    }
  }
  CHECK(has_gmp);
}

TEST_CASE("convexact-check: links GMP and the standard library only") {
  const ScratchFolder scratch;
  const std::string command =
      "ldd '" + environment("CONVEXACT_CHECK") + "' >" + scratch.file("libraries");
  REQUIRE(std::system(command.c_str()) == 0);
  std::istringstream lines(bytes_of(scratch.file("libraries")));
  bool has_gmp = false;
  for (std::string line; std::getline(lines, line);) {
    CAPTURE(line);
    const char* const allowed[] = {"libgmp.", "libgmpxx.", "libstdc++.", "libc++", "libm.", "libc.",
                                   "libgcc_s.", "ld-linux", "linux-vdso", "linux-gate",
                                   // of a sanitizer
                                   "libasan.", "libubsan.", "libtsan.", "libpthread.", "libdl.",
                                   "librt."};
    CHECK(std::any_of(std::begin(allowed), std::end(allowed),
                      [&](const char* name) { return line.find(name) != std::string::npos; }));
    has_gmp = has_gmp || line.find("libgmp.") != std::string::npos;
  }
  CHECK(has_gmp);
}

TEST_CASE("convexact-check: out of memory is exit 6 and a sentence, never an abort (#13)") {
  const ScratchFolder scratch;
  // Numbers of millions of digits, for which GMP takes memory, and words for which C++ does.
  const std::string start = "convexact-proof 1 greedy\npoint ";
  const std::string digits = scratch.write("digits", start + std::string(3000000, '7') + " 1 1\n");
  const std::string word = scratch.write("word", start + std::string(30000000, '7') + " 1 1\n");
  const auto run_within = [&](int kilobytes, const std::string& arguments) {
    const std::string limited = "ulimit -v " + std::to_string(kilobytes) + "; exec '" +
                                environment("CONVEXACT_CHECK") + "' " + arguments + " >" +
                                scratch.file("out") + " 2>" + scratch.file("err");
    const int status = std::system(limited.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  };
  for (const int kilobytes : {7000, 9000, 12000, 16000, 20000, 30000}) {
    CAPTURE(kilobytes);
    if (run_within(kilobytes, "") != 2) continue;  // no room for the program itself
    for (const std::string& proof : {digits, word}) {
      const int code = run_within(kilobytes, proof);
      CHECK((code == 6 || code == 3));  // 3: what stands behind the number is missing
      if (proof == word) CHECK(code == 6);
      if (code != 6) continue;
      CHECK(bytes_of(scratch.file("out")).empty());
      CHECK(bytes_of(scratch.file("err")) ==
            "convexact-check: out of memory: nothing is decided\n");
    }
  }
}
