// SPDX-License-Identifier: MIT
#include "number/normal_form.hpp"

#include <utility>

#include "number/square_classes.hpp"

namespace convexact {
namespace {

// turns * pi + sign * atan(sqrt(t)), 0 <= t < 1; t = 0 if that is a multiple of pi.
struct ReducedAngle {
  Rational turns = 0;
  int sign = 1;
  Rational t = 0;
};

ReducedAngle reduced(const AngleTerm& term) {
  const Integer squared_dot = term.dot * term.dot;
  ReducedAngle angle;
  if (term.dot < 0) {  // pi - the angle of -dot
    angle.turns = 1;
    angle.sign = -1;
  }
  if (term.squared_cross <= squared_dot) {
    angle.t = Rational(term.squared_cross, squared_dot);
  } else {  // pi/2 - its complement, whose tangent is the inverse
    angle.turns += Rational(angle.sign, 2);
    angle.sign = -angle.sign;
    angle.t = Rational(squared_dot, term.squared_cross);
  }
  // tan(pi/4) = 1 and tan(pi/6)^2 = 1/3; no other multiple of pi has a tan^2 in (0, 1].
  const int part = angle.t == 1 ? 4 : angle.t == Rational(1, 3) ? 6 : 0;
  if (part != 0) {
    angle.turns += Rational(angle.sign, part);
    angle.t = 0;
  }
  return angle;
}

void add_angle(ReducedAngles& sum, const Rational& t, const Rational& factor,
               const AngleTerm& term) {
  const auto place = sum.angles.try_emplace(t).first;
  ReducedAngles::Angle& angle = place->second;
  if (angle.factor == 0) angle = {0, term.squared_cross, term.dot};
  angle.factor += factor;
  if (angle.factor == 0) sum.angles.erase(place);
}

}  // namespace

std::vector<ReducedAngles> normal_form(const AngleSum& sum, const Watch& watch) {
  std::vector<Integer> lengths;  // sqrt(a / b) = sqrt(a b) / b
  for (const AngleTerm& term : sum.terms()) {
    lengths.push_back(numerator(term.squared_length) * denominator(term.squared_length));
  }
  const SquareClasses classes = square_classes(lengths, watch);
  std::vector<ReducedAngles> form;
  for (const Integer& radicand : classes.representatives) form.push_back({radicand});
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    watch.ask();
    const AngleTerm& term = sum.terms()[i];
    const auto& [index, multiple] = classes.members[i];
    const Rational factor =
        term.factor * Rational(multiple) / Rational(denominator(term.squared_length));
    const ReducedAngle angle = reduced(term);
    form[index].turns += factor * angle.turns;
    if (angle.t != 0) add_angle(form[index], angle.t, angle.sign * factor, term);
  }
  std::erase_if(
      form, [](const ReducedAngles& angles) { return angles.turns == 0 && angles.angles.empty(); });
  return form;
}

AngleSum to_angle_sum(std::span<const ReducedAngles> form) {
  std::vector<AngleTerm> terms;
  for (const ReducedAngles& angles : form) {
    const Rational squared_length(angles.radicand);
    terms.push_back({angles.turns, squared_length, 0, -1});
    for (const auto& [t, angle] : angles.angles) {  // sqrt(a / b) = sqrt(a b) / b
      terms.push_back(
          {angle.factor, squared_length, numerator(t) * denominator(t), denominator(t)});
    }
  }
  return AngleSum(std::move(terms));
}

}  // namespace convexact
