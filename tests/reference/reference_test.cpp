// What Copperscope makes of a job against a painter that shares no code with it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/base/parallel.h"
#include "model/formats/odb/text/job_tree.h"
#include "tests/locations.h"
#include "tests/reference/document_painter.h"
#include "tests/reference/odb_painter.h"
#include "tests/reference/symbols.h"
#include "tests/unit/model/formats/odb/odb_testing.h"

using namespace odb_testing;
using namespace reference;

namespace {

constexpr double kPi = std::numbers::pi;

/// A job's files as bytes: the one thing taken from the reader.
class JobFiles {
public:
    explicit JobFiles(const fs::path& path) {
        base::Progress progress;
        auto archive = model::formats::Archive::open(path, {}, progress, m_diagnostics);
        m_archive.emplace(std::move(archive.value()));
        m_tree.emplace(model::odb::findJob(*m_archive).value());
    }

    [[nodiscard]] ReadFile reader() {
        return [this](const std::string& path) -> std::optional<std::string> {
            if (!m_tree->has(path)) {
                return std::nullopt;
            }
            const auto file = m_tree->read(path, m_diagnostics);
            return file ? std::optional<std::string>(file->text()) : std::nullopt;
        };
    }

private:
    model::Diagnostics m_diagnostics;
    std::optional<model::formats::Archive> m_archive;
    std::optional<model::formats::FileTree> m_tree;
};

Raster rasterFor(const model::Box& box, double pitch) {
    return {{box.min.x * 1e-6 - 1, box.min.y * 1e-6 - 1}, {box.max.x * 1e-6 + 1, box.max.y * 1e-6 + 1}, pitch};
}

/// Areas in mm² of one layer: ours, the painter's, and where they differ.
struct Comparison {
    double ours = 0.0;
    double painted = 0.0;
    double difference = 0.0;
    std::vector<std::string> unknown;
};

Comparison compare(const model::Document& d, const model::Layer& layer, JobFiles& files, double pitch) {
    model::Box box = d.extent;
    box.include(d.board);
    Raster ours = rasterFor(box, pitch);
    Raster painted = rasterFor(box, pitch);
    for (std::uint32_t i = 0; i < layer.elements.count; ++i) {
        paint(d, model::ElementId{layer.elements.first + i}, ours);
    }
    if (layer.isNegative) {
        paint(d, d.profile, painted);
    }
    OdbPainter painter(files.reader());
    painter.paint(layer.file, painted, layer.isNegative);
    return {ours.area(), painted.area(), ours.difference(painted), painter.unknown()};
}

}  // namespace

class ReferenceTest : public QObject {
    Q_OBJECT

private slots:
    /// The painter itself, against closed formulas: within 0.02 %.
    void thePaintersAreasAreRight() {
        Raster raster({-5, -5}, {5, 5}, 0.002);
        raster.fill({circle({0.3, 0.2}, 2)}, true);
        QVERIFY(std::abs(raster.area() / (4 * kPi) - 1) < 2e-4);
        raster.fill({wound({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, false)}, false);
        QVERIFY(std::abs(raster.area() / (4 * kPi - 4) - 1) < 2e-4);
        Raster tracks({-5, -5}, {5, 5}, 0.002);
        tracks.fill(lineTrack({-2, 1}, {2, 3}, 0.5), true);
        const double line = std::sqrt(20.0) * 0.5 + kPi / 16;
        QVERIFY(std::abs(tracks.area() / line - 1) < 2e-4);
        Raster arcs({-5, -5}, {5, 5}, 0.002);
        arcs.fill(arcTrack({3, 0}, {0, 3}, {0, 0}, false, 0.5), true);
        QVERIFY(std::abs(arcs.area() / (kPi / 2 * 3 * 0.5 + kPi / 16) - 1) < 2e-4);
        Raster asked({-5, -5}, {5, 5}, 0.002);
        asked.fill(
            {0.1, 0}, 2, [](Point p) { return std::hypot(p.x - 0.1, p.y) <= 1.5; }, true);
        QVERIFY(std::abs(asked.area() / (kPi * 2.25) - 1) < 2e-4);
        QVERIFY(std::abs(asked.difference(arcs) - asked.area() - arcs.area()) < 1e-9);
    }

    void everySymbolIsWhatThePainterPaints_data() {
        QTest::addColumn<QString>("name");
        for (const char* name : {"r4000",
                                 "s4000",
                                 "rect4000x2000",
                                 "rect4000x2000xr500",
                                 "rect4000x2000xr500x124",
                                 "rect4000x2000xc500x3",
                                 "oval4000x2000",
                                 "oval2000x4000",
                                 "di4000x2000",
                                 "oct4000x2000x500",
                                 "hex_l4000x2000x1000",
                                 "hex_s4000x2000x500",
                                 "tri4000x3000",
                                 "el4000x2000",
                                 "oval_h4000x2000",
                                 "bfr4000",
                                 "bfs4000",
                                 "donut_r4000x2000",
                                 "donut_s4000x2000",
                                 "donut_s4000x3000xr1000",
                                 "donut_sr4000x2000",
                                 "donut_rc4000x3000x500",
                                 "donut_rc4000x3000x500xr700x14",
                                 "donut_o4000x2000x500",
                                 "thr4000x2000x30x3x300",
                                 "ths4000x2000x45x4x500",
                                 "s_ths4000x2000x45x4x500",
                                 "s_ths4000x2000x0x3x500xr800",
                                 "s_tho4000x2000x45x4x500",
                                 "s_tho4000x2000x0x2x500",
                                 "s_tho4000x2000x45x1x500",
                                 "s_thr4000x3000x45x4x500",
                                 "sr_ths4000x2000x20x3x400",
                                 "rc_ths6000x4000x45x4x500x1000",
                                 "rc_ths6000x4000x0x2x500x1000xr700x13",
                                 "rc_tho4000x6000x45x2x500x1000",
                                 "o_ths6000x2000x90x2x500x500",
                                 "o_ths6000x4000x45x4x500x500",
                                 "oblong_ths6000x4000x45x4x500x500xr",
                                 "oblong_ths6000x4000x45x4x500x500xs",
                                 "moire200x300x3x100x4000x20",
                                 "hplate4000x2000x1500",
                                 "rhplate4000x2000x1000",
                                 "fhplate4000x2000x500x1000",
                                 "radhplate4000x2000x1000",
                                 "dshape4000x2000x500",
                                 "cross4000x3000x500x400x25x75xs",
                                 "cross4000x3000x500x400x50x50xr",
                                 "dogbone4000x3000x500x400x30xs",
                                 "dogbone4000x3000x500x400x50xr",
                                 "dpack4000x2000x200x300x4x2"}) {
            QTest::newRow(name) << name;
        }
    }
    /// Turned by 33° clockwise and mirrored, so that no symmetry hides a mistake.
    void everySymbolIsWhatThePainterPaints() {
        QFETCH(QString, name);
        const Folder folder;
        writeSmallJob(folder, "UNITS=MM\n$0 " + name.toStdString() + "\nP 10 20 0 P 0 9 33\n");
        const auto d = read(folder.path());
        QVERIFY(d->elements.size() > 0);
        JobFiles files(folder.path());
        Raster ours({6, 16}, {14, 24}, 0.008);
        Raster painted({6, 16}, {14, 24}, 0.008);
        paint(*d, model::ElementId{0}, ours);
        OdbPainter painter(files.reader());
        painter.paint("steps/board/layers/top/features", painted);
        QVERIFY(painter.unknown().empty());
        QVERIFY(painted.area() > 1.0);
        QVERIFY2(std::abs(ours.area() / painted.area() - 1) < 1e-3, qPrintable(QString::number(painted.area())));
        // Chords of cut symbols lie up to 1 µm inside of curves, and samples on a border fall to either side.
        QVERIFY2(ours.difference(painted) < 0.006 * painted.area(),
                 qPrintable(QString::number(ours.difference(painted))));
    }

    void paintOrderAndNegativeLayersAgree() {
        for (const auto& [job, layer] :
             {std::pair{"negative", "TOP"}, {"negative", "PLANE"}, {"everything", "BOTTOM"}}) {
            const auto d = read(dataJob(job));
            JobFiles files(dataJob(job));
            const Comparison c = compare(*d, d->layer(d->findLayer(layer)), files, 0.005);
            QVERIFY(c.unknown.empty());
            QVERIFY2(std::abs(c.ours / c.painted - 1) < 1e-3, layer);
            QVERIFY(c.difference < 2e-3 * c.painted);
        }
    }

    void copperOfWholeBoardsAgrees_data() {
        QTest::addColumn<QString>("file");
        for (const fs::path& board : locations::allBoards()) {
            QTest::newRow(board.filename().c_str()) << QString::fromStdString(board.string());
        }
    }
    /// All copper layers; for the time it takes only the two outer ones of boards with more than 100,000 elements on
    /// copper and of boards that are there in several variants; all of them if the test is to be thorough.
    void copperOfWholeBoardsAgrees() {
        QFETCH(QString, file);
        const auto d = read(file.toStdString());
        JobFiles files(file.toStdString());
        std::vector<const model::Layer*> copper;
        std::size_t elements = 0;
        for (const model::Layer& layer : d->layers) {
            if (layer.isCopper() && layer.elements.count > 0) {
                copper.push_back(&layer);
                elements += layer.elements.count;
            }
        }
        if (!locations::isThorough() && copper.size() > 2 && (elements > 100'000 || file.contains("/variants/"))) {
            copper = {copper.front(), copper.back()};
        }
        std::vector<Comparison> results(copper.size());
        base::parallelFor(copper.size(), [&](std::size_t i) {
            JobFiles own(file.toStdString());
            results[i] = compare(*d, *copper[i], own, 0.02);
        });
        for (std::size_t i = 0; i < copper.size(); ++i) {
            const Comparison& c = results[i];
            const std::string line = copper[i]->name + ": ours " + std::to_string(c.ours) + " mm², painted " +
                                     std::to_string(c.painted) + " mm², different " + std::to_string(c.difference);
            qInfo("%s", line.c_str());
            QVERIFY2(c.unknown.empty(), c.unknown.empty() ? "" : c.unknown.front().c_str());
            QVERIFY2(std::abs(c.ours - c.painted) <= 1e-3 * c.painted, line.c_str());
            // Shapes in other places have the right area, too.
            QVERIFY2(c.difference <= 2e-3 * c.painted, line.c_str());
        }
    }
};

QTEST_APPLESS_MAIN(ReferenceTest)
#include "reference_test.moc"
