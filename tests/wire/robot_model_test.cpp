// SPDX-License-Identifier: MIT
// Robots: which bytes of a URDF change, and which do not. Expected texts are written by hand.
#include "wire/robot_model.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "expect_error.hpp"

using namespace convexact;

namespace {

const std::string kRobot = R"(<?xml version="1.0"?>
<!-- <collision> in a comment is none -->
<robot name = "r">
  <link name="base">
    <visual><geometry><mesh filename="package://r/a.dae"/></geometry></visual>
    <collision name='hull > "all"'>
      <origin xyz="0 0 1"/>   <!-- stays > there -->
      <geometry><mesh scale="1 2 -1" filename = "package://r/a.stl" /></geometry>
    </collision>
    <collision><geometry><box size="1 1 1"/></geometry></collision>
    <collision><geometry><mesh filename="b.dae"></mesh></geometry></collision>
  </link>
</robot>
<!-- end -->
)";

RobotParts two(double unit = 1) {
  return {{{"part_000", "a/part_000.obj"}, {"part_001", "a/p&1.obj"}}, unit};
}

std::string message_of(const std::string& bytes) {
  const Error error = error_of([&] { return RobotModel(bytes); });
  CHECK(exit_code(error.code()) == 3);
  return error.what();
}

}  // namespace

TEST_CASE("robot: collisions by meshes are found, by link and line") {
  const RobotModel robot(kRobot);
  CHECK(robot.name() == "r");
  CHECK(robot.links() == 1);
  REQUIRE(robot.collisions().size() == 2);
  CHECK(robot.collisions()[0].link == "base");
  CHECK(robot.collisions()[0].mesh == "package://r/a.stl");
  CHECK(robot.collisions()[0].line == 6);
  CHECK(robot.collisions()[1].mesh == "b.dae");
}

TEST_CASE("robot: without parts no byte changes; with parts, names of files and collisions do") {
  const RobotModel robot(kRobot);
  CHECK(robot.with_parts(std::vector<RobotParts>(2)) == kRobot);
  const std::string collision = kRobot.substr(
      kRobot.find("    <collision name='"),
      kRobot.find("    <collision><geometry><box") - kRobot.find("    <collision name='"));
  const auto changed = [&](const std::string& part, const std::string& path) {
    std::string text = collision;
    text.replace(text.find("\"all\""), 5, "\"all\"_" + part);
    text.replace(text.find("package://r/a.stl"), 17, path);
    return text;
  };
  std::string expected = kRobot;
  expected.replace(expected.find(collision), collision.size(),
                   changed("part_000", "a/part_000.obj") + changed("part_001", "a/p&amp;1.obj"));
  CHECK(robot.with_parts(std::vector<RobotParts>{two(), {}}) == expected);
}

TEST_CASE("robot: the unit of a COLLADA goes into the scale, since OBJ has none") {
  const RobotModel robot(kRobot);
  const std::string text = robot.with_parts(std::vector<RobotParts>{two(0.5), two(0.001)});
  CHECK(text.find("scale=\"0.5 1 -0.5\" filename = \"a/part_000.obj\"") != text.npos);
  CHECK(text.find("<mesh scale=\"0.001 0.001 0.001\" filename=\"a/part_000.obj\"></mesh>") !=
        text.npos);
}

TEST_CASE("robot: a byte order mark, and elements on one line") {
  const std::string line =
      "\xEF\xBB\xBF<robot name='x'><link name='l'><collision><geometry>"
      "<mesh filename='a.stl'/></geometry></collision></link></robot>";
  const RobotModel robot(line);
  const RobotParts one{{{"p", "p.obj"}}, 1};
  std::string expected = line;
  expected.replace(expected.find("a.stl"), 5, "p.obj");
  CHECK(robot.with_parts(std::vector{one}) == expected);
  const RobotParts both{{{"p", "p.obj"}, {"q", "q.obj"}}, 1};
  const std::string text = robot.with_parts(std::vector{both});
  CHECK(text.find("</collision><collision><geometry><mesh filename='q.obj'/>") != text.npos);
}

TEST_CASE("robot: what is no URDF is refused by name") {
  CHECK(message_of("<a/>").find("no robot model") != std::string::npos);
  CHECK(message_of("<robot>\n<link></robot>").find("XML") != std::string::npos);
  CHECK(message_of("").find("XML") != std::string::npos);
  CHECK(message_of("<!DOCTYPE robot [<!ENTITY a \"b\">]><robot/>").find("entities") !=
        std::string::npos);
  CHECK(message_of("<robot xmlns:xacro=\"x\"><xacro:include filename=\"b\"/></robot>")
            .find("run xacro first") != std::string::npos);
}

TEST_CASE("robot: meshes lie beside the model or in a package, links followed") {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / "convexact_robot_test";
  fs::create_directories(folder / "my_robot" / "urdf" / "near");
  fs::create_directories(folder / "other");
  std::ofstream(folder / "secret.stl") << "x";
  const std::string urdf = (folder / "my_robot" / "urdf" / "r.urdf").string();
  const std::vector<RobotPackage> none, other{{"other", (folder / "other").string()}};
  CHECK(fs::path(robot_mesh_path(urdf, "near/a.stl", none)) ==
        folder / "my_robot" / "urdf" / "near" / "a.stl");
  CHECK(fs::weakly_canonical(robot_mesh_path(urdf, "package://my_robot/meshes/a.stl", none)) ==
        fs::weakly_canonical(folder / "my_robot" / "meshes" / "a.stl"));
  CHECK(robot_mesh_path(urdf, "package:///my_robot/meshes/a.stl", none) ==
        robot_mesh_path(urdf, "package://my_robot/meshes/a.stl", none));
  CHECK(fs::path(robot_mesh_path(urdf, "package://other/a.stl", other)) ==
        folder / "other" / "a.stl");
  CHECK(fs::weakly_canonical(robot_mesh_path(urdf, "../../other/a.stl", other)) ==
        fs::weakly_canonical(folder / "other" / "a.stl"));
  for (const char* path :
       {"../../secret.stl", "/etc/passwd", "package://my_robot/../secret.stl",
        "http://example.com/a.stl", "package://unknown/a.stl", "package://my_robot", ""}) {
    CAPTURE(path);
    const Error error = error_of([&] { return robot_mesh_path(urdf, path, other); });
    CHECK(exit_code(error.code()) == 3);
  }
  const Error error =
      error_of([&] { return robot_mesh_path(urdf, "package://unknown/a.stl", none); });
  CHECK(std::string(error.what()).find("--package unknown=DIR") != std::string::npos);
  fs::remove_all(folder);
}
