// SPDX-License-Identifier: MIT
// Texts of options: what is wrong with one is a sentence of its own thread, and every option of the
// tables is one of the C interface.
#include <convexact.h>
#include <doctest/doctest.h>

#include <map>
#include <string>
#include <thread>
#include <vector>

#include "wire/decompose_options.hpp"
#include "wire/judge_fields.hpp"
#include "wire/simplify_options.hpp"

using namespace convexact;

namespace {

// [0, 4]^3 without a corner, as a mesh: 7 planes.
const std::vector<double> kPoints = {0, 0, 0, 4, 0, 0, 0, 4, 0, 4, 4, 0, 0, 0, 4,
                                     4, 0, 4, 0, 4, 4, 3, 4, 4, 4, 3, 4, 4, 4, 3};
const std::vector<std::uint32_t> kTriangles = {0, 2, 3, 0, 3, 1, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2,
                                               7, 9, 2, 9, 3, 0, 4, 6, 0, 6, 2, 1, 3, 9, 1, 9,
                                               8, 1, 8, 5, 4, 5, 8, 4, 8, 7, 4, 7, 6, 7, 8, 9};

const std::size_t kCount = kPoints.size() / 3, kFaces = kTriangles.size() / 3;

// Each function: its status with a text of options.
convexact_status simplify_with(const std::string& options) {
  convexact_solid* result = nullptr;
  const auto status = convexact_simplify(kPoints.data(), kCount, options.c_str(), &result);
  convexact_solid_free(result);
  return status;
}

convexact_status decompose_with(const std::string& options) {
  convexact_decomposition* result = nullptr;
  const auto status = convexact_decompose(kPoints.data(), kCount, kTriangles.data(), kFaces,
                                          options.c_str(), &result);
  convexact_decomposition_free(result);
  return status;
}

convexact_status judge_with(const std::string& options) {
  convexact_verdict* result = nullptr;
  const auto status =
      convexact_judge_mesh(kPoints.data(), kCount, kTriangles.data(), kFaces, kPoints.data(),
                           kCount, nullptr, nullptr, 0, options.c_str(), &result);
  convexact_verdict_free(result);
  return status;
}

convexact_status judge_parts_with(const std::string& options) {
  convexact_verdict* result = nullptr;
  const auto status =
      convexact_verify_parts(kPoints.data(), kCount, kTriangles.data(), kFaces, kPoints.data(),
                             &kCount, 1, nullptr, nullptr, nullptr, options.c_str(), &result);
  convexact_verdict_free(result);
  return status;
}

convexact_status tree_with(const std::string& options) {
  convexact_decomposition* parts = nullptr;
  REQUIRE(convexact_decompose(kPoints.data(), kCount, kTriangles.data(), kFaces, nullptr, &parts) ==
          CONVEXACT_OK);
  convexact_tree* result = nullptr;
  const auto status = convexact_decomposition_tree(parts, options.c_str(), &result);
  convexact_tree_free(result);
  convexact_decomposition_free(parts);
  return status;
}

using Call = convexact_status (*)(const std::string& options);

std::string message(Call call, const std::string& options) {
  CAPTURE(options);
  CHECK(call(options) == CONVEXACT_INVALID_ARGUMENT);
  return convexact_message();
}

// The options that a function says it has.
std::string known_to(Call call) {
  const std::string text = message(call, "none"), before = "expected options out of ";
  REQUIRE(text.starts_with("there is no option 'none': " + before));
  return text.substr(text.find(before) + before.size());
}

using Texts = std::map<std::string, std::string>;  // by option

// Gives each option of a table its default, or the text that has it, and returns their names.
template <class Request>
std::string tried_names(Call call, const Fields<Request>& fields, const Texts& texts,
                        const Request& usual = {}) {
  std::string names;
  for (const Field<Request>& field : fields) {
    const bool is_flag = field.kind == FieldKind::Flag;
    const std::string value = field.write(usual), text = field.name + "=" + value;
    const std::string options = texts.contains(field.name) ? texts.at(field.name)
                                : is_flag && value.empty() ? text + "false"
                                                           : text;
    CAPTURE(options);
    CHECK_MESSAGE(call(options) == CONVEXACT_OK, convexact_message());
    names += (names.empty() ? "" : ", ") + field.name;
  }
  return names;
}

}  // namespace

TEST_CASE("C interface: every option of the tables is one of the function") {
  CHECK(known_to(decompose_with) == tried_names(decompose_with, decompose_call_fields(),
                                                {{"jobs", "jobs=2"},
                                                 {"max_parts", "max_parts=8"},
                                                 {"max_excess", "max_excess=20%"},
                                                 {"faces", "faces=6"},
                                                 {"max_part_vertices", "max_part_vertices=8"},
                                                 {"total_faces", "total_faces=6"}},
                                                default_decompose_request()));
  Texts of_simplify = {{"max_growth", "max_growth=5%"},
                       {"growth_of", "max_growth=5% growth_of=area"},
                       {"moves", "faces=6 search=local moves=7"},
                       {"nodes", "faces=6 search=optimal nodes=1000"},
                       {"jobs", "faces=6 jobs=2"}};
  SimplifyRequest usual;
  usual.faces = 6;
  for (const Field<SimplifyRequest>& field : simplify_call_fields()) {
    if (field.name == "faces") continue;
    of_simplify.emplace(field.name, "faces=6 " + field.name + "=" + field.write(usual));
  }
  CHECK(known_to(simplify_with) ==
        tried_names(simplify_with, simplify_call_fields(), of_simplify, usual));
  const Texts of_each = {{"tolerance", "tolerance=1e-9d"},
                         {"claims", "claims=candidate-solid,contains-input"},
                         {"max_facets", "max_facets=7 exact_facets"},
                         {"max_vertices", "max_vertices=10"},
                         {"max_facet_vertices", "max_facet_vertices=5"}};
  CHECK(known_to(judge_with) == tried_names(judge_with, verify_call_fields(), of_each));
  Fields<VerifyRequest> of_parts = verify_call_fields();
  std::erase_if(of_parts, [](const auto& field) { return field.name == "asks"; });
  Texts texts = of_each;
  texts["claims"] = "claims=covers-solid,tree-nested";
  CHECK(known_to(judge_parts_with) ==
        tried_names(judge_parts_with, of_parts, texts) + ", " +
            tried_names(
                judge_parts_with, parts_fields(),
                {{"distance", "distance=3%"}, {"max_parts", "max_parts=1"}, {"jobs", "jobs=2"}}));
  CHECK(known_to(tree_with) == tried_names(tree_with, tree_fields(),
                                           {{"faces", "faces=6"}, {"leaf_faces", "leaf_faces=6"}}));
}

TEST_CASE("C interface: the message names the option and says what there is") {
  CHECK(message(decompose_with, "max-parts=8").starts_with("there is no option 'max-parts': "));
  CHECK(message(decompose_with, "=8").starts_with("there is no option '': "));
  CHECK(message(decompose_with, "max_parts=8 max_parts=8") == "max_parts: given twice");
  CHECK(message(decompose_with, "method=cut max_parts=0") ==
        "max_parts: expected a whole number from 1 to 18446744073709551615, found '0'");
  CHECK(message(decompose_with, "max_parts") ==
        "max_parts: expected a whole number from 1 to 18446744073709551615, found ''");
  CHECK(message(decompose_with, "method=vhacd") ==
        "method: expected one of acd, auto, cut, hacd, found 'vhacd'");
  CHECK(message(decompose_with, "disjoint=yes") ==
        "disjoint: expected one of false, true, found 'yes'");
  CHECK(message(decompose_with, "concavity=101%").starts_with("concavity: expected a share "));
  CHECK(message(decompose_with, "no_measures exact_volumes") ==
        "exact_volumes or no_measures, not both");
  CHECK(message(judge_with, "tolerance=much") ==
        "tolerance: expected a distance such as 1e-6, or 1e-9d for a part of the diameter, found "
        "'much'");
  CHECK(message(judge_with, "claims=big").starts_with("claims: expected names out of candidate-"));
  CHECK(message(judge_with, "exact_facets") == "exact_facets with max_facets only");
  CHECK(message(judge_parts_with, "asks=hull").starts_with("there is no option 'asks': "));
  CHECK(message(simplify_with, "") == "give a number of faces, a growth limit, or both");
  CHECK(message(simplify_with, "faces=6 moves=7").find("moves") != std::string::npos);
  CHECK(message(tree_with, "precision=16") == "precision: expected one of 32, 64, found '16'");
}

TEST_CASE("C interface: what is not an option has a message, too") {
  convexact_solid* solid = nullptr;
  CHECK(convexact_simplify(nullptr, 8, "faces=6", &solid) == CONVEXACT_INVALID_ARGUMENT);
  CHECK(std::string(convexact_message()) == "the array of points is missing, empty or too long");
  CHECK(convexact_simplify(kPoints.data(), 4, "faces=6", &solid) == CONVEXACT_NO_INTERIOR);
  const std::string flat = convexact_message();
  CHECK(flat.find("plane") != std::string::npos);
  CHECK(convexact_simplify(kPoints.data(), kCount, "faces=6", nullptr) ==
        CONVEXACT_INVALID_ARGUMENT);
  CHECK(std::string(convexact_message()) == "the place for the result is missing");
}

TEST_CASE("C interface: each thread has a message of its own, which calls that succeed leave") {
  const std::string ours = message(decompose_with, "effort=7");
  std::string before, theirs;
  std::thread([&] {
    before = convexact_message();
    convexact_solid* solid = nullptr;
    (void)convexact_simplify(kPoints.data(), kCount, "faces=3", &solid);
    theirs = convexact_message();
  }).join();
  CHECK(before == "");
  CHECK(theirs.starts_with("faces: "));
  CHECK(decompose_with("effort=low") == CONVEXACT_OK);
  CHECK(convexact_message() == ours);
}
