// Whole jobs, from folder to document. The jobs are in tests/data/odb and say in comments what they show.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/base/parallel.h"
#include "model/figures/element_polygons.h"
#include "model/geometry/discretise.h"
#include "tests/unit/model/formats/odb/odb_testing.h"

using namespace odb_testing;
using model::Document;
using model::ElementId;
using model::ElementKind;
using model::Layer;
using model::LayerId;
using model::LayerSide;
using model::Nm;
using model::Point;

namespace {

ElementKind kindOf(const Document& d, ElementId id) {
    return d.elements.kind[id.row()];
}

int flagsOf(const Document& d, ElementId id) {
    return d.elements.flags[id.row()];
}

std::string netOf(const Document& d, ElementId id) {
    const model::NetId net = d.elements.net[id.row()];
    return net.isValid() ? d.nets[net.row()].name : "";
}

const model::LineGeometry& lineOf(const Document& d, ElementId id) {
    return d.lines[d.elements.geometry[id.row()]];
}

const model::CircleGeometry& circleOf(const Document& d, ElementId id) {
    return d.circles[d.elements.geometry[id.row()]];
}

const model::AreaGeometry& areaOf(const Document& d, ElementId id) {
    return d.areas[d.elements.geometry[id.row()]];
}

}  // namespace

class ReaderTest : public QObject {
    Q_OBJECT

private slots:
    void theJobIsDescribed() {
        const auto d = read(dataJob("everything"));
        QCOMPARE(d->job.name, std::string("everything"));
        QCOMPARE(d->job.generator, std::string("A text editor 1.0"));
        QCOMPARE(d->job.version, std::string("8.1"));
        QCOMPARE(d->job.units, std::string("MM"));
        QCOMPARE(d->job.steps, std::vector<std::string>{"BOARD"});
        QCOMPARE(d->job.step, std::string("BOARD"));
        QVERIFY(d->times.parseMs > 0.0 && d->times.createMs > 0.0);
    }

    void layersComeInPhysicalOrderWithSidesAndSpans() {
        const auto d = read(dataJob("everything"));
        std::vector<std::string> names;
        for (const Layer& layer : d->layers) {
            names.push_back(layer.name);
        }
        const std::vector<std::string> expected = {"SST",
                                                   "SPT",
                                                   "SMT",
                                                   "TOP",
                                                   "CORE1",
                                                   "Inner Plane",
                                                   "CORE2",
                                                   "BOTTOM",
                                                   "SMB",
                                                   "COMP_+_TOP",
                                                   "DRILL",
                                                   "BLIND",
                                                   "ROUT",
                                                   "NOTES",
                                                   "COMP_+_BOT",
                                                   "board 1",
                                                   "board 2",
                                                   "SMT solder mask",
                                                   "SMB solder mask",
                                                   "bodies top"};
        QCOMPARE(names, expected);
        QCOMPARE(layerOf(*d, "top").side, LayerSide::Top);
        QCOMPARE(layerOf(*d, "inner plane").side, LayerSide::Inner);
        QCOMPARE(layerOf(*d, "bottom").side, LayerSide::Bottom);
        QCOMPARE(layerOf(*d, "smb").side, LayerSide::Bottom);
        QCOMPARE(layerOf(*d, "comp_+_bot").side, LayerSide::Bottom);
        QCOMPARE(layerOf(*d, "drill").side, LayerSide::Through);
        // The span is written from the bottom to the top; the document has it from the top.
        QCOMPARE(layerOf(*d, "drill").spanTop, d->findLayer("top"));
        QCOMPARE(layerOf(*d, "drill").spanBottom, d->findLayer("bottom"));
        QCOMPARE(layerOf(*d, "blind").spanBottom, d->findLayer("inner plane"));
        QCOMPARE(layerOf(*d, "rout").spanTop, d->findLayer("top"));  // none given: all copper
    }

    void elementsOfALayerAreConsecutiveAndCounted() {
        const auto d = read(dataJob("everything"));
        for (const Layer& layer : d->layers) {
            std::uint32_t sum = 0;
            for (const std::uint32_t count : layer.counts) {
                sum += count;
            }
            QCOMPARE(sum, layer.elements.count);
            for (std::uint32_t i = 0; i < layer.elements.count; ++i) {
                QCOMPARE(&d->layer(d->elements.layer[layer.elements.first + i]), &layer);
            }
        }
        const std::array<std::uint32_t, model::kElementKindCount> expected = {14, 2, 3, 7, 10};
        QCOMPARE(layerOf(*d, "top").counts, expected);
        QCOMPARE(layerOf(*d, "top").featureCount, 27U);
    }

    void strokesBecomeLinesArcsAndTrails() {
        const auto d = read(dataJob("everything"));
        const auto kind = [&](std::uint32_t feature) { return kindOf(*d, elementOf(*d, "top", feature)); };
        QCOMPARE(kind(0), ElementKind::Trail);
        QVERIFY(!elementOf(*d, "top", 1).isValid() && !elementOf(*d, "top", 2).isValid());
        QCOMPARE(kind(3), ElementKind::Line);  // another net
        QCOMPARE(kind(4), ElementKind::Line);  // another place
        QCOMPARE(kind(5), ElementKind::Line);  // a dot
        QCOMPARE(kind(6), ElementKind::Arc);   // a full circle
        QCOMPARE(kind(7), ElementKind::Arc);
        const model::TrailGeometry& trail = d->trails[d->elements.geometry[elementOf(*d, "top", 0).row()]];
        const auto nodes = d->nodesOf(trail);
        QCOMPARE(trail.width, 200'000);
        QCOMPARE(nodes.size(), std::size_t{4});
        QCOMPARE(nodes[2].edge, model::EdgeKind::ArcClockwise);
        QCOMPARE(nodes[3].point, (Point{3'000'000, 3'000'000}));
        const model::LineGeometry& dot = lineOf(*d, elementOf(*d, "top", 5));
        QCOMPARE(dot.a, dot.b);
    }

    void padsBecomeCirclesLinesAndSharedAreas() {
        const auto d = read(dataJob("everything"));
        QCOMPARE(circleOf(*d, elementOf(*d, "top", 8)).diameter, 200'000);
        QCOMPARE(circleOf(*d, elementOf(*d, "top", 9)).innerDiameter, 1'000'000);
        const model::LineGeometry& oval = lineOf(*d, elementOf(*d, "top", 10));
        QCOMPARE(oval.width, 400'000);
        QCOMPARE(oval.a.x, 5'000'000);  // stands up
        QCOMPARE(std::abs(oval.a.y - oval.b.y), 800'000);
        const model::AreaGeometry& plain = areaOf(*d, elementOf(*d, "top", 11));
        const model::AreaGeometry& rotated = areaOf(*d, elementOf(*d, "top", 12));
        const model::AreaGeometry& mirrored = areaOf(*d, elementOf(*d, "top", 13));
        QCOMPARE(plain.shape, rotated.shape);
        QCOMPARE(plain.shape, mirrored.shape);
        QCOMPARE(rotated.placement.clockwiseDeg, 30.0);
        QVERIFY(!rotated.placement.isMirrored && mirrored.placement.isMirrored);
        QVERIFY((flagsOf(*d, elementOf(*d, "top", 8)) & model::kPad) != 0);
        QCOMPARE(circleOf(*d, elementOf(*d, "top", 26)).diameter, 100'000);  // resized
    }

    void aTurnedPadIsTurnedClockwise() {
        // The rectangle is 1 × 0.5 mm; turned clockwise by 30° its right end goes down, mirrored it is its left end.
        const auto d = read(dataJob("everything"));
        const auto rightEndGoesDown = [&](std::uint32_t feature) {
            const model::PolygonSet set = model::discretise(*d, elementOf(*d, "top", feature), {});
            const Point right = *std::ranges::max_element(set.points, {}, &Point::x);
            return right.y < 5'000'000;
        };
        QVERIFY(rightEndGoesDown(12));
        QVERIFY(!rightEndGoesDown(13));
    }

    void userSymbolsAreResolvedInTheirOwnUnits() {
        const auto d = read(dataJob("everything"));
        QVERIFY(std::abs(squareMillimetres(*d, elementOf(*d, "top", 15)) - 0.2) < 1e-6);
        // Two strokes of 20 mil length and 10 mil width that cross: exact area of their union.
        const double mil = 0.0254;
        const double width = 10 * mil;
        const double capsule = 20 * mil * width + std::numbers::pi * width * width / 4;
        const double crossed = 2 * capsule - width * width;
        QVERIFY(std::abs(squareMillimetres(*d, elementOf(*d, "top", 16)) - crossed) <
                0.005 * crossed);  // 1 µm chords on a radius of 127 µm
        // A symbol of two others that keep apart.
        QVERIFY(std::abs(squareMillimetres(*d, elementOf(*d, "top", 23)) - 0.4) < 1e-6);
        const Nm right = d->boxOf(elementOf(*d, "top", 23)).max.x;
        QCOMPARE(right, 6'000'000 + 1'000'000 + 100'000);
    }

    void surfacesKeepHolesAndIslandsInHoles() {
        const auto d = read(dataJob("everything"));
        const ElementId id = elementOf(*d, "top", 17);
        QCOMPARE(kindOf(*d, id), ElementKind::Area);
        QCOMPARE(d->shapes.contoursOf(areaOf(*d, id).shape).size(), std::size_t{3});
        const double expected = 4 * 2.5 - std::numbers::pi + std::numbers::pi / 4;
        QVERIFY(std::abs(squareMillimetres(*d, id) - expected) < 0.01);
    }

    void otherPensAreSwept() {
        const auto d = read(dataJob("everything"));
        const ElementId square = elementOf(*d, "top", 19);
        QVERIFY((flagsOf(*d, square) & model::kSquarePen) != 0);
        QCOMPARE(lineOf(*d, square).width, 1'016'000);
        const ElementId slope = elementOf(*d, "top", 20);
        QCOMPARE(kindOf(*d, slope), ElementKind::Area);
        // The pen 1 × 0.5 mm moved by (1, 1): the pen itself plus one parallelogram for either side.
        QVERIFY(std::abs(squareMillimetres(*d, slope) - (0.5 + 1.0 + 0.5)) < 1e-6);
        QCOMPARE(lineOf(*d, elementOf(*d, "top", 18)).width, 0);
    }

    void holesAreBarrelsPlatedOrBare() {
        const auto d = read(dataJob("everything"));
        const auto hole = [&](std::uint32_t feature) { return elementOf(*d, "drill", feature); };
        QCOMPARE(flagsOf(*d, hole(0)), model::kHole | model::kPlated | model::kPad);
        QCOMPARE(circleOf(*d, hole(0)).diameter, 500'000);
        QCOMPARE(circleOf(*d, hole(0)).innerDiameter, 450'000);
        QVERIFY((flagsOf(*d, hole(1)) & model::kPlated) != 0);  // a via
        QCOMPARE(flagsOf(*d, hole(2)), model::kHole | model::kPad);
        QCOMPARE(circleOf(*d, hole(2)).innerDiameter, circleOf(*d, hole(2)).diameter);
        QCOMPARE(lineOf(*d, hole(3)).width, 500'000);  // a slot drawn as a stroke
        QCOMPARE(lineOf(*d, hole(3)).innerWidth, 450'000);
        QCOMPARE(lineOf(*d, hole(4)).width, 800'000);  // a slot drawn as an oval pad
        QCOMPARE(lineOf(*d, hole(4)).innerWidth, 800'000);
        // Without attribute: the only tool of 500 µm is not plated.
        QCOMPARE(flagsOf(*d, hole(5)), model::kHole | model::kPad);
        QVERIFY((flagsOf(*d, elementOf(*d, "blind", 0)) & model::kPlated) != 0);
        const ElementId rout = elementOf(*d, "rout", 0);
        QCOMPARE(kindOf(*d, rout), ElementKind::Trail);
        QCOMPARE(flagsOf(*d, rout), int{model::kHole});
        QVERIFY(findDiagnostic(d->diagnostics, "taken as plated") != nullptr);
        QVERIFY(findDiagnostic(d->diagnostics, "the job does not say how thick the copper in plated holes is") !=
                nullptr);
        QCOMPARE(d->tools.size(), std::size_t{2});
        QCOMPARE(d->tools[0].layer, d->findLayer("drill"));
    }

    void stackupTakesWhatTheJobSaysAndSharesTheRest() {
        const auto d = read(dataJob("everything"));
        QCOMPARE(layerOf(*d, "bottom").z, 0);
        QCOMPARE(layerOf(*d, "bottom").thickness, 35'000);
        QCOMPARE(layerOf(*d, "bottom").thicknessSource, model::Source::Assumed);
        QCOMPARE(layerOf(*d, "inner plane").thickness, 34'800);  // 1 oz
        QCOMPARE(layerOf(*d, "top").thickness, 70'000);          // µm in an MM file
        QCOMPARE(layerOf(*d, "core1").thickness, 200'000);
        QCOMPARE(layerOf(*d, "core2").thickness, 1'600'000 - 35'000 - 34'800 - 70'000 - 200'000);
        QCOMPARE(layerOf(*d, "core2").thicknessSource, model::Source::Derived);
        QCOMPARE(d->boardThickness, 1'600'000);
        QCOMPARE(layerOf(*d, "top").z, 1'530'000);
        QCOMPARE(layerOf(*d, "drill").z, 0);
        QCOMPARE(layerOf(*d, "drill").thickness, 1'600'000);
        QCOMPARE(layerOf(*d, "blind").z, layerOf(*d, "inner plane").z);
        QCOMPARE(layerOf(*d, "blind").z + layerOf(*d, "blind").thickness, 1'600'000);
        QCOMPARE(layerOf(*d, "smt").z, 1'600'000);
        QVERIFY(layerOf(*d, "sst").z > layerOf(*d, "smt").z);
        QCOMPARE(layerOf(*d, "smb").z + layerOf(*d, "smb").thickness, 0);
        QCOMPARE(layerOf(*d, "notes").thickness, 0);
    }

    void netsComeFromTheFeatureIds() {
        const auto d = read(dataJob("everything"));
        QCOMPARE(d->nets.size(), std::size_t{3});  // $NONE$ is none
        QCOMPARE(netOf(*d, elementOf(*d, "top", 0)), std::string("GND"));
        QCOMPARE(netOf(*d, elementOf(*d, "top", 3)), std::string("VCC/+3V3\\x"));
        QCOMPARE(netOf(*d, elementOf(*d, "top", 4)), std::string(""));   // in a text group
        QCOMPARE(netOf(*d, elementOf(*d, "top", 18)), std::string(""));  // in $NONE$
        QCOMPARE(netOf(*d, elementOf(*d, "inner plane", 0)), std::string("GND"));
        QCOMPARE(netOf(*d, elementOf(*d, "drill", 0)), std::string("GND"));
        QCOMPARE(d->elementsOf(d->findNet("GND")).size(), std::size_t{3});
        QVERIFY(findDiagnostic(d->diagnostics, "has no feature of that number") != nullptr);
        QVERIFY(findDiagnostic(d->diagnostics, "names no layer of the LYR line") != nullptr);
    }

    void componentsHavePinsPackagesAndNets() {
        const auto d = read(dataJob("everything"));
        QCOMPARE(d->components.size(), std::size_t{2});
        const model::Component& u1 = d->components[0];
        QCOMPARE(u1.refdes, std::string("U1"));
        QCOMPARE(u1.part, std::string("Part_10\xc2\xb5"
                                      "F"));
        QCOMPARE(d->packages[u1.package.row()].name, std::string("SOT"));
        QCOMPARE(u1.placement.clockwiseDeg, 90.0);
        QCOMPARE(u1.side, LayerSide::Top);
        QCOMPARE(u1.pinCount, 2U);
        QCOMPARE(d->pins[u1.firstPin].net, d->findNet("VCC/+3V3\\x"));
        QCOMPARE(d->text(d->pins[u1.firstPin + 1].name), std::string("2"));  // from the package
        QVERIFY(!d->pins[u1.firstPin + 1].net.isValid());
        QCOMPARE(d->components[1].side, LayerSide::Bottom);
        QVERIFY(d->components[1].placement.isMirrored);  // on the bottom, and no pin says otherwise
        QCOMPARE(d->components[1].placement.origin, (Point{2'540'000, 5'080'000}));
    }

    void whatIsNotReadIsReportedWithItsPlace() {
        const auto d = read(dataJob("everything"));
        const auto at = [&](const char* text) {
            const model::Diagnostic* entry = findDiagnostic(d->diagnostics, text);
            return entry == nullptr ? std::string() : entry->file + ":" + std::to_string(entry->line);
        };
        QCOMPARE(at("the job has no font standard"), std::string("steps/board/layers/top/features:73"));
        QCOMPARE(at("a barcode does not say how large its text is"), std::string("steps/board/layers/top/features:74"));
        QCOMPARE(at("symbol nowhere is neither"), std::string("steps/board/layers/top/features:68"));
        QCOMPARE(at("symbol r-13.1234 has a negative size"), std::string("steps/board/layers/top/features:69"));
        QCOMPARE(at("layer SPT is in the matrix"), std::string("matrix/matrix:27"));
        QVERIFY(findDiagnostic(d->diagnostics, "no features: SMT, SMB") != nullptr);
    }

    void profileAndExtentAreTheBoards() {
        const auto d = read(dataJob("everything"));
        QCOMPARE(d->board.min, (Point{0, 0}));
        QCOMPARE(d->board.max, (Point{20'000'000, 10'000'000}));
        QCOMPARE(d->shapes.contoursOf(d->profile).size(), std::size_t{2});
        QCOMPARE(layerOf(*d, "board 1").counts[4], 1U);
    }

    void oneAndManyThreadsGiveTheSameDocument() {
        for (const char* name : {"everything", "panel", "negative"}) {
            std::string single;
            {
                const base::ThreadLimit one(1);
                single = fingerprint(*read(dataJob(name)));
            }
            for (int i = 0; i < 5; ++i) {
                QVERIFY(fingerprint(*read(dataJob(name))) == single);
            }
        }
    }

    // ---- rigid-flex ----

    void theMatrixSaysWhatLayersAreFor() {
        using model::LayerUse;
        const std::vector<std::pair<std::string, LayerUse>> words = {
            {"", LayerUse::Plain},          {"SIGNAL_FLEX", LayerUse::Flex},        {"COVERLAY", LayerUse::Coverlay},
            {"PSA", LayerUse::Adhesive},    {"FR4_STIFFENER", LayerUse::Stiffener}, {"BACKDRILL", LayerUse::Backdrill},
            {"EMBEDDED_R", LayerUse::Other}};
        for (const auto& [word, use] : words) {
            Folder folder;
            writeSmallJob(folder, "UNITS=MM\n");
            folder.write("matrix/matrix",
                         "STEP {\nCOL=1\nNAME=BOARD\n}\nLAYER {\nROW=1\nCONTEXT=BOARD\nTYPE=SIGNAL\n"
                         "NAME=TOP\nADD_TYPE=" +
                             word + "\n}\n");
            const auto d = read(folder.path());
            QCOMPARE(layerOf(*d, "top").use, use);
            QCOMPARE(layerOf(*d, "top").useName, word);
        }
    }

    void aLayersOwnProfileBoundsItsPlane() {
        Folder folder;
        writeSmallJob(folder, "UNITS=MM\n$0 r1000\nP 5 5 0 P 0 0\n");
        std::string matrix = matrixOf({{"SIGNAL", "TOP"}, {"POWER_GROUND", "FLEX"}});
        matrix.insert(matrix.rfind("NAME=FLEX"), "POLARITY=NEGATIVE\n ");
        folder.write("matrix/matrix", matrix);
        folder.write("steps/board/layers/flex/features", "UNITS=MM\n");
        folder.write("steps/board/layers/flex/profile",
                     "UNITS=MM\nS P 0\nOB 0 0 I\nOS 30 0\nOS 30 20\nOS 0 20\nOS 0 0\nOE\nSE\n");
        const auto d = read(folder.path());
        QVERIFY(layerOf(*d, "flex").profile.isValid());
        QVERIFY(!layerOf(*d, "top").profile.isValid());
        QCOMPARE(squareMillimetres(*d, ElementId{layerOf(*d, "flex").elements.first}), 600.0);
    }

    // ---- paint order ----

    void aNegativeFeatureTakesAwayWhatIsBelowIt() {
        const auto d = read(dataJob("negative"));
        const ElementId plate = elementOf(*d, "top", 1);
        QCOMPARE(kindOf(*d, plate), ElementKind::Area);
        QCOMPARE(squareMillimetres(*d, plate), 16.0 - 4.0);
        QCOMPARE(netOf(*d, plate), std::string("HOLLOW"));
        QVERIFY(!elementOf(*d, "top", 2).isValid());
        // What is painted later, and what is elsewhere, stays as it is.
        QCOMPARE(kindOf(*d, elementOf(*d, "top", 3)), ElementKind::Circle);
        QCOMPARE(kindOf(*d, elementOf(*d, "top", 0)), ElementKind::Circle);
        QCOMPARE(kindOf(*d, elementOf(*d, "top", 4)), ElementKind::Line);
    }

    void aNegativeLayerIsTheProfileMinusItsFeatures() {
        const auto d = read(dataJob("negative"));
        const Layer& plane = layerOf(*d, "plane");
        QVERIFY(plane.isNegative);
        // A bar cuts the plane in two; in the left part is a frame with copper in it.
        QCOMPARE(plane.counts[4], 3U);
        QCOMPARE(plane.elements.count, 3U);
        double area = 0.0;
        for (std::uint32_t i = 0; i < plane.elements.count; ++i) {
            area += squareMillimetres(*d, ElementId{plane.elements.first + i});
        }
        QCOMPARE(area, 100.0 - 0.5 * 10 - (4.0 - 1.0));
        QVERIFY(findDiagnostic(d->diagnostics, "layer PLANE is negative") != nullptr);
    }

    // ---- profiles ----

    void aMissingProfileIsTakenFromTheCopper() {
        Folder folder;
        writeSmallJob(folder, "UNITS=MM\n$0 r1000\nL 1 1 9 5 0 P 0\n");
        fs::remove(folder.path() / "steps/board/profile");
        const auto d = read(folder.path());
        QCOMPARE(d->board.min, (Point{500'000, 500'000}));
        QCOMPARE(d->board.max, (Point{9'500'000, 5'500'000}));
        QVERIFY(findDiagnostic(d->diagnostics, "the step has no profile") != nullptr);
    }

    void aProfileThatDoesNotEncloseTheCopperIsNotBelieved() {
        Folder folder;
        writeSmallJob(folder, "UNITS=MM\n$0 r1000\nP 10 10 0 P 0 0\nP 80 20 0 P 0 0\nP 50 50 0 P 0 0\n");
        folder.write("steps/board/profile",
                     "UNITS=MM\nS P 0\nOB 0 0 I\nOS 3.3 0\nOS 3.3 1.6\nOS 0 1.6\nOS 0 0\nOE\nSE\n");
        const auto d = read(folder.path());
        QCOMPARE(d->board.max, (Point{80'500'000, 50'500'000}));
        QVERIFY(findDiagnostic(d->diagnostics, "does not enclose the copper") != nullptr);
    }

    void aProfileIsBelievedAlthoughTextLiesOutside() {
        Folder folder;
        writeSmallJob(folder, "UNITS=MM\n$0 r1000\nP 10 10 0 P 0 0\nP 80 20 0 P 0 0\nP 300 50 0 P 0 0\n");
        QCOMPARE(read(folder.path())->board.max, (Point{100'000'000, 100'000'000}));
    }

    // ---- symbols ----

    void aSymbolInsideItselfDrawsNothing() {
        Folder folder;
        writeSmallJob(folder, "UNITS=MM\n$0 a\nP 1 1 0 P 0 0\n");
        folder.write("symbols/a/features", "UNITS=MM\n$0 b\n$1 r100\nP 0 0 0 P 0 0\nP 0 0 1 P 0 0\n");
        folder.write("symbols/b/features", "UNITS=MM\n$0 a\nP 0 0 0 P 0 0\n");
        const auto d = read(folder.path());
        QVERIFY(findDiagnostic(d->diagnostics, "contains itself") != nullptr);
        QCOMPARE(layerOf(*d, "top").counts[4], 1U);  // the rest of symbol a
    }

    void aUserSymbolMayTakeAway() {
        Folder folder;
        writeSmallJob(folder, "UNITS=MM\n$0 frame\nP 10 10 0 P 0 0\n");
        folder.write("symbols/frame/features", "UNITS=MM\n$0 s2000\n$1 s1000\nP 0 0 0 P 0 0\nP 0 0 1 N 0 0\n");
        const auto d = read(folder.path());
        QCOMPARE(squareMillimetres(*d, elementOf(*d, "top", 0)), 3.0);
    }

    void undefinedSymbolsAreOneEntryEach() {
        Folder folder;
        writeSmallJob(folder, "UNITS=MM\n$0 x\n$1 y\nP 1 1 0 P 0 0\nP 2 1 0 P 0 0\nP 3 1 1 P 0 0\nP 4 1 0 P 0 0\n");
        const auto d = read(folder.path());
        const model::Diagnostic* x = findDiagnostic(d->diagnostics, "symbol x ");
        QVERIFY(x != nullptr);
        QCOMPARE(x->count, 3U);
        QCOMPARE(x->line, 4U);
        QVERIFY(findDiagnostic(d->diagnostics, "symbol y ") != nullptr);
    }

    // ---- hostile jobs ----

    void filesThatAreNotReadOrSayNothingAreNamed() {
        Folder folder;
        writeSmallJob(folder, "UNITS=MM\n$0 r1000\nP 1 1 0 P 0 0\n");
        folder.write("steps/board/impedance.xml", "<Impedances/>");
        folder.write("steps/board/layers/top/profile", "UNITS=MM\n");
        const auto d = read(folder.path());
        QVERIFY(findDiagnostic(d->diagnostics, "the layer's profile holds no outline") != nullptr);
        QVERIFY(findDiagnostic(d->diagnostics, "impedance requirements are not read") != nullptr);
        QVERIFY(findDiagnostic(d->diagnostics, "no eda/data") != nullptr);
    }

    void ofJobsBesideEachOtherOneIsShownAndTheOthersNamed() {
        const Folder folder;
        for (const char* const job : {"deep/er/a/", "second/", "first/", "first/user/copy/"}) {
            folder.write(std::string(job) + "matrix/matrix", matrixOf({{"SIGNAL", "TOP"}}));
            folder.write(std::string(job) + "steps/board/profile", "");
        }
        const auto d = read(folder.path());
        const auto* const entry = findDiagnostic(d->diagnostics, "several ODB++ jobs lie here");
        QVERIFY(entry != nullptr);
        QCOMPARE(entry->text, std::string("Several ODB++ jobs lie here; first is shown, and not: second, deep/er/a"));
        QVERIFY(findDiagnostic(read(folder.path() / "first")->diagnostics, "several ODB++ jobs") == nullptr);
    }

    void aMatrixAloneIsABoardWithoutAnything() {
        Folder folder;
        folder.write("matrix/matrix", "");
        folder.write("steps/x/stephdr", "");
        const auto d = read(folder.path());
        QCOMPARE(d->elements.size(), std::size_t{0});
        QCOMPARE(d->job.step, std::string("x"));
    }

    void everyTruncatedFileOfAJobIsReadWithoutHarm() {
        Folder folder;
        folder.copyJob("everything");
        for (const char* name :
             {"matrix/matrix", "misc/info", "misc/attrlist", "steps/board/stephdr", "steps/board/profile",
              "steps/board/eda/data", "steps/board/layers/drill/tools", "steps/board/layers/drill/features",
              "symbols/twice/features", "steps/board/layers/comp_+_top/components"}) {
            const std::string whole = readFile(folder.path() / name);
            for (std::size_t length = 0; length < whole.size(); length += 1 + whole.size() / 23) {
                folder.write(name, whole.substr(0, length));
                const auto result = tryRead(folder.path());
                QVERIFY2(result.ok(), name);
            }
            folder.write(name, whole);
        }
    }
};

QTEST_APPLESS_MAIN(ReaderTest)
#include "reader_test.moc"
