#include "model/board/copies.h"

#include <QtTest>

#include "model/board/document_builder.h"
#include "tests/unit/model/hand_made.h"

using model::Document;
using model::DocumentBuilder;
using model::LayerId;
using model::Placement;
using model::Point;
using model::StepTree;

namespace {

/// Layers "top" and "bottom", each the other's opposite.
void addLayers(DocumentBuilder& builder) {
    for (const char* name : {"top", "bottom"}) {
        model::Layer layer;
        layer.name = name;
        layer.type = model::LayerType::Signal;
        layer.opposite = LayerId{builder.layers().empty() ? std::size_t{1} : std::size_t{0}};
        builder.addLayer(layer);
    }
}

/// One disc of 2 mm at (10, 0) mm on top.
std::shared_ptr<const Document> card() {
    DocumentBuilder builder;
    addLayers(builder);
    builder.beginLayer(LayerId{0});
    builder.addCircle({{10'000'000, 0}, 2'000'000, 0}, {});
    return builder.finish();
}

/// A step without elements of its own that places these copies of another.
std::shared_ptr<const Document> holding(const std::shared_ptr<const Document>& step,
                                        const std::vector<std::pair<Placement, bool>>& copies) {
    DocumentBuilder builder;
    addLayers(builder);
    const std::uint32_t row = builder.addStep(step);
    for (const auto& [placement, isFlipped] : copies) {
        builder.addInstance({row, placement, isFlipped});
    }
    return builder.finish();
}

}  // namespace

class CopiesTest : public QObject {
    Q_OBJECT

private slots:
    void aBoardWithoutCopiesIsItsOwnOnlyCopy() {
        const auto board = card();
        const StepTree tree = model::unfoldCopies(*board);
        QCOMPARE(tree.steps, std::vector<const Document*>{board.get()});
        QCOMPARE(tree.copies.size(), std::size_t{1});
        QVERIFY(!tree.copies[0].isFlipped);
    }

    void copiesOfCopiesArePlacedByBoth() {
        const auto inner = card();
        const auto row = holding(inner, {{{{0, 0}, 90.0, false}, false}, {{{5, 0}, 0.0, true}, true}});
        const auto panel = holding(row, {{{{0, 100}, 90.0, false}, false}, {{{0, 200}, 0.0, true}, true}});
        const StepTree tree = model::unfoldCopies(*panel);
        QCOMPARE(tree.steps.size(), std::size_t{3});
        QCOMPARE(tree.copies.size(), std::size_t{1 + 2 * 3});
        // Panel, row, its two cards, row, its two cards.
        QCOMPARE(tree.steps[tree.copies[1].step], row.get());
        QCOMPARE(tree.steps[tree.copies[2].step], inner.get());
        QCOMPARE(tree.copies[2].placement.apply(Point{10, 0}), (Point{-10, 100}));  // two quarter turns
        QCOMPARE(tree.copies[3].placement.apply(Point{10, 0}), (Point{0, 105}));  // x -> 5 - 10 = -5, turned clockwise
        QVERIFY(tree.copies[3].isFlipped);
        QCOMPARE(tree.copies[6].placement.apply(Point{10, 0}), (Point{5, 200}));  // mirrored twice
        QVERIFY(!tree.copies[6].isFlipped);                                       // turned over twice
    }

    /// Copper of 50 and 35 µm, an ink on top that has no counterpart, and bodies on both sides.
    void flippedCopiesHaveTheHeightsOfTheOtherSide() {
        DocumentBuilder builder;
        addLayers(builder);
        using hand_made::addLayer;
        using model::LayerSide;
        using model::LayerType;
        const LayerId ink = addLayer(builder, LayerType::SilkScreen, LayerSide::Top, 1'600'000, 20'000);
        const LayerId bodies = addLayer(builder, LayerType::ComponentBody, LayerSide::Top, 1'600'000, 9'000'000);
        const LayerId below = addLayer(builder, LayerType::ComponentBody, LayerSide::Bottom, -1'000'000, 1'000'000);
        builder.layer(LayerId{0}).z = 1'550'000;
        builder.layer(LayerId{0}).thickness = 50'000;
        builder.layer(LayerId{1}).thickness = 35'000;
        builder.beginLayer(bodies);
        const model::ElementId body = builder.addCircle({{0, 0}, 1'000'000, 0}, {});
        builder.addBody({body, {}, 300'000});
        model::Document card = *builder.finish();
        const auto of = [&](auto id) {
            const model::ZRange z = model::heightsInCopy(card, id, true);
            return std::pair(z.bottom, z.top);
        };
        QCOMPARE(of(LayerId{0}), std::pair(0, 35'000));
        QCOMPARE(of(ink), std::pair(-20'000, 0));
        QCOMPARE(of(body), std::pair(-300'000, 0));  // a layer without a counterpart
        QVERIFY(model::growsDownInCopy(card, bodies, true));
        card.layers[bodies.row()].opposite = below;
        card.layers[below.row()].opposite = bodies;
        QCOMPARE(of(body), std::pair(-300'000, 0));
        const model::ZRange upright = model::heightsInCopy(card, body, false);
        QCOMPARE(std::pair(upright.bottom, upright.top), std::pair(1'600'000, 1'900'000));
    }

    void countsAndExtentIncludeCopies() {
        const auto panel = holding(card(), {{{{0, 0}, 0.0, false}, false}, {{{0, 0}, 0.0, true}, true}});
        QCOMPARE(panel->elementCounts()[2], 0U);
        QCOMPARE(panel->elementCountsWithCopies()[2], std::uint64_t{2});
        QCOMPARE(panel->layers[0].countsWithCopies[2], std::uint64_t{1});
        QCOMPARE(panel->layers[1].countsWithCopies[2], std::uint64_t{1});  // the flipped one
        QCOMPARE(panel->extent, (model::Box{{-11'000'000, -1'000'000}, {11'000'000, 1'000'000}}));
        const auto twice = holding(panel, {{{{0, 50'000'000}, 90.0, false}, true}});
        QCOMPARE(twice->elementCountsWithCopies()[2], std::uint64_t{2});
        QCOMPARE(twice->extent, (model::Box{{-1'000'000, 39'000'000}, {1'000'000, 61'000'000}}));
    }
};

QTEST_APPLESS_MAIN(CopiesTest)
#include "copies_test.moc"
