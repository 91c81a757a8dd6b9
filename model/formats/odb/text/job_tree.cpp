#include "model/formats/odb/text/job_tree.h"

#include "model/formats/common/archive_stream.h"

namespace model::odb {

namespace {

bool hasBelow(const Archive& archive, const std::string& folder) {
    const auto location = archive.rows().lower_bound(folder);
    return location != archive.rows().end() && location->first.starts_with(folder);
}

}  // namespace

base::Result<JobTree> JobTree::findIn(const Archive& archive) {
    constexpr std::string_view kMatrix = "matrix/matrix";
    JobTree tree;
    tree.m_archive = &archive;
    bool isFound = false;
    for (const auto& [path, row] : archive.rows()) {
        const std::string_view plain = path.ends_with(".z") ? std::string_view(path).substr(0, path.size() - 2) : path;
        const bool isMatrix = plain == kMatrix || plain.ends_with("/matrix/matrix");
        const std::string root = isMatrix ? std::string(plain.substr(0, plain.size() - kMatrix.size())) : "";
        // The shallowest one wins: jobs may carry copies of others in their user folder.
        if (isMatrix && hasBelow(archive, root + "steps/") && (!isFound || root.size() < tree.m_root.size())) {
            tree.m_root = root;
            isFound = true;
        }
    }
    if (!isFound) {
        return base::Error{base::ErrorCode::BadInput,
                           "this is no ODB++ job: no folder in it holds both matrix/matrix and steps/"};
    }
    return tree;
}

std::string JobTree::name() const {
    if (m_root.empty()) {
        return {};
    }
    const std::string& path = m_archive->path(m_archive->rows().lower_bound(m_root)->second);
    const std::string folder = path.substr(0, m_root.size() - 1);
    const std::size_t slash = folder.rfind('/');
    return slash == std::string::npos ? folder : folder.substr(slash + 1);
}

int JobTree::row(std::string_view path) const {
    const std::string full = m_root + lowerCase(path);
    const int plain = m_archive->find(full);
    return plain >= 0 ? plain : m_archive->find(full + ".z");
}

std::uint64_t JobTree::storedSize(std::string_view path) const {
    const int found = row(path);
    return found < 0 ? 0 : m_archive->storedSize(found);
}

bool JobTree::hasFolder(std::string_view path) const {
    return hasBelow(*m_archive, m_root + lowerCase(path) + "/");
}

std::optional<JobFile> JobTree::read(std::string_view path, Diagnostics& diagnostics) const {
    const int found = row(path);
    if (found < 0) {
        return std::nullopt;
    }
    JobFile file;
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

std::vector<std::string> JobTree::foldersIn(std::string_view path) const {
    const std::string prefix = m_root + lowerCase(path) + "/";
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

}  // namespace model::odb
