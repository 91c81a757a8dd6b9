#pragma once

#include "render/calibration/calibrate.h"
#include "render/gpu/device.h"
#include "ui/workspace/background.h"

namespace ui {

/// Measures once what draws fastest on the graphics card of the window, for its next start (decision 214): a few
/// seconds after the window, in the background, on a device of its own, without a word. Destroyed, it cancels: that
/// waits for the frame being drawn, or the pipelines being compiled.
class CardCalibration : public QObject {
    Q_OBJECT

public:
    /// `caps` are of the device that the window draws with; software devices are not measured.
    explicit CardCalibration(const render::gpu::Caps& caps,
                             const std::filesystem::path& folder = render::gpu::pipelineCacheFolder(),
                             const render::Trial& trial = {}, int delayMs = kDelayMs);

signals:
    /// Measuring is over, whatever came of it.
    void finished();

private:
    static constexpr int kDelayMs = 5000;  ///< the first board is on the screen by then

    Background m_background;
};

}  // namespace ui
