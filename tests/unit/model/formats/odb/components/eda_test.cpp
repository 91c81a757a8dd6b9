// eda/data and the attributes of its records.
#include "model/formats/odb/components/eda.h"

#include "tests/unit/model/formats/odb/odb_testing.h"

using model::Diagnostics;
using model::LayerSide;
using model::PinKind;
using model::Point;
using model::SubnetKind;
using model::odb::EdaData;
using model::odb::PropertyReader;
using model::odb::RecordAttributes;
using model::odb::TextProperty;
using model::odb::Unit;
using odb_testing::findDiagnostic;

namespace {

EdaData parse(const std::string& text, Diagnostics& diagnostics) {
    return model::odb::parseEda(text, "eda/data", Unit::Millimetre,
                                {"TOP", "ASSEMBLY TOP", "ASSEMBLY TEXT TOP", "TOPSOLDER"}, {}, diagnostics);
}

EdaData parseClean(const std::string& text) {
    Diagnostics diagnostics;
    EdaData eda = parse(text, diagnostics);
    if (!diagnostics.entries().empty()) {
        qFatal("%s", diagnostics.entries()[0].text.c_str());
    }
    return eda;
}

}  // namespace

class EdaTest : public QObject {
    Q_OBJECT

private slots:
    void layerNamesWithBlanksAreMatchedGreedily() {
        const EdaData eda = parseClean("LYR topsolder Assembly Text Top top  Assembly Top unknown top");
        QCOMPARE(eda.layers,
                 (std::vector<std::string>{"topsolder", "Assembly Text Top", "top", "Assembly Top", "unknown", "top"}));
    }

    void theFirstLineOfLayersCounts() {
        // Found by fuzzing: the second line was shorter than the numbers of records before it.
        Diagnostics diagnostics;
        const EdaData eda = parse("LYR top bottom\nNET A\nSNT TRC\nFID C 1 0\nLYR top", diagnostics);
        QCOMPARE(eda.layers, (std::vector<std::string>{"top", "bottom"}));
        QCOMPARE(eda.features.size(), std::size_t{1});
        QCOMPARE(diagnostics.entries().size(), std::size_t{1});
        QCOMPARE(diagnostics.entries()[0].line, 5U);
    }

    void featuresBelongToTheNetAndSubnetAboveThem() {
        const EdaData eda = parseClean(
            "HDR who\nLYR top topsolder\n#@0 .string\n&1 fast\nNET $NONE$\nFID C 0 1\n"
            "NET A/B\\C?+ ;0=1;ID=2\nPRP why 'because'\nSNT TRC\nFID H 1 5\nFID L 0 7\n"
            "SNT TOP B 3 4\nSNT VIA\nSNT PLN S E 0.5\nFID C 0 3\nNET with blank;;ID=5\nFID C 0 2\n");
        QCOMPARE(eda.generator, std::string("who"));
        QCOMPARE(eda.nets.size(), std::size_t{3});
        QCOMPARE(eda.nets[1].name, std::string("A/B\\C?+"));
        QCOMPARE(eda.nets[2].name, std::string("with blank"));
        QCOMPARE(eda.nets[1].properties, (std::vector<TextProperty>{{".string", "fast"}, {"why", "because"}}));
        QCOMPARE(eda.features.size(), std::size_t{5});
        QCOMPARE(eda.features[1].layer, 1U);
        QCOMPARE(eda.features[1].feature, 5U);
        QCOMPARE(eda.features[4].line, 17U);
        QCOMPARE(eda.subnets.size(), std::size_t{6});
        QCOMPARE(eda.subnets[0].net, 0U);
        QCOMPARE(eda.subnets[0].kind, SubnetKind::Other);  // no SNT record above the feature
        QCOMPARE(eda.subnets[1].kind, SubnetKind::Trace);
        QCOMPARE(eda.subnets[1].featureCount, 2U);
        QCOMPARE(eda.subnets[2].kind, SubnetKind::PinPads);
        QCOMPARE(eda.subnets[2].side, LayerSide::Bottom);
        QCOMPARE(eda.subnets[2].component, 3);
        QCOMPARE(eda.subnets[2].toeprint, 4);
        QCOMPARE(eda.subnets[2].featureCount, 0U);
        QCOMPARE(eda.subnets[3].kind, SubnetKind::Via);
        QCOMPARE(eda.subnets[4].kind, SubnetKind::Plane);
        QCOMPARE(eda.subnets[4].planeFill, model::PlaneFill::Solid);
        QCOMPARE(eda.subnets[4].planeCutout, model::PlaneCutout::Exact);
        QCOMPARE(eda.subnets[4].planeCutoutSize, 500'000);
        QCOMPARE(eda.subnets[4].featureCount, 1U);
        QCOMPARE(eda.subnets[5].net, 2U);
    }

    void groupsHaveFeaturesAndProperties() {
        const EdaData eda =
            parseClean("LYR top\nNET A\nFID C 0 9\nFGR TEXT\nPRP string 'R1'\nFID C 0 1\nFID C 0 2\nFGR PCB\n");
        QCOMPARE(eda.subnets.size(), std::size_t{1});
        QCOMPARE(eda.subnets[0].featureCount, 1U);
        QCOMPARE(eda.groups.size(), std::size_t{2});
        QCOMPARE(eda.groups[0].type, std::string("TEXT"));
        QCOMPARE(eda.groups[0].properties, (std::vector<TextProperty>{{"string", "R1"}}));
        QCOMPARE(eda.groups[0].firstFeature, 1U);
        QCOMPARE(eda.groups[0].featureCount, 2U);
        QCOMPARE(eda.groups[1].featureCount, 0U);
    }

    void packagesHaveOutlinesPinsAndProperties() {
        const EdaData eda = parseClean(
            "UNITS=MM\n@0 .geometry\n&0 G\nPKG 0603 0.5 -1 -2 1 2;0=0;ID=7\nRC -1 -2 2 4\nCR 0 0 1\nSQ 5 5 0.5\n"
            "CT\nOB 0 0 I\nOS 9 0\nOS 9 9\nOS 0 0\nOE\nOB 6 2 H\nOS 7 2\nOS 7 3\nOS 6 2\nOE\nCE\nPRP class 'x' 1 2\n"
            "PIN 1 S -0.5 0 0 E S\nRC -1 -1 1 2\nPIN 2 S 0 0 0 E S ID=7\nPIN 3 T 1 0 90 U U ID=9\nCR 0 0 0.1\nPKG "
            "none\n"
            "PKG far 99999 -1 -1 1 1\n");
        QCOMPARE(eda.packages.size(), std::size_t{3});
        const auto& package = eda.packages[0];
        QCOMPARE(package.pitch, 500'000);
        QCOMPARE(package.box, (model::Box{{-1'000'000, -2'000'000}, {1'000'000, 2'000'000}}));
        QCOMPARE(package.properties, (std::vector<TextProperty>{{".geometry", "G"}, {"class", "x 1 2"}}));
        QCOMPARE(package.outline.contourCount(), std::size_t{5});
        QCOMPARE(package.outline.contour(0)[0].point, (Point{-1'000'000, -2'000'000}));
        QCOMPARE(package.outline.contour(0)[2].point, (Point{1'000'000, 2'000'000}));
        QCOMPARE(package.outline.contour(1)[0].point, (Point{1'000'000, 0}));
        QCOMPARE(package.outline.contour(2)[0].point, (Point{4'500'000, 4'500'000}));
        QCOMPARE(package.outline.contour(2)[2].point, (Point{5'500'000, 5'500'000}));
        QVERIFY(!package.outline.isHole(3) && package.outline.isHole(4));
        QCOMPARE(package.pins.size(), std::size_t{3});
        QCOMPARE(package.pins[0].name, std::string("1"));
        QCOMPARE(package.pins[0].position, (Point{-500'000, 0}));
        QCOMPARE(package.pins[0].outline.contourCount(), std::size_t{1});
        QVERIFY(package.pins[1].outline.isEmpty());
        QCOMPARE(package.pins[2].kind, PinKind::Through);
        QVERIFY(eda.packages[1].box.isEmpty());
        QCOMPARE(eda.packages[2].pitch, 0);  // out of range: Altium's way of saying "none"
        QCOMPARE(eda.packages[2].box.max, (Point{1'000'000, 1'000'000}));
    }

    void unitsOfTheFileRule() {
        QCOMPARE(parseClean("UNITS=INCH\nPKG a 0.1 0 0 1 1\n").packages[0].pitch, 2'540'000);
        QCOMPARE(parseClean("U INCH\nPKG a 0.1 0 0 1 1\n").packages[0].pitch, 2'540'000);
        QCOMPARE(parseClean("PKG a 0.1 0 0 1 1\n").packages[0].pitch, 100'000);
    }

    void nothingIsIgnoredSilently_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("message");
        QTest::addRow("unknown record") << "LYR top\nXYZ 1 2\n"
                                        << "unknown kind";
        QTest::addRow("FID nowhere") << "LYR top\nFID C 0 1\n"
                                     << "outside of nets and groups";
        QTest::addRow("FID in a package") << "LYR top\nPKG a\nFID C 0 1\n"
                                          << "outside of nets and groups";
        QTest::addRow("FID of no layer") << "LYR top\nNET A\nFID C 1 0\n"
                                         << "names no layer";
        QTest::addRow("FID unreadable") << "LYR top\nNET A\nFID C x 0\n"
                                        << "names no layer";
        QTest::addRow("FID too short") << "LYR top\nNET A\nFID C 0\n"
                                       << "names no layer";
        QTest::addRow("FID below zero") << "LYR top\nNET A\nFID C 0 -1\n"
                                        << "names no layer";
        QTest::addRow("subnet nowhere") << "SNT VIA\n"
                                        << "outside of a net";
        QTest::addRow("subnet unknown") << "NET A\nSNT FOO\n"
                                        << "stay in their net";
        QTest::addRow("toeprint without pin") << "NET A\nSNT TOP T 1\n"
                                              << "stay in their net";
        QTest::addRow("pin nowhere") << "PIN 1 S 0 0 0 E S\n"
                                     << "outside of a package";
        QTest::addRow("pin unreadable") << "PKG a\nPIN 1 S x 0 0 E S\n"
                                        << "position of a package's pin";
        QTest::addRow("package unreadable") << "PKG a 1 x 0 1 1\n"
                                            << "size of a package";
        QTest::addRow("outline nowhere") << "RC 0 0 1 1\n"
                                         << "belongs to no package";
        QTest::addRow("outline unreadable") << "PKG a\nRC 0 0 1\n"
                                            << "cannot be read or has no size";
        QTest::addRow("outline without size") << "PKG a\nCR 0 0 0\n"
                                              << "cannot be read or has no size";
        QTest::addRow("property nowhere") << "PRP a 'b'\n"
                                          << "belongs to nothing";
        QTest::addRow("attribute without name") << "NET A ;0=1\n"
                                                << "does not name";
    }
    void nothingIsIgnoredSilently() {
        QFETCH(QString, text);
        QFETCH(QString, message);
        Diagnostics diagnostics;
        static_cast<void>(parse(text.toStdString(), diagnostics));
        QCOMPARE(diagnostics.entries().size(), std::size_t{1});
        QVERIFY2(findDiagnostic(diagnostics, message.toStdString()) != nullptr, diagnostics.entries()[0].text.c_str());
        QCOMPARE(diagnostics.entries()[0].line, static_cast<std::uint32_t>(text.count('\n')));
    }

    void attributesOfRecordsAreWords() {
        RecordAttributes attributes;
        Diagnostics diagnostics;
        for (const char* line :
             {"@0 .comp_mount_type", "@1 count", "@2 .string", "@4 .no_pop", "@5 .height", "&0 zero", "&1 one text"}) {
            QVERIFY(attributes.record(line));
        }
        QVERIFY(!attributes.record("NET A"));
        const model::odb::FileCursor at{"f", diagnostics, 1, 7};
        const auto found = attributes.resolve("0=1,1=1,2=1, 4 ,5=12.5,9=1;ID=123", {}, at);
        QCOMPARE(found, (std::vector<TextProperty>{{".comp_mount_type", "smt"},
                                                   {"count", "1"},
                                                   {".string", "one text"},
                                                   {".no_pop", "yes"},
                                                   {".height", "12.5"}}));
        QCOMPARE(diagnostics.entries().size(), std::size_t{1});  // nobody names attribute 9
        QCOMPARE(diagnostics.entries()[0].line, 7U);
        QVERIFY(attributes.resolve("", {}, at).empty());
        QVERIFY(attributes.resolve(";ID=7", {}, at).empty());
        QVERIFY(attributes.resolve("ID=7", {}, at).empty());
        QCOMPARE(diagnostics.entries()[0].count, 1U);
    }

    void propertiesKeepQuotesNumbersAndLines() {
        PropertyReader reader;
        std::vector<TextProperty> found;
        for (const char* line : {"PRP Sim.Params 'c=\"\"'", "PRP it 'it's'", "PRP n '' 1 -2.5", "PRP bare",
                                 "PRP two 'a", "TOP of it", "end'", "PRP last 'x' "}) {
            QVERIFY(reader.record(line, found));
        }
        QVERIFY(!reader.record("TOP 0 0", found));
        QVERIFY(!reader.record("PRPX 0", found));
        QCOMPARE(found, (std::vector<TextProperty>{{"Sim.Params", "c=\"\""},
                                                   {"it", "it's"},
                                                   {"n", "1 -2.5"},
                                                   {"bare", ""},
                                                   {"two", "a\nTOP of it\nend"},
                                                   {"last", "x"}}));
    }

    void everyTruncatedPrefixIsReadWithoutHarm() {
        const std::string data = odb_testing::readFile(odb_testing::dataJob("everything") / "steps/board/eda/data");
        for (std::size_t length = 0; length <= data.size(); ++length) {
            Diagnostics diagnostics;
            const std::vector<char> part(data.begin(), data.begin() + static_cast<std::ptrdiff_t>(length));
            const EdaData eda =
                model::odb::parseEda({part.data(), part.size()}, "eda/data", Unit::Inch, {"TOP"}, {}, diagnostics);
            QVERIFY(eda.nets.size() <= 4);
        }
    }
};

QTEST_APPLESS_MAIN(EdaTest)
#include "eda_test.moc"
