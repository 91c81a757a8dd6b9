#include "model/board/board_heights.h"

#include <QtTest>

#include "model/board/document_builder.h"

using model::Document;
using model::DocumentBuilder;
using model::Nm;

namespace {

constexpr Nm kCopper = 35'000;
constexpr Nm kThickness = 1'600'000;

struct Copper {
    const char* name;
    model::LayerSide side;
    Nm z;
};

std::shared_ptr<const Document> boardOf(const std::vector<Copper>& copper,
                                        model::LayerContext context = model::LayerContext::Board) {
    DocumentBuilder builder;
    builder.setBoardThickness(kThickness);
    for (const Copper& of : copper) {
        model::Layer layer;
        layer.name = of.name;
        layer.type = model::LayerType::Signal;
        layer.context = context;
        layer.side = of.side;
        layer.z = of.z;
        layer.thickness = kCopper;
        builder.addLayer(layer);
    }
    return builder.finish();
}

}  // namespace

class BoardHeightsTest : public QObject {
    Q_OBJECT

private slots:
    void liesBetweenItsOuterCopper_data() {
        using enum model::LayerSide;
        QTest::addColumn<std::vector<Copper>>("copper");
        QTest::addColumn<Nm>("bottom");
        QTest::addColumn<Nm>("substrateBottom");
        QTest::addColumn<Nm>("substrateTop");
        QTest::addColumn<Nm>("top");
        QTest::newRow("no copper") << std::vector<Copper>{} << Nm{0} << Nm{0} << kThickness << kThickness;
        QTest::newRow("two sides, in any order")
            << std::vector<Copper>{{"bottom", Bottom, 0}, {"top", Top, 1'565'000}, {"inner", Inner, 700'000}} << Nm{0}
            << kCopper << Nm{1'565'000} << kThickness;
        QTest::newRow("one, at the top") << std::vector<Copper>{{"top", Top, 0}} << -kThickness << -kThickness << Nm{0}
                                         << kCopper;
        QTest::newRow("one, at the bottom") << std::vector<Copper>{{"bottom", Bottom, 0}} << Nm{0} << kCopper
                                            << kCopper + kThickness << kCopper + kThickness;
    }
    void liesBetweenItsOuterCopper() {
        QFETCH(const std::vector<Copper>, copper);
        const std::shared_ptr<const Document> board = boardOf(copper);
        QTEST(model::boardHeights(*board).bottom, "bottom");
        QTEST(model::boardHeights(*board).top, "top");
        QTEST(model::substrateHeights(*board).bottom, "substrateBottom");
        QTEST(model::substrateHeights(*board).top, "substrateTop");
    }

    void copperThatIsNotOfTheBoardDoesNotCount() {
        const auto board = boardOf({{"coupon", model::LayerSide::None, 5'000'000}}, model::LayerContext::Misc);
        QCOMPARE(model::boardHeights(*board).top, kThickness);
    }
};

QTEST_GUILESS_MAIN(BoardHeightsTest)
#include "board_heights_test.moc"
