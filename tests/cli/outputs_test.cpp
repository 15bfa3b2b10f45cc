// SPDX-License-Identifier: MIT
// The files of a run appear together, and only with exit code 0. None appears if standard output
// cannot be written. Names of files and objects may consist of any bytes.
#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "process.hpp"

using support::bytes_of;
using support::run_program;
using support::ScratchFolder;

namespace {

// Two tetrahedra, named "café" and "naïve" in Latin-1.
const std::string kLatin1 =
    "o caf\xe9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
    "g na\xefve\nv 5 0 0\nv 6 0 0\nv 5 1 0\nv 5 0 1\nf 5 7 6\nf 5 6 8\nf 5 8 7\nf 6 7 8\n";

std::string quoted(const std::string& path) { return "'" + path + "'"; }

bool includes(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("outputs: object names that are not UTF-8 stay in OBJ and are replaced in JSON (#13)") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("a.obj", kLatin1);
  const std::string output = scratch.file("b.obj"), page = scratch.file("b.html");
  for (const std::string command : {"simplify --faces 4 ", "hull "}) {
    CAPTURE(command);
    const auto ran =
        run_program(command + "--parts --json " + input + " -o " + output + " --picture " + page);
    CAPTURE(ran.err);
    CHECK(ran.exit == 0);
    const auto document = nlohmann::json::parse(ran.out);
    CHECK(document["objects"][0]["name"] == input + ": caf\xef\xbf\xbd");
    CHECK(document["objects"][1]["name"] == input + ": na\xef\xbf\xbdve");
    CHECK(includes(bytes_of(output), "o caf\xe9\n"));
    CHECK(includes(bytes_of(output), "o na\xefve\n"));
  }
  const auto compared = run_program("diff --parts --json " + input);
  CHECK(compared.exit == 0);
  CHECK(nlohmann::json::parse(compared.out)["objects"].size() == 2);
}

TEST_CASE("outputs: file names that are not UTF-8 (#13)") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("caf\xe9.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n");
  const std::string folder = quoted(scratch.file("r\xe9sultat"));
  const std::string page = scratch.file("p\xe9.html");
  const auto name_of = [](const support::Ran& ran) {
    return nlohmann::json::parse(ran.out).value("name", std::string());
  };
  CHECK(includes(name_of(run_program("hull --json " + quoted(input))), "caf\xef\xbf\xbd.obj"));
  CHECK(run_program("simplify --faces 4 --json " + quoted(input) + " --picture " + quoted(page))
            .exit == 0);
  CHECK(includes(bytes_of(page), "<title>caf\xef\xbf\xbd.obj</title>"));
  CHECK_FALSE(includes(bytes_of(page), "caf\xe9.obj"));
  CHECK(run_program("verify --json " + quoted(input) + " " + quoted(input)).exit <= 1);
  CHECK(run_program("report --json --sections tightness " + quoted(input) + " -o " + folder).exit ==
        0);
  CHECK(includes(bytes_of(scratch.file("r\xe9sultat/report.csv")), "caf\xef\xbf\xbd.obj"));
  CHECK(includes(bytes_of(scratch.file("r\xe9sultat/report.html")), "caf\xef\xbf\xbd.obj"));
  const auto shrunk = run_program("shrink --json " + quoted(input) + " -o " +
                                  quoted(scratch.file("m\xe9.obj")) + " -- false {input}");
  CHECK(shrunk.exit == 0);
  CHECK(includes(nlohmann::json::parse(shrunk.out)["output"], "m\xef\xbf\xbd.obj"));
  const std::string table = scratch.file("table.md");
  const auto conformed =
      run_program("conform --json --level 1 --flag ties --vectors " + support::data("../vectors") +
                  " -o " + table + " -- cat {input} {faces} {output} 'caf\xe9'");
  CHECK(includes(nlohmann::json::parse(conformed.out)["program"], "caf\xef\xbf\xbd"));
  CHECK(includes(bytes_of(table), "caf\xef\xbf\xbd"));
}

TEST_CASE("outputs: the title of a picture is the file's name, without folder and part (#14)") {
  const ScratchFolder scratch;
  const std::string tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const std::string hostile = scratch.write("<script>&\".obj", tetrahedron);
  const std::string parts =
      scratch.write("a.obj", "o left/arm\n" + tetrahedron + "f 1 3 2\nf 1 2 4\n");
  const std::string page = scratch.file("page.html");
  const auto title_of = [&](const std::string& arguments) {
    CHECK(run_program("simplify --faces 4 " + arguments + " --picture " + page).exit == 0);
    const std::string html = bytes_of(page);
    const std::size_t at = html.find("<title>") + 7;
    return html.substr(at, html.find("</title>") - at);
  };
  CHECK(title_of(quoted(hostile)) == "&lt;script&gt;&amp;&quot;.obj");
  CHECK(title_of("--parts " + parts) == "a.obj");
  CHECK(title_of("<" + parts + " -") == "standard input");
  CHECK(title_of(parts + " " + quoted(hostile)) == "a.obj and 1 more");
}

TEST_CASE("outputs: option values that are not UTF-8 are refused in JSON that can be read (#13)") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n");
  const std::string bad = "'\xff\xc0\xaf\xed\xa0\x80'";  // no byte, overlong, half a surrogate pair
  for (const std::string& arguments :
       {"simplify " + input + " --max-growth " + bad,
        "simplify " + input + " --center " + bad,
        "simplify " + input + " --engine " + bad,
        "simplify " + input + " --faces " + bad,
        "simplify " + input + " -o " + bad,
        "simplify " + bad,
        "simplify " + input + " --" + bad,
        "verify " + input + " " + input + " --tolerance " + bad,
        "verify " + input + " " + input + " --claims " + bad,
        "verify " + input + " " + bad,
        "verify " + input + " --trace " + input + " --max-regret " + bad,
        "generate " + bad,
        "stress " + bad,
        "stress " + bad + ".obj",
        "stress --engines " + bad,
        "report " + input + " --sections " + bad,
        "compare " + input + " --methods " + bad,
        "diff " + input + " --engines " + bad,
        "conform --vectors " + bad + " -- a {input} {faces} {output}",
        "conform -o " + bad + " -- a {input} {faces} {output}",
        "shrink " + input + " -o " + bad + " -- a {input}",
        "shrink " + input + " -o " + scratch.file("b.obj") + " -- " + bad + " {input}"}) {
    CAPTURE(arguments);
    const auto ran = run_program(arguments + " --json");
    const bool behind_program = includes(arguments, " -- ");
    CAPTURE(ran.err);
    CHECK((ran.exit == 2 || ran.exit == 3));
    if (!behind_program) CHECK(nlohmann::json::parse(ran.out)["error"]["exit"] == ran.exit);
  }
}

TEST_CASE("outputs: if standard output cannot be written, every file stays as it was (#13)") {
  const std::string tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  for (const std::string json : {"", "--json "}) {
    const ScratchFolder scratch;
    const std::string input = scratch.write("a.obj", tetrahedron);
    const std::string old = scratch.write("old.obj", "old"), fresh = scratch.file("fresh.json");
    const std::string both = " -o " + old + " -o " + fresh + " >/dev/full #";
    CHECK(run_program("simplify --faces 4 " + json + input + both).exit == 5);
    CHECK(run_program("hull " + json + input + both).exit == 5);
    CHECK(
        run_program("shrink " + json + "-o " + old + " " + input + " -- false {input} >/dev/full #")
            .exit == 5);
    CHECK(run_program("report --sections tightness " + json + input + " -o " + scratch.file("") +
                      " >/dev/full #")
              .exit == 5);
    CHECK(run_program("generate cube --json -o " + old + " >/dev/full #").exit == 5);
    CHECK(bytes_of(old) == "old");
    CHECK(scratch.count() == 2);
    // A reader that is gone: the pipe is closed before the program starts.
    const ScratchFolder other;
    const std::string code = other.file("code");
    std::system(("(sleep 0.3; '" + std::string(std::getenv("CONVEXACT_PROGRAM")) +
                 "' simplify --faces 4 " + json + input + " -o " + old + " 2>/dev/null; echo $? >" +
                 code + ") | true")
                    .c_str());
    CHECK(bytes_of(code) == "6\n");
    CHECK(bytes_of(old) == "old");
    CHECK(run_program("simplify --faces 4 " + json + input + " -o " + old + " >/dev/null #").exit ==
          0);
    CHECK(bytes_of(old) != "old");
    CHECK(scratch.count() == 2);
  }
}

TEST_CASE("inputs: standard input can be read only once (#13)") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n");
  for (const std::string command : {"simplify --faces 4 - -", "hull - ", "diff - -", "report - -",
                                    "verify - -", "verify - --trace -"}) {
    CAPTURE(command);
    const bool twice = command != "hull - ";
    const auto ran = run_program(command + " <" + input);
    CHECK(ran.exit == (twice ? 2 : 0));
    CHECK(includes(ran.err, twice ? "once" : ""));
  }
}

TEST_CASE("hull: measures that are not asked for are neither computed nor told (#13)") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n");
  const std::vector<std::pair<std::string, std::string>> measures = {
      {"volume", "volume"}, {"area", "area"}, {"mean-width", "mean width"}};
  for (const std::string asked :
       {"volume,area,mean-width", "none", "volume", "area", "mean-width,volume"}) {
    CAPTURE(asked);
    const std::string command = "hull " + input + " --measures " + asked;
    const auto document = nlohmann::json::parse(run_program(command + " --json").out);
    const std::string text = run_program(command + " --stages").out;
    CHECK(document.contains("diameter"));
    for (const auto& measure : measures) {  // Clang 14 captures no bindings
      const auto& word = measure.first;
      const auto& stage = measure.second;
      CAPTURE(word);
      const bool is_asked = includes(asked, word);
      CHECK(document.contains(word == "mean-width" ? "mean_width" : word) == is_asked);
      CHECK(includes(text, stage + "  ") == true);  // as a number, or among the stages not needed
      CHECK(includes(text, stage + std::string(24 - stage.size(), ' ') +
                               "not needed: not among the measures asked for") != is_asked);
      for (const auto& listed : document["stages"]) {
        if (listed["name"] == stage) CHECK(listed.contains("skipped") != is_asked);
      }
    }
  }
  for (const std::string bad :
       {"mean_width", "all", "volume+area", "none,area", "area --exact-values"}) {
    CAPTURE(bad);
    const auto ran = run_program("hull " + input + " --measures " + bad);
    CHECK(ran.exit == 2);
    CHECK(
        includes(ran.err, includes(bad, " ") ? "leaves the volume out" : "expected names out of"));
  }
}

TEST_CASE("outputs: two spellings of one name, and empty names, are refused") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n");
  const auto here = std::filesystem::current_path();
  std::filesystem::current_path(scratch.file(""));
  const auto twice = run_program("simplify " + input + " --faces 4 -o t.json --trace ./t.json");
  std::filesystem::current_path(here);
  CHECK(twice.exit == 2);
  CHECK(includes(twice.err, "two outputs go to this file"));
  for (const std::string option : {"-o", "--trace", "--proof", "--picture"}) {
    CAPTURE(option);
    const auto ran = run_program("simplify " + input + " --faces 4 " + option + " ''");
    CHECK(ran.exit == 2);
    CHECK(includes(ran.err, "expected a value, found an empty text"));
  }
  CHECK(run_program("bvh " + input + " --from ''").exit == 2);
  const auto page = run_program("hull " + input + " --picture " + scratch.file("x.json"));
  CHECK(page.exit == 2);
  CHECK(includes(page.err, "expected a name that ends in .html"));
  CHECK(scratch.count() == 1);
}

TEST_CASE("outputs: a link to a file that does not exist yet stays a link") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n");
  const std::string link = scratch.file("link.obj"), target = scratch.file("target.obj");
  std::filesystem::create_symlink("target.obj", link);
  CHECK(run_program("hull " + input + " -o " + link).exit == 0);
  CHECK(std::filesystem::is_symlink(link));
  CHECK(std::filesystem::is_regular_file(target));
}

TEST_CASE("outputs: what few people ask for is behind --verbose and --help-all") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("t.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n");
  const std::string command = "simplify " + input + " --faces 4 -o " + scratch.file("t.obj");
  const std::string brief = run_program(command).out;
  for (const char* text : {"(local)", "at most 1 +", "not needed"}) {
    CAPTURE(text);
    CHECK_FALSE(includes(brief, text));
  }
  const std::string verbose = run_program(command + " --verbose").out;
  CHECK(includes(verbose, "proven again, exactly (local)"));
  CHECK(includes(verbose, "not needed: "));
  for (const char* name : {"simplify", "decompose", "verify", "conform", "shrink"}) {
    CAPTURE(name);
    const std::string help = run_program(std::string(name) + " --help").out;
    const std::string all = run_program(std::string(name) + " --help-all").out;
    CHECK(includes(help, "--help-all"));
    CHECK_FALSE(includes(help, "--max-memory"));
    CHECK(includes(all, "--max-memory"));
    CHECK(includes(all, "Further options"));
    // Each option is in the help for all, those of the short help at the same place.
    CHECK(all.starts_with(help.substr(0, help.find("Examples:") - 1)));
  }
}
