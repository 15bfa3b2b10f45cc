// SPDX-License-Identifier: MIT
// lrs.hpp - volumes and vertices from the program lrs [Avis2000], in its own exact arithmetic.
#pragma once
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "convexact/geometry.hpp"

/// CONVEXACT_LRS is the program's path. It is run on files beside the test executable.
class Lrs {
 public:
  explicit Lrs(const std::string& name) : base_(std::string("lrs_") + name) {}

  /// Volume of the hull of points that span a volume.
  convexact::Rational volume(std::span<const convexact::RationalPoint> points) const {
    using namespace convexact;
    std::ostringstream input;
    input << "points\nV-representation\nbegin\n" << points.size() << " 4 rational\n";
    for (const RationalPoint& p : points) {
      input << "1 " << to_string(p[0]) << ' ' << to_string(p[1]) << ' ' << to_string(p[2]) << '\n';
    }
    input << "end\nvolume\n";
    const std::string output = run(input.str()), key = "*Volume=";
    const auto start = output.find(key);
    if (start == std::string::npos) throw std::runtime_error("lrs tells no volume:\n" + output);
    std::istringstream rest(output.substr(start + key.size()));
    std::string value;
    rest >> value;
    return parse_rational(value);
  }

  /// Vertices of a bounded intersection, repeats possible where more than three planes meet.
  std::vector<convexact::RationalPoint> vertices(
      std::span<const convexact::Halfspace> halfspaces) const {
    using namespace convexact;
    const std::string output = run(h_representation(halfspaces));
    std::istringstream rows(output.substr(output.find("rational") + 8));
    std::vector<RationalPoint> result;
    for (std::string kind, x, y, z; rows >> kind && kind != "end";) {
      if (kind != "1" || !(rows >> x >> y >> z)) throw std::runtime_error("lrs found a ray");
      result.push_back({parse_rational(x), parse_rational(y), parse_rational(z)});
    }
    return result;
  }

  /// Whether no point satisfies the halfspaces.
  bool is_empty(std::span<const convexact::Halfspace> halfspaces) const {
    const std::string output = run(h_representation(halfspaces));
    if (output.find("No feasible solution") != std::string::npos) return true;
    if (output.find("\n 1 ") == std::string::npos) {
      throw std::runtime_error("lrs finds no vertex:\n" + output);
    }
    return false;
  }

 private:
  // Rows (b, A) with b + A x >= 0, so (-d, -n).
  static std::string h_representation(std::span<const convexact::Halfspace> halfspaces) {
    using namespace convexact;
    std::ostringstream input;
    input << "halfspaces\nH-representation\nbegin\n" << halfspaces.size() << " 4 rational\n";
    for (const Halfspace& h : halfspaces) {
      input << to_string(Integer(-h.offset()));
      for (int k = 0; k < 3; ++k) input << ' ' << to_string(Integer(-h.normal()[k]));
      input << '\n';
    }
    input << "end\n";
    return input.str();
  }

  std::string run(const std::string& input) const {
    const std::string in = base_ + ".in", out = base_ + ".out";
    std::ofstream(in) << input;
    const std::string command =
        std::string(CONVEXACT_LRS) + ' ' + in + ' ' + out + " > /dev/null 2>&1";
    if (std::system(command.c_str()) != 0) throw std::runtime_error("lrs failed on " + in);
    std::ifstream file(out);
    std::string output((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    std::filesystem::remove(in);
    std::filesystem::remove(out);
    return output;
  }

  std::string base_;
};
