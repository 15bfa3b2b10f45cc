// SPDX-License-Identifier: MIT
#include "wire/mass_report.hpp"

#include "number/text.hpp"

namespace convexact {

Json mass_json(const MassProperties& mass) {
  Json center = Json::array(), inertia = Json::array();
  for (const Rational& x : mass.center) center.push_back(x);
  for (const Rational& x : mass.inertia()) inertia.push_back(x);
  return {{"volume", mass.volume}, {"center", center}, {"inertia", inertia}};
}

std::string mass_lines(const MassProperties& mass, int digits) {
  const auto words = [&](const auto& numbers) {
    std::string text;
    for (const Rational& x : numbers) text += (text.empty() ? "" : " ") + to_decimal(x, digits);
    return text;
  };
  return summary_line("mass", to_decimal(mass.volume, digits) + ", for density 1") +
         summary_line("center", words(mass.center)) +
         summary_line("inertia", words(mass.inertia()) + " (xx yy zz xy xz yz, about the center)");
}

}  // namespace convexact
