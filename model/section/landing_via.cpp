#include "model/section/landing_via.h"

#include <algorithm>
#include <cmath>

namespace model {

namespace {

constexpr int kSteps = 8;

double half(double radius, double beside) {
    return radius > beside ? std::sqrt((radius - beside) * (radius + beside)) : 0.0;
}

/// Heights, rising, between which the sides of the cone count as straight.
std::vector<Nm> stepsOf(const LandingVia& via, Nm bottom, Nm top) {
    const double direction = via.entry > via.target ? 1.0 : -1.0;
    const Nm floor = via.target + static_cast<Nm>(std::lround(direction * via.wall));
    std::vector<Nm> heights{bottom, top, via.entry, via.shoulder, via.target, floor};
    const int steps = via.beside == 0.0 ? 1 : kSteps;
    for (int i = 1; i < steps; ++i) {
        heights.push_back(via.target +
                          static_cast<Nm>(std::llround((double{1} * via.shoulder - via.target) * i / steps)));
    }
    std::erase_if(heights, [=](Nm z) { return z < bottom || z > top; });
    std::ranges::sort(heights);
    heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
    return heights;
}

/// From one pair of halves at the lower to another at the upper edge, on one side of the middle or on both.
class Pieces {
public:
    Pieces(const LandingVia& via, const SectionPiece& like) : m_middle(via.middle), m_like(like) {}

    void setHeights(Nm bottom, Nm top) {
        m_like.bottom = bottom;
        m_like.top = top;
    }
    void addBetween(double lowerFrom, double lowerTo, double upperFrom, double upperTo) {
        if (lowerTo - lowerFrom <= 0.0 && upperTo - upperFrom <= 0.0) {
            return;
        }
        m_like.from = m_middle + lowerFrom;
        m_like.to = m_middle + lowerTo;
        m_like.leanFrom = upperFrom - lowerFrom;
        m_like.leanTo = upperTo - lowerTo;
        pieces.push_back(m_like);
    }
    void addBothSides(double lowerInner, double lowerOuter, double upperInner, double upperOuter) {
        addBetween(-lowerOuter, -lowerInner, -upperOuter, -upperInner);
        addBetween(lowerInner, lowerOuter, upperInner, upperOuter);
    }

    std::vector<SectionPiece> pieces;

private:
    double m_middle;
    SectionPiece m_like;
};

}  // namespace

double LandingVia::radiusAt(double z) const {
    const double depth = std::clamp((shoulder - z) / (double{1} * shoulder - target), 0.0, 1.0);
    return radius * (1.0 - (1.0 - taper) * depth);
}

double LandingVia::outerHalf(double z) const {
    return half(radiusAt(z), beside);
}

double LandingVia::innerHalf(double z) const {
    return half(radiusAt(z) - wall, beside);
}

std::vector<SectionPiece> platingOf(const LandingVia& via, const SectionPiece& like) {
    Pieces out(via, like);
    const std::vector<Nm> heights = stepsOf(via, std::min(via.entry, via.target), std::max(via.entry, via.target));
    for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
        const double low = heights[i];
        const double high = heights[i + 1];
        out.setHeights(heights[i], heights[i + 1]);
        const bool isFloor = std::abs((low + high) / 2 - via.target) < via.wall;
        if (isFloor || (via.innerHalf(low) <= 0.0 && via.innerHalf(high) <= 0.0)) {
            out.addBetween(-via.outerHalf(low), via.outerHalf(low), -via.outerHalf(high), via.outerHalf(high));
        } else {
            out.addBothSides(via.innerHalf(low), via.outerHalf(low), via.innerHalf(high), via.outerHalf(high));
        }
    }
    return std::move(out.pieces);
}

std::vector<SectionPiece> besideVia(const LandingVia& via, const SectionPiece& like) {
    Pieces out(via, like);
    const double drilled = half(via.radius, via.beside);
    const Nm bottom = std::max(like.bottom, std::min(via.shoulder, via.target));
    const Nm top = std::min(like.top, std::max(via.shoulder, via.target));
    if (bottom >= top) {
        return {};
    }
    const std::vector<Nm> heights = stepsOf(via, bottom, top);
    for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
        out.setHeights(heights[i], heights[i + 1]);
        out.addBothSides(via.outerHalf(heights[i]), drilled, via.outerHalf(heights[i + 1]), drilled);
    }
    return std::move(out.pieces);
}

}  // namespace model
