#pragma once

#include <map>
#include <tuple>
#include <utility>

#include "model/formats/gerber/image/image.h"

namespace model::gerber {

/// How objects are laid elsewhere: grown by `scale`, then placed.
struct Transform {
    Placement placement;
    double scale = 1.0;
    bool isInverted = false;  ///< polarities the other way round

    [[nodiscard]] bool isIdentity() const { return scale == 1.0 && !isInverted && model::isIdentity(placement); }
    /// Without its place.
    [[nodiscard]] bool isPlain() const {
        return scale == 1.0 && placement.clockwiseDeg == 0.0 && !placement.isMirrored;
    }
};

/// The mirroring (LM) and rotation (LR, counter-clockwise) of the plot state: mirrored first, then rotated.
[[nodiscard]] Placement placementOf(bool isMirroredX, bool isMirroredY, double rotationDeg);

/// Lays objects elsewhere; symbols that have to change for it are added to the image, each once.
class Mover {
public:
    explicit Mover(Image& image) : m_image(image) {}

    /// False if the object would lie beyond the largest coordinate.
    [[nodiscard]] bool move(formats::DrawnFeature& feature, const Transform& transform);
    /// The symbol grown by a factor.
    [[nodiscard]] std::int32_t scaledSymbol(std::int32_t symbol, double factor);
    /// The symbol as a pen that has been rotated and mirrored.
    [[nodiscard]] std::int32_t turnedSymbol(std::int32_t symbol, const Placement& placement);

private:
    [[nodiscard]] std::int32_t scaledRegion(std::int32_t region, double factor);

    Image& m_image;
    std::map<std::pair<std::int32_t, double>, std::int32_t> m_scaled;
    std::map<std::pair<std::int32_t, double>, std::int32_t> m_scaledRegions;
    std::map<std::tuple<std::int32_t, double, bool>, std::int32_t> m_turned;
};

}  // namespace model::gerber
