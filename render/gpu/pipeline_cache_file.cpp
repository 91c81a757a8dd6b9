#include "render/gpu/pipeline_cache_file.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <type_traits>

#include "model/text/file_writer.h"
#include "model/text/whole_file.h"

namespace render::gpu {
namespace {

namespace fs = std::filesystem;

/// What our file begins with; `size` bytes of the driver's follow.
struct Header {
    std::array<char, 8> magic{};
    PipelineCacheOwner owner;
    std::uint64_t reserved = 0;
    std::uint64_t size = 0;
    std::uint64_t checksum = 0;
};
// Written and compared as it lies in memory, so without padding.
static_assert(sizeof(Header) == 64 && std::has_unique_object_representations_v<Header>);

constexpr std::array<char, 8> kMagic = {'C', 'S', 'P', 'I', 'P', 'E', '0', '1'};

/// FNV-1a, 64 bits: finds damage, not malice.
std::uint64_t checksumOf(std::string_view bytes) {
    std::uint64_t sum = 0xcbf29ce484222325U;
    for (const char byte : bytes) {
        sum = (sum ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
    }
    return sum;
}

Header headerFor(const PipelineCacheOwner& owner, std::string_view data) {
    return {kMagic, owner, 0, data.size(), checksumOf(data)};
}

std::string nameFor(const PipelineCacheOwner& owner) {
    char name[64];
    std::snprintf(name, sizeof name, "pipelines-%08x-%08x-%u.cache", owner.vendor, owner.device, owner.driver);
    return name;
}

}  // namespace

fs::path pipelineCacheFolder() {
    const char* cache = std::getenv("XDG_CACHE_HOME");
    if (cache != nullptr && fs::path(cache).is_absolute()) {
        return fs::path(cache) / "copperscope";
    }
    const char* home = std::getenv("HOME");
    return home != nullptr && fs::path(home).is_absolute() ? fs::path(home) / ".cache" / "copperscope" : fs::path();
}

PipelineCacheFile::PipelineCacheFile(const fs::path& folder, const PipelineCacheOwner& owner) : m_owner(owner) {
    if (!folder.empty()) {
        m_path = folder / nameFor(owner);
    }
}

std::string PipelineCacheFile::load() {
    m_loaded.clear();
    std::error_code error;
    // A pipe or a device in its place would be read for ever.
    if (m_path.empty() || !fs::is_regular_file(m_path, error) ||
        fs::file_size(m_path, error) > sizeof(Header) + kMostBytes) {
        return {};
    }
    const base::Result<std::string> file = model::readWholeFile(m_path);
    if (!file || file->size() < sizeof(Header)) {
        return {};
    }
    const std::string_view data = std::string_view(*file).substr(sizeof(Header));
    const Header expected = headerFor(m_owner, data);
    if (std::memcmp(file->data(), &expected, sizeof(Header)) == 0) {
        m_loaded = data;
    }
    return m_loaded;
}

base::Status PipelineCacheFile::save(std::string_view data) {
    if (m_path.empty() || data.size() <= kEmptyBytes || data.size() > kMostBytes || data == m_loaded) {
        return base::Done{};
    }
    std::error_code error;
    fs::create_directories(m_path.parent_path(), error);  // where that fails the writer says so
    const Header header = headerFor(m_owner, data);
    model::FileWriter writer(m_path);
    writer.write({reinterpret_cast<const char*>(&header), sizeof header});
    writer.write(data);
    const base::Status status = writer.commit();
    if (status) {
        m_loaded = data;
    }
    return status;
}

}  // namespace render::gpu
