#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/generate/layout.h"
#include "render/backends/measured_backends.h"
#include "render/modelling/board_frame.h"
#include "render/scene/camera.h"

namespace render {

namespace gpu {
class Device;
}

/// What a device is measured with. The board is as large as t8 of the paper, because back ends differ where frames take
/// long: what is fastest on a small board saves nothing that could be seen.
struct Trial {
    model::generate::Wanted board{model::generate::findPaperModel("t8")->counts, 15};
    std::uint32_t width = 1280;  ///< of pictures, in pixels
    std::uint32_t height = 800;
    int rounds = 5;           ///< of all candidates in turn
    double warmUpMs = 300.0;  ///< until a card that was idle runs at full speed
};

/// How long a back end takes for the whole board and for a fifth of its width, both tilted.
struct CandidateTime {
    Backend backend = Backend::Auto;
    bool isSmoothed = false;
    double ms = 0.0;       ///< of the device by timestamps, or else until the picture is there: medians, added up
    bool isTaken = false;  ///< by Auto from now on
};

struct Calibration {
    std::vector<CandidateTime> times;  ///< unsmoothed ones first
    MeasuredBackends fastest;
};

/// The view that frames are measured in: from a corner, so much closer than where all of the board is seen.
[[nodiscard]] Camera tiltedCamera(const BoardFrame& board, float zoom, float aspect);

/// Draws a made-up board with each back end in turn. The rules for devices that were not measured have the benefit of
/// the doubt: another back end is taken where it takes at least 15 % less time than theirs. Asks between frames whether
/// it is cancelled. Errors: DeviceFailed (one of the back ends cannot draw the board), Cancelled.
[[nodiscard]] base::Result<Calibration> calibrate(gpu::Device& device, const Trial& trial, base::Progress& progress);

/// Which of them is taken: `usual` (which is one of them) or the fastest, by the above.
[[nodiscard]] Backend fastestOf(std::span<const CandidateTime> times, Backend usual);

/// For a window whose device is this owner's: measures another one of the same card, opened for this alone, and saves
/// what came out. Does nothing where `file` holds an answer. The answer that nothing is known is saved first, and stays
/// where measuring fails: a driver that does not survive it is not tried again. Cancelled, it leaves no file. Errors:
/// those of `calibrate`; OutputFailed, and then nothing is measured.
[[nodiscard]] base::Status calibrateOnce(const MeasuredBackendsFile& file, const gpu::PipelineCacheOwner& owner,
                                         const Trial& trial, base::Progress& progress);

}  // namespace render
