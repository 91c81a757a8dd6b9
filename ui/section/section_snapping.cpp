// Where the pointer catches the edges of a cross-section.

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/section/section_view.h"

namespace ui {

namespace {

using model::SectionPiece;
using model::SectionPosition;

constexpr double kCatchPixels = 6.0;  // around edges and corners that are measured
constexpr double kSame = 1.5;         // nm: job files and sums of lengths are rounded

/// A location and how far it is from the pointer, in pixels.
struct Candidate {
    SectionPosition position;
    double far = 2.0 * kCatchPixels;
    /// Corners first, then what is nearer.
    [[nodiscard]] bool isBefore(const Candidate& other) const {
        const bool isCorner = position.isOnUpright && position.isOnLevel;
        const bool isOtherCorner = other.position.isOnUpright && other.position.isOnLevel;
        return isCorner == isOtherCorner ? far < other.far : isCorner;
    }
};

double apart(QPointF a, QPointF b) {
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

std::array<SectionPosition, 4> cornersOf(const SectionPiece& piece) {
    const auto bottom = static_cast<double>(piece.bottom);
    const auto top = static_cast<double>(piece.top);
    return {{{piece.from, bottom, true, true},
             {piece.to, bottom, true, true},
             {piece.upperTo(), top, true, true},
             {piece.upperFrom(), top, true, true}}};
}

}  // namespace

std::optional<SectionPosition> SectionView::locationAt(QPointF at) const {
    // The ends of a line that is shown whole lie on the rim of the plot.
    if (!m_section || !plot().adjusted(-kCatchPixels, -kCatchPixels, kCatchPixels, kCatchPixels).contains(at)) {
        return std::nullopt;
    }
    std::optional<Candidate> best;
    const auto offer = [&](const SectionPosition& position, double far, double reach) {
        const Candidate candidate{position, far};
        if (far <= reach && (!best || candidate.isBefore(*best))) {
            best = candidate;
        }
    };
    const QPointF zero = positionOf(0.0, 0.0);
    const double along = (at.x() - zero.x()) / m_perNm;
    const double z = (zero.y() - at.y()) / m_perNm / m_times;
    const double reach = kCatchPixels / m_perNm;
    for (const SectionPiece& piece : m_drawn) {
        if (along < piece.least() - reach || along > piece.most() + reach) {
            continue;
        }
        const std::array<SectionPosition, 4> corners = cornersOf(piece);
        for (const SectionPosition& corner : corners) {
            offer(corner, apart(positionOf(corner.along, corner.z), at), std::sqrt(2.0) * kCatchPixels);
        }
        for (const std::size_t level : {0U, 2U}) {
            const SectionPosition on{along, corners[level].z, false, true};
            const auto [least, most] = std::minmax(corners[level].along, corners[level + 1].along);
            if (along >= least && along <= most) {
                offer(on, apart(positionOf(on.along, on.z), at), kCatchPixels);
            }
        }
        for (const std::size_t side : {0U, 1U}) {
            const SectionPosition on{corners[side].along, z, true, false};
            if (!piece.leans() && z >= static_cast<double>(piece.bottom) && z <= static_cast<double>(piece.top)) {
                offer(on, apart(positionOf(on.along, on.z), at), kCatchPixels);
            }
        }
    }
    return best ? std::optional(best->position) : std::nullopt;
}

bool SectionView::isEdge(const SectionPosition& position) const {
    return std::ranges::any_of(m_drawn, [&](const SectionPiece& piece) {
        return std::ranges::any_of(cornersOf(piece), [&](const SectionPosition& corner) {
            return (!position.isOnUpright || std::abs(corner.along - position.along) <= kSame) &&
                   (!position.isOnLevel || std::abs(corner.z - position.z) <= kSame);
        });
    });
}

bool SectionView::isStale(const model::SectionDimension& dimension) const {
    return !isEdge(dimension.from) || !isEdge(dimension.to);
}

}  // namespace ui
