#pragma once

#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <utility>

#include "model/base/result.h"
#include "ui/workspace/background.h"

namespace ui {

/// A question that is worked out in the background, one at a time, and its answer.
template <class T>
class BackgroundResult {
public:
    /// Runs on a thread of its own.
    using Work = std::function<base::Result<T>(base::Progress&)>;

    /// Its `finished` says that there is an answer to take.
    [[nodiscard]] const Background& background() const { return m_background; }
    [[nodiscard]] bool isRunning() const { return m_background.isRunning(); }

    /// Cancels what is being worked out. `phase` is shown until the work names one. Where memory runs out, `lack` is
    /// the answer: a huge board must not take down the window.
    void ask(Work work, const char* phase, const char* shortage) {
        m_result = std::make_shared<Slot>();
        m_background.start(
            [work = std::move(work), slot = m_result, shortage](base::Progress& progress) {
                try {
                    *slot = work(progress);
                } catch (const std::bad_alloc&) {
                    *slot = base::Error{base::ErrorCode::BadInput, shortage};
                }
            },
            phase);
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
