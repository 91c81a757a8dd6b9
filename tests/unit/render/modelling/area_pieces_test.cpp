#include "render/modelling/area_pieces.h"

#include <QtTest>
#include <map>
#include <random>
#include <set>

using render::BoardModel;

namespace {

/// A strip of `quads` squares side by side as one shape, rows of vertices in random order, walls round it. Placed
/// `places` times on the first layer.
BoardModel strip(std::uint32_t quads, std::uint32_t locations) {
    BoardModel model;
    std::vector<std::uint32_t> row(2 * (quads + 1));
    std::iota(row.begin(), row.end(), 0U);
    std::ranges::shuffle(row, std::mt19937(3));
    model.vertices.resize(row.size());
    model.next.resize(row.size());
    const auto at = [&](std::uint32_t x, std::uint32_t y) { return row[2 * x + y]; };
    for (std::uint32_t x = 0; x <= quads; ++x) {
        for (std::uint32_t y = 0; y < 2; ++y) {
            model.vertices[at(x, y)] = {static_cast<float>(x), static_cast<float>(y)};
        }
        model.next[at(x, 0)] = x < quads ? at(x + 1, 0) : at(x, 1);
        model.next[at(x, 1)] = x > 0 ? at(x - 1, 1) : at(x, 1);  // the left side has no wall
    }
    for (std::uint32_t x = 0; x < quads; ++x) {
        model.indices.insert(model.indices.end(),
                             {at(x, 0), at(x + 1, 0), at(x + 1, 1), at(x, 0), at(x + 1, 1), at(x, 1)});
    }
    model.shapes.push_back({0, static_cast<std::uint32_t>(row.size()), 0, 2 * quads});
    for (std::uint32_t i = 0; i < locations; ++i) {
        model.instances.push_back(
            {glm::vec2(0.0F, 10.0F * static_cast<float>(i)), {1.0F, 0.0F}, 0, 0, i, 0, 0.0F, 0, 0.0F, 0});
    }
    model.areaBatches.push_back({0, 0, 0, locations});
    model.areaBatchesOfLayer.push_back({0, 1});
    return model;
}

using Triangle = std::multiset<std::pair<float, float>>;
using Wall = std::array<float, 4>;

/// Everything drawn for one element, however it is cut.
struct Drawn {
    std::multiset<Triangle> triangles;
    std::multiset<Wall> walls;
    bool operator==(const Drawn&) const = default;
};

Drawn drawnOf(const BoardModel& model, std::uint32_t element) {
    Drawn drawn;
    for (const shader::AreaInstance& instance : model.instances) {
        if (instance.element != element) {
            continue;
        }
        const render::AreaShape& piece = model.shapes[instance.shape];
        const auto vertex = [&](std::uint32_t row) { return model.vertices[row]; };
        for (std::uint32_t i = 0; i < piece.triangleCount; ++i) {
            Triangle triangle;
            for (std::uint32_t k = 0; k < 3; ++k) {
                const glm::vec2 p = vertex(piece.firstVertex + model.indices[piece.firstIndex + 3 * i + k]);
                triangle.insert({p.x, p.y});
            }
            drawn.triangles.insert(triangle);
        }
        for (std::uint32_t i = piece.firstWall; i < piece.firstWall + piece.wallCount; ++i) {
            const glm::vec2 a = vertex(i);
            const glm::vec2 b = vertex(model.next[i]);
            drawn.walls.insert({a.x, a.y, b.x, b.y});
        }
    }
    return drawn;
}

}  // namespace

class AreaPiecesTest : public QObject {
    Q_OBJECT

private slots:
    void nothingIsLostAndNothingDrawnTwice_data() {
        QTest::addColumn<std::uint32_t>("quads");
        QTest::addColumn<std::size_t>("pieces");
        QTest::newRow("small") << 5U << std::size_t{1};
        QTest::newRow("just one") << 256U << std::size_t{1};
        QTest::newRow("large") << 1000U << std::size_t{8 + 8};
    }
    void nothingIsLostAndNothingDrawnTwice() {
        QFETCH(std::uint32_t, quads);
        QFETCH(std::size_t, pieces);
        BoardModel model = strip(quads, 3);
        BoardModel whole = model;
        whole.shapes[0].wallCount = whole.shapes[0].vertexCount;
        Drawn expected = drawnOf(whole, 0);
        std::erase_if(expected.walls, [](const Wall& w) { return w[0] == w[2] && w[1] == w[3]; });
        render::cutIntoPieces(model);
        QCOMPARE(model.shapes.size(), pieces);
        QCOMPARE(model.instances.size(), 3 * pieces);
        QCOMPARE(model.areaBatchesOfLayer[0].count, pieces);
        for (std::uint32_t element = 0; element < 3; ++element) {
            QVERIFY(drawnOf(model, element) == expected);
        }
    }

    void piecesAreSmallAndClose() {
        BoardModel model = strip(4096, 1);
        render::cutIntoPieces(model);
        for (const render::AreaShape& piece : model.shapes) {
            QVERIFY(piece.triangleCount <= render::kPieceSize && piece.wallCount <= render::kPieceSize);
            float low = 1e9F;
            float high = -1e9F;
            for (std::uint32_t i = 0; i < 3 * piece.triangleCount; ++i) {
                low = std::min(low, model.vertices[model.indices[piece.firstIndex + i]].x);
                high = std::max(high, model.vertices[model.indices[piece.firstIndex + i]].x);
            }
            QVERIFY(high - low <= 130.0F);  // 256 triangles are 128 squares
        }
    }
};

QTEST_APPLESS_MAIN(AreaPiecesTest)
#include "area_pieces_test.moc"
