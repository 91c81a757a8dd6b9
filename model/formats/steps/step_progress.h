#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>

#include "model/base/progress.h"

namespace model::formats {

/// How far all steps of a job together are; the steps are built side by side.
class StepProgress {
public:
    /// `layers` of all steps.
    StepProgress(base::Progress& progress, std::size_t layers) : m_progress(progress), m_layers(layers) {}

    void layerDone() {
        m_progress.setFraction(static_cast<float>(++m_done) / static_cast<float>(std::max<std::size_t>(m_layers, 1)));
    }
    [[nodiscard]] bool isCancelled() const { return m_progress.isCancelled(); }
    [[nodiscard]] const base::Progress& inner() const { return m_progress; }

private:
    base::Progress& m_progress;
    std::size_t m_layers;
    std::atomic<std::size_t> m_done{0};
};

}  // namespace model::formats
