#include "model/session/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <thread>

namespace model::session {

namespace {

/// Writing a session takes milliseconds.
constexpr int kLockTries = 1000;
constexpr std::chrono::milliseconds kLockPause{2};

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder)
    : m_folder(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    m_isHeld = m_folder < 0 || take();
    for (int i = 0; i < kLockTries && !m_isHeld; ++i) {
        std::this_thread::sleep_for(kLockPause);
        m_isHeld = take();
    }
}

FolderLock::~FolderLock() {
    if (m_folder >= 0) {
        ::close(m_folder);
    }
}

bool FolderLock::take() const {
    return ::flock(m_folder, LOCK_EX | LOCK_NB) == 0 || (errno != EWOULDBLOCK && errno != EINTR);
}

}  // namespace model::session
