#include "model/solids/solids.h"

#include <QtTest>

#include "model/base/parallel.h"
#include "model/board/flip.h"
#include "model/figures/element_polygons.h"
#include "model/geometry/discretise.h"
#include "tests/unit/model/hand_made.h"

using hand_made::kMm;
using model::DocumentBuilder;
using model::ElementId;
using model::Layer;
using model::LayerType;

namespace {

void addSquare(DocumentBuilder& builder) {
    model::ShapeSketch outline;
    const model::Point corners[] = {{0, 0}, {10'000'000, 0}, {10'000'000, 10'000'000}, {0, 10'000'000}};
    outline.addPolygon(corners, false);
    builder.setProfile(builder.addShape(outline));
}

std::shared_ptr<const model::Document> withSolids(DocumentBuilder& builder) {
    base::Progress progress;
    return model::addSolids(builder, progress) ? builder.finish() : nullptr;
}

double areaMm2(const model::Document& document, const Layer& layer) {
    const model::PolygonSet region = model::discretise(document, ElementId{layer.elements.first}, {500.0, false});
    return static_cast<double>(model::twiceArea(region)) / 2e12;
}

/// Two copper layers 35 µm thick on either side of 1.53 mm, a 10 × 10 mm outline and one hole of 1 mm, plus one that
/// touches it.
std::shared_ptr<const model::Document> boardWithHoles() {
    DocumentBuilder builder;
    addSquare(builder);
    Layer copper;
    copper.type = LayerType::Signal;
    copper.thickness = 35'000;
    copper.z = 1'565'000;
    builder.addLayer(copper);
    copper.z = 0;
    builder.addLayer(copper);
    Layer drill;
    drill.type = LayerType::Drill;
    drill.thickness = 1'600'000;
    builder.beginLayer(builder.addLayer(drill));
    DocumentBuilder::Origin hole;
    hole.flags = model::kHole;
    builder.addCircle({{5'000'000, 5'000'000}, 1'000'000, 1'000'000}, hole);
    builder.addLine({{2'000'000, 2'000'000}, {4'000'000, 2'000'000}, 1'000'000, 0}, hole);
    builder.addCircle({{10'000'000, 5'000'000}, 2'000'000, 2'000'000}, hole);  // a castellation
    return withSolids(builder);
}

/// The same square of copper, with a mask of two openings, one routed slot, and a wide and a narrow plated hole.
std::shared_ptr<const model::Document> boardWithMask() {
    DocumentBuilder builder;
    addSquare(builder);
    Layer copper;
    copper.type = LayerType::Signal;
    copper.thickness = 35'000;
    builder.addLayer(copper);
    Layer mask;
    mask.name = "SMT";
    mask.type = LayerType::SolderMask;
    mask.side = model::LayerSide::Top;
    mask.z = 35'000;
    mask.thickness = 25'000;
    builder.beginLayer(builder.addLayer(mask));
    builder.addCircle({{2'000'000, 2'000'000}, 1'000'000, 0}, {});
    builder.addLine({{4'000'000, 2'000'000}, {6'000'000, 2'000'000}, 1'000'000, 0}, {});
    Layer holes;
    holes.thickness = 35'000;
    DocumentBuilder::Origin hole;
    hole.flags = model::kHole;
    holes.type = LayerType::Rout;
    builder.beginLayer(builder.addLayer(holes));
    builder.addLine({{2'000'000, 8'000'000}, {4'000'000, 8'000'000}, 1'000'000, 1'000'000}, hole);
    holes.type = LayerType::Drill;
    builder.beginLayer(builder.addLayer(holes));
    hole.flags = model::kHole | model::kPlated;
    builder.addCircle({{8'000'000, 8'000'000}, 1'000'000, 950'000}, hole);
    builder.addCircle({{8'000'000, 5'000'000}, 400'000, 350'000}, hole);
    mask.name = "empty";
    builder.addLayer(mask);
    return withSolids(builder);
}

model::ShapeSketch upTo6Mm() {
    return hand_made::rectangle({0, 0}, {6 * kMm, 10 * kMm});
}

/// Three copper layers of a square of 10 mm, and two dielectrics between them with outlines of their own.
std::shared_ptr<const model::Document> twoZones(const model::ShapeSketch& upper, const model::ShapeSketch& lower) {
    DocumentBuilder builder;
    addSquare(builder);
    const auto addCopper = [&](model::Nm z) {
        Layer layer;
        layer.type = LayerType::Signal;
        layer.z = z;
        layer.thickness = 100'000;
        builder.addLayer(layer);
    };
    const auto addDielectric = [&](model::Nm z, const model::ShapeSketch& outline, std::uint32_t group) {
        Layer layer;
        layer.type = LayerType::Dielectric;
        layer.z = z;
        layer.thickness = 500'000;
        layer.profile = builder.addShape(outline);
        layer.outlineGroup = group;
        builder.addLayer(layer);
    };
    addCopper(1'200'000);
    addDielectric(700'000, upper, 1);
    addCopper(600'000);
    addDielectric(100'000, lower, 2);
    addCopper(0);
    return withSolids(builder);
}

/// Four copper layers with masks outside, drilled from the first to the second and, if so, from the last to the one
/// above.
std::shared_ptr<const model::Document> drilledFromOutside(bool isFromBothSides) {
    DocumentBuilder builder;
    addSquare(builder);
    const auto add = [&](const char* name, LayerType type, model::LayerSide side, model::Nm z, model::Nm thickness) {
        const model::LayerId id = hand_made::addLayer(builder, type, side, z, thickness);
        builder.layer(id).name = name;
        return id;
    };
    using model::LayerSide;
    add("mask top", LayerType::SolderMask, LayerSide::Top, 1'600'000, 20'000);
    const model::LayerId copper[] = {add("l1", LayerType::Signal, LayerSide::Top, 1'550'000, 50'000),
                                     add("l2", LayerType::Signal, LayerSide::Inner, 1'300'000, 50'000),
                                     add("l3", LayerType::Signal, LayerSide::Inner, 400'000, 50'000),
                                     add("l4", LayerType::Signal, LayerSide::Bottom, 0, 50'000)};
    add("mask bottom", LayerType::SolderMask, LayerSide::Bottom, -30'000, 30'000);
    const auto drill = [&](model::LayerId top, model::LayerId bottom) {
        const Layer& low = builder.layer(bottom);
        const Layer& high = builder.layer(top);
        const model::LayerId id =
            add("drill", LayerType::Drill, LayerSide::None, low.z, high.z + high.thickness - low.z);
        builder.layer(id).spanTop = top;
        builder.layer(id).spanBottom = bottom;
    };
    drill(copper[0], copper[1]);
    if (isFromBothSides) {
        drill(copper[2], copper[3]);
    }
    model::setOpposites(builder.layers());
    return withSolids(builder);
}

bool saysThatArcsAreLost(const model::Document& document) {
    return std::ranges::any_of(document.diagnostics.entries(), [](const model::Diagnostic& entry) {
        return entry.text.find("straight edges within 1 µm") != std::string::npos;
    });
}

}  // namespace

class SolidsTest : public QObject {
    Q_OBJECT

private slots:
    void bodyFillsTheSpaceBetweenTheOuterCopperLayers() {
        const auto document = boardWithHoles();
        const Layer& body = document->layers.back();
        QCOMPARE(body.type, LayerType::Body);
        QVERIFY(body.isSynthetic);
        QCOMPARE(body.z, 35'000);
        QCOMPARE(body.thickness, 1'530'000);
        QCOMPARE(body.elements.count, 1U);
    }

    void bodyIsTheOutlineMinusTheHoles() {
        const auto document = boardWithHoles();
        const ElementId body{document->layers.back().elements.first};
        const model::PolygonSet region = model::discretise(*document, body, {500.0, false});
        const double expected = 100.0 - M_PI * 0.25 - (2.0 + M_PI * 0.25) - M_PI / 2;
        QVERIFY(std::abs(areaMm2(*document, document->layers.back()) - expected) < 0.05);
        QCOMPARE(region.polygons.size(), 1U);
        QCOMPARE(region.loopCount(), 3U);
    }

    void boardWithoutAnOutlineGetsNoBody() {
        DocumentBuilder builder;
        QVERIFY(withSolids(builder)->layers.empty());
    }

    /// A dielectric to x = 6 mm, the next from x = 4 mm on; copper between them has resin beside it where they overlap.
    void besideCopperTheBodyIsWhereBothDielectricsAre() {
        const auto document = twoZones(upTo6Mm(), hand_made::rectangle({4 * kMm, 0}, {10 * kMm, 10 * kMm}));
        std::vector<double> areas;
        for (const Layer& layer : document->layers) {
            if (layer.type == LayerType::Body) {
                areas.push_back(areaMm2(*document, layer));
            }
        }
        QCOMPARE(areas, (std::vector<double>{60.0, 20.0, 60.0}));
        QVERIFY(!saysThatArcsAreLost(*document));
    }

    void outlinesThatCrossLoseTheirArcsAndSayIt_data() {
        QTest::addColumn<int>("centreXMm");
        QTest::addColumn<bool>("isLost");
        QTest::newRow("across the edge of the other") << 6 << true;
        QTest::newRow("within the other") << 3 << false;
        QTest::newRow("apart") << 8 << false;
    }
    void outlinesThatCrossLoseTheirArcsAndSayIt() {
        QFETCH(int, centreXMm);
        QFETCH(bool, isLost);
        model::ShapeSketch disc;
        disc.addCircle({centreXMm * kMm, 5 * kMm}, kMm, false);
        QCOMPARE(saysThatArcsAreLost(*twoZones(upTo6Mm(), disc)), isLost);
    }

    void solderMaskIsTheOutlineMinusOpeningsAndOpenHoles() {
        const auto document = boardWithMask();
        const Layer& coat = document->layer(document->findLayer("SMT solder mask"));
        QCOMPARE(coat.type, LayerType::SolderMask);
        QCOMPARE(coat.side, model::LayerSide::Top);
        QVERIFY(coat.isSynthetic);
        QCOMPARE(coat.z, 35'000);
        QCOMPARE(coat.thickness, 25'000);
        const double slot = 2.0 + M_PI / 4;
        // The narrow plated hole stays under the lacquer.
        QVERIFY(std::abs(areaMm2(*document, coat) - (100.0 - M_PI / 2 - slot - slot)) < 0.01);
        QCOMPARE(document->layer(document->findLayer("empty solder mask")).elements.count, 0U);
    }

    void syntheticLayersHaveOpposites() {
        const auto d = drilledFromOutside(true);
        const auto opposite = [&](const char* name) {
            const model::LayerId id = d->layer(d->findLayer(name)).opposite;
            return id.isValid() ? QString::fromStdString(d->layer(id).name) : QString();
        };
        QCOMPARE(opposite("mask top solder mask"), QString("mask bottom solder mask"));
        QCOMPARE(opposite("mask bottom solder mask"), QString("mask top solder mask"));
        QCOMPARE(opposite("board 1"), QString("board 3"));
        QCOMPARE(opposite("board 2"), QString("board 2"));
        QCOMPARE(opposite("board 3"), QString("board 1"));
    }

    /// Between other copper a part of the substrate would overlap what is drilled there.
    void partsOfTheSubstrateThatHaveNoMirrorImageAreMirroredThroughTheBoard() {
        const auto d = drilledFromOutside(false);
        QVERIFY(d->findLayer("board 2").isValid() && !d->findLayer("board 3").isValid());
        QVERIFY(!d->layer(d->findLayer("board 1")).opposite.isValid());
        QVERIFY(!d->layer(d->findLayer("board 2")).opposite.isValid());
    }

    void aPanelIsWithoutTheBoardsItHolds() {
        DocumentBuilder card;
        addSquare(card);
        DocumentBuilder panel;
        model::ShapeSketch outline;
        const model::Point corners[] = {{0, 0}, {30'000'000, 0}, {30'000'000, 12'000'000}, {0, 12'000'000}};
        outline.addPolygon(corners, false);
        panel.setProfile(panel.addShape(outline));
        panel.setBoardThickness(1'600'000);
        const std::uint32_t step = panel.addStep(card.finish());
        panel.addInstance({step, {{1'000'000, 1'000'000}, 0.0, false}, false});
        panel.addInstance({step, {{29'000'000, 1'000'000}, 0.0, true}, true});
        const auto document = withSolids(panel);
        QCOMPARE(areaMm2(*document, document->layers.back()), 360.0 - 200.0);
    }

    /// One with an island in its cut-out, one with two islands beside each other.
    void cutoutsOfTheBoardsOfAPanelAreOpenInIt() {
        const auto square = [](model::ShapeSketch& sketch, model::Nm low, model::Nm high, bool isHole) {
            const model::Point corners[] = {{low, low}, {high, low}, {high, high}, {low, high}};
            sketch.addPolygon(corners, isHole);
        };
        const auto stepOf = [](const model::ShapeSketch& outline) {
            DocumentBuilder step;
            step.setProfile(step.addShape(outline));
            return step.finish();
        };
        model::ShapeSketch nested;
        square(nested, 0, 10'000'000, false);
        square(nested, 2'000'000, 8'000'000, true);
        square(nested, 4'000'000, 5'000'000, false);
        model::ShapeSketch pair;
        square(pair, 0, 4'000'000, false);
        square(pair, 1'000'000, 2'000'000, true);
        square(pair, 5'000'000, 9'000'000, false);
        DocumentBuilder panel;
        model::ShapeSketch outline;
        square(outline, 0, 40'000'000, false);
        panel.setProfile(panel.addShape(outline));
        panel.setBoardThickness(1'600'000);
        const std::uint32_t first = panel.addStep(stepOf(nested));
        panel.addInstance({first, {{1'000'000, 1'000'000}, 0.0, false}, false});
        panel.addInstance({first, {{29'000'000, 11'000'000}, 90.0, true}, true});
        panel.addInstance({panel.addStep(stepOf(pair)), {{20'000'000, 20'000'000}, 0.0, false}, false});
        const auto document = withSolids(panel);
        QCOMPARE(areaMm2(*document, document->layers.back()), 1600.0 - 200.0 - 32.0);
    }

    void oneAndManyThreadsAgree() {
        const auto areas = [] {
            const auto document = boardWithMask();
            return std::pair<std::vector<model::PathNode>, std::vector<std::uint32_t>>(document->shapes.nodes,
                                                                                       document->elements.geometry);
        };
        const auto many = areas();
        const base::ThreadLimit limit(1);
        QVERIFY(areas() == many);
    }

    void cancellingStopsTheCutting() {
        DocumentBuilder builder;
        addSquare(builder);
        base::Progress progress;
        progress.cancel();
        QVERIFY(!model::addSolids(builder, progress));
    }

    void bodyIsNotCountedAsAnElementOfTheJob() { QCOMPARE(boardWithHoles()->elementCounts()[4], 0U); }
};

QTEST_APPLESS_MAIN(SolidsTest)
#include "solids_test.moc"
