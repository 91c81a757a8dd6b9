#include "model/formats/common/back_drills.h"

#include <QtTest>

#include "model/base/progress.h"
#include "model/nets/connectivity.h"

using model::Document;
using model::DocumentBuilder;
using model::ElementId;
using model::LayerId;
using model::LayerUse;
using model::Nm;
using model::Point;

namespace {

constexpr Nm kMm = 1'000'000;

/// Four copper layers, 0 to 3, each with a pad at the middle, and a plated hole of 0.3 mm through all of them.
struct Board {
    Board() {
        model::Layer copper;
        copper.type = model::LayerType::Signal;
        for (int i = 0; i < 4; ++i) {
            builder.beginLayer(builder.addLayer(copper));
            pads.push_back(builder.addCircle({{}, kMm, 0}, {}));
        }
        hole = drill(LayerUse::Plain, 0, 3, {}, 300'000, model::kHole | model::kPlated);
    }

    ElementId drill(LayerUse use, std::size_t top, std::size_t bottom, Point at, Nm diameter,
                    int flags = model::kHole) {
        model::Layer layer;
        layer.type = model::LayerType::Drill;
        layer.use = use;
        layer.spanTop = LayerId{top};
        layer.spanBottom = LayerId{bottom};
        builder.beginLayer(builder.addLayer(layer));
        DocumentBuilder::Origin origin;
        origin.flags = static_cast<std::uint8_t>(flags);
        return builder.addCircle({at, diameter, diameter - 50'000}, origin);
    }

    std::shared_ptr<const Document> finish() {
        model::formats::cutPlating(builder);
        return builder.finish();
    }

    DocumentBuilder builder;
    std::vector<ElementId> pads;
    ElementId hole;
};

/// Copper layers the hole joins, as (top, bottom); (-1, -1) for none.
std::pair<int, int> joined(const Document& d, ElementId hole) {
    const model::PlatedSpan span = d.platedSpanOf(hole);
    return span.top.isValid() ? std::pair(static_cast<int>(span.top.row()), static_cast<int>(span.bottom.row()))
                              : std::pair(-1, -1);
}

std::size_t islands(const Document& d) {
    base::Progress progress;
    return model::Connectivity::of(d, progress)->islandCount();
}

}  // namespace

class BackDrillsTest : public QObject {
    Q_OBJECT

private slots:
    void aBoardWithoutThemIsPlatedThrough() {
        Board board;
        const auto d = board.finish();
        QVERIFY(d->platedSpans.empty());
        QCOMPARE(joined(*d, board.hole), (std::pair{0, 3}));
        QCOMPARE(islands(*d), std::size_t{1});
    }

    void aBackDrillTakesTheCopperOfItsSpanFromTheHole() {
        Board board;
        const ElementId back = board.drill(LayerUse::Backdrill, 2, 3, {}, 500'000);
        const auto d = board.finish();
        QCOMPARE(joined(*d, board.hole), (std::pair{0, 1}));
        QCOMPARE(islands(*d), std::size_t{3});  // two pads stay alone
        QCOMPARE(d->diagnostics.entries().size(), std::size_t{1});
        QVERIFY(d->diagnostics.entries()[0].text.find("takes the plating") != std::string::npos);
        QCOMPARE(d->diagnostics.entries()[0].element, back);
    }

    void fromBothSidesTheMiddleIsLeft() {
        Board board;
        board.drill(LayerUse::Backdrill, 0, 0, {}, 500'000);
        board.drill(LayerUse::Backdrill, 3, 3, {}, 500'000);
        QCOMPARE(joined(*board.finish(), board.hole), (std::pair{1, 2}));
    }

    void drilledOutAltogetherItJoinsNothing() {
        Board board;
        board.drill(LayerUse::Backdrill, 0, 3, {}, 500'000);
        const auto d = board.finish();
        QCOMPARE(joined(*d, board.hole), (std::pair{-1, -1}));
        QCOMPARE(islands(*d), std::size_t{5});
    }

    void aBareSecondDiameterTakesThePlatingAPlatedOneDoesNot() {
        Board bare;
        bare.drill(LayerUse::DualDiameter, 0, 1, {}, 600'000);
        const auto d = bare.finish();
        QCOMPARE(joined(*d, bare.hole), (std::pair{2, 3}));
        QVERIFY(d->diagnostics.entries()[0].text.starts_with("The wider part of a hole"));
        Board plated;
        plated.drill(LayerUse::DualDiameter, 0, 1, {}, 600'000, model::kHole | model::kPlated);
        QCOMPARE(joined(*plated.finish(), plated.hole), (std::pair{0, 3}));
    }

    void otherHolesTakeNothing() {
        Board board;
        board.drill(LayerUse::Plain, 2, 3, {}, 500'000);
        board.drill(LayerUse::Backdrill, 2, 3, {2 * kMm, 0}, 500'000);
        const auto d = board.finish();
        QVERIFY(d->platedSpans.empty());
        QVERIFY(d->diagnostics.entries().empty());
    }

    void whatCannotBeIsTold_data() {
        QTest::addColumn<int>("top");
        QTest::addColumn<int>("diameter");
        QTest::addColumn<QString>("text");
        QTest::newRow("narrow") << 3 << 200'000 << "does not cover";
        QTest::newRow("off centre") << 3 << 450'000 << "does not cover";
        QTest::newRow("in the middle") << 1 << 800'000 << "begins and ends within";
    }
    void whatCannotBeIsTold() {
        QFETCH(int, top);
        QFETCH(int, diameter);
        QFETCH(QString, text);
        Board board;
        const auto layer = static_cast<std::size_t>(top);
        board.drill(LayerUse::Backdrill, layer, layer == 1 ? 2 : 3, {100'000, 0}, diameter);
        const auto d = board.finish();
        QCOMPARE(joined(*d, board.hole), (std::pair{0, 3}));
        QCOMPARE(d->diagnostics.count(model::Severity::Warning), std::size_t{1});
        QVERIFY(QString::fromStdString(d->diagnostics.entries()[0].text).contains(text));
    }
};

QTEST_APPLESS_MAIN(BackDrillsTest)
#include "back_drills_test.moc"
