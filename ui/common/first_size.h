#pragma once

#include <QScreen>
#include <QSize>
#include <QWidget>

namespace ui {

/// What a screen leaves to a window inside its frame, which window managers draw around it.
[[nodiscard]] inline QSize roomForWindow(QSize available) {
    constexpr QSize kFrame(16, 48);  // a title bar is 20 to 40 pixels high
    return available - kFrame;
}

/// How large the main window is the first time.
struct FirstSize {
    QSize size;                ///< without its frame; of a maximised one, what it goes back to
    bool isMaximised = false;  ///< the screen is too small for it
    bool operator==(const FirstSize&) const = default;
};

/// The size that is wanted if the window and its frame have room in what a screen leaves to windows.
[[nodiscard]] inline FirstSize firstSize(QSize wanted, QSize available) {
    const QSize room = roomForWindow(available);
    const bool hasRoom = wanted.width() <= room.width() && wanted.height() <= room.height();
    return {wanted.boundedTo(hasRoom ? wanted : room * 0.9), !hasRoom};
}

/// Opens a dialog as large as is wanted, but not beyond the screen, where its buttons could not be reached.
inline void resizeToScreen(QWidget& dialog, QSize wanted) {
    dialog.resize(wanted.boundedTo(roomForWindow(dialog.screen()->availableSize())));
}

}  // namespace ui
