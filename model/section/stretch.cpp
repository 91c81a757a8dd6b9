#include "model/section/stretch.h"

#include <algorithm>

namespace model {

namespace {

/// Outlines that share an edge go apart by less.
constexpr double kTouch = 1'000.0;

bool holds(const Intervals& intervals, double at) {
    return std::ranges::any_of(intervals, [at](const Interval& i) { return i.from <= at && at <= i.to; });
}

/// Which rows of the stackup are at a location.
std::vector<bool> rowsAt(const Document& board, const LayerRanges& ranges, double at) {
    return rowsWhere(board, [&](LayerId layer) {
        const auto range = ranges.find(layer);
        return range == ranges.end() || holds(range->second, at);
    });
}

Stretch stretchBetween(const Document& board, double from, double to, const LayerRanges& ranges,
                       const std::vector<BoardFace>& whole, bool isAsSolid) {
    const std::vector<bool> has = rowsAt(board, ranges, (from + to) / 2);
    Stretch stretch{from, to, LocalStack(board, has), whole, dielectricBandsOf(board, has), {}, !ranges.empty()};
    if (isAsSolid || ranges.empty()) {
        return stretch;
    }
    stretch.faces.clear();
    stretch.core = ZRange{};
    for (const bool isTop : {true, false}) {
        if (const std::optional<BoardFace> face = stretch.stack.outerFace(isTop)) {
            stretch.faces.push_back(*face);
            (isTop ? stretch.core->top : stretch.core->bottom) = face->copper;
        }
    }
    return stretch;
}

}  // namespace

std::vector<Stretch> stretchesBetween(const Document& board, double from, double to, const LayerRanges& ranges,
                                      const std::vector<BoardFace>& whole, bool isAsSolid) {
    std::vector<double> ends{from, to};
    for (const auto& [layer, intervals] : ranges) {
        for (const Interval& interval : intervals) {
            ends.push_back(std::clamp(interval.from, from, to));
            ends.push_back(std::clamp(interval.to, from, to));
        }
    }
    std::ranges::sort(ends);
    std::vector<Stretch> stretches;
    double start = from;
    for (const double end : ends) {
        if (end - start > kTouch || (end == to && end > start)) {
            stretches.push_back(stretchBetween(board, start, end, ranges, whole, isAsSolid));
            start = end;
        }
    }
    return stretches;
}

std::optional<SectionPiece> alongPart(SectionPiece piece, double from, double to) {
    piece.from = std::max(piece.from, from);
    piece.to = std::min(piece.to, to);
    return piece.from < piece.to ? std::optional(piece) : std::nullopt;
}

void joinAlong(std::vector<SectionPiece>& pieces) {
    std::vector<SectionPiece> out;
    for (const SectionPiece& piece : pieces) {
        const auto before = std::ranges::find_if(out, [&](const SectionPiece& other) {
            return !piece.leans() && !other.leans() && other.to == piece.from && other.bottom == piece.bottom &&
                   other.top == piece.top && other.material == piece.material && other.stackupRow == piece.stackupRow;
        });
        if (before != out.end()) {
            before->to = piece.to;
        } else {
            out.push_back(piece);
        }
    }
    pieces = std::move(out);
}

void fitHoles(const std::vector<Stretch>& stretches, std::vector<SectionPiece>& pieces,
              const std::function<bool(const SectionPiece&)>& isHole) {
    std::vector<SectionPiece> out;
    for (const SectionPiece& piece : pieces) {
        if (!isHole(piece) || !stretches.front().core) {
            out.push_back(piece);
            continue;
        }
        std::vector<SectionPiece> parts;
        for (const Stretch& stretch : stretches) {
            if (auto part = alongPart(piece, stretch.from, stretch.to); part && stretch.core) {
                part->bottom = std::max(part->bottom, stretch.core->bottom);
                part->top = std::min(part->top, stretch.core->top);
                parts.push_back(*part);
            }
        }
        std::erase_if(parts, [](const SectionPiece& part) { return part.bottom >= part.top; });
        joinAlong(parts);
        out.insert(out.end(), parts.begin(), parts.end());
    }
    pieces = std::move(out);
}

}  // namespace model
