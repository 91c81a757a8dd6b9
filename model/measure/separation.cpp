#include "model/measure/separation.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "model/board/copies.h"
#include "model/figures/distance.h"
#include "model/figures/overlap.h"
#include "model/geometry/box_index.h"
#include "model/geometry/curve_edges.h"
#include "model/measure/hole_ring.h"
#include "model/text/formatting.h"

namespace model {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// So many overlapping pairs of two items are tested for the deepest.
constexpr std::size_t kMostOverlaps = 256;

double apart(Nm highOfLower, Nm lowOfUpper) {
    return std::max(0.0, static_cast<double>(lowOfUpper) - highOfLower);
}

double heightBetween(const Piece& a, const Piece& b) {
    return std::max(apart(a.z.top, b.z.bottom), apart(b.z.top, a.z.bottom));
}

/// Which pairs of pieces count, and how far apart their heights are.
using Heights = std::function<std::optional<double>(const Piece&, const Piece&)>;

std::optional<double> inPlane(const Piece&, const Piece&) {
    return 0.0;
}

std::optional<double> onLayer(const Piece& a, const Piece& b) {
    return a.sharesLayerWith(b) ? std::optional(0.0) : std::nullopt;
}

std::optional<double> throughStackup(const Piece& a, const Piece& b) {
    return a.hasHeights && b.hasHeights ? std::optional(heightBetween(a, b)) : std::nullopt;
}

Box grown(const Box& box, double reach) {
    return box.grownBy(static_cast<Nm>(std::min(std::ceil(reach), double{base::kMaxCoordinate} / 2)) + 1);
}

PointD middleOf(const Box& box) {
    return {(double(box.min.x) + box.max.x) / 2, (double(box.min.y) + box.max.y) / 2};
}

/// Finds the closest pair of pieces of two items.
class ClosestPieces {
public:
    ClosestPieces(const Pieces& a, const Pieces& b, const BoxIndex& indexOfB, base::Progress& progress)
        : m_a(a), m_b(b), m_indexOfB(indexOfB), m_progress(progress) {}

    /// With the relation of all pairs that meet.
    std::optional<PieceDistance> findRelated(const Heights& heights) {
        if (find(heights)) {
            findRelation();
        }
        return m_best;
    }

    /// Without: it says Apart.
    std::optional<PieceDistance> find(const Heights& heights) {
        m_best.reset();
        m_limit = kInfinity;
        const bool isOnePair = m_a.pieces.size() == 1 && m_b.pieces.size() == 1;
        if (!isOnePair && !guess(heights)) {
            return std::nullopt;
        }
        m_meeting.clear();
        std::vector<std::uint32_t> near;
        for (std::size_t i = 0; i < m_a.pieces.size() && !m_progress.isCancelled(); ++i) {
            near.clear();
            m_indexOfB.visit(grown(m_a.figures.box(i), m_limit), [&](std::uint32_t j) { near.push_back(j); });
            std::ranges::sort(near);
            for (const std::uint32_t j : near) {
                compare(i, j, heights);
            }
        }
        return m_best;
    }

private:
    /// A first limit, so that the search begins with little: from one piece to what is near it, and back. False if no
    /// pair counts.
    bool guess(const Heights& heights) {
        std::size_t a = 0;
        std::size_t b = m_b.pieces.size();
        for (; a < m_a.pieces.size() && b == m_b.pieces.size(); ++a) {
            b = nearestTo(m_a.figures.box(a), m_b, m_a.pieces[a], heights);
        }
        if (b == m_b.pieces.size()) {
            return false;
        }
        --a;
        for (int round = 0; round < 3; ++round) {
            compare(a, b, heights);
            const std::pair before(a, b);
            a = nearestTo(m_b.figures.box(b), m_a, m_b.pieces[b], heights);
            b = nearestTo(m_a.figures.box(a), m_b, m_a.pieces[a], heights);
            if (before == std::pair(a, b)) {
                break;
            }
        }
        return true;
    }

    static std::size_t nearestTo(const Box& from, const Pieces& to, const Piece& piece, const Heights& heights) {
        std::size_t nearest = to.pieces.size();
        double least = kInfinity;
        const PointD middle = middleOf(from);
        for (std::size_t row = 0; row < to.pieces.size(); ++row) {
            const PointD other = middleOf(to.figures.box(row));
            const double distance = std::hypot(other.x - middle.x, other.y - middle.y);
            if (distance < least && heights(piece, to.pieces[row])) {
                least = distance;
                nearest = row;
            }
        }
        return nearest;
    }

    void compare(std::size_t i, std::size_t j, const Heights& heights) {
        const std::optional<double> dz = heights(m_a.pieces[i], m_b.pieces[j]);
        if (!dz || *dz > m_limit) {
            return;
        }
        const double limit = m_limit == kInfinity ? kInfinity : std::sqrt(m_limit * m_limit - *dz * *dz);
        const std::optional<Spacing> spacing =
            spacingBetween(m_a.figures, i, m_b.figures, j, std::max(limit, kTouchNm));
        if (!spacing) {
            return;
        }
        const double distance = *dz > 0 ? std::hypot(spacing->distance, *dz) : spacing->distance;
        if (*dz == 0 && distance <= kTouchNm && m_meeting.size() <= kMostOverlaps) {
            m_meeting.push_back({i, j, spacing->from});
        }
        if (!m_best || distance < m_best->distance) {
            m_best = PieceDistance{*spacing, *dz, distance, m_a.pieces[i], m_b.pieces[j], Relation::Apart, 0.0, true};
            m_limit = std::max(distance, kTouchNm);
        }
    }

    /// Touching, or overlapping and by how much: the deepest of all pairs that meet.
    void findRelation() {
        for (const Meeting& pair : m_meeting) {
            const Overlap& overlap = overlapOf(pair);
            if (m_best->relation == Relation::Apart || overlap.depth > m_best->overlap) {
                m_best->relation = overlap.depth > kTouchNm ? Relation::Overlapping : Relation::Touching;
                m_best->overlap = overlap.depth;
                m_best->isOverlapExact = overlap.isExact;
                m_best->spacing = {0.0, pair.location, pair.location};
                m_best->distance = 0.0;
                m_best->from = m_a.pieces[pair.a];
                m_best->to = m_b.pieces[pair.b];
            }
        }
        const bool isOnePair = m_a.pieces.size() == 1 && m_b.pieces.size() == 1;
        m_best->isOverlapExact = m_best->isOverlapExact && isOnePair;
    }

    struct Meeting {
        std::size_t a = 0;
        std::size_t b = 0;
        PointD location;
    };

    /// Pairs that meet in the plane meet on their layer and through the stackup as well.
    const Overlap& overlapOf(const Meeting& pair) {
        const auto [known, isNew] = m_overlaps.try_emplace({pair.a, pair.b});
        if (isNew) {
            known->second = overlapBetween(m_a.figures, pair.a, m_b.figures, pair.b, pair.location);
        }
        return known->second;
    }

    const Pieces& m_a;
    const Pieces& m_b;
    const BoxIndex& m_indexOfB;
    base::Progress& m_progress;
    std::optional<PieceDistance> m_best;
    double m_limit = kInfinity;
    std::vector<Meeting> m_meeting;
    std::map<std::pair<std::size_t, std::size_t>, Overlap> m_overlaps;
};

/// Says why there is nothing to measure; empty if there is.
std::string whyNothing(const BoardIndex& index, const MeasureItem& a, const std::vector<BoardElement>& inA,
                       const MeasureItem& b, const std::vector<BoardElement>& inB) {
    std::vector<BoardElement> both;
    std::ranges::set_intersection(inA, inB, std::back_inserter(both));
    const bool areEdges = std::holds_alternative<BoardEdge>(a) && std::holds_alternative<BoardEdge>(b);
    if ((!both.empty() && both.size() == inA.size() && both.size() == inB.size()) || areEdges) {
        return "both are the same";
    }
    if (!both.empty() && (both.size() == inA.size() || both.size() == inB.size())) {
        const bool isAPart = both.size() == inA.size();
        return nameOf(index, isAPart ? a : b) + " is part of " + nameOf(index, isAPart ? b : a);
    }
    return both.empty() ? "" : nameOf(index, a) + " and " + nameOf(index, b) + " share copper";
}

void noteOnEmpty(const BoardIndex& index, const MeasureItem& item, const Pieces& pieces, Separation& separation) {
    if (pieces.pieces.empty()) {
        const bool isEdge = std::holds_alternative<BoardEdge>(item);
        const bool isPart = std::holds_alternative<PartOfCopy>(item) || std::holds_alternative<PinOfCopy>(item);
        separation.notes.push_back(isEdge   ? "the board has no outline"
                                   : isPart ? "the job ties no copper to " + nameOf(index, item)
                                            : nameOf(index, item) + " covers nothing, so it has no distance");
    } else if (!pieces.empty.empty()) {
        separation.notes.push_back(std::to_string(pieces.empty.size()) + " tracks of " + nameOf(index, item) +
                                   " have no width and were left out");
    }
}

/// One net, no common layer, no heights, assumed thicknesses.
void noteOnStackup(const BoardIndex& index, Separation& separation) {
    const NetId netA = netOf(index, separation.inPlane->from.at);
    const NetId netB = netOf(index, separation.inPlane->to.at);
    const bool isOneStep = separation.inPlane->from.at.copy == separation.inPlane->to.at.copy;
    if (netA.isValid() && netA == netB && isOneStep) {
        const NetOfCopy net{separation.inPlane->from.at.copy, netA};
        separation.notes.push_back("both are of " + nameOf(index, net));
    }
    if (!separation.onLayer) {
        separation.notes.push_back("no common layer");
    }
    if (!separation.throughStackup) {
        separation.notes.push_back("one of them is not in the stackup, so the distance is in the plane only");
        return;
    }
    const PieceDistance& shortest = *separation.throughStackup;
    if (shortest.dz > 0) {
        if (std::string note = noteOnHeight(*index.board, shortest.from.z, shortest.to.z); !note.empty()) {
            separation.notes.push_back(std::move(note));
        }
    }
}

void noteOnEdge(const BoardIndex& index, const MeasureItem& edge, const PieceDistance& shortest, bool isFromEdge,
                std::vector<std::string>& notes) {
    const Document& board = *index.board;
    if (!std::holds_alternative<BoardEdge>(edge) || shortest.distance <= kTouchNm) {
        return;
    }
    const PointD location = isFromEdge ? shortest.spacing.to : shortest.spacing.from;
    int winding = 0;
    for (const Contour& contour : board.shapes.contoursOf(board.profile)) {
        int around = 0;
        forEachEdge(board.shapes.nodesOf(contour), [&](const Edge& side) { around += windingAround(side, location); });
        winding += around != 0 ? (contour.isHole ? -1 : 1) : 0;
    }
    if (winding <= 0) {
        notes.push_back("it lies outside of the board");
    }
}

/// First: it is what people want to know of a hole and its pad.
void findRing(const BoardIndex& index, const Pieces& a, const Pieces& b, Separation& separation) {
    separation.annularRing = annularRing(index, a, b);
    if (separation.annularRing) {
        const double width = separation.annularRing->distance;
        separation.notes.insert(separation.notes.begin(), kAnnularRing + fixedText(base::toMm(width), 6) + " mm (" +
                                                              fixedText(width / base::kNmPerMil, 3) + " mil)");
    }
}

/// The heights from `low` to `high` that layers lying one on the other lead to: from `low` upwards, or from `high`
/// downwards.
std::set<Nm> facesReached(const Stackup& stackup, Nm low, Nm high, bool isUpwards) {
    std::set<Nm> reached;
    std::vector<Nm> next{isUpwards ? low : high};
    while (!next.empty()) {
        const Nm face = next.back();
        next.pop_back();
        if (face < low || face > high || !reached.insert(face).second) {
            continue;
        }
        for (const StackupRow& row : stackup.rows) {
            const Nm top = row.z + row.thickness;
            if (face == (isUpwards ? row.z : top)) {
                next.push_back(isUpwards ? top : row.z);
            }
        }
    }
    return reached;
}

void noteOnNames(const BoardIndex& index, const MeasureItem& a, const MeasureItem& b, Separation& separation) {
    for (const MeasureItem* item : {&a, &b}) {
        if (std::string note = noteOnName(index, *item); !note.empty()) {
            separation.notes.push_back(std::move(note));
        }
    }
}

}  // namespace

const char* toString(Relation relation) {
    constexpr const char* kNames[] = {"apart", "touching", "overlapping"};
    return kNames[static_cast<std::size_t>(relation)];
}

std::vector<std::string> assumedBetween(const Document& board, Nm low, Nm high) {
    const std::set<Nm> above = facesReached(board.stackup, low, high, true);
    const std::set<Nm> below = facesReached(board.stackup, low, high, false);
    std::vector<std::string> names;
    for (const StackupRow& row : board.stackup.rows) {
        const Nm top = row.z + row.thickness;
        // Of heights that are no faces of the stackup every layer counts that lies between them in part.
        const bool counts =
            above.contains(high) ? above.contains(row.z) && below.contains(top) : row.z < high && top > low;
        if (row.source == Source::Assumed && counts) {
            names.push_back(row.name);
        }
    }
    return names;
}

std::string noteOnHeight(const Document& board, ZRange a, ZRange b) {
    const auto assumed = assumedBetween(board, std::min(a.top, b.top), std::max(a.bottom, b.bottom));
    return assumed.empty() ? "" : kHeightIsAssumed + joined(assumed);
}

std::string noteOnHeight(const Document& board, LayerId a, LayerId b) {
    if (model::heightBetween(board, a, b).value_or(0.0) <= 0) {
        return {};
    }
    return noteOnHeight(board, heightsInCopy(board, a, false), heightsInCopy(board, b, false));
}

base::Result<Separation> separationOf(const BoardIndex& index, const MeasureItem& a, const MeasureItem& b,
                                      base::Progress& progress, Depths depths) {
    progress.beginPhase("Measuring");
    Separation separation;
    const Pieces piecesA = piecesOf(index, a);
    const Pieces piecesB = piecesOf(index, b);
    if (std::string why = whyNothing(index, a, piecesA.elements, b, piecesB.elements); !why.empty()) {
        separation.notes.push_back(std::move(why));
        noteOnNames(index, a, b, separation);
        return separation;
    }
    noteOnEmpty(index, a, piecesA, separation);
    noteOnEmpty(index, b, piecesB, separation);
    if (piecesA.pieces.empty() || piecesB.pieces.empty()) {
        return separation;
    }
    const BoxIndex indexOfB(piecesB.figures.outerBoxes());
    ClosestPieces closest(piecesA, piecesB, indexOfB, progress);
    const auto find = [&](const Heights& heights, bool isMain) {
        return isMain || depths == Depths::OfAll ? closest.findRelated(heights) : closest.find(heights);
    };
    separation.onLayer = find(onLayer, true);
    separation.throughStackup = find(throughStackup, separation.main() == nullptr);
    separation.inPlane = find(inPlane, separation.main() == nullptr);
    if (progress.isCancelled()) {
        return base::Error{base::ErrorCode::Cancelled, "cancelled"};
    }
    noteOnStackup(index, separation);
    noteOnEdge(index, a, *separation.inPlane, true, separation.notes);
    noteOnEdge(index, b, *separation.inPlane, false, separation.notes);
    findRing(index, piecesA, piecesB, separation);
    noteOnNames(index, a, b, separation);
    return separation;
}

std::optional<PieceDistance> closestOnLayer(const BoardIndex& index, const MeasureItem& a, const MeasureItem& b,
                                            base::Progress& progress) {
    progress.beginPhase("Measuring");
    const Pieces piecesA = piecesOf(index, a);
    const Pieces piecesB = piecesOf(index, b);
    const BoxIndex indexOfB(piecesB.figures.outerBoxes());
    return ClosestPieces(piecesA, piecesB, indexOfB, progress).find(onLayer);
}

}  // namespace model
