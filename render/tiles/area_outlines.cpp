#include "render/tiles/area_outlines.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "model/base/parallel.h"

namespace render {

namespace {

constexpr std::uint32_t kMostEdges = 64;  // of a chain: so many are passed over together
constexpr std::uint32_t kNone = 0xffffffffU;

/// Pieces of one shape, which follow each other: rows of BoardModel::shapes.
struct Pieces {
    std::uint32_t first = 0;
    std::uint32_t end = 0;
};

std::vector<Pieces> piecesIn(const BoardModel& model) {
    std::vector<Pieces> all;
    for (std::uint32_t row = 0; row < model.shapes.size(); ++row) {
        // A shape without points starts where the next one does.
        const auto isPieceOf = [&](const AreaShape& before) {
            const AreaShape& own = model.shapes[row];
            return own.firstVertex == before.firstVertex && own.vertexCount == before.vertexCount;
        };
        if (row == 0 || !isPieceOf(model.shapes[row - 1])) {
            all.push_back({row, row});
        }
        all.back().end = row + 1;
    }
    return all;
}

/// The outlines of one shape. Vertices count from its first one.
class Tracer {
public:
    Tracer(const BoardModel& model, const Pieces& pieces)
        : m_model(model), m_pieces(pieces), m_shape(model.shapes[pieces.first]), m_next(m_shape.vertexCount) {
        for (std::uint32_t v = 0; v < m_next.size(); ++v) {
            m_next[v] = model.next[m_shape.firstVertex + v] - m_shape.firstVertex;
        }
    }

    /// Lines of vertices, from each to the next.
    std::vector<std::vector<std::uint32_t>> run() {
        if (isEmpty()) {
            return {};
        }
        followTriangles();
        std::vector<std::uint8_t> isReached(m_next.size(), 0);
        for (std::uint32_t v = 0; v < m_next.size(); ++v) {
            if (m_next[v] != v) {
                isReached[m_next[v]] = 1;
            }
        }
        for (const bool isClosed : {false, true}) {
            for (std::uint32_t v = 0; v < m_next.size(); ++v) {
                if (isClosed || isReached[v] == 0) {
                    trace(v);
                }
            }
        }
        return std::move(m_lines);
    }

private:
    /// Could not be triangulated: nothing of it is drawn.
    [[nodiscard]] bool isEmpty() const {
        const auto first = m_model.shapes.begin();
        return std::all_of(first + m_pieces.first, first + m_pieces.end,
                           [](const AreaShape& piece) { return piece.triangleCount == 0; });
    }

    /// Where no wall starts - around what lets fill in - the edge of a triangle without another one beside it goes on.
    void followTriangles() {
        const auto isOpen = [&](std::uint32_t v) { return m_next[v] == v; };
        std::vector<std::uint8_t> open(m_next.size());
        for (std::uint32_t v = 0; v < m_next.size(); ++v) {
            open[v] = isOpen(v) ? 1 : 0;
        }
        if (std::ranges::find(open, 1) == open.end()) {
            return;
        }
        std::unordered_set<std::uint64_t> edges;
        const auto key = [](std::uint32_t a, std::uint32_t b) { return std::uint64_t{a} << 32U | b; };
        for (std::uint32_t row = m_pieces.first; row < m_pieces.end; ++row) {
            const AreaShape& piece = m_model.shapes[row];
            const std::uint32_t* corners = m_model.indices.data() + piece.firstIndex;
            for (std::uint32_t i = 0; i < 3 * piece.triangleCount; ++i) {
                const std::uint32_t a = corners[i];
                const std::uint32_t b = corners[i % 3 == 2 ? i - 2 : i + 1];
                if ((open[a] != 0 || open[b] != 0) && edges.erase(key(b, a)) == 0) {
                    edges.insert(key(a, b));
                }
            }
        }
        for (const std::uint64_t edge : edges) {
            const auto from = static_cast<std::uint32_t>(edge >> 32U);
            if (open[from] != 0) {
                m_next[from] = static_cast<std::uint32_t>(edge);
            }
        }
    }

    void trace(std::uint32_t from) {
        std::vector<std::uint32_t> line;
        std::uint32_t v = from;
        while (m_next[v] != v && m_next[v] != kNone) {
            line.push_back(v);
            v = std::exchange(m_next[v], kNone);
        }
        if (!line.empty()) {
            line.push_back(v);
            m_lines.push_back(std::move(line));
        }
    }

    const BoardModel& m_model;
    Pieces m_pieces;
    const AreaShape& m_shape;
    std::vector<std::uint32_t> m_next;
    std::vector<std::vector<std::uint32_t>> m_lines;
};

}  // namespace

AreaOutlines::AreaOutlines(const BoardModel& model) : m_chainsOfShape(model.shapes.size()) {
    const std::vector<Pieces> shapes = piecesIn(model);
    std::vector<std::vector<std::vector<std::uint32_t>>> lines(shapes.size());
    base::parallelFor(shapes.size(), [&](std::size_t i) { lines[i] = Tracer(model, shapes[i]).run(); });
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const glm::vec2* vertices = model.vertices.data() + model.shapes[shapes[i].first].firstVertex;
        const auto first = static_cast<std::uint32_t>(m_chains.size());
        for (const std::vector<std::uint32_t>& line : lines[i]) {
            for (std::size_t done = 0; done + 1 < line.size(); done += kMostEdges) {
                Chain chain{static_cast<std::uint32_t>(m_points.size()), 0, {}};
                for (std::size_t k = done; k < std::min<std::size_t>(done + kMostEdges + 1, line.size()); ++k) {
                    m_points.push_back(vertices[line[k]]);
                    chain.box.include(m_points.back());
                    ++chain.pointCount;
                }
                m_chains.push_back(chain);
            }
        }
        m_chainsOfShape[shapes[i].first] = {first, static_cast<std::uint32_t>(m_chains.size()) - first};
    }
}

}  // namespace render
