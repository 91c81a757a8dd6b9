#include "render/backends/measured_backends.h"

#include <system_error>

#include "model/text/formatting.h"
#include "model/text/whole_file.h"
#include "render/gpu/device.h"

namespace render {
namespace {

namespace fs = std::filesystem;

/// Counts up when back ends, or the rules they are held against, change so much that cards are to be measured again.
constexpr int kVersion = 1;
/// What is longer was not written here.
constexpr std::uint64_t kMostBytes = 1000;

constexpr Backend kBackends[] = {Backend::Pull, Backend::Mesh, Backend::Impostor, Backend::Raster};

std::string hexOf(std::span<const std::uint8_t> bytes) {
    std::string text;
    for (const std::uint8_t byte : bytes) {
        text += model::formatted("%02x", byte);
    }
    return text;
}

/// An answer may also be that nothing is known.
std::vector<Backend> answers(bool isSmoothed) {
    std::vector<Backend> all = {Backend::Auto};
    const std::span<const Backend> known = tiltedBackends(isSmoothed);
    all.insert(all.end(), known.begin(), known.end());
    return all;
}

}  // namespace

std::span<const Backend> tiltedBackends(bool isSmoothed) {
    return std::span(kBackends).first(std::size(kBackends) - (isSmoothed ? 1 : 0));
}

std::string measuredText(const MeasuredBackends& measured, const gpu::PipelineCacheOwner& owner) {
    return model::formatted(
        "Copperscope's fastest back ends, version %d\nvendor %08x, device %08x, driver %u, driver version %08x, %s\n"
        "plain: %s\nsmoothed: %s\n",
        kVersion, owner.vendor, owner.device, owner.driver, owner.driverVersion, hexOf(owner.cacheUuid).c_str(),
        nameOf(measured.plain), nameOf(measured.smoothed));
}

std::optional<MeasuredBackends> parseMeasured(std::string_view text, const gpu::PipelineCacheOwner& owner) {
    // There are so few texts that are right that it is one of them or none.
    for (const Backend plain : answers(false)) {
        for (const Backend smoothed : answers(true)) {
            if (text == measuredText({plain, smoothed}, owner)) {
                return MeasuredBackends{plain, smoothed};
            }
        }
    }
    return std::nullopt;
}

MeasuredBackendsFile::MeasuredBackendsFile(const fs::path& folder, const gpu::PipelineCacheOwner& owner)
    : m_owner(owner) {
    if (!folder.empty()) {
        m_path = folder / model::formatted("backends-%08x-%08x-%u.txt", owner.vendor, owner.device, owner.driver);
    }
}

std::optional<MeasuredBackends> MeasuredBackendsFile::load() const {
    std::error_code error;
    // A pipe or a device in its place would be read for ever.
    if (m_path.empty() || !fs::is_regular_file(m_path, error)) {
        return std::nullopt;
    }
    const base::Result<std::string> text = model::readWholeFile(m_path, kMostBytes);
    return text ? parseMeasured(*text, m_owner) : std::nullopt;
}

base::Status MeasuredBackendsFile::save(const MeasuredBackends& measured) const {
    if (m_path.empty()) {
        return base::Error{base::ErrorCode::OutputFailed,
                           "The fastest back ends cannot be saved: neither XDG_CACHE_HOME nor HOME names a folder."};
    }
    std::error_code error;
    fs::create_directories(m_path.parent_path(), error);  // where that fails the writer says so
    return model::writeWholeFile(m_path, measuredText(measured, m_owner));
}

void MeasuredBackendsFile::remove() const {
    std::error_code error;
    fs::remove(m_path, error);
}

MeasuredBackends measuredBackends(const gpu::Caps& caps) {
    return MeasuredBackendsFile(gpu::pipelineCacheFolder(), caps.cacheOwner).load().value_or(MeasuredBackends{});
}

}  // namespace render
