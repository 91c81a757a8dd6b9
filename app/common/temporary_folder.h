#pragma once

#include <filesystem>

#include "model/base/result.h"

namespace app {

/// A folder of our own in the folder for temporary files. It goes with all that is in it when this does.
class TemporaryFolder {
public:
    /// Errors: OutputFailed where there is no folder for temporary files (TMPDIR), or none can be made in it.
    [[nodiscard]] static base::Result<TemporaryFolder> make();
    ~TemporaryFolder();
    TemporaryFolder(TemporaryFolder&& other) noexcept;
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return m_path; }

private:
    explicit TemporaryFolder(std::filesystem::path path) : m_path(std::move(path)) {}

    std::filesystem::path m_path;  ///< empty where another one has taken it over
};

}  // namespace app
