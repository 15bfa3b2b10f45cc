// SPDX-License-Identifier: MIT
// Dual points in doubles: from the corners of facets where that is certain, otherwise from exact
// planes.
#include "fast/dual.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "fast/congruence.hpp"
#include "fast/mesh.hpp"
#include "fast/signs.hpp"
#include "number/arithmetic.hpp"
#include "task/lazy.hpp"

namespace convexact {

// Exact planes: those of a solid as they stand, or formed from corners when first asked for.
struct FastDual::Planes {
  const DualHull* dual = nullptr;
  const Hull* hull = nullptr;
  const PointSet* points = nullptr;
  std::vector<Lazy<std::unique_ptr<const Halfspace>>> formed;

  std::array<PointId, 3> corners(std::size_t i) const {
    const auto all = hull->facets[i];
    return {all[0], all[all.size() / 3], all[2 * all.size() / 3]};
  }
  const Halfspace& operator[](std::size_t i) const {
    if (dual != nullptr) return dual->halfspaces[i];
    return *formed[i].get([&] { return form(i); });
  }
  std::unique_ptr<const Halfspace> form(std::size_t i) const {
    const auto [a, b, c] = corners(i);
    const auto exact = [&](PointId id) { return points->doubles()[id.index()]; };
    return std::make_unique<const Halfspace>(
        points->is_binary() ? Halfspace::through(exact(a), exact(b), exact(c))
                            : Halfspace::through((*points)[a], (*points)[b], (*points)[c]));
  }
};

FastDual::FastDual() : planes_(std::make_unique<Planes>()) {}
FastDual::FastDual(FastDual&&) noexcept = default;
FastDual::~FastDual() = default;

const Halfspace& FastDual::exact(HalfspaceId i) const { return (*planes_)[i.index()]; }

std::span<const PointId> FastDual::corners(HalfspaceId i) const {
  const bool is_of_doubles = planes_->points != nullptr && planes_->points->is_binary();
  return is_of_doubles ? planes_->hull->facets[i.index()] : std::span<const PointId>();
}

const Point& FastDual::point(PointId corner) const {
  return planes_->points->doubles()[corner.index()];
}

// Areas have one factor |P|, mean widths two, and P in the caller's frame is 2^-least as large as
// in_callers_frame(), least being the lowest exponent of the frame.
long FastDual::cost_exponent(CostMeasure measure) const {
  const long least = *std::min_element(frame_.begin(), frame_.end());
  return volume_exponent() - static_cast<long>(measure) * least;
}

std::size_t FastDual::formed() const {
  const auto& formed = planes_->formed;
  return static_cast<std::size_t>(
      std::count_if(formed.begin(), formed.end(), [](const auto& each) { return each.is_made(); }));
}

bool FastDual::precedes(HalfspaceId i, HalfspaceId j) const {
  if (planes_->dual != nullptr) return i < j;
  // The sign of a normal's first entry is that of the dual point's, unless that is zero.
  const double a = near(i).x, b = near(j).x;
  if ((a < 0 && b > 0) || (a > 0 && b < 0)) return a < b;
  const std::optional<bool> is_first = precedes_image(*this, i, j);
  return is_first ? *is_first : exact(i) < exact(j);
}

std::array<double, 3> FastDual::direction(HalfspaceId i) const {
  std::array<double, 3> n{near(i).x * axis_weight_[0], near(i).y * axis_weight_[1],
                          near(i).z * axis_weight_[2]};
  const double largest = std::max({std::abs(n[0]), std::abs(n[1]), std::abs(n[2])});
  if (!(largest >= std::numeric_limits<double>::min())) return {0, 0, 0};
  for (double& x : n) x /= largest;
  return n;
}

std::array<double, 3> FastDual::normal_sizes(HalfspaceId i) const {
  std::array<double, 3> sizes = direction(i);
  for (double& x : sizes) x = std::abs(x);
  std::sort(sizes.begin(), sizes.end());
  return sizes;
}

bool FastDual::seem_congruent(HalfspaceId i, HalfspaceId j) const {
  const std::array<double, 3> a = normal_sizes(i), b = normal_sizes(j);
  return std::equal(a.begin(), a.end(), b.begin(),
                    [](double x, double y) { return std::abs(x - y) <= kEqualSizes; });
}

bool FastDual::seems_to_precede(HalfspaceId i, HalfspaceId j) const {
  if (planes_->dual != nullptr) return i < j;
  const std::array<double, 3> a = direction(i), b = direction(j);
  const bool is_by_direction = seem_congruent(i, j);
  for (int k = 0; k < 3 && is_by_direction; ++k) {
    if (std::abs(a[k] - b[k]) > kEqualSizes) return a[k] < b[k];
  }
  return precedes(i, j);
}

namespace {

using Long = Triple<DoubleDouble>;

// x = mantissa * 2^exponent, |mantissa| in [1/2, 1); a large negative exponent for zero.
int exponent_or_lowest(double x) { return x == 0 ? -1100 : exponent_of(x); }

// 2^exponent in two halves, as it may not be a double itself. A product with it is exact where the
// result is a normal number, because everything between x and the result is in range as well.
struct PowerOfTwo {
  double first, second;

  explicit PowerOfTwo(int exponent)
      : first(std::ldexp(1.0, exponent / 2)), second(std::ldexp(1.0, exponent - exponent / 2)) {}
  double times(double x) const { return x * first * second; }
};

DoubleDouble to_long(const Rational& x) {
  const double hi = to_double(x, Rounding::Nearest);
  return {hi, to_double(Rational(x - to_rational(hi)), Rounding::Nearest)};
}

// Numbers known to a relative error of about this are used as they are; otherwise rationals decide.
constexpr double kCertain = 0x1p-88;
bool is_certain(const DoubleDouble& value, double error) {
  return error <= kCertain * std::abs(value.hi());
}

}  // namespace

class FastDualBuilder {
 public:
  explicit FastDualBuilder(FastDual& dual) : dual_(dual) {}

  // (1) A frame in which the solid has about unit size on each axis. If the scaling by a power of
  //     two changes some coordinate, only exact numbers can be used.
  void scale(const Hull& hull, const PointSet& points);
  // (2) The mean of the extreme points, as rounded: any interior point serves.
  void choose_center(const Hull& hull);
  // (3) Dual points; false if the center is not strictly inside.
  bool add_all_from_corners();
  bool add_all_from_planes();
  // (4) Each axis to unit size.
  void normalise();
  // (5) Which planes share a vertex, read off the flat edges of the dual.
  void merge_flat_edges();

 private:
  bool add_from_corners(std::size_t i);
  bool add_from_plane(std::size_t i);
  bool is_finite() const;

  std::array<int, 3> exponent_{0, 0, 0};  // caller's length = scaled length * 2^exponent
  std::vector<Point> scaled_;             // by PointId; empty if only exact numbers can be used
  Long center_;                           // in scaled lengths, exactly dual_.center_
  FastDual& dual_;
};

void FastDualBuilder::scale(const Hull& hull, const PointSet& points) {
  Point low = points.doubles()[hull.vertices[0].index()], high = low;
  for (const PointId v : hull.vertices) {
    low = low.cwiseMin(points.doubles()[v.index()]);
    high = high.cwiseMax(points.doubles()[v.index()]);
  }
  for (int k = 0; k < 3; ++k) exponent_[k] = exponent_or_lowest(high[k] / 2 - low[k] / 2) + 1;
  if (!points.is_binary()) return;
  scaled_.resize(points.size());
  const std::array<PowerOfTwo, 3> factor{PowerOfTwo(-exponent_[0]), PowerOfTwo(-exponent_[1]),
                                         PowerOfTwo(-exponent_[2])};
  for (const PointId v : hull.vertices) {
    for (int k = 0; k < 3; ++k) {
      const double x = points.doubles()[v.index()][k], y = factor[k].times(x);
      // A coordinate so far from zero, or so close, that products would leave the range is refused.
      const bool fits = x == 0 || (std::abs(y) < 0x1p200 && std::abs(y) > 0x1p-200);
      if (!fits) {
        scaled_.clear();
        return;
      }
      scaled_[v.index()][k] = y;
    }
  }
}

void FastDualBuilder::choose_center(const Hull& hull) {
  if (scaled_.empty()) return;
  Long sum{0.0, 0.0, 0.0};
  for (const PointId v : hull.vertices) {
    const Point& p = scaled_[v.index()];
    sum = {sum.x + p[0], sum.y + p[1], sum.z + p[2]};
  }
  const DoubleDouble n(static_cast<double>(hull.vertices.size()));
  center_ = {sum.x / n, sum.y / n, sum.z / n};
  for (int k = 0; k < 3; ++k) {
    dual_.center_[k] = scale_by_power_of_two(
        Rational(to_rational(center_[k].hi()) + to_rational(center_[k].lo())), exponent_[k]);
  }
}

bool FastDualBuilder::add_from_corners(std::size_t i) {
  // With v = 2^-102, the unit of DoubleDouble: differences of doubles are exact, so a component of
  // n is off by v (|f.y g.z| + |f.z g.y|) from the products and v times its size: 2v m, m that sum.
  // The distance a - c is off by v relative. Each product n.k (a - c).k, its factors included, is
  // off by (2v + v + v) m.k |a - c|.k, two additions by 2v more: w is off by 6v M, M = sum of
  // m.k |a - c|.k. A quotient adds v, so with relative errors of 2^-88 of both: less than 2^-86.
  constexpr double v = DoubleDouble::kUnit;
  // The factors are rounded up enough for m and M being rounded themselves.
  constexpr double kOfNormal = 2, kOfDistance = kOfNormal + 1 + 1 + 2;
  constexpr double kNormalFactor = 3, kDistanceFactor = 8;
  static_assert(kOfNormal < kNormalFactor && kOfDistance + 1 < kDistanceFactor);
  static_assert(kCertain + kCertain + 2 * v < FastDual::kLongError);
  const auto [ia, ib, ic] = dual_.planes_->corners(i);
  const Point &a = scaled_[ia.index()], &b = scaled_[ib.index()], &c = scaled_[ic.index()];
  const auto difference = [](const Point& p, const Point& q) {
    return Long{DoubleDouble::difference(p[0], q[0]), DoubleDouble::difference(p[1], q[1]),
                DoubleDouble::difference(p[2], q[2])};
  };
  const Long f = difference(b, a), g = difference(c, a);
  const Long from_center{DoubleDouble(a[0]) - center_.x, DoubleDouble(a[1]) - center_.y,
                         DoubleDouble(a[2]) - center_.z};
  const Long n = cross(f, g);
  const DoubleDouble w = dot(n, from_center);
  const auto size = [](const DoubleDouble& p, const DoubleDouble& q, const DoubleDouble& r,
                       const DoubleDouble& s) {
    return std::abs(p.hi() * q.hi()) + std::abs(r.hi() * s.hi());
  };
  const Triple<double> m{size(f.y, g.z, f.z, g.y), size(f.z, g.x, f.x, g.z),
                         size(f.x, g.y, f.y, g.x)};
  const double total = m.x * std::abs(from_center.x.hi()) + m.y * std::abs(from_center.y.hi()) +
                       m.z * std::abs(from_center.z.hi());
  constexpr double of_normal = kNormalFactor * v;
  if (w.hi() > 0 && is_certain(w, kDistanceFactor * v * total) &&
      is_certain(n.x, of_normal * m.x) && is_certain(n.y, of_normal * m.y) &&
      is_certain(n.z, of_normal * m.z)) {
    const Long p{n.x / w, n.y / w, n.z / w};
    dual_.near_[i] = {p.x.hi(), p.y.hi(), p.z.hi()};
    dual_.rest_[i] = {p.x.lo(), p.y.lo(), p.z.lo()};
    return true;
  }
  return add_from_plane(i);
}

bool FastDualBuilder::add_from_plane(std::size_t i) {
  const Halfspace& plane = dual_.exact(HalfspaceId(i));
  const Rational w = -plane(dual_.center_);
  if (w <= 0) return false;
  for (int k = 0; k < 3; ++k) {
    const DoubleDouble p =
        to_long(scale_by_power_of_two(Rational(plane.normal()[k]) / w, exponent_[k]));
    dual_.near_[i][k] = p.hi();
    dual_.rest_[i][k] = p.lo();
  }
  return true;
}

bool FastDualBuilder::add_all_from_corners() {
  if (scaled_.empty()) return false;
  for (std::size_t i = 0; i < dual_.size(); ++i) {
    if (!add_from_corners(i)) return false;
  }
  return is_finite();
}

bool FastDualBuilder::add_all_from_planes() {
  // The frame is free, and only the sizes of the results show which one keeps them in range.
  const auto bits = [](const Integer& x) { return static_cast<long>(bit_length(x)); };
  std::array<long, 3> largest;
  largest.fill(std::numeric_limits<long>::min());
  for (std::size_t i = 0; i < dual_.size(); ++i) {
    const Halfspace& plane = dual_.exact(HalfspaceId(i));
    const Rational w = -plane(dual_.center_);
    if (w <= 0) return false;
    for (int k = 0; k < 3; ++k) {
      if (plane.normal()[k] == 0) continue;
      largest[k] =
          std::max(largest[k], bits(plane.normal()[k]) + bits(denominator(w)) - bits(numerator(w)));
    }
  }
  for (int k = 0; k < 3; ++k) exponent_[k] = static_cast<int>(-largest[k]);
  for (std::size_t i = 0; i < dual_.size(); ++i) (void)add_from_plane(i);
  return true;
}

bool FastDualBuilder::is_finite() const {
  return std::all_of(dual_.near_.begin(), dual_.near_.end(), [](const Triple<double>& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  });
}

void FastDualBuilder::normalise() {
  for (int k = 0; k < 3; ++k) {
    double largest = 0;
    for (Triple<double>& p : dual_.near_) largest = std::max(largest, std::abs(p[k]));
    const int down = exponent_or_lowest(largest);
    const PowerOfTwo factor(-down);
    for (std::vector<Triple<double>>* part : {&dual_.near_, &dual_.rest_}) {
      for (Triple<double>& p : *part) p[k] = factor.times(p[k]);
    }
    dual_.frame_[k] = exponent_[k] - down;
  }
  const int least = *std::min_element(dual_.frame_.begin(), dual_.frame_.end());
  for (int k = 0; k < 3; ++k) dual_.axis_weight_[k] = std::ldexp(1.0, least - dual_.frame_[k]);
}

void FastDualBuilder::merge_flat_edges() {
  dual_.incident_start_.assign(dual_.size() + 1, 0);  // nothing is known to be incident yet
  const DualSigns signs(dual_);
  const HalfEdgeMesh mesh(dual_.size(), dual_.triangles_);
  dual_.twins_.resize(3 * dual_.triangles_.size());
  for (std::uint32_t h = 0; h < dual_.twins_.size(); ++h) dual_.twins_[h] = mesh.twin(h);
  // Union-find over triangles: those in one plane are one vertex of the solid.
  std::vector<std::uint32_t> parent(dual_.triangles_.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t t) {
    while (parent[t] != t) t = parent[t] = parent[parent[t]];
    return t;
  };
  std::vector<std::vector<std::uint32_t>> vertices(dual_.size());
  for (std::uint32_t t = 0; t < parent.size(); ++t) {
    const auto [a, b, c] = dual_.triangles_[t];
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
      const std::uint32_t across = mesh.twin(h);
      if (across > h || signs.height(a, b, c, mesh.apex(across)) != Sign::Zero) continue;
      parent[root(t)] = root(across / 3);
    }
  }
  for (std::uint32_t t = 0; t < parent.size(); ++t) {
    for (const HalfspaceId i : dual_.triangles_[t]) vertices[i.index()].push_back(root(t));
  }
  dual_.incident_start_.assign(1, 0);
  for (std::vector<std::uint32_t>& of_plane : vertices) {
    std::sort(of_plane.begin(), of_plane.end());
    const auto last = std::unique(of_plane.begin(), of_plane.end());
    dual_.incident_.insert(dual_.incident_.end(), of_plane.begin(), last);
    dual_.incident_start_.push_back(static_cast<std::uint32_t>(dual_.incident_.size()));
  }
}

FastDual FastDual::of(const Hull& hull, const PointSet& points) {
  FastDual dual;
  dual.planes_->hull = &hull;
  dual.planes_->points = &points;
  dual.planes_->formed = decltype(dual.planes_->formed)(hull.facets.size());
  dual.near_.resize(hull.facets.size());
  dual.rest_.resize(hull.facets.size());
  DualFaces faces = triangulate_dual_faces(hull.facets, points.size());
  dual.triangles_ = std::move(faces.triangles);
  dual.twins_ = std::move(faces.twins);
  dual.incident_.reserve(hull.facets.corner_count());
  dual.incident_start_.reserve(hull.facets.size() + 1);
  dual.incident_start_.push_back(0);
  for (std::size_t f = 0; f < hull.facets.size(); ++f) {
    for (const PointId corner : hull.facets[f]) dual.incident_.push_back(corner.value);
    std::sort(dual.incident_.begin() + dual.incident_start_.back(), dual.incident_.end());
    dual.incident_start_.push_back(static_cast<std::uint32_t>(dual.incident_.size()));
  }

  FastDualBuilder builder(dual);
  builder.scale(hull, points);
  builder.choose_center(hull);
  if (!builder.add_all_from_corners()) {
    // The mean of four points that span a volume is strictly inside, exactly.
    RationalPoint sum = RationalPoint::Zero();
    for (const PointId corner : hull.certificate.simplex) sum += points[corner];
    dual.center_ = sum / Rational(4);
    const bool inside = builder.add_all_from_planes();
    CONVEXACT_ASSERT(inside);
    (void)inside;
  }
  builder.normalise();
  return dual;
}

FastDual FastDual::of(const DualHull& exact, const RationalPoint& center) {
  FastDual dual;
  dual.planes_->dual = &exact;
  dual.center_ = center;
  dual.near_.resize(exact.halfspaces.size());
  dual.rest_.resize(exact.halfspaces.size());
  dual.triangles_ = exact.triangles;
  FastDualBuilder builder(dual);
  if (!builder.add_all_from_planes()) {
    throw Error(ErrorCode::InvalidArgument, "the center is not strictly inside every halfspace");
  }
  builder.normalise();
  builder.merge_flat_edges();
  return dual;
}

}  // namespace convexact
