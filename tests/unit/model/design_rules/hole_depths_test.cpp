// How deep holes are drilled: by their span, by what they land on, and whether anybody knows.
#include "model/design_rules/hole_depths.h"

#include <QtTest>
#include <array>

#include "model/board/document_builder.h"
#include "model/board/stackup.h"
#include "tests/unit/model/hand_made.h"

using namespace hand_made;
using model::ElementId;
using model::LayerId;
using model::Nm;

namespace {

using Dielectrics = std::array<std::optional<double>, 3>;

constexpr Dielectrics kStated = {100e3, 1300e3, 100e3};
constexpr ElementId kThrough{std::size_t{0}};
constexpr ElementId kFlexible{std::size_t{1}};
constexpr ElementId kLaser{std::size_t{2}};
constexpr ElementId kDrilled{std::size_t{3}};

/// Four layers of copper of 35 um with dielectrics between, through holes at (0, 0) and (20, 0) mm, and from the first
/// layer to the second a laser via and a wider one. Outside of 10 mm around the first hole `isFlex` leaves the inner
/// layers alone.
std::shared_ptr<const model::Document> boardOf(const Dielectrics& below, std::optional<double> board = {},
                                               bool isFlex = false) {
    model::DocumentBuilder builder;
    for (const char* name : {"L1", "L2", "L3", "L4"}) {
        addLayer(builder, name);
    }
    const LayerId through = addDrill(builder, LayerId{0}, LayerId{3});
    const LayerId blind = addDrill(builder, LayerId{0}, LayerId{1});
    model::StackupFacts facts;
    facts.layers.resize(builder.layers().size());
    facts.boardNm = board;
    for (std::size_t row = 0; row < 4; ++row) {
        facts.layers[row].thicknessNm = 35e3;
        facts.layers[row].belowNm = row < 3 ? below[row] : std::nullopt;
    }
    builder.setStackup(model::buildStackup(builder.layers(), std::move(facts), builder.diagnostics()));
    if (isFlex) {
        const model::ShapeId rigid = builder.addShape(rectangle({-10 * kMm, -10 * kMm}, {10 * kMm, 10 * kMm}));
        builder.layer(LayerId{0}).profile = builder.layer(LayerId{3}).profile = rigid;
    }
    const auto add = [&](Nm x, Nm diameter) {
        builder.addCircle({{x, 0}, diameter, diameter / 2}, flagged(model::kHole | model::kPlated | model::kVia));
    };
    builder.beginLayer(through);
    add(0, 300 * kUm);
    add(20 * kMm, 300 * kUm);
    builder.beginLayer(blind);
    add(2 * kMm, 100 * kUm);
    add(4 * kMm, 300 * kUm);
    return builder.finish();
}

using Depth = std::optional<Nm>;

Depth depthOf(const model::Document& board, ElementId hole) {
    return model::HoleDepths(board).of(hole);
}

}  // namespace

class HoleDepthsTest : public QObject {
    Q_OBJECT

private slots:
    void aHoleIsAsDeepAsTheCopperThatItPasses() {
        const auto board = boardOf(kStated);
        QCOMPARE(depthOf(*board, kThrough), Depth(1'640'000));
        QCOMPARE(depthOf(*board, kDrilled), Depth(170'000));
        QCOMPARE(depthOf(*board, kLaser), Depth(135'000));  // down to its target
    }

    void anAssumedThicknessIsNone() {
        const auto board = boardOf({100e3, std::nullopt, 100e3});
        QCOMPARE(depthOf(*board, kThrough), Depth());
        QCOMPARE(depthOf(*board, kDrilled), Depth(170'000));
        QCOMPARE(depthOf(*boardOf({}), kDrilled), Depth());
    }

    /// The sum is what the job says of the board, whatever each of them is.
    void anEvenShareOfTheBoardSaysNothingOfOneDielectric() {
        const auto shared = boardOf({}, 1640e3);
        QCOMPARE(depthOf(*shared, kThrough), Depth(1'640'000));
        QCOMPARE(depthOf(*shared, kDrilled), Depth());
        const auto rest = boardOf({std::nullopt, 1300e3, 100e3}, 1640e3);  // one share, so it is known
        QCOMPARE(depthOf(*rest, kThrough), Depth(1'640'000));
        QCOMPARE(depthOf(*rest, kDrilled), Depth(170'000));
    }

    void layersThatAreMissingThereDoNotCount() {
        const auto board = boardOf(kStated, {}, true);
        QCOMPARE(depthOf(*board, kThrough), Depth(1'640'000));
        QCOMPARE(depthOf(*board, kFlexible), Depth(1'370'000));
        QCOMPARE(depthOf(*boardOf(kStated), kFlexible), Depth(1'640'000));
    }

    /// Of formats that state heights themselves there is no stackup.
    void withoutAStackupTheDrillIsAsDeepAsItsLayer() {
        model::DocumentBuilder builder;
        const LayerId top = addLayer(builder, "top");
        const LayerId drill = addDrill(builder, top, addLayer(builder, "bottom"));
        const LayerId open = addLayer(builder, "open", model::LayerType::Drill);
        const LayerId flat = addDrill(builder, top, top);
        builder.layer(drill).thickness = builder.layer(open).thickness = 1600 * kUm;
        for (const LayerId layer : {drill, open, flat}) {
            builder.beginLayer(layer);
            builder.addCircle({{0, 0}, 300 * kUm, 250 * kUm}, flagged(model::kHole | model::kPlated));
        }
        const auto board = builder.finish();
        QCOMPARE(depthOf(*board, ElementId{0U}), Depth(1'600'000));
        QCOMPARE(depthOf(*board, ElementId{1U}), Depth());
        QCOMPARE(depthOf(*board, ElementId{2U}), Depth());
    }
};

QTEST_APPLESS_MAIN(HoleDepthsTest)
#include "hole_depths_test.moc"
