#include "render/tiles/warped_picture.h"

#include <algorithm>
#include <cmath>

#include "model/base/parallel.h"
#include "render/tiles/pixel_between.h"

namespace render {

namespace {

constexpr int kBand = 16;  // rows per task
/// Within so many pixels the way through the source is as good as straight.
constexpr int kRun = 16;
constexpr double kFixed = 65536.0;
constexpr double kFarAway = 1e4;  // pixels beside the source: all the same
constexpr double kLeastTilt = 1e-3;
constexpr double kNearScale = 1.35;
constexpr double kNearMiddle = 0.3;  // of the picture, from the middle of the source
constexpr double kNearTurn = 0.12;

/// Pixels from clip space.
glm::dmat3 pixelsOf(glm::ivec2 size) {
    const glm::dvec2 half = glm::dvec2(size) / 2.0;
    return {{half.x, 0.0, 0.0}, {0.0, half.y, 0.0}, {half.x, half.y, 1.0}};
}

/// How much of the plane a camera sees of what it would see from straight above, with a sign by the face.
double facing(const glm::dmat3& clipFromPlane) {
    const double scale = std::max(glm::dot(clipFromPlane[0], clipFromPlane[0]), 1e-30);
    return glm::determinant(clipFromPlane) / scale;
}

}  // namespace

glm::dmat3 clipFromPlane(const glm::mat4& clipFromBoard, float z) {
    const auto flat = [](const glm::vec4& column) { return glm::dvec3(column.x, column.y, column.w); };
    return {flat(clipFromBoard[0]), flat(clipFromBoard[1]),
            flat(clipFromBoard[2]) * double{z} + flat(clipFromBoard[3])};
}

std::optional<WarpedPicture> WarpedPicture::make(const WarpSource& source, const glm::dmat3& clipFromPlane,
                                                 glm::ivec2 size) {
    const double before = facing(source.clipFromPlane);
    const double now = facing(clipFromPlane);
    if (source.pixels == nullptr || before * now <= 0.0 || std::min(std::abs(before), std::abs(now)) < kLeastTilt) {
        return std::nullopt;
    }
    const glm::dmat3 targetFromPlane = pixelsOf(size) * clipFromPlane;
    const glm::dmat3 sourceFromPlane = pixelsOf(source.size) * source.clipFromPlane;
    return WarpedPicture(source, sourceFromPlane * glm::inverse(targetFromPlane), size);
}

/// Far beside the source where the line of sight misses the plane.
glm::dvec2 WarpedPicture::at(const glm::dvec3& homogeneous) const {
    if (homogeneous.z <= 0.0) {
        return glm::dvec2(-kFarAway);
    }
    return glm::clamp(glm::dvec2(homogeneous) / homogeneous.z, -kFarAway, kFarAway);
}

void WarpedPicture::paintRun(glm::dvec2 from, glm::dvec2 to, int count, std::uint32_t ground,
                             std::uint32_t* out) const {
    const glm::dvec2 last = glm::dvec2(m_source.size) - 1.0;
    const glm::dvec2 low = glm::min(from, to);
    const glm::dvec2 high = glm::max(from, to);
    if (high.x < 0.0 || high.y < 0.0 || low.x >= last.x || low.y >= last.y) {
        std::fill_n(out, count, ground);
        return;
    }
    const bool isInside = low.x >= 0.0 && low.y >= 0.0 && high.x < last.x && high.y < last.y;
    const glm::i64vec2 step((to - from) * kFixed / double{kRun});
    glm::i64vec2 at(from * kFixed);
    for (int i = 0; i < count; ++i, at += step) {
        const glm::i64vec2 pixel = at >> std::int64_t{16};
        if (!isInside &&
            (pixel.x < 0 || pixel.y < 0 || pixel.x + 1 >= m_source.size.x || pixel.y + 1 >= m_source.size.y)) {
            out[i] = ground;
            continue;
        }
        const std::uint32_t* upper = m_source.pixels + pixel.y * m_source.size.x + pixel.x;
        const std::uint32_t* lower = upper + m_source.size.x;
        const auto right = static_cast<std::uint32_t>(at.x >> 8 & 0xff);
        const auto down = static_cast<std::uint32_t>(at.y >> 8 & 0xff);
        out[i] = pixelBetween(pixelBetween(upper[0], upper[1], right), pixelBetween(lower[0], lower[1], right), down) |
                 0xff000000U;
    }
}

void WarpedPicture::paintRow(int y, std::uint32_t ground, std::uint32_t* out) const {
    const auto sourceAt = [&](int x) {  // of the middles of pixels
        return at(m_sourceFromTarget * glm::dvec3(x + 0.5, y + 0.5, 1.0)) - 0.5;
    };
    glm::dvec2 from = sourceAt(0);
    for (int x = 0; x < m_size.x; x += kRun) {
        const glm::dvec2 to = sourceAt(x + kRun);
        paintRun(from, to, std::min(kRun, m_size.x - x), ground, out + x);
        from = to;
    }
}

void WarpedPicture::paint(std::uint32_t ground, std::uint32_t* pixels) const {
    base::parallelFor(static_cast<std::size_t>((m_size.y + kBand - 1) / kBand), [&](std::size_t band) {
        const int from = static_cast<int>(band) * kBand;
        for (int y = from; y < std::min(from + kBand, m_size.y); ++y) {
            paintRow(y, ground, pixels + std::ptrdiff_t{y} * m_size.x);
        }
    });
}

bool WarpedPicture::isNear() const {
    const glm::dvec2 middle = glm::dvec2(m_size) / 2.0;
    const auto sourceAt = [&](glm::dvec2 pixel) { return at(m_sourceFromTarget * glm::dvec3(pixel, 1.0)); };
    const glm::dvec2 centre = sourceAt(middle);
    const glm::dvec2 right = sourceAt(middle + glm::dvec2(1.0, 0.0)) - centre;
    const glm::dvec2 down = sourceAt(middle + glm::dvec2(0.0, 1.0)) - centre;
    const glm::dvec2 away = glm::abs(centre - glm::dvec2(m_source.size) / 2.0) / glm::dvec2(m_source.size);
    const double width = glm::length(right);
    const double height = glm::length(down);
    const bool isAsLarge = std::max({width, height, 1.0 / width, 1.0 / height}) < kNearScale;
    // Turned, mirrored or sheared it would have parts across.
    const double across = std::max(std::abs(right.y), std::abs(down.x));
    return isAsLarge && across < kNearTurn && std::max(away.x, away.y) < kNearMiddle;
}

}  // namespace render
