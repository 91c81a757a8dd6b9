#include "render/tiles/warped_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/base/parallel.h"
#include "render/tiles/pixel_between.h"

namespace render {

namespace {

constexpr int kBand = 16;  // rows per task
constexpr int kRun = 16;   // pixels
/// Where the plane goes no farther away than this within a run, steps through the source are as good as even.
constexpr double kStraight = 1.05;
constexpr double kFixed = 65536.0;
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

/// Pixels of the source, counted from the middle of the first one.
glm::dvec2 inSource(const glm::dvec3& homogeneous) {
    return glm::dvec2(homogeneous) / homogeneous.z - 0.5;
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

WarpedPicture::Run WarpedPicture::runAt(glm::ivec2 start) const {
    const glm::dvec2 first = glm::dvec2(start) + 0.5;
    return {start, std::min(kRun, m_size.x - start.x), sourceOf(first), sourceOf(first + glm::dvec2(kRun, 0.0))};
}

WarpedPicture::Reach WarpedPicture::reachOf(const Run& run) const {
    if (run.from.z <= 0.0 && run.to.z <= 0.0) {
        return Reach::None;
    }
    if (run.from.z <= 0.0 || run.to.z <= 0.0) {
        return Reach::Part;
    }
    const glm::dvec2 from = inSource(run.from);
    const glm::dvec2 to = inSource(run.to);
    const glm::dvec2 low = glm::min(from, to);
    const glm::dvec2 high = glm::max(from, to);
    const glm::dvec2 last = glm::dvec2(m_source.size) - 1.0;
    if (high.x < 0.0 || high.y < 0.0 || low.x >= last.x || low.y >= last.y) {
        return Reach::None;
    }
    const bool isAll = low.x >= 0.0 && low.y >= 0.0 && high.x < last.x && high.y < last.y;
    return isAll ? Reach::All : Reach::Part;
}

/// With its neighbours to the right and below.
bool WarpedPicture::isInside(glm::i64vec2 pixel) const {
    return pixel.x >= 0 && pixel.y >= 0 && pixel.x + 1 < m_source.size.x && pixel.y + 1 < m_source.size.y;
}

std::uint32_t WarpedPicture::pixelAt(glm::i64vec2 fixed) const {
    const glm::i64vec2 pixel = fixed >> std::int64_t{16};
    const std::uint32_t* upper = m_source.pixels + pixel.y * m_source.size.x + pixel.x;
    const std::uint32_t* lower = upper + m_source.size.x;
    const auto right = static_cast<std::uint32_t>(fixed.x >> 8 & 0xff);
    const auto down = static_cast<std::uint32_t>(fixed.y >> 8 & 0xff);
    return pixelBetween(pixelBetween(upper[0], upper[1], right), pixelBetween(lower[0], lower[1], right), down) |
           0xff000000U;
}

/// As if the way through the source were even.
void WarpedPicture::paintStraight(const Run& run, Reach reach, std::uint32_t* out) const {
    const glm::dvec2 from = inSource(run.from);
    const glm::i64vec2 step((inSource(run.to) - from) * kFixed / double{kRun});
    glm::i64vec2 at(from * kFixed);
    for (int i = 0; i < run.count; ++i, at += step) {
        if (reach == Reach::All || isInside(at >> std::int64_t{16})) {
            out[i] = pixelAt(at);
        }
    }
}

/// Where the plane goes far away.
void WarpedPicture::paintBent(const Run& run, std::uint32_t* out) const {
    for (int i = 0; i < run.count; ++i) {
        const glm::dvec3 place = glm::mix(run.from, run.to, i / double{kRun});
        if (place.z <= 0.0) {
            continue;
        }
        const glm::dvec2 at = inSource(place);
        if (at.x >= 0.0 && at.y >= 0.0 && at.x < m_source.size.x - 1.0 && at.y < m_source.size.y - 1.0) {
            out[i] = pixelAt(glm::i64vec2(at * kFixed));
        }
    }
}

void WarpedPicture::paintRun(glm::ivec2 start, std::uint32_t ground, const WarpedPicture* behind,
                             std::uint32_t* out) const {
    const Run run = runAt(start);
    const Reach reach = reachOf(run);
    if (reach != Reach::All) {
        if (behind != nullptr) {
            behind->paintRun(start, ground, nullptr, out);
        } else {
            std::fill_n(out, run.count, ground);
        }
    }
    if (reach == Reach::None) {
        return;
    }
    const auto [less, more] = std::minmax(run.from.z, run.to.z);
    if (more < less * kStraight) {
        paintStraight(run, reach, out);
    } else {
        paintBent(run, out);
    }
}

void WarpedPicture::paint(std::uint32_t ground, const WarpedPicture* behind, std::uint32_t* pixels) const {
    base::parallelFor(static_cast<std::size_t>((m_size.y + kBand - 1) / kBand), [&](std::size_t band) {
        const int from = static_cast<int>(band) * kBand;
        for (int y = from; y < std::min(from + kBand, m_size.y); ++y) {
            for (int x = 0; x < m_size.x; x += kRun) {
                paintRun({x, y}, ground, behind, pixels + std::ptrdiff_t{y} * m_size.x + x);
            }
        }
    });
}

/// None: the source sees nothing of what is in the middle.
std::optional<WarpedPicture::Middle> WarpedPicture::middle() const {
    const glm::dvec2 middle = glm::dvec2(m_size) / 2.0;
    const glm::dvec3 place = sourceOf(middle);
    const glm::dvec3 right = sourceOf(middle + glm::dvec2(1.0, 0.0));
    const glm::dvec3 down = sourceOf(middle + glm::dvec2(0.0, 1.0));
    if (std::min({place.z, right.z, down.z}) <= 0.0) {
        return std::nullopt;
    }
    const auto at = [](const glm::dvec3& homogeneous) { return glm::dvec2(homogeneous) / homogeneous.z; };
    return Middle{at(place), at(right) - at(place), at(down) - at(place)};
}

bool WarpedPicture::isNear() const {
    const std::optional<Middle> middle = this->middle();
    if (!middle) {
        return false;
    }
    const auto& [place, right, down] = *middle;
    const glm::dvec2 away = glm::abs(place - glm::dvec2(m_source.size) / 2.0) / glm::dvec2(m_source.size);
    const double width = glm::length(right);
    const double height = glm::length(down);
    const bool isAsLarge = std::max({width, height, 1.0 / width, 1.0 / height}) < kNearScale;
    // Turned, mirrored or sheared it would have parts across.
    const double across = std::max(std::abs(right.y), std::abs(down.x));
    return isAsLarge && across < kNearTurn && std::max(away.x, away.y) < kNearMiddle;
}

double WarpedPicture::stretch() const {
    const std::optional<Middle> middle = this->middle();
    if (!middle) {
        return std::numeric_limits<double>::infinity();
    }
    const auto& [place, right, down] = *middle;
    // The smaller singular value of the matrix of both.
    const double turned = glm::length(glm::dvec2(right.x + down.y, right.y - down.x));
    const double mirrored = glm::length(glm::dvec2(right.x - down.y, right.y + down.x));
    return 2.0 / std::abs(turned - mirrored);
}

}  // namespace render
