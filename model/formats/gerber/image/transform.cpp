#include "model/formats/gerber/image/transform.h"

#include <cmath>
#include <optional>

#include "model/formats/gerber/image/apertures.h"
#include "model/formats/gerber/text/words.h"

namespace model::gerber {

namespace {

double normalised(double degrees) {
    const double turn = std::fmod(degrees, 360.0);
    return turn < 0 ? turn + 360.0 : turn + 0.0;
}

std::optional<Point> moved(Point p, const Transform& transform) {
    const PointD at = transform.placement.apply(PointD{p.x * transform.scale, p.y * transform.scale});
    const std::optional<Nm> x = toNm(at.x);
    const std::optional<Nm> y = toNm(at.y);
    return x && y ? std::optional(Point{*x, *y}) : std::nullopt;
}

}  // namespace

Placement placementOf(bool isMirroredX, bool isMirroredY, double rotationDeg) {
    // Mirroring both ways is half a turn; mirroring y is mirroring x and half a turn.
    const double turn = rotationDeg + (isMirroredY ? 180.0 : 0.0);
    const bool isMirrored = isMirroredX != isMirroredY;
    // R(t) · M = M · R(-t): a mirrored placement rotates before it mirrors.
    return {{}, normalised(isMirrored ? turn : -turn), isMirrored};
}

std::int32_t Mover::scaledSymbol(std::int32_t symbol, double factor) {
    if (factor == 1.0 || symbol < 0) {
        return symbol;
    }
    const auto [found, isNew] =
        m_scaled.try_emplace({symbol, factor}, static_cast<std::int32_t>(m_image.symbols.size()));
    if (isNew) {
        const formats::DrawnSymbol& old = m_image.symbols[static_cast<std::size_t>(symbol)];
        m_image.symbols.push_back({old.name + " scaled " + shortNumber(factor), scaled(old.shape, factor)});
    }
    return found->second;
}

std::int32_t Mover::turnedSymbol(std::int32_t symbol, const Placement& placement) {
    if (symbol < 0 || (placement.clockwiseDeg == 0.0 && !placement.isMirrored)) {
        return symbol;
    }
    const formats::PadShape::Kind kind = m_image.symbols[static_cast<std::size_t>(symbol)].shape.kind;
    if (kind != formats::PadShape::Kind::Oval && kind != formats::PadShape::Kind::Region) {
        return symbol;
    }
    const auto [found, isNew] = m_turned.try_emplace({symbol, placement.clockwiseDeg, placement.isMirrored},
                                                     static_cast<std::int32_t>(m_image.symbols.size()));
    if (isNew) {
        const formats::DrawnSymbol& old = m_image.symbols[static_cast<std::size_t>(symbol)];
        m_image.symbols.push_back(
            {old.name + " rotated " + shortNumber(360.0 - placement.clockwiseDeg), turned(old.shape, placement)});
    }
    return found->second;
}

std::int32_t Mover::scaledRegion(std::int32_t region, double factor) {
    if (factor == 1.0 || region < 0) {
        return region;
    }
    const auto [found, isNew] =
        m_scaledRegions.try_emplace({region, factor}, static_cast<std::int32_t>(m_image.regions.size()));
    if (isNew) {
        formats::PadShape shape;
        shape.region = m_image.regions[static_cast<std::size_t>(region)];
        m_image.regions.push_back(scaled(shape, factor).region);
    }
    return found->second;
}

bool Mover::move(formats::DrawnFeature& feature, const Transform& transform) {
    using formats::DrawnKind;
    feature.isNegative = feature.isNegative != transform.isInverted;
    const std::optional<Point> a = moved(feature.a, transform);
    const std::optional<Point> b = moved(feature.b, transform);
    const std::optional<Point> centre = moved(feature.centre, transform);
    if (!a || !b || !centre) {
        return false;
    }
    feature.a = *a;
    const bool isDrawn = feature.kind == DrawnKind::Line || feature.kind == DrawnKind::Arc;
    if (isDrawn) {
        feature.b = *b;
        feature.centre = *centre;
        feature.isClockwise = feature.isClockwise != transform.placement.isMirrored;
        feature.symbol = turnedSymbol(scaledSymbol(feature.symbol, transform.scale), transform.placement);
        return true;
    }
    const Placement turn = Placement{{}, transform.placement.clockwiseDeg, transform.placement.isMirrored}.after(
        {{}, feature.clockwiseDeg, feature.isMirrored});
    feature.clockwiseDeg = normalised(turn.clockwiseDeg);
    feature.isMirrored = turn.isMirrored;
    feature.symbol = scaledSymbol(feature.symbol, transform.scale);
    feature.region = scaledRegion(feature.region, transform.scale);
    return true;
}

}  // namespace model::gerber
