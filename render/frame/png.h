#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "model/base/result.h"
#include "render/scene/view_settings.h"

namespace render {

/// A picture that is packed row by row.
struct PngRows {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    bool hasAlpha = false;
    /// RGB, or RGBA, a byte each, of a row from the top; counts until the next call.
    std::function<const std::uint8_t*(std::uint32_t row)> row;
};

/// Packs a picture as PNG. `write` takes piece by piece and says whether to go on; it is not called again once it said
/// no. Errors: OutputFailed, Cancelled where `write` ended it.
[[nodiscard]] base::Status packPng(const PngRows& rows, const std::function<bool(std::string_view)>& write);

/// A PNG in memory. Errors: OutputFailed.
[[nodiscard]] base::Result<std::string> encodePng(const Image& image);

}  // namespace render
