#include "model/section/inner_copper.h"

#include <algorithm>

namespace model {

namespace {

void addAlong(SectionPiece piece, const Intervals& locations, std::vector<SectionPiece>& out) {
    for (const Interval& location : locations) {
        piece.from = location.from;
        piece.to = location.to;
        out.push_back(piece);
    }
}

/// What is left of a piece that copper of these heights meets.
void addLeft(const SectionPiece& piece, const std::pair<Nm, Nm>& heights, const Intervals& copper,
             std::vector<SectionPiece>& out) {
    const Intervals all{{piece.from, piece.to}};
    const Intervals beside = subtracted(all, copper);
    addAlong(piece, beside, out);
    const Intervals met = subtracted(all, beside);
    SectionPiece part = piece;
    part.top = heights.first;
    if (part.bottom < part.top) {
        addAlong(part, met, out);
    }
    part = piece;
    part.bottom = heights.second;
    if (part.bottom < part.top) {
        addAlong(part, met, out);
    }
}

}  // namespace

InnerCopper::InnerCopper(const std::vector<SectionPiece>& pieces) {
    std::map<std::pair<Nm, Nm>, std::vector<Interval>> found;
    for (const SectionPiece& piece : pieces) {
        if (piece.material == SectionMaterial::Copper && !piece.leans() && piece.bottom < piece.top) {
            found[{piece.bottom, piece.top}].push_back({piece.from, piece.to});
        }
    }
    for (auto& [heights, locations] : found) {
        m_byHeight[heights] = united(std::move(locations));
    }
}

std::vector<SectionPiece> InnerCopper::leftOf(const SectionPiece& dielectric) const {
    std::vector<SectionPiece> left{dielectric};
    for (const auto& [heights, locations] : m_byHeight) {
        std::vector<SectionPiece> next;
        for (const SectionPiece& piece : left) {
            if (heights.first < piece.top && heights.second > piece.bottom) {
                addLeft(piece, heights, locations, next);
            } else {
                next.push_back(piece);
            }
        }
        left = std::move(next);
    }
    return left;
}

}  // namespace model
