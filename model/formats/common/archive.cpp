#include "model/formats/common/archive.h"

#include <algorithm>
#include <fstream>
#include <system_error>

#include "model/base/ascii.h"
#include "model/formats/common/archive_stream.h"
#include "model/formats/common/folder_files.h"

namespace model::formats {

namespace {

namespace fs = std::filesystem;

base::Error badInput(const fs::path& path, std::string_view text) {
    return {base::ErrorCode::BadInput, path.string() + ": " + std::string(text)};
}

base::Error cancelled() {
    return {base::ErrorCode::Cancelled, "cancelled"};
}

/// Slashes forward, no leading "./", no trailing slash.
std::string normalised(std::string name) {
    std::ranges::replace(name, '\\', '/');
    while (name.starts_with("./")) {
        name.erase(0, 2);
    }
    while (name.ends_with('/')) {
        name.pop_back();
    }
    return name;
}

bool isAbsolute(std::string_view name) {
    return name.starts_with('/') || (name.size() > 1 && name[1] == ':');
}

bool climbs(const fs::path& name) {
    return std::ranges::find(name, fs::path("..")) != name.end();
}

/// Why an entry must not be taken, or nothing.
std::string_view refusal(const ArchiveStream& stream, std::string_view name) {
    if (name.empty()) {
        return "an entry of the archive has no name that can be read and was left out";
    }
    if (isAbsolute(name)) {
        return "the archive entry has an absolute path and was left out";
    }
    if (climbs(name)) {
        return "the archive entry has '..' in its path and was left out";
    }
    if (!stream.isRegularFile()) {
        return "the archive entry is a link or a device and was left out";
    }
    return {};
}

/// Bytes that may come from so many, and why there may not be more.
struct Allowance {
    std::uint64_t bytes = 0;
    std::string problem;
};

Allowance allowanceOf(const ArchiveLimits& limits, std::uint64_t packedBytes) {
    const std::uint64_t byRatio = packedBytes > limits.totalBytes / std::max<std::uint64_t>(limits.expansion, 1)
                                      ? limits.totalBytes
                                      : packedBytes * limits.expansion;
    const std::uint64_t suspicious = std::max(limits.freeBytes, byRatio);
    if (suspicious < limits.totalBytes) {
        return {suspicious, "the archive unpacks to too much: more than " + bytesText(limits.freeBytes) + " and " +
                                std::to_string(limits.expansion) +
                                " times its own size, which is what archives made to burst do; --max-unpacked sets "
                                "another limit"};
    }
    return {limits.totalBytes, "the archive unpacks to too much: more than " + bytesText(limits.totalBytes) +
                                   ", the limit for a job; --max-unpacked sets another one"};
}

/// What the file unpacks to, if it is one gzip member.
std::optional<FileBytes> unpackGzipFile(const fs::path& path, std::uintmax_t size, const ArchiveLimits& limits) {
    std::ifstream file(path, std::ios::binary);
    char magic[2] = {};
    if (size > kMostAtOneGo || !file.read(magic, sizeof magic) || std::string_view(magic, sizeof magic) != kGzipMagic) {
        return std::nullopt;
    }
    FileBytes packed(size);
    file.seekg(0);
    if (!packed.holdsMemory() || !file.read(packed.data(), static_cast<std::streamsize>(size))) {
        return std::nullopt;
    }
    return unpackGzip(packed.view(), allowanceOf(limits, size).bytes);
}

/// What libarchive says of what is none of the formats asked for.
constexpr std::string_view kNoFormat = "Unrecognized archive format";

bool isPacked(const ArchiveStream& stream) {
    return stream.hasEntries() && stream.isPacked();
}

base::Error damaged(const fs::path& path, const ArchiveStream& stream) {
    return badInput(path, "this is packed, but ends early or is damaged (" + stream.errorText() + ")");
}

base::Error tooManyFiles(const fs::path& path, const ArchiveLimits& limits) {
    return badInput(path, "it holds too many files for a job: more than " + std::to_string(limits.entries) +
                              ", the limit for an archive or folder");
}

}  // namespace

std::string bytesText(std::uint64_t bytes) {
    const bool isGiB = bytes >= base::kGiB && bytes % base::kGiB == 0;
    const bool isMiB = bytes >= base::kMiB && bytes % base::kMiB == 0;
    return isGiB   ? std::to_string(bytes / base::kGiB) + " GiB"
           : isMiB ? std::to_string(bytes / base::kMiB) + " MiB"
                   : std::to_string(bytes) + " bytes";
}

std::string noneThere(fs::file_status status, std::error_code error) {
    const bool isKnown = status.type() == fs::file_type::not_found;
    return isKnown ? "there is no such file or folder" : "it cannot be read: " + error.message();
}

base::Result<Archive> Archive::open(const fs::path& path, const ArchiveLimits& limits, base::Progress& progress,
                                    Diagnostics& diagnostics) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) {
        return badInput(path, noneThere(status, error));
    }
    return fs::is_directory(status) ? openFolder(path, limits, progress, diagnostics)
                                    : openFile(path, limits, progress, diagnostics);
}

base::Result<Archive> Archive::openFolder(const fs::path& path, const ArchiveLimits& limits, base::Progress& progress,
                                          Diagnostics& diagnostics) {
    ASSIGN_OR_RETURN(std::vector<FolderFile> files, filesBelow(path, limits.entries, progress, diagnostics));
    if (progress.isCancelled()) {
        return cancelled();
    }
    if (files.size() > limits.entries) {
        return tooManyFiles(path, limits);
    }
    Archive tree;
    for (FolderFile& file : files) {
        tree.add({std::move(file.path), {}, std::move(file.source), file.size}, diagnostics);
    }
    return tree;
}

base::Result<Archive> Archive::openFile(const fs::path& path, const ArchiveLimits& limits, base::Progress& progress,
                                        Diagnostics& diagnostics) {
    std::error_code error;
    const std::uintmax_t fileSize = fs::file_size(path, error);
    if (error || fileSize == 0) {
        return badInput(path, error ? "the file cannot be read" : "the file is empty");
    }
    if (std::optional<FileBytes> unpacked = unpackGzipFile(path, fileSize, limits)) {
        return readUnpacked(*std::move(unpacked), fileSize, path, limits, progress, diagnostics);
    }
    ArchiveStream stream(path, ArchiveStream::Formats::Containers);
    base::Result<Archive> tree = readAll(stream, fileSize, fileSize, path, limits, progress, diagnostics);
    if (tree || stream.hasEntries() || tree.error().code != base::ErrorCode::BadInput) {
        return tree;
    }
    ArchiveStream member(path, ArchiveStream::Formats::Member);
    if (std::optional<base::Result<Archive>> lone = readLone(member, fileSize, path, limits)) {
        return *std::move(lone);
    }
    return isPacked(member) ? damaged(path, member) : std::move(tree);
}

base::Result<Archive> Archive::unpack(std::string_view bytes, const fs::path& name, const ArchiveLimits& limits,
                                      base::Progress& progress, Diagnostics& diagnostics) {
    if (bytes.empty()) {
        return badInput(name, "the file is empty");
    }
    if (std::optional<FileBytes> unpacked = unpackGzip(bytes, allowanceOf(limits, bytes.size()).bytes)) {
        return readUnpacked(*std::move(unpacked), bytes.size(), name, limits, progress, diagnostics);
    }
    ArchiveStream stream(bytes, ArchiveStream::Formats::Containers);
    base::Result<Archive> tree = readAll(stream, bytes.size(), bytes.size(), name, limits, progress, diagnostics);
    if (tree || stream.hasEntries() || tree.error().code != base::ErrorCode::BadInput) {
        return tree;
    }
    ArchiveStream member(bytes, ArchiveStream::Formats::Member);
    if (std::optional<base::Result<Archive>> lone = readLone(member, bytes.size(), name, limits)) {
        return *std::move(lone);
    }
    return isPacked(member) ? damaged(name, member) : std::move(tree);
}

base::Result<Archive> Archive::readUnpacked(FileBytes unpacked, std::uint64_t packedBytes, const fs::path& path,
                                            const ArchiveLimits& limits, base::Progress& progress,
                                            Diagnostics& diagnostics) {
    ArchiveStream stream(unpacked, ArchiveStream::Formats::Containers);
    base::Result<Archive> tree = readAll(stream, unpacked.size(), packedBytes, path, limits, progress, diagnostics);
    if (tree) {
        tree->m_unpacked = std::move(unpacked);
        return tree;
    }
    if (stream.hasEntries() || tree.error().code != base::ErrorCode::BadInput) {
        return tree;
    }
    // Packed once more?
    ArchiveStream member(unpacked, ArchiveStream::Formats::Member);
    if (std::optional<base::Result<Archive>> lone = readLone(member, packedBytes, path, limits)) {
        return *std::move(lone);
    }
    return loneFile(path, Bytes(std::move(unpacked)));
}

Archive Archive::of(std::vector<std::pair<std::string, std::string>> files) {
    Archive tree;
    Diagnostics none;
    for (auto& [path, bytes] : files) {
        const std::uint64_t size = bytes.size();
        tree.add({std::move(path), Bytes(std::move(bytes)), {}, size}, none);
    }
    return tree;
}

Archive Archive::loneFile(const fs::path& path, Bytes data) {
    Entry entry{path.stem().string(), std::move(data), {}, 0};
    entry.size = entry.data.view().size();
    Archive tree;
    Diagnostics none;
    tree.add(std::move(entry), none);
    return tree;
}

std::optional<base::Result<Archive>> Archive::readLone(ArchiveStream& stream, std::uint64_t packedBytes,
                                                       const fs::path& path, const ArchiveLimits& limits) {
    Bytes data;
    if (!stream.next() || !stream.isPacked()) {
        return std::nullopt;
    }
    const Allowance allowance = allowanceOf(limits, packedBytes);
    const ArchiveStream::Reading reading = stream.read(data, allowance.bytes);
    if (reading == ArchiveStream::Reading::TooLarge) {
        return badInput(path, allowance.problem);
    }
    if (reading == ArchiveStream::Reading::Broken) {
        return std::nullopt;
    }
    return loneFile(path, std::move(data));
}

base::Result<Archive> Archive::readAll(ArchiveStream& stream, std::uint64_t streamBytes, std::uint64_t packedBytes,
                                       const fs::path& path, const ArchiveLimits& limits, base::Progress& progress,
                                       Diagnostics& diagnostics) {
    Archive tree;
    const Allowance allowance = allowanceOf(limits, packedBytes);
    std::uint64_t total = 0;
    while (stream.next()) {
        if (progress.isCancelled()) {
            return cancelled();
        }
        progress.setFraction(
            static_cast<float>(static_cast<double>(stream.position()) / static_cast<double>(streamBytes)));
        const std::string name = normalised(stream.name());
        if (stream.isFolder()) {
            continue;
        }
        if (const std::string_view reason = refusal(stream, name); !reason.empty()) {
            diagnostics.report(Severity::Error, name, 0, reason);
            continue;
        }
        Entry entry{name, {}, {}, 0};
        const ArchiveStream::Reading reading = stream.read(entry.data, allowance.bytes - total);
        if (reading != ArchiveStream::Reading::Whole) {
            return badInput(path, reading == ArchiveStream::Reading::TooLarge
                                      ? allowance.problem
                                      : "the archive ends early or is damaged at " + name);
        }
        entry.size = entry.data.view().size();
        total += entry.size;
        if (tree.m_entries.size() >= limits.entries) {
            return tooManyFiles(path, limits);
        }
        tree.add(std::move(entry), diagnostics);
    }
    if (stream.failed()) {
        if (tree.size() == 0) {
            return stream.errorText() == kNoFormat ? badInput(path, "this is no archive we can read")
                                                   : damaged(path, stream);
        }
        return badInput(path, "the archive ends early or is damaged (" + stream.errorText() + ")");
    }
    return tree;
}

void Archive::add(Entry entry, Diagnostics& diagnostics) {
    const auto [location, isNew] = m_rows.try_emplace(base::lowerCase(entry.path), static_cast<int>(m_entries.size()));
    if (!isNew) {
        diagnostics.report(Severity::Warning, entry.path, 0,
                           "another file has the same name but for upper and lower case; the first one is used");
        return;
    }
    m_entries.push_back(std::move(entry));
}

int Archive::find(std::string_view path) const {
    const auto location = m_rows.find(base::lowerCase(path));
    return location == m_rows.end() ? -1 : location->second;
}

base::Result<Bytes> Archive::bytes(int row) const {
    const Entry& entry = m_entries[static_cast<std::size_t>(row)];
    if (entry.source.empty()) {
        return Bytes::borrow(entry.data.view());
    }
    if (entry.size > base::kMostFileBytes) {
        return badInput(entry.source,
                        "the file is larger than " + bytesText(base::kMostFileBytes) + ", the limit for one file");
    }
    std::ifstream file(entry.source, std::ios::binary);
    std::string data(entry.size, '\0');
    file.read(data.data(), static_cast<std::streamsize>(data.size()));
    if (!file) {
        return badInput(entry.source, "the file cannot be read");
    }
    return Bytes(std::move(data));
}

}  // namespace model::formats
