#pragma once

#include <filesystem>

namespace model::session {

/// While it lives, no other program changes a session in this folder: reading a file, changing a part and writing it
/// again must not mix with the same of others. The folder is locked, because files in it are replaced. A file system
/// without locks is taken as one without other programs. Waits for two seconds at most.
class FolderLock {
public:
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    /// False: somebody keeps it for longer than writing a session takes.
    [[nodiscard]] bool isHeld() const { return m_isHeld; }

private:
    [[nodiscard]] bool take() const;

    int m_folder;
    bool m_isHeld = false;
};

}  // namespace model::session
