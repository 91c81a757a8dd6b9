// Rows of points inside of areas, against asking for each point.
#include "model/figures/covered_runs.h"

#include <QtTest>
#include <random>

#include "model/board/document_builder.h"
#include "model/figures/distance.h"

using model::DocumentBuilder;
using model::EdgeKind;
using model::Nm;
using model::PathNode;
using model::Point;

namespace {

void addContour(model::ShapeSketch& sketch, const std::vector<PathNode>& nodes, bool isHole) {
    sketch.beginContour(isHole);
    for (const PathNode& node : nodes) {
        sketch.addNode(node);
    }
}

/// Islands and holes of straight edges and arcs that bulge either way, star-shaped around a centre, laid on the board
/// turned and mirrored.
std::shared_ptr<const model::Document> randomAreas(std::uint32_t seed) {
    DocumentBuilder builder;
    model::Layer layer;
    layer.name = "top";
    layer.type = model::LayerType::Signal;
    const model::LayerId top = builder.addLayer(layer);
    std::mt19937 random(seed);
    const auto star = [&](Nm radius) {
        std::vector<PathNode> nodes;
        const int corners = 3 + static_cast<int>(random() % 9);
        for (int i = 0; i < corners; ++i) {
            const double angle = 2 * M_PI * i / corners;
            const double r = radius * (0.6 + 0.004 * static_cast<double>(random() % 100));
            nodes.push_back(
                {{static_cast<Nm>(r * std::cos(angle)), static_cast<Nm>(r * std::sin(angle))}, {}, EdgeKind::Line});
        }
        for (int i = 0; i < corners; ++i) {
            const Point a = nodes[static_cast<std::size_t>(i)].point;
            const Point b = nodes[static_cast<std::size_t>((i + 1) % corners)].point;
            if (random() % 2 == 0) {
                nodes[static_cast<std::size_t>(i)].centre = {(a.x + b.x) / 2, (a.y + b.y) / 2};  // half a circle
                nodes[static_cast<std::size_t>(i)].edge =
                    random() % 2 == 0 ? EdgeKind::ArcClockwise : EdgeKind::ArcCounterClockwise;
            }
        }
        return nodes;
    };
    builder.beginLayer(top);
    for (int i = 0; i < 12; ++i) {
        model::ShapeSketch sketch;
        addContour(sketch, star(1'000'000), false);
        if (i % 2 == 0) {
            addContour(sketch, star(300'000), true);
        }
        const model::ShapeId shape = builder.addShape(sketch);
        model::Placement placement;
        placement.origin = {static_cast<Nm>(random() % 3'000'000), static_cast<Nm>(random() % 3'000'000)};
        placement.clockwiseDeg = static_cast<double>(random() % 4) * 45.0;
        placement.isMirrored = random() % 2 == 0;
        builder.addArea({shape, placement}, {});
    }
    return builder.finish();
}

}  // namespace

class CoveredRunsTest : public QObject {
    Q_OBJECT

private slots:
    void agreesWithEveryPoint() {
        int inside = 0;
        for (std::uint32_t seed = 0; seed < 8; ++seed) {
            const auto board = randomAreas(seed);
            model::FigureTable figures;
            for (std::uint32_t i = 0; i < board->elements.size(); ++i) {
                figures.add(*board, model::ElementId{i});
            }
            for (std::size_t row = 0; row < figures.size(); ++row) {
                inside += compare(figures, row);
            }
        }
        QVERIFY(inside > 1000);
    }

private:
    /// Cells inside.
    int compare(const model::FigureTable& figures, std::size_t row) {
        const model::Box box = figures.box(row);
        int inside = 0;
        for (int j = -1; j <= 20; ++j) {
            const double y = box.min.y + (j + 0.5) * static_cast<double>(box.height()) / 20 + 0.25;
            const double end = box.min.x + static_cast<double>(box.width()) * 0.8;
            std::vector<model::CoveredRun> runs;
            model::addCoveredRuns(figures, row, y, end, runs);
            for (double x = box.min.x - 1e4; x <= end; x += 60'013.0) {
                const bool isCovered =
                    std::ranges::any_of(runs, [&](const model::CoveredRun& r) { return r.from <= x && x < r.to; });
                if (isCovered != model::isInside(figures, row, {x, y})) {
                    // Only points that lie on an edge may fall to either side.
                    if (model::spacingToEdges(figures, row, {x, y}).distance >= 1.0) {
                        qFatal("figure %zu at %f %f", row, x, y);
                    }
                }
                inside += isCovered ? 1 : 0;
            }
        }
        return inside;
    }
};

QTEST_GUILESS_MAIN(CoveredRunsTest)
#include "covered_runs_test.moc"
