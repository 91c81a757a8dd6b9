#include "model/formats/gerber/outline.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "model/formats/common/outline_gaps.h"
#include "model/geometry/edges.h"
#include "model/geometry/vectors.h"

namespace model::gerber {

namespace {

using formats::DrawnFeature;
using formats::DrawnKind;

constexpr std::size_t kMostLoops = 4'000;
/// Ends nearer than this are one: most programs meet exactly, some draw with a grid of 10 µm.
constexpr Nm kReaches[] = {0, 2'000, 50'000};

struct Track {
    PathNode from;
    Point to;
    bool isUsed = false;    ///< in a walk
    bool isClosed = false;  ///< part of a loop
};

using Loop = std::vector<PathNode>;

PathNode reversedNode(const Track& track) {
    PathNode node = track.from;
    node.point = track.to;
    node.edge = reversed(node.edge);
    return node;
}

/// Finds numbered points near a point.
class Places {
public:
    explicit Places(Nm reach) : m_reach(reach), m_cell(std::max(reach, 1)) {}

    void add(Point p, std::uint32_t number) { m_points[key(p)].push_back({p, number}); }
    void removeLast(Point p) { m_points[key(p)].pop_back(); }

    /// The nearest one within reach that counts.
    template <class Counts>
    [[nodiscard]] std::optional<std::uint32_t> near(Point p, Counts counts) const {
        std::optional<std::uint32_t> best;
        double least = static_cast<double>(m_reach) + 0.5;
        const Nm step = m_reach == 0 ? 0 : m_cell;
        for (Nm dx = -step; dx <= step; dx += m_cell) {
            for (Nm dy = -step; dy <= step; dy += m_cell) {
                const auto found = m_points.find(key({p.x + dx, p.y + dy}));
                if (found == m_points.end()) {
                    continue;
                }
                for (const auto& [point, number] : found->second) {
                    if (distance(point, p) < least && counts(number)) {
                        least = distance(point, p);
                        best = number;
                    }
                }
            }
        }
        return best;
    }

private:
    [[nodiscard]] std::uint64_t key(Point p) const {
        const auto cell = [&](Nm v) { return static_cast<std::uint32_t>((std::int64_t{v} + (1LL << 31)) / m_cell); };
        return (std::uint64_t{cell(p.x)} << 32) | cell(p.y);
    }

    Nm m_reach;
    Nm m_cell;
    std::unordered_map<std::uint64_t, std::vector<std::pair<Point, std::uint32_t>>> m_points;
};

class Chainer {
public:
    explicit Chainer(const Image& image) {
        for (const DrawnFeature& feature : image.features) {
            take(feature, image);
        }
    }

    /// Closed loops; those that meet exactly first, what is left with wider joints.
    std::vector<Loop> run() {
        for (const Nm reach : kReaches) {
            Places ends(reach);
            for (std::uint32_t i = 0; i < m_tracks.size(); ++i) {
                m_tracks[i].isUsed = m_tracks[i].isClosed;
                if (!m_tracks[i].isUsed) {
                    ends.add(m_tracks[i].from.point, i);
                    ends.add(m_tracks[i].to, i);
                }
            }
            for (std::uint32_t i = 0; i < m_tracks.size(); ++i) {
                if (!m_tracks[i].isUsed) {
                    follow(i, ends, reach);
                }
            }
        }
        return std::move(m_loops);
    }

    [[nodiscard]] std::size_t openTracks() const {
        return static_cast<std::size_t>(std::ranges::count(m_tracks, false, &Track::isClosed));
    }
    [[nodiscard]] Nm widestJoint() const { return m_widestJoint; }
    /// What is part of no loop.
    [[nodiscard]] std::vector<formats::OutlineTrack> openOnes() const {
        std::vector<formats::OutlineTrack> open;
        for (const Track& track : m_tracks) {
            if (!track.isClosed) {
                open.push_back({track.from, track.to});
            }
        }
        return open;
    }

private:
    void take(const DrawnFeature& feature, const Image& image) {
        if (feature.kind == DrawnKind::Region) {
            const ShapeSketch& sketch = image.regions[static_cast<std::size_t>(feature.region)];
            for (std::size_t i = 0; i < sketch.contourCount(); ++i) {
                const PathNodes nodes = sketch.contour(i);
                m_loops.emplace_back(nodes.begin(), nodes.end());
            }
            return;
        }
        if (feature.kind == DrawnKind::Pad || feature.isNegative) {
            return;
        }
        const EdgeKind edge = feature.kind == DrawnKind::Line ? EdgeKind::Line
                              : feature.isClockwise           ? EdgeKind::ArcClockwise
                                                              : EdgeKind::ArcCounterClockwise;
        if (feature.a == feature.b) {
            if (edge != EdgeKind::Line) {
                m_loops.push_back({{feature.a, feature.centre, edge}});
            }
            return;
        }
        const PathNode node{feature.a, edge == EdgeKind::Line ? Point{} : feature.centre, edge};
        const Track track{node, feature.b};
        if (isNew(track)) {
            m_tracks.push_back(track);
        }
    }

    /// Some outlines are drawn twice, or there and back: such lines would close with each other, and not around the
    /// board.
    bool isNew(const Track& track) {
        constexpr double kSameCentre = 5'000.0;
        const bool isForward = track.from.point < track.to;
        const PathNode start = isForward ? track.from : reversedNode(track);
        const Point end = isForward ? track.to : track.from.point;
        std::vector<Point>& centres = m_drawn[{start.point, end, start.edge}];
        const bool isThere = std::ranges::any_of(
            centres, [&](Point centre) { return distance(centre, track.from.centre) <= kSameCentre; });
        if (!isThere) {
            centres.push_back(track.from.centre);
        }
        return !isThere;
    }

    /// Walks along free tracks. Where the walk meets itself, the loop is taken out; where it ends, it goes back a
    /// track.
    void follow(std::uint32_t first, const Places& ends, Nm reach) {
        std::vector<std::uint32_t> chain;  ///< tracks
        Loop nodes;                        ///< where each of them starts
        Places starts(reach);
        Point at = m_tracks[first].from.point;
        std::optional<std::uint32_t> next = first;
        for (;;) {
            if (next) {
                Track& track = m_tracks[*next];
                track.isUsed = true;
                const bool isForward = distance(track.from.point, at) <= distance(track.to, at);
                starts.add((isForward ? track.from : reversedNode(track)).point,
                           static_cast<std::uint32_t>(nodes.size()));
                chain.push_back(*next);
                nodes.push_back(isForward ? track.from : reversedNode(track));
                at = isForward ? track.to : track.from.point;
            }
            const auto all = [](std::uint32_t) { return true; };
            if (const std::optional<std::uint32_t> begin = next ? starts.near(at, all) : std::nullopt) {
                at = close(*begin, at, chain, nodes, starts);
            } else if (!next) {
                chain.pop_back();  // a dead end: its track stays used, for this walk
                starts.removeLast(nodes.back().point);
                at = nodes.back().point;
                nodes.pop_back();
            }
            if (chain.empty()) {
                return;
            }
            next = ends.near(at, [&](std::uint32_t i) { return !m_tracks[i].isUsed; });
        }
    }

    /// Takes the loop out that begins with the node `begin` and ends at `at`; gives back where the rest of the walk is.
    Point close(std::uint32_t begin, Point at, std::vector<std::uint32_t>& chain, Loop& nodes, Places& starts) {
        Loop loop(nodes.begin() + begin, nodes.end());
        double joint = distance(at, loop.front().point);
        for (std::size_t i = begin; i < chain.size(); ++i) {
            m_tracks[chain[i]].isClosed = true;
            if (i > begin) {
                const Track& before = m_tracks[chain[i - 1]];
                const Point end = nodes[i - 1].point == before.from.point ? before.to : before.from.point;
                joint = std::max(joint, distance(end, nodes[i].point));
            }
        }
        m_widestJoint = std::max(m_widestJoint, static_cast<Nm>(joint));
        while (nodes.size() > begin) {
            starts.removeLast(nodes.back().point);
            nodes.pop_back();
            chain.pop_back();
        }
        const Point rest = loop.front().point;
        m_loops.push_back(std::move(loop));
        return rest;
    }

    std::vector<Track> m_tracks;
    std::map<std::tuple<Point, Point, EdgeKind>, std::vector<Point>> m_drawn;  ///< centres by ends and kind of edge
    std::vector<Loop> m_loops;
    Nm m_widestJoint = 0;
};

bool isInside(Point p, const Loop& loop) {
    int winding = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Edge edge = edgeOf(loop[i], loop[i + 1 < loop.size() ? i + 1 : 0].point);
        winding += windingAround(edge, base::toDouble(p));
    }
    return winding != 0;
}

double areaOf(const Box& box) {
    return static_cast<double>(box.width()) * static_cast<double>(box.height());
}

constexpr std::size_t kMostPlaces = 300;
/// The share of the copper that a board holds: some lies in frames.
constexpr double kMost = 0.9;
/// Closed loops that hold less are cut-outs and drawings.
constexpr double kLeastHeld = 0.5;
/// A ring around a fiducial in the frame of a panel is no board.
constexpr double kLeastShare = 0.02;
/// Mechanical layers with texts and dimensions have many more loops than any board has cut-outs.
constexpr std::size_t kMostCutouts = 500;

/// How many of the places lie inside, of a few hundred that are looked at.
double shareInside(std::span<const Point> copper, const Loop& loop, const Box& box) {
    const std::size_t step = copper.size() / kMostPlaces + 1;
    std::size_t count = 0;
    std::size_t inside = 0;
    for (std::size_t i = 0; i < copper.size(); i += step, ++count) {
        inside += box.holds(copper[i]) && isInside(copper[i], loop) ? 1 : 0;
    }
    return count == 0 ? 0.0 : static_cast<double>(inside) / static_cast<double>(count);
}

/// Closed loops by falling size, each once.
class Loops {
public:
    explicit Loops(std::vector<Loop> loops) {
        std::erase_if(loops, [](const Loop& loop) { return loop.size() < 2 && loop[0].edge == EdgeKind::Line; });
        std::vector<std::pair<Box, std::size_t>> order;
        for (std::size_t i = 0; i < loops.size(); ++i) {
            order.emplace_back(boxOfPath(loops[i], true), i);
        }
        std::ranges::stable_sort(order, [](const auto& a, const auto& b) { return areaOf(a.first) > areaOf(b.first); });
        for (const auto& [box, row] : order) {
            // Outlines are often drawn twice.
            const bool isNew = m_boxes.empty() || std::ranges::find(m_boxes, box) == m_boxes.end();
            if (areaOf(box) > 0 && isNew && m_loops.size() < kMostLoops) {
                m_loops.push_back(std::move(loops[row]));
                m_boxes.push_back(box);
            }
        }
    }

    [[nodiscard]] std::size_t size() const { return m_loops.size(); }
    [[nodiscard]] const Loop& loop(std::size_t i) const { return m_loops[i]; }
    [[nodiscard]] const Box& box(std::size_t i) const { return m_boxes[i]; }
    [[nodiscard]] bool holds(std::size_t outer, std::size_t inner) const {
        return m_boxes[outer].holds(m_boxes[inner].min) && m_boxes[outer].holds(m_boxes[inner].max) &&
               isInside(m_loops[inner][0].point, m_loops[outer]);
    }

private:
    std::vector<Loop> m_loops;
    std::vector<Box> m_boxes;
};

/// The share of the copper that lies in one of the loops; where there is none, of nothing, all of it.
double shareHeld(std::span<const Loop> loops, std::span<const Point> copper) {
    double share = copper.empty() && !loops.empty() ? 1.0 : 0.0;
    for (const Loop& loop : loops) {  // boards of a panel, each with its own
        share += shareInside(copper, loop, boxOfPath(loop, true));
    }
    return share;
}

/// Adds what holds most of the copper once its gaps are closed.
void bridge(const std::vector<formats::OutlineTrack>& open, std::span<const Point> copper, std::vector<Loop>& loops,
            Outline& outline) {
    for (formats::BridgedLoop& loop : formats::bridgedLoops(open, static_cast<double>(std::ranges::max(kReaches)))) {
        if (shareHeld(std::span(&loop.nodes, 1), copper) > kMost) {
            outline.gaps.push_back(formats::gapsText(loop));
            outline.openTracks -= loop.trackCount;
            loops.push_back(std::move(loop.nodes));
        }
    }
}

void add(Outline& outline, const Loop& loop, const Box& box, bool isHole) {
    outline.shape.beginContour(isHole);
    for (const PathNode& node : loop) {
        outline.shape.addNode(node);
    }
    outline.box.include(box);
}

}  // namespace

Outline outlineOf(const Image& image, std::span<const Point> copper, bool isBridged) {
    Chainer chainer(image);
    Outline outline;
    std::vector<Loop> closed = chainer.run();
    outline.openTracks = chainer.openTracks();
    outline.widestJoint = chainer.widestJoint();
    if (isBridged && shareHeld(closed, copper) < kLeastHeld) {
        bridge(chainer.openOnes(), copper, closed, outline);
    }
    const Loops loops(std::move(closed));
    std::vector<double> shares;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        shares.push_back(shareInside(copper, loops.loop(i), loops.box(i)));
    }
    // The innermost loop around nearly all copper is the board's: what lies around it are frames, with fiducials
    // perhaps.
    std::size_t first = 0;
    for (std::size_t i = 1; i < loops.size(); ++i) {
        const bool isInner = shares[i] > kMost && (shares[first] <= kMost || loops.holds(first, i));
        first = isInner ? i : first;
    }
    const bool isDrawing = loops.size() > kMostCutouts;
    std::vector<std::pair<std::size_t, bool>> taken;  // and whether it is a hole
    for (std::size_t i = first; i < loops.size(); ++i) {
        std::size_t depth = 0;
        for (const auto& [outer, isOuterHole] : taken) {
            depth += loops.holds(outer, i) ? 1 : 0;
        }
        const bool isHole = depth % 2 != 0;
        if (isHole && (isDrawing || shares[i] > 0)) {
            outline.isDrawing = true;  // copper in a cut-out, or more loops than boards have
            continue;
        }
        const bool isWorth = isHole || i == first || copper.empty() || shares[i] > kLeastShare;
        if (isWorth) {
            taken.emplace_back(i, isHole);
            add(outline, loops.loop(i), loops.box(i), isHole);
        }
    }
    return outline;
}

}  // namespace model::gerber
