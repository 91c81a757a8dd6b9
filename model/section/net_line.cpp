#include "model/section/net_line.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <queue>
#include <utility>

namespace model {

namespace {

constexpr double kChord = 5.0 * std::numbers::pi / 180.0;
constexpr std::uint32_t kNone = 0xffffffffU;
constexpr double kFar = std::numeric_limits<double>::infinity();

struct Track {
    Edge edge;
    LayerId layer;
    std::uint32_t a = 0;  ///< places, see Tracks
    std::uint32_t b = 0;
};

/// How locations are reached from one of them. Made once for many searches: each costs what it reaches.
struct Reached {
    explicit Reached(std::size_t locations) : length(locations, kFar), by(locations, kNone) {}

    void clear() {
        for (const std::uint32_t location : found) {
            length[location] = kFar;
            by[location] = kNone;
        }
        found.clear();
    }

    std::vector<double> length;
    std::vector<std::uint32_t> by;     ///< track; none at the start and where nothing leads
    std::vector<std::uint32_t> found;  ///< locations that are reached
    std::uint32_t farthest = 0;
};

/// The middle lines of a net's tracks as a graph.
class Tracks {
public:
    explicit Tracks(const Pieces& pieces, const BoardIndex& index) {
        for (std::size_t row = 0; row < pieces.pieces.size(); ++row) {
            const BoardElement at = pieces.pieces[row].at;
            const Document& step = index.stepOf(at.copy);
            const bool isDot = (step.elements.flags[at.element.row()] & (kPad | kHole)) != 0 ||
                               step.elements.kind[at.element.row()] == ElementKind::Circle;
            if (isDot || pieces.figures[row].isFilled) {
                continue;
            }
            for (const Edge& edge : pieces.figures.edges(row)) {
                add(edge, pieces.pieces[row].layer);
            }
        }
    }

    [[nodiscard]] bool isEmpty() const { return m_tracks.empty(); }

    /// From one end of the longest chain to the other.
    [[nodiscard]] NetLine longest() const {
        std::vector<bool> isSeen(m_at.size());
        double most = -1.0;
        std::uint32_t end = 0;
        Reached reached(m_at.size());
        for (std::uint32_t location = 0; location < m_at.size(); ++location) {
            if (isSeen[location]) {
                continue;
            }
            search(location, reached);
            for (const std::uint32_t found : reached.found) {
                isSeen[found] = true;
            }
            const std::uint32_t start = reached.farthest;
            search(start, reached);
            if (reached.length[reached.farthest] > most) {
                most = reached.length[reached.farthest];
                end = start;
            }
        }
        search(end, reached);
        return walk(reached);
    }

private:
    void add(const Edge& edge, LayerId layer) {
        if (edge.a.x == edge.b.x && edge.a.y == edge.b.y) {
            return;  // a dot or a full circle leads nowhere
        }
        const auto row = static_cast<std::uint32_t>(m_tracks.size());
        m_tracks.push_back({edge, layer, locationOf(edge.a), locationOf(edge.b)});
        m_at[m_tracks[row].a].push_back(row);
        m_at[m_tracks[row].b].push_back(row);
    }

    std::uint32_t locationOf(PointD p) {
        const auto [location, isFirst] =
            m_locations.try_emplace({std::llround(p.x), std::llround(p.y)}, static_cast<std::uint32_t>(m_at.size()));
        if (isFirst) {
            m_at.emplace_back();
        }
        return location->second;
    }

    /// How locations are reached from `start`: Dijkstra's search.
    void search(std::uint32_t start, Reached& out) const {
        out.clear();
        using Entry = std::pair<double, std::uint32_t>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
        out.length[start] = 0.0;
        out.found.push_back(start);
        queue.push({0.0, start});
        while (!queue.empty()) {
            const Entry entry = queue.top();
            queue.pop();
            if (entry.first > out.length[entry.second]) {
                continue;
            }
            out.farthest = entry.second;  // they come in rising order
            for (const std::uint32_t row : m_at[entry.second]) {
                const std::uint32_t to = otherEnd(row, entry.second);
                const double length = entry.first + lengthOf(m_tracks[row].edge);
                if (length < out.length[to]) {
                    if (out.length[to] == kFar) {
                        out.found.push_back(to);
                    }
                    out.length[to] = length;
                    out.by[to] = row;
                    queue.push({length, to});
                }
            }
        }
    }

    [[nodiscard]] std::uint32_t otherEnd(std::uint32_t row, std::uint32_t location) const {
        return m_tracks[row].a == location ? m_tracks[row].b : m_tracks[row].a;
    }

    /// Back from the farthest location to the start.
    [[nodiscard]] NetLine walk(const Reached& reached) const {
        NetLine path;
        std::vector<PointD>& line = path.line;
        std::uint32_t location = reached.farthest;
        while (reached.by[location] != kNone) {
            const Track& track = m_tracks[reached.by[location]];
            std::vector<PointD> corners = cornersOf(track.edge);
            if (track.a != location) {
                std::ranges::reverse(corners);
            }
            // Tracks meet at one location: its corner counts once.
            line.insert(line.end(), corners.begin() + (line.empty() ? 0 : 1), corners.end());
            path.layers.resize(line.size() - 1, track.layer);
            location = otherEnd(reached.by[location], location);
        }
        return path;
    }

    static std::vector<PointD> cornersOf(const Edge& edge) {
        std::vector<PointD> corners{edge.a};
        if (edge.isArc()) {
            const double start = std::atan2(edge.a.y - edge.centre.y, edge.a.x - edge.centre.x);
            const double sweep = lengthOf(edge) / edge.radius * (edge.isClockwise ? -1.0 : 1.0);
            const double count = std::ceil(std::abs(sweep) / kChord);
            for (double i = 1.0; i < count; ++i) {
                const double angle = start + sweep * i / count;
                corners.push_back(
                    {edge.centre.x + edge.radius * std::cos(angle), edge.centre.y + edge.radius * std::sin(angle)});
            }
        }
        corners.push_back(edge.b);
        return corners;
    }

    std::vector<Track> m_tracks;
    std::map<std::pair<long long, long long>, std::uint32_t> m_locations;
    std::vector<std::vector<std::uint32_t>> m_at;  ///< by location: tracks that end there
};

}  // namespace

std::vector<LayerRun> runsOf(const NetLine& line) {
    std::vector<LayerRun> runs;
    double at = 0.0;
    for (std::size_t i = 0; i < line.layers.size(); ++i) {
        const PointD a = line.line[i];
        const PointD b = line.line[i + 1];
        const double end = at + std::hypot(b.x - a.x, b.y - a.y);
        if (runs.empty() || runs.back().layer != line.layers[i]) {
            runs.push_back({at, end, line.layers[i]});
        }
        runs.back().to = at = end;
    }
    return runs;
}

base::Result<NetLine> lineAlong(const BoardIndex& index, NetOfCopy net) {
    const Tracks tracks(piecesOf(index, net), index);
    if (tracks.isEmpty()) {
        return base::Error{base::ErrorCode::BadUsage, nameOf(index, net) + " has no tracks to follow"};
    }
    return tracks.longest();
}

}  // namespace model
