// SPDX-License-Identifier: MIT
// picture_frame.hpp - the places that the shapes of a picture get on its page.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "number/arithmetic.hpp"
#include "pages/picture.hpp"

namespace convexact {

/// Maps the scene's bounding box into the cube [-1, 1]^3. The power of two keeps huge coordinates
/// from overflowing and subnormal ones from vanishing.
class PictureFrame {
 public:
  explicit PictureFrame(const std::vector<PictureLayer>& layers) {
    double largest = 0;
    for (const PictureLayer& layer : layers) {
      for (const Point& p : layer.points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
    }
    exponent_ = exponent_of(largest);
    Point low = Point::Constant(1), high = -low;
    for (const PictureLayer& layer : layers) {
      for (const Point& p : layer.points) {
        low = low.cwiseMin(scaled(p));
        high = high.cwiseMax(scaled(p));
      }
    }
    if (largest > 0) center_ = (low + high) / 2;
    const double size = (high - low).maxCoeff();
    if (size > 0) half_size_ = size / 2;
  }
  Point operator()(const Point& p) const { return (scaled(p) - center_) / half_size_; }
  Point length(const Point& v) const { return scaled(v) / half_size_; }

 private:
  Point scaled(const Point& p) const {
    return p.unaryExpr([this](double x) { return std::ldexp(x, -exponent_); });
  }

  int exponent_ = 0;
  Point center_ = Point::Zero();
  double half_size_ = 1;
};

}  // namespace convexact
