#include "render/modelling/area_pieces.h"

#include <algorithm>
#include <numeric>

#include "model/base/parallel.h"
#include "render/modelling/morton.h"

namespace render {
namespace {

/// One shape's part of the model's columns.
class ShapeSorter {
public:
    ShapeSorter(BoardModel& model, AreaShape& shape)
        : m_model(model), m_shape(shape), m_isLarge(shape.triangleCount > 2 * kPieceSize) {
        Box2 box;
        for (std::uint32_t i = 0; i < shape.vertexCount; ++i) {
            box.include(model.vertices[shape.firstVertex + i]);
        }
        m_curve = MortonCurve(box.min, box.max);
    }

    void run() {
        sortVertices();
        if (m_isLarge) {
            sortTriangles();
        }
    }

private:
    static std::vector<std::uint32_t> risingRows(std::uint32_t count) {
        std::vector<std::uint32_t> rows(count);
        std::iota(rows.begin(), rows.end(), 0U);
        return rows;
    }
    [[nodiscard]] bool hasWall(std::uint32_t vertex) const { return m_model.next[vertex] != vertex; }

    void sortVertices() {
        const std::uint32_t first = m_shape.firstVertex;
        std::vector<std::uint32_t> order = risingRows(m_shape.vertexCount);
        const auto wallless =
            std::stable_partition(order.begin(), order.end(), [&](std::uint32_t row) { return hasWall(first + row); });
        m_shape.firstWall = first;
        m_shape.wallCount = static_cast<std::uint32_t>(wallless - order.begin());
        if (m_isLarge) {
            sortRows(std::span(order.begin(), wallless), [&](std::uint32_t row) {
                const std::uint32_t end = m_model.next[first + row];
                return m_curve.key(0.5F * (m_model.vertices[first + row] + m_model.vertices[end]));
            });
        }
        moveVertices(order);
    }

    /// Old row `order[i]` becomes row i.
    void moveVertices(const std::vector<std::uint32_t>& order) {
        const std::uint32_t first = m_shape.firstVertex;
        std::vector<std::uint32_t> newRow(order.size());
        for (std::uint32_t i = 0; i < order.size(); ++i) {
            newRow[order[i]] = i;
        }
        std::vector<glm::vec2> vertices(order.size());
        std::vector<std::uint32_t> next(order.size());
        for (std::uint32_t i = 0; i < order.size(); ++i) {
            vertices[i] = m_model.vertices[first + order[i]];
            next[i] = first + newRow[m_model.next[first + order[i]] - first];
        }
        std::ranges::copy(vertices, m_model.vertices.begin() + first);
        std::ranges::copy(next, m_model.next.begin() + first);
        for (std::uint32_t i = m_shape.firstIndex; i < m_shape.firstIndex + 3 * m_shape.triangleCount; ++i) {
            m_model.indices[i] = newRow[m_model.indices[i]];
        }
    }

    void sortTriangles() {
        const std::uint32_t* corners = m_model.indices.data() + m_shape.firstIndex;
        std::vector<std::uint32_t> order = risingRows(m_shape.triangleCount);
        sortRows(order, [&](std::uint32_t triangle) {
            glm::vec2 sum(0.0F);
            for (std::uint32_t k = 0; k < 3; ++k) {
                sum += m_model.vertices[m_shape.firstVertex + corners[3 * triangle + k]];
            }
            return m_curve.key(sum / 3.0F);
        });
        std::vector<std::uint32_t> sorted;
        sorted.reserve(3 * order.size());
        for (const std::uint32_t i : order) {
            sorted.insert(sorted.end(), corners + 3 * i, corners + 3 * i + 3);
        }
        std::ranges::copy(sorted, m_model.indices.begin() + m_shape.firstIndex);
    }

    BoardModel& m_model;
    AreaShape& m_shape;
    bool m_isLarge;
    MortonCurve m_curve;
};

/// Runs of kPieceSize of `count`.
template <class Add>
void forRuns(std::uint32_t count, const Add& add) {
    for (std::uint32_t done = 0; done < count; done += kPieceSize) {
        add(done, std::min(kPieceSize, count - done));
    }
}

std::vector<AreaShape> piecesOf(const AreaShape& shape) {
    if (shape.triangleCount <= 2 * kPieceSize) {
        return {shape};
    }
    std::vector<AreaShape> pieces;
    AreaShape piece = shape;
    piece.wallCount = 0;
    forRuns(shape.triangleCount, [&](std::uint32_t first, std::uint32_t count) {
        piece.firstIndex = shape.firstIndex + 3 * first;
        piece.triangleCount = count;
        pieces.push_back(piece);
    });
    piece.triangleCount = 0;
    forRuns(shape.wallCount, [&](std::uint32_t first, std::uint32_t count) {
        piece.firstWall = shape.firstWall + first;
        piece.wallCount = count;
        pieces.push_back(piece);
    });
    return pieces;
}

/// Instances and batches by piece instead of by shape.
void placePieces(const std::vector<LayerRun>& piecesOfShape, BoardModel& model) {
    const std::vector<shader::AreaInstance> instances = std::move(model.instances);
    const std::vector<AreaBatch> batches = std::move(model.areaBatches);
    model.instances.clear();
    model.areaBatches.clear();
    for (LayerRun& layer : model.areaBatchesOfLayer) {
        const auto first = static_cast<std::uint32_t>(model.areaBatches.size());
        for (std::uint32_t b = layer.first; b < layer.first + layer.count; ++b) {
            const LayerRun pieces = piecesOfShape[batches[b].shape];
            for (std::uint32_t piece = pieces.first; piece < pieces.first + pieces.count; ++piece) {
                model.areaBatches.push_back({piece, batches[b].layer,
                                             static_cast<std::uint32_t>(model.instances.size()),
                                             batches[b].instanceCount});
                for (std::uint32_t i = 0; i < batches[b].instanceCount; ++i) {
                    model.instances.push_back(instances[batches[b].firstInstance + i]);
                    model.instances.back().shape = piece;
                }
            }
        }
        layer = {first, static_cast<std::uint32_t>(model.areaBatches.size()) - first};
    }
}

}  // namespace

void cutIntoPieces(BoardModel& model) {
    const std::vector<std::uint32_t> order =
        base::largestFirst(model.shapes.size(), [&](std::size_t row) { return model.shapes[row].vertexCount; });
    base::parallelFor(order.size(), [&](std::size_t i) { ShapeSorter(model, model.shapes[order[i]]).run(); });
    std::vector<AreaShape> pieces;
    std::vector<LayerRun> piecesOfShape;
    for (const AreaShape& shape : model.shapes) {
        const std::vector<AreaShape> own = piecesOf(shape);
        piecesOfShape.push_back({static_cast<std::uint32_t>(pieces.size()), static_cast<std::uint32_t>(own.size())});
        pieces.insert(pieces.end(), own.begin(), own.end());
    }
    model.shapes = std::move(pieces);
    placePieces(piecesOfShape, model);
}

}  // namespace render
