// eda/data and components.
#include "model/odb/eda.h"

#include "model/odb/components.h"
#include "odb_testing.h"

using model::Diagnostics;
using model::odb::EdaData;
using odb_testing::findDiagnostic;

namespace {

EdaData parse(const std::string& text, Diagnostics& diagnostics) {
    return model::odb::parseEda(text, "eda/data", {"TOP", "ASSEMBLY TOP", "ASSEMBLY TEXT TOP", "TOPSOLDER"},
                                diagnostics);
}

}  // namespace

class EdaTest : public QObject {
    Q_OBJECT

private slots:
    void layerNamesWithBlanksAreMatchedGreedily() {
        Diagnostics diagnostics;
        const EdaData eda = parse("LYR topsolder Assembly Text Top top  Assembly Top unknown top", diagnostics);
        QCOMPARE(eda.layers,
                 (std::vector<std::string>{"topsolder", "Assembly Text Top", "top", "Assembly Top", "unknown", "top"}));
    }

    void featuresBelongToTheNetAboveThem() {
        Diagnostics diagnostics;
        const EdaData eda = parse(
            "HDR who\nLYR top topsolder\nNET $NONE$\nFID C 0 1\nNET A/B\\C?+ ;0=1;ID=2\nSNT TRC\nFID H 1 5\nFID L 0 7\n"
            "NET with blank;;ID=5\nFID C 0 2\n",
            diagnostics);
        QCOMPARE(eda.generator, std::string("who"));
        QCOMPARE(eda.nets, (std::vector<std::string>{"$NONE$", "A/B\\C?+", "with blank"}));
        QCOMPARE(eda.netFeatures.size(), std::size_t{4});
        QCOMPARE(eda.netFeatures[1].net, 1U);
        QCOMPARE(eda.netFeatures[1].layer, 1U);
        QCOMPARE(eda.netFeatures[1].feature, 5U);
        QCOMPARE(eda.netFeatures[3].net, 2U);
        QCOMPARE(eda.netFeatures[3].line, 10U);
        QVERIFY(diagnostics.entries().empty());
    }

    void featureGroupsAndPackagesAreNoNets() {
        Diagnostics diagnostics;
        const EdaData eda = parse(
            "LYR top\nNET A\nPKG 0603;\nPIN 1 S 0 0 0 E S\nPIN 2;ID=7\nRC 0 0 1 1\nFGR TEXT\nPRP string 'x'\nFID C 0 "
            "1\n",
            diagnostics);
        QVERIFY(eda.netFeatures.empty());
        QCOMPARE(eda.packages.size(), std::size_t{1});
        QCOMPARE(eda.packages[0].name, std::string("0603"));
        QCOMPARE(eda.packages[0].pins, (std::vector<std::string>{"1", "2"}));
    }

    void badFeatureIdsAreReported() {
        Diagnostics diagnostics;
        const EdaData eda = parse("LYR top\nNET A\nFID C 1 0\nFID C x 0\nFID C 0\nFID C 0 -1\n", diagnostics);
        QVERIFY(eda.netFeatures.empty());
        QCOMPARE(diagnostics.entries().size(), std::size_t{1});
        QCOMPARE(diagnostics.entries()[0].count, 4U);
        QCOMPARE(diagnostics.entries()[0].line, 3U);
    }

    void componentsHaveTheirPins() {
        Diagnostics diagnostics;
        const auto components = model::odb::parseComponents(
            "UNITS=INCH\n@0 .comp_height\n# CMP 0\nCMP 7 1 -2 90.5 M U1 10\xb5"
            "F ;0=1.2;ID=3\nPRP X 'TOP ; y'\n"
            "TOP 0 1 -2 90.5 M 12 0 A1\nTOP 1 1 -1 0 N -1 0\nCMP -1 0 0 0 N R1 ???\n",
            "components", model::odb::Unit::Millimetre, diagnostics);
        QCOMPARE(components.size(), std::size_t{2});
        QCOMPARE(components[0].package, 7);
        QCOMPARE(components[0].position, (model::Point{25'400'000, -50'800'000}));
        QCOMPARE(components[0].clockwiseDeg, 90.5);
        QVERIFY(components[0].isMirrored);
        QCOMPARE(components[0].part, std::string("10\xc2\xb5"
                                                 "F"));
        QCOMPARE(components[0].pins.size(), std::size_t{2});
        QCOMPARE(components[0].pins[0].net, 12);
        QCOMPARE(components[0].pins[0].name, std::string("A1"));
        QCOMPARE(components[0].pins[1].net, -1);
        QVERIFY(components[0].pins[1].name.empty());
        QVERIFY(components[1].pins.empty());
        QVERIFY(diagnostics.entries().empty());
    }

    void aBadComponentTakesItsPinsWithIt() {
        Diagnostics diagnostics;
        const auto components =
            model::odb::parseComponents("U MM\nCMP x 0 0 0 N R1 p\nTOP 0 0 0 0 N 1 0 1\nCMP 0 0 0 0 N R2 p\nTOP 0 a\n",
                                        "components", model::odb::Unit::Inch, diagnostics);
        QCOMPARE(components.size(), std::size_t{1});
        QVERIFY(components[0].pins.empty());
        QVERIFY(findDiagnostic(diagnostics, "CMP record is unreadable") != nullptr);
        QVERIFY(findDiagnostic(diagnostics, "TOP record is unreadable") != nullptr);
    }

    void everyTruncatedPrefixIsReadWithoutHarm() {
        const std::string data = odb_testing::readFile(odb_testing::dataJob("everything") / "steps/board/eda/data");
        for (std::size_t length = 0; length <= data.size(); ++length) {
            Diagnostics diagnostics;
            const std::vector<char> part(data.begin(), data.begin() + static_cast<std::ptrdiff_t>(length));
            const EdaData eda = model::odb::parseEda({part.data(), part.size()}, "eda/data", {"TOP"}, diagnostics);
            QVERIFY(eda.nets.size() <= 4);
            QVERIFY(model::odb::parseComponents({part.data(), part.size()}, "components", model::odb::Unit::Inch,
                                                diagnostics)
                        .empty());
        }
    }
};

QTEST_APPLESS_MAIN(EdaTest)
#include "eda_test.moc"
