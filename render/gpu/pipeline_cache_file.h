#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "model/base/result.h"

namespace render::gpu {

/// Whose compiled pipelines a cache holds. Those of another device, driver or version of a driver are of no use.
struct PipelineCacheOwner {
    std::uint32_t vendor = 0;                  ///< VkPhysicalDeviceProperties::vendorID
    std::uint32_t device = 0;                  ///< its deviceID
    std::uint32_t driver = 0;                  ///< VkPhysicalDeviceDriverProperties::driverID
    std::uint32_t driverVersion = 0;           ///< VkPhysicalDeviceProperties::driverVersion
    std::array<std::uint8_t, 16> cacheUuid{};  ///< its pipelineCacheUUID

    bool operator==(const PipelineCacheOwner&) const = default;
};

/// Where caches of this user lie: `copperscope` in XDG_CACHE_HOME, or in ~/.cache. Empty where neither is known (a
/// relative XDG_CACHE_HOME does not count, by the XDG base directory specification).
[[nodiscard]] std::filesystem::path pipelineCacheFolder();

/// The file between two starts of the program that holds what the driver compiled: one per device and driver, which a
/// new version of the driver takes over. Drivers trust the bytes they are given, so whole and own is checked here: by
/// owner, length and a checksum. Whatever is wrong with the file costs a slower start and nothing else.
class PipelineCacheFile {
public:
    /// Larger ones are neither read nor written.
    static constexpr std::uint64_t kMostBytes = std::uint64_t{64} << 20;
    /// What a cache that holds nothing consists of: VkPipelineCacheHeaderVersionOne.
    static constexpr std::size_t kEmptyBytes = 32;

    /// Without a folder nothing is read or written.
    PipelineCacheFile(const std::filesystem::path& folder, const PipelineCacheOwner& owner);

    /// For vkCreatePipelineCache: what was saved last; empty if that is missing, foreign, damaged or too large.
    [[nodiscard]] std::string load();
    /// Replaces the file by what vkGetPipelineCacheData returned, all of it or nothing, and makes the folder. Does
    /// nothing if that is what was loaded, holds nothing or is too large. Errors: OutputFailed.
    base::Status save(std::string_view data);

    [[nodiscard]] const std::filesystem::path& path() const { return m_path; }

private:
    std::filesystem::path m_path;
    PipelineCacheOwner m_owner;
    std::string m_loaded;
};

}  // namespace render::gpu
