#include "model/index/figure_cache.h"

#include <QtTest>
#include <atomic>
#include <thread>

#include "model/index/board_index.h"
#include "tests/unit/model/hand_made.h"

using namespace hand_made;
using model::BoardIndex;
using model::ElementId;
using model::FigureTable;

namespace {

/// A rectangle whose upper side goes up and down, of this many corners.
model::ShapeSketch comb(std::size_t corners) {
    const auto teeth = static_cast<model::Nm>(corners / 2);
    std::vector<model::Point> outline = {{0, 0}, {teeth * kMm, 0}};
    for (model::Nm x = teeth - 1; outline.size() < corners; --x) {
        outline.push_back({x * kMm, (1 + x % 2) * kMm});
    }
    model::ShapeSketch sketch;
    sketch.addPolygon(outline, false);
    return sketch;
}

/// Areas of these numbers of corners, all of which are sides.
std::shared_ptr<const BoardIndex> boardOf(std::initializer_list<std::size_t> areas) {
    model::DocumentBuilder builder;
    builder.beginLayer(addLayer(builder, "top"));
    for (const std::size_t corners : areas) {
        builder.addArea({builder.addShape(comb(corners)), {}}, {});
    }
    return indexed(builder.finish());
}

std::size_t edgesOf(const FigureTable& figures) {
    std::size_t edges = 0;
    for (std::size_t row = 0; row < figures.size(); ++row) {
        edges += figures.edges(row).size();
    }
    return edges;
}

}  // namespace

class FigureCacheTest : public QObject {
    Q_OBJECT

private slots:
    void largeAreasAreKept() {
        const auto index = boardOf({1000, 10});
        const auto large = index->figuresOf(0, ElementId{0});
        QCOMPARE(edgesOf(*large), std::size_t{1000});
        QCOMPARE(edgesOf(*index->figuresOf(0, ElementId{1})), std::size_t{10});
        QCOMPARE(index->figures->edgeCount(), std::size_t{1000});
        QCOMPARE(index->figuresOf(0, ElementId{0}), large);
    }

    void areasAreKeptBeforeTheyAreRequested() {
        const auto index = boardOf({10, 300, 2000});
        index->figures->fill(index->tree, base::Progress());
        QCOMPARE(index->figures->edgeCount(), std::size_t{2300});
        QCOMPARE(edgesOf(*index->figuresOf(0, ElementId{2})), std::size_t{2000});
        QCOMPARE(index->figures->edgeCount(), std::size_t{2300});
    }

    void cancelledWorkKeepsNothing() {
        const auto index = boardOf({1000});
        base::Progress progress;
        progress.cancel();
        index->figures->fill(index->tree, progress);
        QCOMPARE(index->figures->edgeCount(), std::size_t{0});
    }

    void heightsShareTheOutlines() {
        const auto index = boardOf({1000});
        const auto large = index->figuresOf(0, ElementId{0});
        QCOMPARE(model::withHeights(*index, index->board)->figuresOf(0, ElementId{0}), large);
    }

    /// Nothing is counted twice, whoever comes first.
    void threadsRequestTheSame() {
        const auto index = boardOf({3000, 3000, 3000, 3000});
        std::vector<std::jthread> threads;
        threads.emplace_back([&] { index->figures->fill(index->tree, base::Progress()); });
        std::atomic<std::size_t> edges = 0;
        for (int i = 0; i < 4; ++i) {
            threads.emplace_back([&] {
                for (std::uint32_t row = 0; row < 4; ++row) {
                    edges += edgesOf(*index->figuresOf(0, ElementId{row}));
                }
            });
        }
        threads.clear();
        QCOMPARE(edges.load(), std::size_t{4 * 12'000});
        QCOMPARE(index->figures->edgeCount(), std::size_t{12'000});
    }

    /// What does not fit any more makes room; what was handed out stays.
    void roomIsBounded() {
        const auto index = boardOf({1000, 1000, 1000});
        model::FigureCache cache(2500);
        cache.fill(index->tree, base::Progress());
        QCOMPARE(cache.edgeCount(), std::size_t{1000});  // half of the room
        const auto first = cache.of(index->tree, 0, ElementId{0});
        (void)cache.of(index->tree, 0, ElementId{1});
        QCOMPARE(cache.edgeCount(), std::size_t{2000});
        (void)cache.of(index->tree, 0, ElementId{2});
        QCOMPARE(cache.edgeCount(), std::size_t{1000});
        QCOMPARE(edgesOf(*first), std::size_t{1000});
    }
};

QTEST_APPLESS_MAIN(FigureCacheTest)
#include "figure_cache_test.moc"
