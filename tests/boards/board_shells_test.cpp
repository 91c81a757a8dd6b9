// The exact outlines of all elements of whole boards.
#include <QtTest>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "model/formats/registry.h"
#include "model/geometry/boolean.h"
#include "model/geometry/loops/edge_faults.h"
#include "model/geometry/loops/edge_union.h"
#include "model/solids/shells/element_shells.h"
#include "model/solids/shells/merged_shells.h"
#include "model/solids/shells/trail_shell.h"
#include "tests/locations.h"
#include "tests/unit/model/geometry/edge_loop_checks.h"

using namespace edge_loop_checks;
using model::Document;
using model::EdgeLoops;
using model::ElementId;
using model::ElementKind;

namespace {

std::shared_ptr<const Document> read(const std::filesystem::path& path) {
    base::Progress progress;
    const auto board = model::readBoard(path, {}, progress);
    return board ? *board : nullptr;
}

double sumOfAreas(const std::vector<EdgeLoops>& regions) {
    double sum = 0.0;
    for (const EdgeLoops& region : regions) {
        sum += model::areaOf(region);
    }
    return sum;
}

double sumOfLengths(const std::vector<EdgeLoops>& regions) {
    double sum = 0.0;
    for (const EdgeLoops& region : regions) {
        sum += lengthOf(region);
    }
    return sum;
}

std::vector<std::uint32_t> rowsOf(const Document& document, ElementKind kind) {
    std::vector<std::uint32_t> rows;
    for (std::uint32_t row = 0; row < document.elements.size(); ++row) {
        if (document.elements.kind[row] == kind) {
            rows.push_back(row);
        }
    }
    return rows;
}

constexpr double kChordNm = 50.0;
using Copper = std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<ElementId>>;

/// By copper layer and net.
Copper copperOf(const Document& document) {
    Copper copper;
    for (std::uint32_t row = 0; row < document.elements.size(); ++row) {
        const model::LayerId layer = document.elements.layer[row];
        if (document.layer(layer).isCopper() && document.elements.net[row].isValid()) {
            copper[{layer.row(), document.elements.net[row].row()}].push_back(ElementId{row});
        }
    }
    return copper;
}

/// The area of the union of polygons that chords make of the elements, and the length of their outlines.
std::pair<double, double> discretised(const Document& document, const std::vector<ElementId>& elements) {
    model::PolygonSet polygons;
    double length = 1.0;
    for (const ElementId element : elements) {
        for (const EdgeLoops& region : model::outlinesOf(document, element).regions) {
            polygons.append(edge_loop_checks::polygonsOf(region, kChordNm));
            length += lengthOf(region);
        }
    }
    return {edge_loop_checks::areaOf(model::unite(polygons)), length};
}

QString nameOf(const Document& document, std::uint32_t row) {
    return QString("element %1, %2, line %3")
        .arg(row)
        .arg(QString::fromStdString(document.layer(document.elements.layer[row]).name))
        .arg(document.elements.line[row]);
}

}  // namespace

class BoardShellsTest : public QObject {
    Q_OBJECT

private:
    static void addBoards() {
        QTest::addColumn<QString>("board");
        for (const std::filesystem::path& path : locations::allBoards()) {
            QTest::newRow(path.filename().c_str()) << QString::fromStdString(path.string());
        }
    }

private slots:
    void regionsAreSound_data() { addBoards(); }
    void regionsAreSound() {
        QFETCH(QString, board);
        const auto document = read(board.toStdString());
        if (!document) {
            return;  // no board on purpose: tests of the readers say so
        }
        std::map<std::string, int> problems;
        for (std::uint32_t row = 0; row < document->elements.size(); ++row) {
            const model::ElementOutlines outlines = model::outlinesOf(*document, ElementId{row});
            if (!outlines.problem.empty()) {
                ++problems[std::string(outlines.problem)];
                continue;
            }
            for (const EdgeLoops& region : outlines.regions) {
                const auto fault = model::findFault(region);
                QVERIFY2(!fault, qPrintable(nameOf(*document, row) + ": " + (fault ? fault->what.c_str() : "")));
                QVERIFY2(areSound(region), qPrintable(nameOf(*document, row)));
            }
        }
        for (const auto& [problem, count] : problems) {
            qInfo() << count << "elements:" << problem.c_str();
        }
        QCOMPARE(problems["its tracks could not be joined and overlap"], 0);
        QCOMPARE(problems["its outline touches or crosses itself"], 0);
        QCOMPARE(problems["the track overlaps itself"], 0);
    }

    /// What is made locally is what the union of the tracks is.
    void trailsAreTheUnionOfTheirTracks_data() { addBoards(); }
    void trailsAreTheUnionOfTheirTracks() {
        QFETCH(QString, board);
        const auto document = read(board.toStdString());
        const std::vector<std::uint32_t> rows =
            document ? rowsOf(*document, ElementKind::Trail) : std::vector<std::uint32_t>{};
        const std::size_t step = locations::isThorough() ? 1 : std::max<std::size_t>(rows.size() / 2000, 1);
        for (std::size_t i = 0; i < rows.size(); i += step) {
            const model::TrailGeometry& trail = document->trails[document->elements.geometry[rows[i]]];
            const auto regions = model::trailOutlines(*document, trail);
            if (!regions || trail.innerWidth > 0 || trail.width <= 0) {
                continue;
            }
            const auto united = model::unite(model::trackOutlines(*document, trail));
            QVERIFY2(united.has_value(), qPrintable(nameOf(*document, rows[i])));
            QVERIFY2(std::abs(sumOfAreas(*regions) - sumOfAreas(*united)) < 2.0 * sumOfLengths(*united),
                     qPrintable(nameOf(*document, rows[i]) +
                                QString(": %1 instead of %2").arg(sumOfAreas(*regions)).arg(sumOfAreas(*united))));
            QCOMPARE(regions->size(), united->size());
        }
    }

    /// The copper of every net on every layer.
    void netsMerge_data() { addBoards(); }
    void netsMerge() {
        QFETCH(QString, board);
        const auto document = read(board.toStdString());
        std::size_t apart = 0;
        std::size_t compared = 0;
        for (const auto& [place, elements] : document ? copperOf(*document) : Copper{}) {
            const model::MergedShells merged = model::mergedShells(*document, elements);
            std::vector<EdgeLoops> regions;
            for (const model::Shell& shell : merged.shells) {
                const auto fault = model::findFault(shell.outline);
                QVERIFY2(!fault, fault ? fault->what.c_str() : "");
                QVERIFY(areSound(shell.outline));
                regions.push_back(shell.outline);
            }
            apart += merged.apart;
            if (elements.size() > 400 || (compared > 300 && !locations::isThorough())) {
                continue;
            }
            ++compared;
            const auto [area, length] = discretised(*document, elements);
            QVERIFY2(std::abs(sumOfAreas(regions) - area) <= kChordNm * length,
                     qPrintable(QString("net %1 on layer %2: %3 instead of %4, %5 nm")
                                    .arg(place.second)
                                    .arg(place.first)
                                    .arg(sumOfAreas(regions))
                                    .arg(area)
                                    .arg((sumOfAreas(regions) - area) / length)));
        }
        QCOMPARE(apart, 0U);
    }
};

QTEST_APPLESS_MAIN(BoardShellsTest)
#include "board_shells_test.moc"
