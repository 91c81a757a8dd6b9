#pragma once

#include <QSize>

namespace ui {

/// How large a window is the first time.
struct FirstSize {
    QSize size;                ///< without its frame; of a maximised one, what it goes back to
    bool isMaximised = false;  ///< the screen is too small for it
    bool operator==(const FirstSize&) const = default;
};

/// The size that is wanted if the window and its frame, which window managers draw around it, have room in what a
/// screen leaves to windows.
[[nodiscard]] inline FirstSize firstSize(QSize wanted, QSize available) {
    constexpr QSize kFrame(16, 48);  // a title bar is 20 to 40 pixels high
    const QSize room = available - kFrame;
    const bool hasRoom = wanted.width() <= room.width() && wanted.height() <= room.height();
    return {wanted.boundedTo(hasRoom ? wanted : room * 0.9), !hasRoom};
}

}  // namespace ui
