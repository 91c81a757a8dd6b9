#include "model/formats/common/file_tree.h"

#include "model/base/ascii.h"
#include "model/formats/common/archive_stream.h"

namespace model::formats {

std::string FileTree::name() const {
    if (m_root.empty()) {
        return {};
    }
    const std::string& path = m_archive->path(m_archive->rows().lower_bound(m_root)->second);
    const std::string folder = path.substr(0, m_root.size() - 1);
    const std::size_t slash = folder.rfind('/');
    return slash == std::string::npos ? folder : folder.substr(slash + 1);
}

int FileTree::row(std::string_view path) const {
    const std::string full = m_root + base::lowerCase(path);
    const int plain = m_archive->find(full);
    return plain >= 0 ? plain : m_archive->find(full + ".z");
}

std::uint64_t FileTree::storedSize(std::string_view path) const {
    const int found = row(path);
    return found < 0 ? 0 : m_archive->storedSize(found);
}

bool FileTree::hasFolder(std::string_view path) const {
    const std::string folder = m_root + base::lowerCase(path) + "/";
    const auto first = m_archive->rows().lower_bound(folder);
    return first != m_archive->rows().end() && first->first.starts_with(folder);
}

std::optional<TreeFile> FileTree::read(std::string_view path, Diagnostics& diagnostics) const {
    const int found = row(path);
    if (found < 0) {
        return std::nullopt;
    }
    TreeFile file;
    file.path = m_archive->path(found).substr(m_root.size());
    base::Result<Bytes> stored = m_archive->bytes(found);
    base::Result<Bytes> decoded = stored ? decodeMember(std::move(*stored)) : std::move(stored);
    if (!decoded) {
        diagnostics.report(Severity::Error, file.path, 0, decoded.error().text);
        return std::nullopt;
    }
    file.bytes = std::move(*decoded);
    return file;
}

std::vector<std::string> FileTree::foldersIn(std::string_view path) const {
    const std::string prefix = m_root + base::lowerCase(path) + "/";
    std::vector<std::string> folders;
    std::string last;
    for (auto location = m_archive->rows().lower_bound(prefix);
         location != m_archive->rows().end() && location->first.starts_with(prefix); ++location) {
        const std::size_t slash = location->first.find('/', prefix.size());
        if (slash == std::string::npos) {
            continue;
        }
        const std::string key = location->first.substr(0, slash);
        if (key != last) {
            folders.push_back(m_archive->path(location->second).substr(prefix.size(), slash - prefix.size()));
            last = key;
        }
    }
    return folders;
}

}  // namespace model::formats
