// SPDX-License-Identifier: MIT
// decompose robot.urdf: what changes, what stays, and what happens when a mesh cannot be had.
#include <doctest/doctest.h>

#include <filesystem>

#include "cells.hpp"
#include "convexact/io.hpp"
#include "process.hpp"
#include "program_json.hpp"

using namespace support;
using nlohmann::json;

namespace {

const std::string kTwoLinks = R"(<robot name="r">
  <link name="arm"><visual><geometry><mesh filename="package://r/arm.obj"/></geometry></visual>
    <collision>
      <origin xyz="1 2 3"/>
      <geometry><mesh filename="package://r/arm.obj" scale="1 -1 1"/></geometry>
    </collision>
  </link>
  <link name="hand">
    <collision><geometry><mesh filename="package://r/arm.obj"/></geometry></collision>
    <collision><geometry><sphere radius="1"/></geometry></collision>
  </link>
  <link name="flat"><collision><geometry><mesh filename="package://r/flat.obj"/></geometry></collision></link>
</robot>
)";

// Two boxes that form an L.
const std::string kArm =
    convexact::write_mesh(mesh_of_cells(l_cells()), convexact::MeshFormat::Obj);
const std::string kFlatMesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

}  // namespace

TEST_CASE("robot: all or nothing, or the collision that fails stays") {
  const ScratchFolder scratch;
  const std::string urdf = scratch.write("r.urdf", kTwoLinks), out = scratch.file("out/");
  const std::string package = " --package r=" + std::filesystem::path(urdf).parent_path().string();
  const std::string command = "decompose " + urdf + package + " -o " + out;
  scratch.write("arm.obj", kArm);
  const auto missing = run_program(command);
  CHECK(missing.exit == 3);
  CHECK(missing.err.find("link 'flat'") != missing.err.npos);
  CHECK_FALSE(std::filesystem::exists(out));
  scratch.write("flat.obj", kFlatMesh);
  const auto flat = run_program(command + "");
  CHECK(flat.exit == 4);
  CHECK_FALSE(std::filesystem::exists(out));
  const auto kept = run_program(command + " --keep-going");
  CAPTURE(kept.err);
  REQUIRE(kept.exit == 0);
  CHECK(kept.err.find("the collision stays as it was") != kept.err.npos);
  CHECK(kept.out.find("2 of 3 collisions with meshes replaced by 4 parts") != kept.out.npos);
  CHECK(kept.out.find("arm: arm.obj, 2 parts") != kept.out.npos);
  std::string expected = kTwoLinks;
  const auto replace = [&](const std::string& before, const std::string& after) {
    const std::size_t at = expected.find(before);
    REQUIRE(at != expected.npos);
    expected.replace(at, before.size(), after);
  };
  const auto placed = [](const std::string& part) {
    return "    <collision>\n      <origin xyz=\"1 2 3\"/>\n      <geometry><mesh "
           "filename=\"arm/arm_" +
           part + ".obj\" scale=\"1 -1 1\"/></geometry>\n    </collision>\n";
  };
  replace(
      "    <collision>\n      <origin xyz=\"1 2 3\"/>\n      <geometry><mesh "
      "filename=\"package://r/arm.obj\" scale=\"1 -1 1\"/></geometry>\n    </collision>\n",
      placed("part_000") + placed("part_001"));
  const auto plain = [](const std::string& part) {
    return "    <collision><geometry><mesh filename=\"arm/arm_" + part +
           ".obj\"/></geometry></collision>\n";
  };
  replace(
      "    <collision><geometry><mesh filename=\"package://r/arm.obj\"/></geometry></collision>\n",
      plain("part_000") + plain("part_001"));
  CHECK(convexact::read_bytes(scratch.file("out/r.urdf")) == expected);
  CHECK(run_program("verify " + scratch.file("arm.obj") + " " + scratch.file("out/arm")).exit == 0);
}

TEST_CASE("robot: what cannot be, is refused in one sentence") {
  const ScratchFolder scratch;
  const std::string urdf = scratch.write("r.urdf", kTwoLinks), out = " -o " + scratch.file("out/");
  const auto says = [&](const std::string& options, int exit, const std::string& words) {
    const auto ran = run_program("decompose " + options);
    CAPTURE(ran.err);
    CHECK(ran.exit == exit);
    CHECK(ran.err.find(words) != ran.err.npos);
  };
  says(urdf + out, 3, "--package r=DIR");
  says(urdf + " -o " + scratch.file("a.obj"), 2, "to one folder");
  says(urdf + out + " --package r", 2, "NAME=DIR");
  says(urdf + out + " --precision 64", 2, "binary32");
  says(scratch.write("a.urdf", "<robot name='a'><link name='l'/>"), 2, "to one folder");
  says(scratch.write("b.urdf", "<robot name='a'><link name='l'/>") + out, 3, "XML");
  says(scratch.write("c.urdf", "<!DOCTYPE r [<!ENTITY x 'y'>]><robot/>") + out, 3, "entities");
  says(scratch.write("x.urdf.xacro", "<robot xmlns:xacro='x'><xacro:if/></robot>") + out, 3,
       "run xacro first");
  const auto none = run_program("decompose " + scratch.write("d.urdf", "<robot name='d'/>") + out);
  CHECK(none.exit == 0);
  CHECK(none.out.find("no collision names a mesh") != none.out.npos);
}

TEST_CASE("robot: thousands of links of one mesh") {
  const ScratchFolder scratch;
  scratch.write("arm.obj", kArm);
  std::string text = "<robot name='many'>";
  for (int k = 0; k < 3000; ++k) {
    text += "<link name='l" + std::to_string(k) +
            "'><collision><geometry><mesh filename='arm.obj'/></geometry></collision></link>\n";
  }
  const std::string urdf = scratch.write("many.urdf", text + "</robot>");
  const auto ran = run_program("decompose " + urdf + " -o " + scratch.file("out/") + " --json");
  REQUIRE(ran.exit == 0);
  const json document = json::parse(ran.out);
  CHECK(document["robot"] == "many");
  CHECK(document["links"] == 3000);
  REQUIRE(document["collisions"].size() == 3000);
  CHECK(document["collisions"][2999]["parts"] == 2);
  CHECK(document["collisions"][2999]["covers"] == "solid");
}
