# SPDX-License-Identifier: MIT
"""The faults of faults.py: (kind, file, the text that occurs once, its replacement, tests to run in order)."""

CONSTANT, FORGOTTEN, TIE, SIGN = 'constant / 16', 'underflow forgotten', 'tie rule dropped', 'sign flipped'
PUSH, SKIP, STALE = 'push too small', 'verification skipped', 'stale value trusted'

_FAST, _GEO = 'src/fast/', 'src/geometry/'
_AUDIT = 'fast_plane_filter fast_audit'
_CAPS = 'fast_cap_bounds fast_audit'
_AGREE = 'fast'
_STORED = 'stored_planes stored_mesh containment growth'

FAULTS = [
    # Error constants.
    (CONSTANT, _GEO + 'orient3d_stages.hpp', 'kBoundA = (8 + 128 * u) * u', 'kBoundA = (8 + 128 * u) * u / 16', 'geometry'),
    (CONSTANT, _GEO + 'orient3d_stages.hpp', 'kBoundB = (3 + 128 * u) * u', 'kBoundB = (3 + 128 * u) * u / 16', 'geometry'),
    (CONSTANT, _GEO + 'orient3d_stages.hpp', 'kBoundC = 96 * u * u', 'kBoundC = 6 * u * u', 'geometry'),
    (CONSTANT, _GEO + 'orient3d_stages.hpp', 'kRelativeC = 20 * u', 'kRelativeC = 1.25 * u', 'geometry'),
    (CONSTANT, _FAST + 'signs.hpp', 'kHeightFactor = 64,', 'kHeightFactor = 4,', _AUDIT),
    (CONSTANT, _FAST + 'signs.hpp', 'kDeterminantFactor = 64;', 'kDeterminantFactor = 4;', _AUDIT),
    (CONSTANT, _FAST + 'signs.hpp', 'kUnit = kUnitRoundoff', 'kUnit = kUnitRoundoff / 16', _AUDIT),
    (CONSTANT, _FAST + 'signs.hpp', 'kUnit = 0x1p-86', 'kUnit = 0x1p-90', _AUDIT),
    (CONSTANT, _FAST + 'dual.hpp', 'kNearError = 0x1p-52', 'kNearError = 0x1p-56', _AUDIT),
    (CONSTANT, _FAST + 'dual.hpp', 'kLongError = 0x1p-85', 'kLongError = 0x1p-89', _AUDIT),
    (CONSTANT, _FAST + 'dual.cpp', 'kCertain = 0x1p-88', 'kCertain = 0x1p-84', _AUDIT),
    (CONSTANT, _FAST + 'dual.cpp', 'kDistanceFactor = 8;', 'kDistanceFactor = 0.5;', _AUDIT),
    (CONSTANT, _FAST + 'cap_volume.hpp', 'kVertexError = 6,', 'kVertexError = 0.375,', _CAPS),
    (CONSTANT, _FAST + 'cap_volume.hpp', '2 * (3 * filter.height * from_heights',
     '2 * (0.1875 * filter.height * from_heights', _CAPS),
    (CONSTANT, _FAST + 'cap_volume.hpp', 'const double relative = kRelativeErrors *',
     'const double relative = 0.0625 * kRelativeErrors *', _CAPS),
    (CONSTANT, _FAST + 'cap_volume.hpp', '(16 + static_cast<double>(triangles.size())) * unit',
     '(16 + static_cast<double>(triangles.size())) * unit / 16', _CAPS),
    (CONSTANT, _FAST + 'cap_volume.hpp', 'Scalar(2 * n * unit_)', 'Scalar(2 * n * unit_ / 16)', _CAPS),
    (CONSTANT, _FAST + 'cap_volume.hpp', 'value - Scalar(error);', 'value - Scalar(error / 16);', _CAPS),
    (CONSTANT, _FAST + 'cap_volume.hpp', 'value + Scalar(error)}', 'value + Scalar(error / 16)}', _CAPS),
    (CONSTANT, _FAST + 'cap_volume.hpp', '(sides.size, unit_).determinant)', '(sides.size, unit_).determinant / 16)', _CAPS),
    (CONSTANT, _FAST + 'cap.cpp', 'const double slop = 2 * (16', 'const double slop = 0.125 * (16', _AGREE),
    (CONSTANT, 'src/hull/near_geometry.hpp', 'kNearError = 8 * kUnitRoundoff', 'kNearError = 0.5 * kUnitRoundoff', 'hull'),
    (CONSTANT, 'src/hull/near_geometry.hpp', 'kSlope = 512 *', 'kSlope = 32 *', 'hull'),
    (CONSTANT, 'src/hull/near_geometry.hpp', 'kIntercept = 8192 *', 'kIntercept = 512 *', 'hull'),
    (CONSTANT, 'src/hull/near_geometry.hpp', 'kCenterBound = 256 *', 'kCenterBound = 16 *', 'hull'),
    (CONSTANT, 'src/stored/near_products.hpp', 'kRelative = 8 * kUnitRoundoff', 'kRelative = 0.5 * kUnitRoundoff', _STORED),
    (FORGOTTEN, 'src/stored/near_products.hpp', 'return 0x1p-1070 + 0x1p-1070 * largest', 'return 0 * largest', _STORED),
    (CONSTANT, 'src/number/double_double.hpp', 'kUnit = 0x1p-102', 'kUnit = 0x1p-106', 'number ' + _AUDIT),
    (CONSTANT, 'src/number/roundoff.hpp', '0x8000001p0 * x', '0x800001p0 * x', 'number geometry ' + _AUDIT),

    # Tie rules.
    (TIE, _GEO + 'halfspace.cpp', 'a.normal_gcd_ == b.normal_gcd_', 'true', 'geometry'),
    (TIE, 'src/simplify/exact_engine.cpp', 'it != queue_.end() && it->first == cost', 'it != queue_.end() && it->second == i', 'simplify'),
    (TIE, 'src/simplify/exact_engine.cpp', 'const auto& [cost, i] = *queue_.begin();',
     'const auto& [cost, i] = *std::prev(queue_.upper_bound({queue_.begin()->first, HalfspaceId(removals_.size())}));', 'simplify'),
    (TIE, _FAST + 'filtered_loop.cpp', 'return dual_.precedes(a, b);', 'return dual_.precedes(b, a);', _AGREE),
    (TIE, _FAST + 'ties.cpp', 'return exact_cost(i) != least;', 'return exact_cost(i) < least;', _AGREE),
    (TIE, _FAST + 'ties.cpp', 'return refined_.at(i).bounds.lower > best;', 'return !(refined_.at(i).bounds.lower < best);', _AGREE),
    (TIE, _FAST + 'ties.cpp', 'return classes.size() == 1;', 'return true;', _AGREE),
    (TIE, _FAST + 'dual.cpp', 'return exact(i) < exact(j);', 'return i < j;', _AGREE),
    (TIE, _FAST + 'ties.cpp', 'symmetry.is_reflection() ? k - 1 : 1', '1', _AGREE),
    (TIE, _FAST + 'ties.cpp', 'm == k && differ_by_one_translation(pairs)', 'm == k', _AGREE),
    (TIE, 'src/hull/merge_facets.cpp', 'std::min(chosen_[vertex.index()], p)', 'chosen_[vertex.index()]', 'hull'),
    (TIE, 'src/hull/incremental_hull.cpp', 'apex) == Sign::Positive;', 'apex) != Sign::Negative;', 'hull'),
    (TIE, 'src/lp/flat.cpp', 'for (std::size_t i = 0; slope == 0; ++i) slope = form(i, column);', '', 'lp'),
    (TIE, 'src/oracle/judge_trace.cpp', 'if (claimed != judged.tie)', 'if (false)', 'oracle'),
    (TIE, 'src/check/convexact_check.cpp', '!greedy_ || tie[0] == i', 'true', 'check check_mutated'),
    (TIE, 'src/check/convexact_check.cpp', 'require(words_.ids(planes_.size()) == tie,', 'require(!words_.ids(planes_.size()).empty() || true,', 'check check_mutated'),

    # Signs.
    (SIGN, _GEO + 'orient3d_stages.hpp', '(y.x() * z.y() - z.x() * y.y())', '(y.x() * z.y() + z.x() * y.y())', 'geometry'),
    (SIGN, _GEO + 'orient3d_stages.hpp', 'minor(z.x(), x.y(), x.x(), z.y())', 'minor(z.x(), x.y(), -x.x(), z.y())', 'geometry'),
    (SIGN, _GEO + 'orient3d.cpp', '-product(entry(q, 0), entry(p, 1))', 'product(entry(q, 0), entry(p, 1))', 'geometry'),
    (SIGN, _GEO + 'orient3d_stages.hpp', 'total += determinant(a, b, c)', 'total -= determinant(a, b, c)', 'geometry'),
    (SIGN, _GEO + 'orient3d.cpp', 'sign_of(Rational(x.dot(cross)))', 'sign_of(Rational(-x.dot(cross)))', 'geometry'),
    (SIGN, _GEO + 'plane_side.cpp', 'add_product(sum, term', 'subtract_product(sum, term', 'geometry'),
    (SIGN, _GEO + 'plane_determinants.cpp', 'return dot(ab, cp_d) + dot(ab_d, cp);', 'return dot(ab, cp_d) - dot(ab_d, cp);', 'geometry'),
    (SIGN, 'src/dual/polar.cpp', 'subtract_product(sum, plane.d', 'add_product(sum, plane.d', 'geometry'),
    (SIGN, 'src/simplify/plain_vertex.cpp', 'ca * b.offset() + ab', 'ca * b.offset() - ab', 'geometry'),
    # Of a determinant that the filtered engine and its own check share: step verification must find it alone.
    (SIGN, _GEO + 'plane_determinants.cpp', 'return dot(ab, cp_d) + dot(ab_d, cp);', 'return dot(ab_d, cp) - dot(ab, cp_d);', 'shared_determinants'),
    (SIGN, _FAST + 'signs.cpp', 'if (is_zero(a) && is_zero(b) && is_zero(c))', 'if (is_zero(a) && is_zero(b))', _AGREE),
    (SIGN, _FAST + 'signs.cpp', 'contains(second, vertex) && contains(third, vertex)', 'contains(second, vertex)', _AGREE),
    (SIGN, _FAST + 'cap_volume.hpp', 'first_[t] + second_[t] + above - height', 'first_[t] + second_[t] + above + height', 'fast_audit'),
    (SIGN, _FAST + 'cap_volume.hpp', ': triangles[parent].low == low ? -first_', ': triangles[parent].low == low ? first_', 'fast_audit'),
    (SIGN, 'src/simplify/cap.cpp', 'vertex.x * apex.d - apex.x * vertex.d', 'vertex.x * apex.d + apex.x * vertex.d', 'simplify definition'),
    (SIGN, 'src/lp/halfspace_certificates.cpp', 'sum.normal.isZero(0) && sum.offset > 0', 'sum.normal.isZero(0) && sum.offset < 0', 'lp'),
    (SIGN, 'src/hull/check_hull.cpp', 'over[i].next) != Sign::Negative', 'over[i].next) == Sign::Positive', 'hull'),
    (SIGN, 'src/stored/stored_planes.cpp', 'top - error - error', 'top - error + error', _STORED),
    (SIGN, 'src/measure/area_and_volume.cpp', 'Rational(Integer(-offset))', 'Rational(Integer(abs(offset)))', 'measure'),

    # The push of stored numbers, and other roundings that must go outward.
    (PUSH, 'src/stored/stored_planes.cpp', 'Rational(-support(n)), Rounding::Down);', 'Rational(-support(n)), Rounding::Nearest);', _STORED),
    (PUSH, 'src/stored/stored_planes.cpp', 'const double d = round_to(precision, Rational(-support(n)), Rounding::Down);',
     'const double d = std::nextafter(round_to(precision, Rational(-support(n)), Rounding::Down), 1e308);', _STORED),
    (PUSH, 'src/stored/stored_planes.cpp', 'rounding = Rounding::Up;', 'rounding = Rounding::Down;', _STORED),
    (PUSH, 'src/stored/stored_mesh.cpp', 'mesh.points = subset(rung.points, rung.hull.vertices);',
     '''mesh.points = subset(rung.points, rung.hull.vertices);
  std::vector<Point> pulled(mesh.points.doubles().begin(), mesh.points.doubles().end());
  for (Point& p : pulled) p[0] = std::nextafter(p[0], 0.0);
  mesh.points = PointSet(pulled);''', _STORED),
    (PUSH, 'src/stored/growth.cpp', 'return std::nextafter(root, std::numeric_limits<double>::infinity());', 'return root;', _STORED),
    (PUSH, 'src/stored/growth.cpp', 'to_double(x, Rounding::Up)', 'to_double(x, Rounding::Down)', _STORED),
    (PUSH, 'src/stored/growth.cpp', ').high_double()', ').low_double()', _STORED),
    (PUSH, 'src/number/rounding.cpp', ': away && rest != 0;', ': away && twice >= scaled.r;', 'number'),
    (PUSH, 'src/number/enclosure.cpp', 'mpfr_add(high_.data(), high_.data(), other.high_.data(), MPFR_RNDU);',
     'mpfr_add(high_.data(), high_.data(), other.high_.data(), MPFR_RNDN);', 'number'),
    (PUSH, 'src/number/enclosure.cpp', 'mpfr_sqrt(result.high_.data(), x.high_.data(), MPFR_RNDU)',
     'mpfr_sqrt(result.high_.data(), x.high_.data(), MPFR_RNDN)', 'number'),
    (PUSH, _FAST + 'ties.cpp', 'return {next_below(lower), next_above(upper)};', 'return {lower, upper};', _AGREE),
    (PUSH, _FAST + 'filtered_loop.cpp', 'next_above(upper_[i.index()] / 6)', 'upper_[i.index()] / 6', _AGREE),

    # Verifications.
    *[(SKIP, 'src/simplify/step_verification.cpp', f'  state_->check_{what}(step);\n', '', 'simplify')
      for what in ('ring', 'cap')],
    (SKIP, 'src/simplify/step_verification.cpp', '  state_->check_rim(step, disk);\n', '', 'simplify'),
    (SKIP, 'src/simplify/step_verification.cpp', 'whole.is_certified(state_->surface, state_->present)', 'true', 'simplify'),
    (SKIP, 'src/simplify/step_verification.cpp', 'whole.volume_grew_by(step.cost.value().rational(), state_->surface)', 'true', 'simplify'),
    (SKIP, 'src/simplify/step_verification.cpp', 'state_->whole->volume_is_sum_of_costs(state_->surface)', 'true', 'simplify'),
    (SKIP, 'src/simplify/exact_engine.cpp', '    verification.check(step);\n', '', 'simplify'),
    (SKIP, 'src/simplify/exact_engine.cpp', '  verification.finish();\n', '', 'simplify'),
    *[(SKIP, _FAST + 'checks.cpp', f'  check_{what}(step);\n', '', 'fast') for what in ('disk', 'triangles', 'rim')],
    (SKIP, _FAST + 'filtered_loop.cpp', 'if (options_.verify != VerifyLevel::None) verify(*choice);', '', _AGREE),
    (SKIP, 'src/stored/acceptance.cpp', 'if (violations > 0)', 'if (false)', _STORED),
    (SKIP, 'src/stored/stored_mesh.cpp', 'if (count_outside(halfspaces, witnesses) > 0) return {};', '', _STORED),
    (SKIP, 'src/stored/stored_planes.cpp', 'while (const auto ray = escape_ray(normals))', 'while (const auto ray = std::optional<RationalVector3>())', _STORED),
    (SKIP, 'src/scene/simplify.cpp', 'if (outside != 0)', 'if (false)', 'scene'),
    (SKIP, 'src/scene/simplify.cpp', 'engine == Engine::Float && !is_dual_hull(dual, result.triangles)', 'false', 'fast scene'),
    (SKIP, 'src/hull/check_hull.cpp', ' && one_ray_meets_one_triangle()', '', 'hull'),
    (SKIP, 'src/hull/check_hull.cpp', 'the_rest_is_inside() && ', '', 'hull'),
    (SKIP, 'src/lp/halfspace_certificates.cpp', 'if (!are_positive(halfspaces, claim.multipliers)) return false;', '', 'lp'),
    (SKIP, 'src/oracle/judge_containment.cpp', 'if (reaches_out != is_outside)', 'if (false)', 'oracle'),
    (SKIP, 'src/oracle/removal_cost.cpp', 'if (!confirmed)', 'if (false)', 'oracle'),
    (SKIP, 'src/check/convexact_check.cpp', 'require_one_cover(read_vertices());', 'read_vertices();', 'check check_mutated'),
    (SKIP, 'src/check/convexact_check.cpp', '    for (const std::size_t i : left_) require_points_inside(planes_[i]);\n', '', 'check check_mutated'),
    (SKIP, 'src/check/convexact_check.cpp', '      require_points_inside(stored.back());\n', '', 'check check_mutated'),

    # Ends of costs that no longer hold.
    (STALE, _FAST + 'filtered_loop.cpp', '    stale_[r.index()] = true;\n', '', _AGREE),
    (STALE, _FAST + 'filtered_loop.cpp', '    ties_.forget(r);\n', '', _AGREE),
    (STALE, _FAST + 'filtered_loop.cpp', 'if (!refresh_candidates()) continue;', '', _AGREE),
    (STALE, _FAST + 'filtered_loop.cpp', 'if (stale_[top.index()]) {', 'if (false) {', _AGREE),
    (STALE, _FAST + 'filtered_loop.cpp', '  upper_[i.index()] = upper;\n', '  if (upper < upper_[i.index()] || upper_[i.index()] == 0) upper_[i.index()] = upper;\n', _AGREE),
    (STALE, _FAST + 'filtered_loop.cpp', '  cap_.invalidate();\n', '', _AGREE),
    (STALE, _FAST + 'filtered_loop.cpp', 'if (queue_.contains(i) && stale_[i.index()]) evaluate(i);', '', 'oracle'),
    (STALE, _FAST + 'float_loop.hpp', '    state_[r.index()] |= kStale;\n', '', 'fast'),
    (STALE, _FAST + 'float_loop.hpp', 'queue_.update(r, lower_[r.index()]);', '', 'fast fast_float_sample'),
    (STALE, _FAST + 'keyed_queue.hpp', 'if (hole < heap_.size()) settle(hole, last);', 'if (hole < heap_.size()) put(hole, last);', _AGREE),
    (STALE, 'src/simplify/exact_engine.cpp', '  for (const HalfspaceId j : removal.ring) evaluate(j);\n', '', 'simplify'),
    (STALE, 'src/simplify/dual_surface.cpp', '    if (height_above < 0) continue;', '    if (height_above <= 0) continue;', 'simplify'),
    (STALE, 'src/simplify/dual_surface.cpp', '      is_present_[j.index()] = false;\n      --left_;\n', '', 'simplify'),
    (STALE, 'src/simplify/exact_engine.cpp', '  if (removal.cost) queue_.erase({*removal.cost, i});\n', '', 'simplify'),
    (STALE, _FAST + 'filtered_loop.hpp', 'next_above(grown_.upper + cost.upper)', 'next_above(cost.upper)', 'fast_agreement_sample'),
    (STALE, 'src/check/convexact_check.cpp', '      removals_[a].fresh = false;\n', '', 'check check_mutated'),
    (STALE, 'src/check/convexact_check.cpp', 'require(removals_[j].fresh,', 'require(true,', 'check check_mutated'),
]
