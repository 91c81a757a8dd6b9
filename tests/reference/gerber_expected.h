#pragma once

#include <functional>
#include <string_view>

#include "tests/reference/raster.h"

namespace reference {

/// A file of tests/data/gerber-conformance whose picture is not what the Gerber Layer Format Specification (revision
/// 2022.02) says, and what that says, shape by shape.
struct ExpectedPicture {
    const char* file;
    const char* paragraph;  ///< of the specification, and what the picture has instead
    std::function<void(Raster&)> paint;
    /// Covers what the specification leaves open: what invalid objects draw.
    std::function<void(Raster&)> paintOpen = {};
};

/// Nullptr for files whose picture is right.
[[nodiscard]] const ExpectedPicture* expectedPicture(std::string_view file);

}  // namespace reference
