#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "model/base/result.h"
#include "render/gpu/pipeline_cache_file.h"
#include "render/scene/view_settings.h"

namespace render {

namespace gpu {
struct Caps;
}

/// The back ends that were measured to draw tilted views of a large board fastest on a device
/// (render/calibration/calibrate.h). Auto: nothing is known, and the rules of backend_choice.cpp decide.
struct MeasuredBackends {
    Backend plain = Backend::Auto;     ///< one sample per pixel
    Backend smoothed = Backend::Auto;  ///< several

    [[nodiscard]] Backend of(bool isSmoothed) const { return isSmoothed ? smoothed : plain; }
    bool operator==(const MeasuredBackends&) const = default;
};

/// Those there are for tilted views, on whatever device; Raster cannot smooth.
[[nodiscard]] std::span<const Backend> tiltedBackends(bool isSmoothed);

/// A few lines that people can read: version, device and driver, a line per answer.
[[nodiscard]] std::string measuredText(const MeasuredBackends& measured, const gpu::PipelineCacheOwner& owner);
/// None for all but what `measuredText` writes for this owner: it is damaged, or of another device, driver or version.
[[nodiscard]] std::optional<MeasuredBackends> parseMeasured(std::string_view text,
                                                            const gpu::PipelineCacheOwner& owner);

/// The text as a file beside the compiled pipelines: one per device and driver, which a new version of the driver takes
/// over. Whatever is wrong with it, nothing was measured.
class MeasuredBackendsFile {
public:
    /// Without a folder nothing is read, and nothing can be written.
    MeasuredBackendsFile(const std::filesystem::path& folder, const gpu::PipelineCacheOwner& owner);

    [[nodiscard]] std::optional<MeasuredBackends> load() const;
    /// Replaces the file, all of it or nothing, and makes the folder. Errors: OutputFailed.
    [[nodiscard]] base::Status save(const MeasuredBackends& measured) const;
    /// As if nothing had been measured.
    void remove() const;

    [[nodiscard]] const std::filesystem::path& path() const { return m_path; }

private:
    std::filesystem::path m_path;
    gpu::PipelineCacheOwner m_owner;
};

/// What is known of a device of this user (gpu::pipelineCacheFolder).
[[nodiscard]] MeasuredBackends measuredBackends(const gpu::Caps& caps);

}  // namespace render
