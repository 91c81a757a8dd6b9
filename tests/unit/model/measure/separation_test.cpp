// Distances of any two things: against a reference of its own in long double, on boards worked out by hand, and what is
// said where there is no number.
#include "model/measure/separation.h"

#include <QtTest>
#include <cmath>
#include <random>

#include "model/board/stackup.h"
#include "model/figures/distance.h"
#include "model/formats/registry.h"
#include "model/measure/hole_ring.h"
#include "model/solids/restack.h"
#include "tests/locations.h"
#include "tests/unit/model/measure/measure_fixture.h"
#include "tests/unit/model/measure/separation_reference.h"

using namespace model;
using namespace measuring;
using namespace measuring::reference;

namespace {

Separation measured(const BoardIndex& index, const MeasureItem& a, const MeasureItem& b) {
    base::Progress progress;
    return *separationOf(index, a, b, progress);
}

bool says(const Separation& separation, const QString& what) {
    return std::ranges::any_of(separation.notes,
                               [&](const std::string& text) { return QString::fromStdString(text).contains(what); });
}

BoardElement own(ElementId element) {
    return {0, element};
}

bool isNear(double a, double b, double within = 1.0) {
    return std::abs(a - b) <= within;
}

}  // namespace

class SeparationTest : public QObject {
    Q_OBJECT

private slots:
    void everyTwoKindsAgreeWithTheReference() {
        int apartCount = 0;
        int together = 0;
        for (std::size_t kindA = 0; kindA < kKindCount; ++kindA) {
            for (std::size_t kindB = kindA; kindB < kKindCount; ++kindB) {
                DocumentBuilder builder;
                addLayers(builder);
                builder.beginLayer(LayerId{Top});
                Maker maker(builder, static_cast<unsigned>(100 * kindA + kindB));
                std::vector<std::tuple<ElementId, ElementId, double>> pairs;
                for (int round = 0; round < 8; ++round) {
                    const auto a = maker.make(kindA, {0, 0});
                    const auto b = maker.make(kindB, {round * 50'000, round * 25'000});
                    pairs.emplace_back(a.first, b.first, static_cast<double>(between(a.second, b.second)));
                }
                const auto index = indexed(builder.finish());
                for (const auto& [a, b, expected] : pairs) {
                    const Separation s = measured(*index, own(a), own(b));
                    const PieceDistance& way = *s.inPlane;
                    const QString what = QString("%1 and %2: %3, not %4")
                                             .arg(kKinds[kindA])
                                             .arg(kKinds[kindB])
                                             .arg(way.distance)
                                             .arg(expected);
                    QVERIFY2(isNear(way.distance, expected), qPrintable(what));
                    QVERIFY2((way.relation == Relation::Apart) == (expected > kTouchNm), qPrintable(what));
                    QVERIFY(
                        isNear(std::hypot(way.spacing.to.x - way.spacing.from.x, way.spacing.to.y - way.spacing.from.y),
                               way.distance, 1e-3));
                    const Separation back = measured(*index, own(b), own(a));
                    QVERIFY(isNear(back.inPlane->distance, way.distance, 1e-3));
                    QVERIFY(isNear(back.inPlane->overlap, way.overlap, 1e-3) || !way.isOverlapExact);
                    QCOMPARE(s.onLayer->distance, way.distance);
                    (expected > kTouchNm ? apartCount : together)++;
                }
            }
        }
        QVERIFY2(apartCount > 60 && together > 60, qPrintable(QString("%1 %2").arg(apartCount).arg(together)));
    }

    void turningTheBoardChangesNothing() {
        // Copies turned by quarters and turned over: the same distances as in the step itself.
        DocumentBuilder builder;
        addLayers(builder);
        builder.beginLayer(LayerId{Top});
        Maker maker(builder, 5);
        std::vector<std::pair<ElementId, ElementId>> pairs;
        for (std::size_t kind = 0; kind < kKindCount; ++kind) {
            const ElementId a = maker.make(kind, {0, 0}).first;
            pairs.emplace_back(a, maker.make(kKindCount - 1 - kind, {500'000, 300'000}).first);
        }
        const auto step = builder.finish();
        DocumentBuilder panel;
        addLayers(panel);
        const std::uint32_t row = panel.addStep(step);
        for (int i = 0; i < 8; ++i) {
            panel.addInstance({row, {{i * 5 * kMm, 7}, 90.0 * (i % 4), i >= 4}, i >= 4});
        }
        const auto index = indexed(panel.finish());
        const auto alone = indexed(step);
        for (const auto& [a, b] : pairs) {
            const double expected = measured(*alone, own(a), own(b)).inPlane->distance;
            for (std::uint32_t copy = 1; copy <= 8; ++copy) {
                const Separation s = measured(*index, BoardElement{copy, a}, BoardElement{copy, b});
                QVERIFY(isNear(s.inPlane->distance, expected, 1e-3));
                QCOMPARE(s.inPlane->from.layer, LayerId{copy > 4 ? std::size_t{Bottom} : std::size_t{Top}});
            }
        }
        // From copy to copy: discs, whose centres tell.
        const ElementId disc = pairs[2].first;
        const CircleGeometry& circle = step->circles[step->elements.geometry[disc.row()]];
        const Point here = index->tree.copies[1].placement.apply(circle.centre);
        const Point there = index->tree.copies[6].placement.apply(circle.centre);
        const Separation across = measured(*index, BoardElement{1, disc}, BoardElement{6, disc});
        const double centres = std::hypot(double(here.x) - there.x, double(here.y) - there.y);
        QVERIFY(isNear(across.inPlane->distance, centres - circle.diameter, 1e-3));
        QVERIFY(!across.onLayer);
    }

    void heightsComeFromTheStack() {
        DocumentBuilder builder;
        addLayers(builder);
        const NetId a = builder.addNet("A");
        const NetId b = builder.addNet("B");
        builder.beginLayer(LayerId{Top});
        const ElementId top = builder.addCircle({{0, 0}, kMm, 0}, of(a));
        builder.beginLayer(LayerId{Inner});
        const ElementId inner = builder.addCircle({{3 * kMm, 0}, kMm, 0}, of(b));
        builder.beginLayer(LayerId{Bottom});
        const ElementId bottom = builder.addCircle({{0, 0}, kMm, 0}, of(b));
        builder.beginLayer(LayerId{Drawing});
        const ElementId text = builder.addLine({{0, 2 * kMm}, {kMm, 2 * kMm}, 100'000, 0}, {});
        const auto index = indexed(builder.finish());

        const Separation aside = measured(*index, own(top), own(inner));
        QVERIFY(!aside.onLayer && aside.notes.front() == "no common layer");
        QCOMPARE(aside.inPlane->distance, 2.0 * kMm);
        QCOMPARE(aside.throughStackup->dz, 1.0 * kMm);
        QVERIFY(isNear(aside.throughStackup->distance, std::hypot(2e6, 1e6), 1e-3));
        QVERIFY(says(aside, "assumed thicknesses: below top"));
        QCOMPARE(aside.main(), &*aside.throughStackup);

        const Separation below = measured(*index, own(top), own(bottom));
        QCOMPARE(below.inPlane->relation, Relation::Overlapping);
        QVERIFY(isNear(below.inPlane->overlap, kMm, 1e-3));
        QCOMPARE(below.throughStackup->distance, 2.1e6);
        QCOMPARE(below.throughStackup->relation, Relation::Apart);

        const Separation known = measured(*index, own(inner), own(bottom));
        QVERIFY(!says(known, "assumed") && says(known, "both are of net B"));

        const Separation drawn = measured(*index, own(top), own(text));
        QVERIFY(!drawn.throughStackup && says(drawn, "not in the stackup"));
        QCOMPARE(drawn.inPlane->distance, 2.0 * kMm - 500'000 - 50'000);

        // Nets: the nearest pair in space is not the nearest in the plane.
        const Separation nets = measured(*index, NetOfCopy{0, a}, NetOfCopy{0, b});
        QCOMPARE(nets.inPlane->to.at.element, bottom);
        QCOMPARE(nets.throughStackup->to.at.element, bottom);
        QCOMPARE(nets.throughStackup->distance, 2.1e6);
    }

    /// Paste lies beside the solder mask, on the same copper: silkscreen on the mask does not rest on it.
    void layersBesideTheHeightAreNotWhatItRestsOn() {
        Document board;
        const auto row = [&](const char* name, LayerType type, Nm z, Nm thickness, Source source) {
            board.stackup.rows.push_back({name, {}, type, z, thickness, source, {}});
        };
        row("silk", LayerType::SilkScreen, 1'590'000, 15'000, Source::Assumed);
        row("paste", LayerType::SolderPaste, 1'580'000, 100'000, Source::Assumed);
        row("thin paste", LayerType::SolderPaste, 1'580'000, 5'000, Source::Assumed);
        row("mask", LayerType::SolderMask, 1'580'000, 10'000, Source::Job);
        row("copper", LayerType::Signal, 1'545'000, 35'000, Source::Job);
        using Names = std::vector<std::string>;
        QCOMPARE(assumedBetween(board, 1'580'000, 1'590'000), Names{});
        QCOMPARE(assumedBetween(board, 1'580'000, 1'605'000), Names{"silk"});
        QCOMPARE(assumedBetween(board, 1'545'000, 1'680'000), Names{"paste"});
        // No layer ends there.
        QCOMPARE(assumedBetween(board, 1'600'000, 1'650'000), (Names{"silk", "paste"}));
    }

    void holesReachAllTheirLayers() {
        DocumentBuilder builder;
        addLayers(builder);
        builder.beginLayer(LayerId{Inner});
        const ElementId track = builder.addLine({{-kMm, kMm}, {kMm, kMm}, 200'000, 0}, {});
        builder.beginLayer(LayerId{Drill});
        const ElementId via = builder.addCircle({{0, 0}, 600'000, 400'000}, of({}, kHole | kPlated | kVia));
        const ElementId cut = builder.addCircle({{5 * kMm, 0}, 600'000, 400'000}, of({}, kHole | kPlated | kVia));
        builder.addPlatedSpan({cut, LayerId{Bottom}, LayerId{Bottom}});
        const auto index = indexed(builder.finish());
        const Separation s = measured(*index, own(track), own(via));
        QCOMPARE(s.onLayer->distance, 600'000.0);
        QCOMPARE(s.throughStackup->dz, 0.0);
        // Drilled away down to the bottom copper.
        const Separation gone = measured(*index, own(track), own(cut));
        QVERIFY(!gone.onLayer);
        QCOMPARE(gone.throughStackup->dz, 1e6);
    }

    void aHoleWithinCopperHasAnAnnularRing() {
        DocumentBuilder builder;
        addLayers(builder);
        const NetId n = builder.addNet("N");
        builder.beginLayer(LayerId{Top});
        const ElementId disc = builder.addCircle({{0, 0}, 2 * kMm, 0}, of(n, kPad));
        const ElementId oblong = builder.addLine({{5 * kMm, 0}, {7 * kMm, 0}, kMm, 0}, of(n, kPad));
        const ElementId plane =
            builder.addArea({builder.addShape(rectangle({-10 * kMm, -9 * kMm}, {20 * kMm, 30 * kMm})), {}}, of(n));
        const ElementId other = builder.addCircle({{0, 0}, 3 * kMm, 0}, of(builder.addNet("M")));
        builder.beginLayer(LayerId{Bottom});
        const ElementId pair = builder.addCircle({{5'500'000, 0}, 4 * kMm, 0}, of(n, kPad));
        builder.beginLayer(LayerId{Drill});
        const int plated = kHole | kPlated;
        const ElementId hole = builder.addCircle({{100'000, 0}, 500'000, 400'000}, of(n, plated));
        const ElementId beside = builder.addCircle({{6 * kMm, 100'000}, 400'000, 300'000}, of(n, plated));
        const ElementId across = builder.addCircle({{5 * kMm, 400'000}, 400'000, 300'000}, of(n, plated));
        const auto index = indexed(builder.finish());
        const auto expect = [&](ElementId a, ElementId b, double ring, PointD from, PointD to) {
            const auto found = measured(*index, own(a), own(b)).annularRing;
            const auto isAt = [](PointD at, PointD wanted) { return isNear(at.x, wanted.x) && isNear(at.y, wanted.y); };
            return found && isNear(found->distance, ring, 1e-3) && isAt(found->from, from) && isAt(found->to, to);
        };
        QVERIFY(expect(hole, disc, 650'000.0, {350'000, 0}, {1e6, 0}));
        QVERIFY(expect(disc, hole, 650'000.0, {1e6, 0}, {350'000, 0}));
        QVERIFY(expect(beside, oblong, 200'000.0, {6e6, 300'000}, {6e6, 500'000}));
        QVERIFY(expect(hole, plane, 8'750'000.0, {100'000, -250'000}, {100'000, -9e6}));
        const Separation s = measured(*index, own(disc), own(hole));
        QVERIFY(s.notes.front() == "annular ring 0.650000 mm (25.591 mil)");
        QVERIFY(s.main()->relation == Relation::Overlapping && s.main()->overlap > 650'000.0);
        for (const auto& [a, b] : {std::pair(across, oblong), std::pair(hole, other), std::pair(disc, plane),
                                   std::pair(hole, oblong), std::pair(hole, beside)}) {
            QVERIFY(!measured(*index, own(a), own(b)).annularRing);
        }
        QVERIFY(!measured(*index, own(hole), NetOfCopy{0, n}).annularRing);

        const auto inDisc = holeInPad(*index, own(disc));
        QVERIFY(inDisc && inDisc->hole == hole && isNear(inDisc->ring->distance, 650'000.0, 1e-3));
        QVERIFY(!holeInPad(*index, own(pair)) && !holeInPad(*index, own(plane)) && !holeInPad(*index, own(hole)));
    }

    void theEdgeOfTheBoardIsALine() {
        DocumentBuilder builder;
        addLayers(builder);
        builder.setProfile(builder.addShape(rectangle({0, 0}, {20 * kMm, 10 * kMm})));
        builder.beginLayer(LayerId{Top});
        const ElementId inside = builder.addCircle({{2 * kMm, 5 * kMm}, kMm, 0}, {});
        const ElementId across = builder.addCircle({{20 * kMm, 5 * kMm}, kMm, 0}, {});
        const ElementId outside = builder.addCircle({{-2 * kMm, 5 * kMm}, kMm, 0}, {});
        const auto index = indexed(builder.finish());
        const Separation s = measured(*index, own(inside), BoardEdge{});
        QCOMPARE(s.main()->distance, 1.5 * kMm);
        QCOMPARE(s.main()->spacing.to.x, 0.0);
        QVERIFY(!says(s, "outside"));
        QCOMPARE(measured(*index, BoardEdge{}, own(across)).main()->relation, Relation::Overlapping);
        const Separation beyond = measured(*index, own(outside), BoardEdge{});
        QCOMPARE(beyond.main()->distance, 1.5 * kMm);
        QVERIFY(says(beyond, "outside of the board"));
        QVERIFY(says(measured(*index, BoardEdge{}, BoardEdge{}), "the same"));
    }

    void partsAndPinsAreTheirPads() {
        DocumentBuilder builder;
        addLayers(builder);
        const NetId net = builder.addNet("N");
        const std::array<Pin, 3> pins = {Pin{builder.string("1"), {0, 0}, net, {}, 0},
                                         Pin{builder.string("2"), {4 * kMm, 0}, {}, {}, 1},
                                         Pin{builder.string("3"), {100, 0}, net, {}, 2}};
        Component component;
        component.refdes = "U1";
        const ComponentId part = builder.addComponent(component, pins);
        builder.beginLayer(LayerId{Top});
        const auto pad = [&](std::size_t pin, Nm x, NetId of) {
            DocumentBuilder::Origin origin;
            origin.net = of;
            origin.flags = kPad;
            origin.subnet = builder.addSubnet({of, SubnetKind::PinPads, PinId{pin}});
            return builder.addCircle({{x, 0}, kMm, 0}, origin);
        };
        pad(0, 0, net);
        pad(1, 4 * kMm, {});
        const ElementId far = builder.addCircle({{7 * kMm, 0}, kMm, 0}, {});
        const auto index = indexed(builder.finish());
        QCOMPARE(measured(*index, PartOfCopy{0, part}, own(far)).main()->distance, 2.0 * kMm);
        QCOMPARE(measured(*index, PinOfCopy{0, PinId{std::size_t{0}}}, own(far)).main()->distance, 6.0 * kMm);
        QCOMPARE(
            measured(*index, PinOfCopy{0, PinId{std::size_t{0}}}, PinOfCopy{0, PinId{std::size_t{1}}}).main()->distance,
            3.0 * kMm);
        // The third pin shares the pad of the first, which the job ties to that one only.
        QCOMPARE(measured(*index, PinOfCopy{0, PinId{std::size_t{2}}}, own(far)).main()->distance, 6.0 * kMm);
        const Separation within = measured(*index, PinOfCopy{0, PinId{std::size_t{0}}}, NetOfCopy{0, net});
        QVERIFY(within.main() == nullptr && says(within, "the same"));
        const Separation part2 = measured(*index, PinOfCopy{0, PinId{std::size_t{0}}}, PartOfCopy{0, part});
        QVERIFY(part2.main() == nullptr && says(part2, "pin U1.1 is part of U1"));
        QCOMPARE(measured(*index, Location{{7e6, 3e6}, {}}, own(far)).main()->distance, 2.5 * kMm);
    }

    void nothingIsNeverANumber() {
        DocumentBuilder builder;
        addLayers(builder);
        builder.beginLayer(LayerId{Top});
        const ElementId thin = builder.addLine({{0, 0}, {kMm, 0}, 0, 0}, {});
        const ElementId disc = builder.addCircle({{5 * kMm, 0}, kMm, 0}, {});
        const auto index = indexed(builder.finish());
        const Separation s = measured(*index, own(thin), own(disc));
        QVERIFY(s.main() == nullptr && says(s, "covers nothing"));
        const Separation same = measured(*index, own(disc), own(disc));
        QVERIFY(same.main() == nullptr && says(same, "both are the same"));
        QVERIFY(says(measured(*index, BoardEdge{}, own(disc)), "no outline"));
    }

    void aCancelIsHeeded() {
        DocumentBuilder builder;
        addLayers(builder);
        builder.beginLayer(LayerId{Top});
        const ElementId a = builder.addCircle({{0, 0}, kMm, 0}, {});
        const ElementId b = builder.addCircle({{5 * kMm, 0}, kMm, 0}, {});
        const auto index = indexed(builder.finish());
        base::Progress progress;
        progress.cancel();
        QCOMPARE(separationOf(*index, own(a), own(b), progress).error().code, base::ErrorCode::Cancelled);
    }

    void otherThicknessesGiveOtherHeights() {
        base::Progress progress;
        const auto board = *readBoard(locations::kSample, {}, progress);
        const auto index = indexed(board);
        const auto onLayer = [&](const char* name) {
            return BoardElement{0, ElementId{board->layer(board->findLayer(name)).elements.first}};
        };
        const auto dz = [&](const BoardIndex& of) {
            return measured(of, onLayer("L01-TOP_LAYER"), onLayer("L04-BOTTOM_LAYER")).throughStackup->dz;
        };
        const Nm before = findRow(board->stackup, "DIELECTRIC_2")->thickness;
        // All other rows are set to what they are, so that none gives way.
        std::vector<ThicknessOverride> set;
        for (const StackupRow& row : board->stackup.rows) {
            set.push_back({row.name, row.name == "DIELECTRIC_2" ? 2'000'000 : row.thickness});
        }
        const auto thicker = withHeights(*index, restack(*board, set));
        QCOMPARE(dz(*thicker) - dz(*index), 2e6 - before);
    }

    void netsAreMeasuredAsAllTheirPairsWouldBe() {
        base::Progress progress;
        const auto board = readBoard(locations::kSample, {}, progress);
        QVERIFY(board.ok());
        const auto index = indexed(*board);
        std::mt19937 random(9);
        for (int round = 0; round < 12; ++round) {
            const NetId a{random() % (*board)->nets.size()};
            const NetId b{random() % (*board)->nets.size()};
            const Separation s = measured(*index, NetOfCopy{0, a}, NetOfCopy{0, b});
            const Pieces inA = piecesOf(*index, NetOfCopy{0, a});
            const Pieces inB = piecesOf(*index, NetOfCopy{0, b});
            if (a == b || inA.pieces.empty() || inB.pieces.empty()) {
                QVERIFY(s.main() == nullptr);
                continue;
            }
            double expected[3] = {1e18, 1e18, 1e18};
            for (std::size_t i = 0; i < inA.pieces.size(); ++i) {
                for (std::size_t j = 0; j < inB.pieces.size(); ++j) {
                    const double gap = spacingBetween(inA.figures, i, inB.figures, j)->distance;
                    const Piece& p = inA.pieces[i];
                    const Piece& q = inB.pieces[j];
                    const double dz = std::max({0.0, double(p.z.bottom) - q.z.top, double(q.z.bottom) - p.z.top});
                    expected[0] = std::min(expected[0], gap);
                    expected[1] = std::min(expected[1], p.sharesLayerWith(q) ? gap : 1e18);
                    expected[2] = std::min(expected[2], std::hypot(gap, dz));
                }
            }
            QCOMPARE(s.inPlane->distance, expected[0]);
            QCOMPARE(s.onLayer ? s.onLayer->distance : 1e18, expected[1]);
            const Separation inShort =
                *separationOf(*index, NetOfCopy{0, a}, NetOfCopy{0, b}, progress, Depths::OfMain);
            QCOMPARE(inShort.main()->relation, s.main()->relation);
            QCOMPARE(inShort.main()->overlap, s.main()->overlap);
            QCOMPARE(inShort.inPlane->distance, s.inPlane->distance);
            QCOMPARE(inShort.notes, s.notes);
            const auto closest = closestOnLayer(*index, NetOfCopy{0, a}, NetOfCopy{0, b}, progress);
            QCOMPARE(closest ? closest->distance : 1e18, expected[1]);
            QVERIFY(isNear(s.throughStackup->distance, expected[2], 1e-3));
        }
    }
};

QTEST_APPLESS_MAIN(SeparationTest)
#include "separation_test.moc"
