#pragma once

#include <QColor>

#include "model/board/diagnostics.h"

namespace ui {

/// The swatch beside a message: mid tones, readable on a light and on a dark ground.
[[nodiscard]] inline QColor severityColour(model::Severity severity) {
    constexpr QColor kColours[] = {{0x56, 0x8c, 0xc8}, {0xe0, 0x9a, 0x1f}, {0xd9, 0x4a, 0x3d}};
    return kColours[static_cast<std::size_t>(severity)];
}

}  // namespace ui
