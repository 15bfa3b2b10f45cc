// SPDX-License-Identifier: MIT
#include "checker.hpp"

#define main convexact_check_main
#include "../../src/check/convexact_check.cpp"
#undef main

CheckerVerdict check_proof(const std::string& text, const std::string& mesh) {
  try {
    return {0, prove_by_kind(text, mesh.empty() ? std::nullopt : std::optional(mesh))};
  } catch (const Failure& failure) {
    return {failure.exit_code, failure.where + ": " + failure.what};
  }
}

int sign_by_checker(const std::vector<std::array<std::string, 2>>& terms) {
  check::RootSum sum;
  for (const auto& [factor, radicand] : terms) {
    check::add_term(sum, Integer(radicand, 10), check::number_of_proof(factor));
  }
  return check::sign(sum);
}

std::optional<std::vector<std::string>> rows_by_checker(const std::string& bytes,
                                                        const std::string& path, bool as_spelt) {
  std::vector<std::string> rows;
  try {
    const MeshFile file =
        check::parse_mesh_file(bytes, path, as_spelt ? Decimals::Spelt : Decimals::Nearest);
    for (const Row& row : file.rows) {
      const Integer below = file.is_mesh ? row[3] : Integer(1);
      std::string text;
      for (std::size_t k = 0; k < (file.is_mesh ? 3 : 4); ++k) {
        text += (k > 0 ? " " : "") + check::quotient(row[k], below).get_str();
      }
      rows.push_back(text);
    }
  } catch (const Failure&) {
    return std::nullopt;
  }
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

std::optional<std::vector<std::string>> faces_by_checker(const std::string& bytes,
                                                         const std::string& path, bool as_spelt) {
  std::vector<std::string> faces;
  try {
    const MeshFile file =
        check::parse_mesh_file(bytes, path, as_spelt ? Decimals::Spelt : Decimals::Nearest, true);
    for (const Ids& corners : file.faces) {
      faces.emplace_back();
      for (const std::size_t corner : corners) {
        const Row& p = file.rows[corner];
        for (std::size_t k = 0; k < 3; ++k) {
          faces.back() += check::quotient(p[k], p[3]).get_str() + (k == 2 ? ", " : " ");
        }
      }
    }
  } catch (const Failure&) {
    return std::nullopt;
  }
  return faces;
}
