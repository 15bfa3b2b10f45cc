// SPDX-License-Identifier: MIT
// static_drawing.hpp - a picture as a drawing that needs no script: for print, and for browsers
// without WebGL 2.
#pragma once
#include <string>

#include "pages/picture.hpp"
#include "pages/picture_frame.hpp"

namespace convexact {

/// An <svg> of the layers that are shown at first, in the first view of the page.
[[nodiscard]] std::string static_drawing(const Picture& picture, const PictureFrame& frame);

}  // namespace convexact
