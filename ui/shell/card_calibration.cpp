#include "ui/shell/card_calibration.h"

#include <QTimer>
#include <new>

#include "model/base/background.h"

namespace ui {
namespace {

/// Failures leave the rules in force, so nobody is bothered with them.
void measure(const render::MeasuredBackendsFile& file, const render::gpu::PipelineCacheOwner& owner,
             const render::Trial& trial, base::Progress& progress) {
    base::becomeBackground();
    try {
        static_cast<void>(render::calibrateOnce(file, owner, trial, progress));
    } catch (const std::bad_alloc&) {  // the window needs it more
    }
}

}  // namespace

CardCalibration::CardCalibration(const render::gpu::Caps& caps, const std::filesystem::path& folder,
                                 const render::Trial& trial, int delayMs) {
    const render::MeasuredBackendsFile file(folder, caps.cacheOwner);
    if (caps.isCpu || folder.empty() || file.load()) {
        return;
    }
    connect(&m_background, &Background::finished, this, &CardCalibration::finished);
    QTimer::singleShot(delayMs, this, [this, file, owner = caps.cacheOwner, trial] {
        m_background.start([=](base::Progress& progress) { measure(file, owner, trial, progress); }, "Measuring");
    });
}

}  // namespace ui
