#include "model/formats/common/folder_files.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

namespace model::formats {

namespace {

namespace fs = std::filesystem;

/// Is `inner` the folder, or does it lie in it? Both without links.
bool holds(const fs::path& folder, const fs::path& inner) {
    return std::mismatch(folder.begin(), folder.end(), inner.begin(), inner.end()).first == folder.end();
}

class FolderWalk {
public:
    FolderWalk(const fs::path& top, std::size_t most, base::Progress& progress, Diagnostics& diagnostics)
        : m_top(top), m_most(most), m_progress(progress), m_diagnostics(diagnostics) {
        std::error_code error;
        m_ownTop = fs::canonical(top, error);
    }
    [[nodiscard]] base::Result<std::vector<FolderFile>> walk();

private:
    [[nodiscard]] bool isOver() const { return m_files.size() > m_most || m_progress.isCancelled(); }
    /// A folder by its own name before all that only links lead to: what lies in it has the paths that the job means.
    [[nodiscard]] fs::path takeNext();
    /// Is the folder not to be read, by this name at least?
    [[nodiscard]] bool isLeftOut(const fs::path& folder);
    /// Takes what lies in the folder itself.
    [[nodiscard]] std::error_code list(const fs::path& folder);
    void take(const fs::directory_entry& entry);
    [[nodiscard]] std::string pathOf(const fs::path& found) const {
        return found.lexically_relative(m_top).generic_string();
    }
    void report(Severity severity, const fs::path& found, std::string_view text);

    fs::path m_top;
    fs::path m_ownTop;  ///< without links
    std::size_t m_most;
    base::Progress& m_progress;
    Diagnostics& m_diagnostics;
    std::vector<FolderFile> m_files;
    std::vector<fs::path> m_folders;  ///< still to be listed, as those that m_links lead to are
    std::set<fs::path> m_links;       ///< in order: the system lists folders in any
    std::set<fs::path> m_known;       ///< all that were listed, without links
};

base::Result<std::vector<FolderFile>> FolderWalk::walk() {
    m_folders.push_back(m_top);
    while (!isOver() && (!m_folders.empty() || !m_links.empty())) {
        const fs::path folder = takeNext();
        const std::error_code error = isLeftOut(folder) ? std::error_code() : list(folder);
        if (error && folder == m_top) {
            return base::Error{base::ErrorCode::BadInput,
                               m_top.string() + ": the folder cannot be read: " + error.message()};
        }
        if (error) {
            report(Severity::Error, folder, "the folder cannot be read: " + error.message());
        }
    }
    std::ranges::sort(m_files, {}, &FolderFile::path);
    return std::move(m_files);
}

fs::path FolderWalk::takeNext() {
    if (m_folders.empty()) {
        return std::move(m_links.extract(m_links.begin()).value());
    }
    fs::path folder = std::move(m_folders.back());
    m_folders.pop_back();
    return folder;
}

bool FolderWalk::isLeftOut(const fs::path& folder) {
    std::error_code error;
    const fs::path own = fs::canonical(folder, error);
    if (error) {
        return false;  // why is said when it is listed
    }
    if (!m_known.insert(own).second) {
        report(Severity::Info, folder, "the folder is read by another name, and once only");
        return true;
    }
    if (folder != m_top && holds(own, m_ownTop)) {
        report(Severity::Warning, folder, "the link leads to a folder that holds this one and was left out");
        return true;
    }
    return false;
}

std::error_code FolderWalk::list(const fs::path& folder) {
    std::error_code error;
    fs::directory_iterator at(folder, error);
    for (; !error && at != fs::directory_iterator() && !isOver(); at.increment(error)) {
        take(*at);
    }
    return error;
}

void FolderWalk::take(const fs::directory_entry& entry) {
    std::error_code error;
    std::error_code ignored;
    const fs::file_type type = entry.status(error).type();
    const bool isLink = entry.is_symlink(ignored);
    if (type == fs::file_type::regular) {
        const std::uintmax_t size = entry.file_size(ignored);
        m_files.push_back({pathOf(entry.path()), entry.path(), ignored ? 0 : size});
    } else if (type == fs::file_type::directory && isLink) {
        m_links.insert(entry.path());
    } else if (type == fs::file_type::directory) {
        m_folders.push_back(entry.path());
    } else if (type != fs::file_type::not_found) {
        report(Severity::Error, entry.path(),
               error ? "it cannot be read: " + error.message() : "it is a pipe or a device and was left out");
    } else if (isLink) {
        report(Severity::Error, entry.path(), "the link leads to nothing");
    }
}

void FolderWalk::report(Severity severity, const fs::path& found, std::string_view text) {
    const bool isHidden = found.filename().string().starts_with('.');
    m_diagnostics.report(isHidden ? Severity::Info : severity, pathOf(found), 0, text);
}

}  // namespace

base::Result<std::vector<FolderFile>> filesBelow(const fs::path& folder, std::size_t most, base::Progress& progress,
                                                 Diagnostics& diagnostics) {
    return FolderWalk(folder, most, progress, diagnostics).walk();
}

}  // namespace model::formats
