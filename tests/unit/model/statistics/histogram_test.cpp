#include "model/statistics/histogram.h"

#include <QtTest>
#include <algorithm>

#include "model/board/document_builder.h"
#include "tests/unit/model/hand_made.h"

using hand_made::flagged;
using model::Histogram;
using model::Measure;
using model::Nm;

namespace {

/// Copper and drills through it.
std::pair<model::LayerId, model::LayerId> addLayers(model::DocumentBuilder& builder) {
    model::Layer layer;
    layer.type = model::LayerType::Signal;
    const model::LayerId copper = builder.addLayer(layer);
    layer.spanTop = copper;
    layer.spanBottom = copper;
    layer.type = model::LayerType::Drill;
    return {copper, builder.addLayer(layer)};
}

/// Copper with tracks of given widths and a pad; a drill layer with a plated hole in the pad, and a bare one.
std::shared_ptr<const model::Document> boardWith(const std::vector<Nm>& widths) {
    model::DocumentBuilder builder;
    const auto [copper, drill] = addLayers(builder);
    builder.beginLayer(copper);
    for (const Nm width : widths) {
        builder.addLine({{0, 0}, {1'000'000, 0}, width, 0}, {});
    }
    builder.addLine({{0, 0}, {1'000'000, 0}, 777'000, 0}, flagged(model::kPad));  // an oval pad is no track
    builder.addCircle({{5'000'000, 0}, 600'000, 0}, flagged(model::kPad));
    builder.addCircle({{5'000'000, 0}, 900'000, 0}, flagged(model::kPad));
    builder.beginLayer(drill);
    builder.addCircle({{5'000'000, 0}, 300'000, 250'000}, flagged(model::kHole | model::kPlated));
    builder.addCircle({{9'000'000, 0}, 400'000, 400'000}, flagged(model::kHole));
    return builder.finish();
}

QStringList textOf(const Histogram& histogram) {
    QStringList bars;
    for (const model::HistogramBar& bar : histogram.bars) {
        bars += QStringLiteral("%1-%2:%3").arg(bar.least).arg(bar.most).arg(bar.count);
    }
    return bars;
}

}  // namespace

class HistogramTest : public QObject {
    Q_OBJECT

private slots:
    void fewWidthsHaveABarEach() {
        const auto board = boardWith({200'000, 100'000, 200'000, 150'000});
        const Histogram histogram = model::histogramOf(*board, Measure::TrackWidth, 16);
        QCOMPARE(textOf(histogram), (QStringList{"100000-100000:1", "150000-150000:1", "200000-200000:2"}));
        QCOMPARE(histogram.elements.size(), std::size_t{4});
        QVERIFY((histogram.elements[2] == model::StepElement{0, model::ElementId{0}}));
        QVERIFY((histogram.elements[3] == model::StepElement{0, model::ElementId{2}}));
    }

    void manyWidthsShareBarsAndNoneIsLost() {
        std::vector<Nm> widths;
        for (int i = 0; i < 1000; ++i) {
            widths.push_back(100'000 + i * 7);
        }
        widths.push_back(2'000'000'000);  // one far off; must not overflow
        const auto board = boardWith(widths);
        const Histogram histogram = model::histogramOf(*board, Measure::TrackWidth, 16);
        QCOMPARE(histogram.bars.size(), std::size_t{2});  // empty bars are left out
        QCOMPARE(histogram.bars[0].elements.count, 1000U);
        QCOMPARE(histogram.elements.size(), widths.size());
    }

    void holesAreMeasuredAsDrilled() {
        const Histogram histogram = model::histogramOf(*boardWith({}), Measure::HoleDiameter, 16);
        QCOMPARE(textOf(histogram), (QStringList{"300000-300000:1", "400000-400000:1"}));
    }

    void ringsGoByTheNarrowestPadOfPlatedHoles() {
        const Histogram histogram = model::histogramOf(*boardWith({}), Measure::AnnularRing, 16);
        QCOMPARE(textOf(histogram), QStringList{"150000-150000:1"});
    }

    void elementsOfCopiesCountAsOftenAsTheyArePlaced() {
        model::DocumentBuilder builder;
        builder.beginLayer(addLayers(builder).first);
        builder.addLine({{0, 0}, {1'000'000, 0}, 100'000, 0}, {});
        builder.addLine({{0, 0}, {1'000'000, 0}, 500'000, 0}, {});
        const std::uint32_t card = builder.addStep(boardWith({100'000, 200'000}));
        builder.addInstance({card, {{10'000'000, 0}, 0.0, false}, false});
        builder.addInstance({card, {{30'000'000, 0}, 0.0, true}, true});
        const auto panel = builder.finish();
        const Histogram tracks = model::histogramOf(*panel, Measure::TrackWidth, 16);
        QCOMPARE(textOf(tracks), (QStringList{"100000-100000:3", "200000-200000:2", "500000-500000:1"}));
        const model::ElementId first{std::size_t{0}};
        QVERIFY((model::elementsOf(*panel, tracks, tracks.bars[0]) ==
                 std::vector<model::BoardElement>{{0, first}, {1, first}, {2, first}}));
        QCOMPARE(textOf(model::histogramOf(*panel, Measure::HoleDiameter, 16)),
                 (QStringList{"300000-300000:2", "400000-400000:2"}));
    }

    void anEmptyBoardHasNoBars() {
        for (const Measure measure : {Measure::TrackWidth, Measure::HoleDiameter, Measure::AnnularRing}) {
            QVERIFY(model::histogramOf(model::Document(), measure, 16).bars.empty());
        }
    }
};

QTEST_APPLESS_MAIN(HistogramTest)
#include "histogram_test.moc"
