// SPDX-License-Identifier: MIT
// convexact decompose -o MODEL: MJCF, URDF and USD of the parts, read by programs that share
// nothing with convexact.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cells.hpp"
#include "convexact/io.hpp"
#include "process.hpp"

using nlohmann::json;
using support::bytes_of;
using support::run_program;
using support::ScratchFolder;

namespace {

// Of a mesh whose coordinates are no numbers of binary32.
std::string tenth_obj(const std::set<support::Cell>& cells, const std::string& object = "",
                      int first = 1, double shift = 0) {
  const support::Mesh mesh = support::mesh_of_cells(cells);
  std::string text = object.empty() ? "" : "o " + object + "\n";
  for (const support::Point& p : mesh.points.doubles()) {
    text += "v";
    for (const double x : p) text += " " + json(x / 10 + shift).dump();
    text += "\n";
  }
  for (const auto& polygon : mesh.polygons) {
    text += "f";
    for (const std::uint32_t corner : polygon) text += " " + std::to_string(corner + first);
    text += "\n";
  }
  return text;
}

struct ModelRefusal {
  std::string options;
  int exit;
  std::string says;
};

// What a program prints; nothing if it is not installed.
std::optional<std::string> said_by(const std::string& program, const std::string& arguments) {
  const ScratchFolder scratch;
  if (std::system(("command -v " + program + " >/dev/null").c_str()) != 0) return {};
  const std::string command =
      program + " " + arguments + " >'" + scratch.file("out") + "' 2>'" + scratch.file("err") + "'";
  const int status = std::system(command.c_str());
  INFO(command);
  INFO(bytes_of(scratch.file("err")));
  CHECK(status == 0);
  return bytes_of(scratch.file("out"));
}

// An XML document as [tag, attributes, children], by Python's parser.
std::optional<json> parsed_xml(const std::string& path) {
  const ScratchFolder scratch;
  const std::string script = scratch.write("parse.py", R"(
import json, sys, xml.etree.ElementTree as tree
def plain(node): return [node.tag, node.attrib, [plain(child) for child in node]]
print(json.dumps(plain(tree.parse(sys.argv[1]).getroot())))
)");
  const auto said = said_by("python3", "'" + script + "' '" + path + "'");
  if (!said) return {};
  return json::parse(*said);
}

// A number as readers of doubles and readers of floats get it, which must be the same.
double number_of(const json& spelled) {
  const std::string text = spelled.dump();
  const double number = std::strtod(text.c_str(), nullptr);
  CHECK(static_cast<double>(std::strtof(text.c_str(), nullptr)) == number);
  return number;
}

// The points of each mesh of USD.
std::vector<std::vector<support::Point>> points_of_usd(const std::string& text) {
  std::vector<std::vector<support::Point>> meshes;
  const std::string key = "point3f[] points = [";
  for (auto at = text.find(key); at != text.npos; at = text.find(key, at)) {
    at += key.size();
    std::string list = text.substr(at - 1, text.find(']', at) - at + 2);
    for (char& c : list) c = c == '(' ? '[' : c == ')' ? ']' : c;
    meshes.emplace_back();
    for (const json& p : json::parse(list)) {
      meshes.back().emplace_back(number_of(p[0]), number_of(p[1]), number_of(p[2]));
    }
  }
  return meshes;
}

std::vector<support::Point> points_of_obj(const std::string& path) {
  const convexact::Mesh mesh = convexact::read_mesh(path);
  return {mesh.points.doubles().begin(), mesh.points.doubles().end()};
}

}  // namespace

TEST_CASE("part models: MJCF and URDF name every file of the folder, from where they are") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("l.obj", tenth_obj(support::l_cells()));
  std::filesystem::create_directory(scratch.file("models"));
  for (const std::string place : {"", "models/", "parts/"}) {
    CAPTURE(place);
    const std::string mjcf = scratch.file(place + "l.mjcf.xml"),
                      urdf = scratch.file(place + "l.urdf");
    const auto ran = run_program("decompose --method hacd " + input + " --precision 32 -o " + mjcf +
                                 " -o " + scratch.file("parts/") + " -o " + urdf);
    CAPTURE(ran.err);
    REQUIRE(ran.exit == 0);
    const auto model = parsed_xml(mjcf), robot = parsed_xml(urdf);
    if (!model) {
      MESSAGE("skipped: python3 is not installed");
      return;
    }
    CHECK((*model)[0] == "mujoco");
    CHECK((*model)[1] == json{{"model", "l"}});
    const json assets = (*model)[2][0], geoms = (*model)[2][1][2][0];
    CHECK(assets[0] == "asset");
    CHECK(geoms[0] == "body");
    REQUIRE(assets[2].size() == 2);
    // First what the body weighs, then its shapes.
    REQUIRE(geoms[2].size() == 3);
    CHECK(geoms[2][0][0] == "inertial");
    const json link = (*robot)[2][0];
    CHECK(link[0] == "link");
    REQUIRE(link[2].size() == 4);
    CHECK(link[2][0][0] == "inertial");
    CHECK(link[2][1][0] == "visual");
    const std::string seen = link[2][1][2][0][2][0][1]["filename"];
    CHECK(std::filesystem::equivalent(scratch.file(place + seen), input));
    for (std::size_t k = 0; k < 2; ++k) {
      const std::string name = "part_00" + std::to_string(k);
      const std::string file = assets[2][k][1]["file"];
      CHECK(assets[2][k][1]["name"] == name);
      CHECK(geoms[2][k + 1][1] == json{{"name", name}, {"type", "mesh"}, {"mesh", name}});
      CHECK(link[2][k + 2][1] == json{{"name", name}});
      CHECK(link[2][k + 2][2][0][2][0][1] == json{{"filename", file}});
      CHECK(file.front() != '/');
      CHECK(std::filesystem::equivalent(scratch.file(place + file),
                                        scratch.file("parts/" + name + ".obj")));
    }
  }
}

TEST_CASE("part models: USD holds the points of the files, numbers of binary32, around the input") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("cross.obj", tenth_obj(support::cross_cells()));
  const std::string usd = scratch.file("cross.usda"), parts = scratch.file("parts/");
  const auto ran = run_program("decompose --method hacd " + input + " --precision 32 -o " + parts +
                               " -o " + usd);
  REQUIRE(ran.exit == 0);
  const auto meshes = points_of_usd(bytes_of(usd));
  const json document = json::parse(bytes_of(parts + "parts.json"));
  REQUIRE(meshes.size() == document["parts"].size());
  REQUIRE(meshes.size() > 1);
  for (std::size_t k = 0; k < meshes.size(); ++k) {
    const auto points = points_of_obj(parts + document["parts"][k]["file"].get<std::string>());
    CHECK(std::is_permutation(meshes[k].begin(), meshes[k].end(), points.begin(), points.end()));
  }
  // What USD holds in memory, judged against the input.
  std::string text;
  for (std::size_t k = 0; k < meshes.size(); ++k) {
    text += "o part_" + std::to_string(k) + "\n";
    for (const support::Point& p : meshes[k]) {
      text += "v";
      for (const double x : p) text += " " + json(x).dump();
      text += "\n";
    }
    const int count = static_cast<int>(meshes[k].size());
    text += "f";
    for (int corner = -count; corner < 0; ++corner) text += " " + std::to_string(corner);
    text += "\n";
  }
  scratch.write("usd_points.obj", text);
  const auto verdict = run_program("verify " + input + " " + scratch.file("usd_points.obj") +
                                   " --union --claims covers-points,covers-surface");
  CAPTURE(verdict.out);
  CHECK(verdict.exit == 0);
}

TEST_CASE("part models: at the first try") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("l.obj", tenth_obj(support::l_cells()));
  for (const std::string& extension : {"urdf", "mjcf.xml", "usda"}) {
    CAPTURE(extension);
    const std::string model = scratch.file("l." + extension);
    const auto ran = run_program("decompose " + input + " -o " + model);
    CHECK(ran.exit == 0);
    CHECK(ran.err.find("in binary32, rounded outward") != std::string::npos);
    const bool has_folder = extension != "usda";
    CHECK((ran.err.find("which are in " + scratch.file("l_parts/")) != std::string::npos) ==
          has_folder);
    CHECK(run_program("verify --union " + input + " " + model).exit == 0);
    if (!has_folder) continue;
    CHECK(std::filesystem::exists(scratch.file("l_parts/part_000.obj")));
    std::filesystem::remove_all(scratch.file("l_parts"));
  }
  // A folder that is named is taken, and so is a precision.
  CHECK(run_program("decompose " + input + " -o " + scratch.file("other/") + " -o " +
                    scratch.file("l.urdf"))
            .exit == 0);
  CHECK(!std::filesystem::exists(scratch.file("l_parts")));
}

TEST_CASE("part models: what cannot be, is refused before anything is written") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("l.obj", tenth_obj(support::l_cells()));
  const std::string mjcf = " -o " + scratch.file("l.mjcf.xml"),
                    urdf = " -o " + scratch.file("l.urdf"), usd = " -o " + scratch.file("l.usda"),
                    folder = " -o " + scratch.file("parts/"),
                    second = " -o " + scratch.file("other/");
  for (const ModelRefusal& refusal : std::vector<ModelRefusal>{
           {" --precision 32" + urdf + folder + second, 2, "there are several"},
           {" --precision 64" + mjcf + folder, 2, "--precision 32 rounds outward"},
           {" --precision 64" + urdf + folder, 2, "--precision 32 rounds outward"},
           {" --precision 64" + usd, 2, "which cuts off points of the input"},
           {" --precision 32 --flat keep" + usd, 2, "--flat thicken"},
           {" --precision 32 --flat keep" + folder + mjcf, 2, "is no solid there"},
           {" --precision 32 -o " + scratch.file("l.xml"), 2, ".mjcf.xml, .urdf or .usda"},
           {" --precision 32 -o " + scratch.file("missing/l.usda"), 5, "missing"},
           {" --precision 32 --names '\xFF_%d'" + usd, 5, "UTF-8"},
           {" --precision 32 --names '\xEF\xBF\xBF_%d'" + usd, 5, "UTF-8"},
           {" --precision 32 -o '" + scratch.file("a\tb/") + "'" + urdf, 5, "control character"}}) {
    const auto ran = run_program("decompose --method hacd " + input + refusal.options);
    CAPTURE(refusal.options);
    CAPTURE(ran.err);
    CHECK(ran.exit == refusal.exit);
    CHECK(ran.err.find(refusal.says) != std::string::npos);
    CHECK(scratch.count() == 1);
  }
}

TEST_CASE("part models: a file that cannot be written leaves none behind") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("l.obj", tenth_obj(support::l_cells()));
  std::filesystem::create_directory(scratch.file("taken.urdf"));
  // A folder in the place of the file is taken for the folder of the parts.
  const auto ran =
      run_program("decompose --method hacd " + input + " --precision 32 -o " +
                  scratch.file("taken.urdf") + " -o " + scratch.file("missing/l.mjcf.xml"));
  CHECK(ran.exit == 5);
  CHECK_FALSE(std::filesystem::exists(scratch.file("taken.urdf/part_000.obj")));
}

TEST_CASE("part models: names that XML and USD cannot spell are escaped, and kept") {
  const ScratchFolder scratch;
  // Two objects whose names become one identifier, with characters that mean something.
  const std::string name = "1 & <b> \"q\" 'a' \xC3\xA9", other = "1 & <b> \"q\" 'a' \xC3\xA8";
  const std::string left = tenth_obj(support::l_cells(), name, 1);
  const auto corners = static_cast<int>(support::mesh_of_cells(support::l_cells()).points.size());
  const std::string input =
      scratch.write("two.obj", left + tenth_obj(support::l_cells(), other, corners + 1, 5));
  const std::string mjcf = scratch.file("a \"b\" & c.mjcf.xml"), urdf = scratch.file("9.urdf"),
                    usd = scratch.file("9 \"z\".usda");
  const auto ran =
      run_program("decompose --method hacd --parts " + input + " --precision 32 -o '" + mjcf +
                  "' -o '" + scratch.file("p & q/") + "' -o '" + urdf + "' -o '" + usd + "'");
  CAPTURE(ran.err);
  REQUIRE(ran.exit == 0);
  const std::string text = bytes_of(usd);
  CHECK(text.find("defaultPrim = \"_9__z_\"") != std::string::npos);
  CHECK(text.find("displayName = \"9 \\\"z\\\"\"") != std::string::npos);
  CHECK(text.find("displayName = \"1 & <b> \\\"q\\\" 'a' \xC3\xA9_part_000\"") !=
        std::string::npos);
  CHECK(text.find("def Mesh \"_1____b___q___a____part_000\"") != std::string::npos);
  CHECK(text.find("def Mesh \"_1____b___q___a____part_000_2\"") != std::string::npos);
  const auto model = parsed_xml(mjcf), robot = parsed_xml(urdf);
  if (!model) {
    MESSAGE("skipped: python3 is not installed");
    return;
  }
  CHECK((*model)[1]["model"] == "a \"b\" & c");
  CHECK((*robot)[1]["name"] == "9");
  const json assets = (*model)[2][0][2], collisions = (*robot)[2][0][2];
  REQUIRE(assets.size() == 4);
  REQUIRE(collisions.size() == 6);  // behind inertial and visual
  for (const json& asset : assets) {
    CHECK(std::filesystem::exists(scratch.file(asset[1]["file"].get<std::string>())));
  }
  CHECK(assets[0][1]["name"] == name + "_part_000");
  CHECK(assets[2][1]["name"] == other + "_part_000");
  CHECK(collisions[5][1]["name"] == other + "_part_001");
}

TEST_CASE("part models: a unit box in centimeters, y upward, with its name and density") {
  const ScratchFolder scratch;
  const std::string input =
      scratch.write("box.obj",
                    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
                    "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n");
  const std::string urdf = scratch.file("m.urdf"), mjcf = scratch.file("m.mjcf.xml"),
                    usd = scratch.file("m.usda");
  const auto ran = run_program("decompose " + input + " -o " + urdf + " -o " + mjcf + " -o " + usd +
                               " --up y --scale 0.01 --density 2000 --name 'my box' --json");
  CAPTURE(ran.err);
  REQUIRE(ran.exit == 0);
  const json mass = json::parse(ran.out)["mass"];
  CHECK(mass["volume"] == "1");
  CHECK(mass["center"] == json{"1/2", "1/2", "1/2"});
  CHECK(mass["inertia"] == json{"1/6", "1/6", "1/6", "0", "0", "0"});
  CHECK(mass["density"] == "2000");
  CHECK(mass["kilograms"] == 0.002);
  // m a^2 / 6 with a = 0.01; (x, y, z) is (x, -z, y) with z upward.
  const std::string text = bytes_of(urdf);
  CHECK(text.find("<robot name=\"my box\">") != text.npos);
  CHECK(text.find("<origin xyz=\"0.005 -0.005 0.005\" rpy=\"1.5707963267948966 0 0\"/>") !=
        text.npos);
  CHECK(text.find("<mass value=\"0.002\"/>") != text.npos);
  CHECK(text.find("ixx=\"3.3333333333333334e-08\"") != text.npos);
  CHECK(text.find("scale=\"0.01 0.01 0.01\"") != text.npos);
  CHECK(bytes_of(mjcf).find("<inertial pos=\"0.005 0.005 0.005\" mass=\"0.002\"") != text.npos);
  CHECK(bytes_of(usd).find("upAxis = \"Y\"") != text.npos);
  CHECK(bytes_of(usd).find("metersPerUnit = 0.01") != text.npos);
  CHECK(bytes_of(usd).find("centerOfMass = (0.5, 0.5, 0.5)") != text.npos);
  for (const char* wrong : {"--up x", "--scale 0", "--scale -1", "--density nan"}) {
    CHECK(run_program("decompose " + input + " -o " + urdf + " " + wrong).exit == 2);
  }
  // In units of a micrometer, MuJoCo would refuse the mesh.
  const auto small = run_program("decompose " + input + " -o " + mjcf + " --scale 1e-6");
  CHECK(small.exit == 0);
  CHECK(small.out.find("MuJoCo refuses such meshes") != small.out.npos);
}

TEST_CASE("part models: GLB holds the parts, in binary32, and is proven") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("l.obj", tenth_obj(support::l_cells()));
  const std::string glb = scratch.file("l.glb");
  const auto ran = run_program("decompose " + input + " -o " + glb);
  CAPTURE(ran.err);
  REQUIRE(ran.exit == 0);
  CHECK(convexact::read_mesh(glb).parts.size() == 2);
  CHECK(run_program("verify --union " + input + " " + glb).exit == 0);
  CHECK(run_program("decompose " + input + " --precision 64 -o " + glb).exit == 2);
  const std::string hull = scratch.file("hull.glb");
  REQUIRE(run_program("simplify " + input + " --faces 6 -o " + hull).exit == 0);
  CHECK(run_program("verify " + input + " " + hull).exit == 0);
  CHECK(run_program("simplify " + input + " --faces 6 --precision 64 -o " + hull).exit == 2);
}

TEST_CASE("part models: programs of others read them") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("l.obj", tenth_obj(support::l_cells()));
  const std::string mjcf = scratch.file("l.mjcf.xml"), urdf = scratch.file("l.urdf");
  REQUIRE(run_program("decompose --method hacd " + input + " --precision 32 -o " +
                      scratch.file("parts/") + " -o " + mjcf + " -o " + urdf)
              .exit == 0);
  const auto robot = said_by("check_urdf", "'" + urdf + "'");
  if (robot) {
    CHECK(robot->find("robot name is: l") != std::string::npos);
    CHECK(robot->find("Successfully Parsed XML") != std::string::npos);
  } else {
    MESSAGE("skipped: check_urdf is not installed");
  }
  if (!said_by("xmllint", "--noout '" + mjcf + "' '" + urdf + "'")) {
    MESSAGE("skipped: xmllint is not installed");
  }
}

TEST_CASE("verify: models that decompose wrote are read as parts, others are refused") {
  const ScratchFolder scratch;
  const std::string input = scratch.write("l.obj", tenth_obj(support::l_cells()));
  const std::string parts = scratch.file("parts/");
  std::string outputs = " -o " + parts;
  for (const char* name : {"a.mjcf.xml", "a.urdf", "a.usda"}) {
    outputs += " -o " + scratch.file(name);
  }
  REQUIRE(run_program("decompose --method hacd " + input + " --precision 32 --names 'p<%d>&' " +
                      outputs)
              .exit == 0);
  for (const char* name : {"a.mjcf.xml", "a.urdf", "a.usda"}) {
    CAPTURE(name);
    const auto judged = run_program("verify " + input + " " + scratch.file(name) + " --json");
    CHECK(judged.exit == 0);
    const json document = json::parse(judged.out);
    CHECK(document["parts"].size() == 2);
    CHECK(document["parts"][0]["name"] == "p<0>&");
    // A model that scales its meshes, or says anything else of where they are.
    std::string text = bytes_of(scratch.file(name)) + "\n";
    if (const std::size_t mesh = text.rfind("<mesh "); mesh != text.npos) {
      text.insert(mesh + 6, "scale=\"2 2 2\" ");
    }
    const std::string altered = scratch.write(std::string("b") + (name + 1), text);
    const auto refused = run_program("verify " + input + " " + altered);
    CHECK(refused.exit == 3);
    CHECK(refused.err.find("convexact did not write") != std::string::npos);
  }
  std::string text = bytes_of(scratch.file("a.urdf"));
  for (std::size_t at; (at = text.find("parts/")) != text.npos;) text.replace(at, 6, "../o/");
  const auto leaves = run_program("verify " + input + " " + scratch.write("c.urdf", text));
  CHECK(leaves.exit == 3);
  CHECK(leaves.err.find("leaves its folder") != std::string::npos);
}
