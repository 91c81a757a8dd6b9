#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "model/base/result.h"
#include "model/opening/open_board.h"

/// How fast the window answers the hand. Free of Qt, for the command line.
namespace ui {

/// What is measured, on which canvas.
struct InteractionRequest {
    model::OpenRequest board;
    int width = 1920;  ///< of the canvas of either view, pixels
    int height = 1080;
    int frames = 60;       ///< per movement of the camera; changes of the picture (highlight, layers) take a quarter
    std::string pictures;  ///< a folder that gets a PNG of every frame, and of every view at rest; empty: none
};

/// One kind of movement in one view. A frame lasts from the event of mouse or keyboard, or the change, until the
/// canvas shows what came of it; where that is nothing but the overlay (hovering), until that is shown.
struct InteractionRun {
    std::string view;               ///< "2D", "3D"
    std::string name;               ///< "pan", "zoom", "orbit", "hover", "highlight", "layers"
    std::vector<double> frameMs;    ///< in the order in which they came
    double seconds = 0.0;           ///< of all of them
    double processorSeconds = 0.0;  ///< likewise, of all threads: on a busy machine it tells more than the clock
    double longestStallMs = 0.0;    ///< the longest time in which the window could not have answered

    /// The least time within which a share of the frames (0 to 1) came, ms.
    [[nodiscard]] double percentile(double share) const {
        std::vector<double> sorted = frameMs;
        std::ranges::sort(sorted);
        const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
        return sorted.empty() ? 0.0 : sorted[std::clamp<std::size_t>(rank, 1, sorted.size()) - 1];
    }
    [[nodiscard]] double framesPerSecond() const { return static_cast<double>(frameMs.size()) / seconds; }
    [[nodiscard]] double processorMs() const { return processorSeconds * 1e3 / static_cast<double>(frameMs.size()); }
};

struct InteractionReport {
    std::string device;
    /// From the model being ready to the first picture in the 2D view, and to the first that shows all of the board.
    double firstFrameMs = 0.0;
    double firstWholeMs = 0.0;
    std::vector<InteractionRun> runs;
};

/// Opens the board in a window without a display (or on the one that QT_QPA_PLATFORM names) and moves it as hands do,
/// through the events that canvases get. No session of the board is read or written. Makes a
/// QApplication, so there must be none. Errors: those of opening; BadUsage if the window cannot have canvases of that
/// size; DeviceFailed if a view gets no frame for a minute; OutputFailed if a picture cannot be written.
[[nodiscard]] base::Result<InteractionReport> measureInteraction(const InteractionRequest& request);

}  // namespace ui
