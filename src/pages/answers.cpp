// SPDX-License-Identifier: MIT
#include "pages/answers.hpp"

#include "convexact/error.hpp"
#include "io/json_document.hpp"
#include "number/text.hpp"
#include "pages/parts_picture.hpp"
#include "pages/solids_picture.hpp"
#include "pages/verdict_picture.hpp"
#include "wire/decompose_request.hpp"
#include "wire/solid_request.hpp"
#include "wire/stdio_request.hpp"

namespace convexact {
namespace {

template <class Result>
std::string page_of_solid(const SceneObject& input, const Result& result) {
  return picture_html(solids_picture({drawn(input, result)}));
}

std::string page_of_inner(const SceneObject& input, const InnerResult& result) {
  return picture_html(inner_picture({{input, result}}));
}

std::string page_of_verdict(const SceneObject& input, const Candidate& candidate,
                            const Verdict& verdict) {
  return picture_html(
      verdict_picture(input, candidate, verdict, as_utf8(input.name), first_sentence(verdict)));
}

std::string page_of_parts(const std::string& name, const Decomposition& parts) {
  return picture_html(decomposition_picture(parts, as_utf8(name)));
}

}  // namespace

std::string answer_line_of(std::string_view kind, std::string_view line,
                           std::optional<double> time_limit) {
  if (kind == "hull") return answer_hull_request(line, time_limit, page_of_solid<HullResult>);
  if (kind == "simplify") {
    return answer_simplify_request(line, time_limit,
                                   {page_of_solid<SimplifyResult>, page_of_inner});
  }
  if (kind == "verify") return answer_request(line, time_limit, page_of_verdict);
  if (kind == "decompose") return answer_decompose_request(line, time_limit, page_of_parts);
  throw Error(ErrorCode::InvalidArgument,
              "expected hull, simplify, verify or decompose, found " + in_quotes(kind));
}

std::string first_sentence(const Verdict& verdict) {
  for (const Claim& claim : verdict.claims) {
    if (claim.status == Status::Violated || claim.status == Status::Undecided) {
      return claim.sentence;
    }
  }
  return verdict.holds() ? "every claim holds" : "not all claims hold";
}

}  // namespace convexact
