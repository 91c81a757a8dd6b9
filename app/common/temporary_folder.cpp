#include "app/common/temporary_folder.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>

namespace app {

namespace fs = std::filesystem;

base::Result<TemporaryFolder> TemporaryFolder::make() {
    std::error_code error;
    const fs::path parent = fs::temp_directory_path(error);
    if (error) {
        return base::Error{base::ErrorCode::OutputFailed,
                           "there is no folder for temporary files (TMPDIR): " + error.message()};
    }
    std::string path = (parent / "copperscope-XXXXXX").string();
    if (::mkdtemp(path.data()) == nullptr) {
        return base::Error{base::ErrorCode::OutputFailed,
                           "no folder can be made in " + parent.string() + ": " + std::strerror(errno)};
    }
    return TemporaryFolder(path);
}

TemporaryFolder::~TemporaryFolder() {
    if (!m_path.empty()) {
        std::error_code error;
        fs::remove_all(m_path, error);
    }
}

TemporaryFolder::TemporaryFolder(TemporaryFolder&& other) noexcept : m_path(std::exchange(other.m_path, {})) {}

}  // namespace app
