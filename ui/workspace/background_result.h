#pragma once

#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <utility>

#include "model/base/result.h"
#include "ui/workspace/background.h"

namespace ui {

/// Something that is worked out in the background, one at a time, and its result.
template <class T>
class BackgroundResult {
public:
    /// Runs on a thread of its own.
    using Work = std::function<base::Result<T>(base::Progress&)>;

    /// Its `finished` says that there is a result to take.
    [[nodiscard]] Background& background() { return m_background; }
    [[nodiscard]] bool isRunning() const { return m_background.isRunning(); }

    /// Cancels what is being worked out. `phase` is shown until the work names one. Out of memory is an error with the
    /// text `outOfMemory`: a huge board must not take down the window.
    void run(Work work, const QString& phase, const QString& outOfMemory) {
        m_result = std::make_shared<Slot>();
        m_background.start(
            [work = std::move(work), slot = m_result, text = outOfMemory.toStdString()](base::Progress& progress) {
                try {
                    *slot = work(progress);
                } catch (const std::bad_alloc&) {
                    *slot = base::Error{base::ErrorCode::BadInput, text};
                }
            },
            phase.toUtf8().constData());
    }
    /// Nothing is heard of it after this.
    void cancel() { m_background.cancel(); }
    /// Once, after it has finished.
    [[nodiscard]] base::Result<T> take() { return std::move(**std::exchange(m_result, nullptr)); }

private:
    using Slot = std::optional<base::Result<T>>;

    Background m_background;
    std::shared_ptr<Slot> m_result;  ///< of the work under way; written by its thread
};

}  // namespace ui
