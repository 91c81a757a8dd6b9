#include "ui/search/board_search.h"

#include <QtTest>

#include "tests/unit/model/formats/odb/odb_testing.h"
#include "tests/unit/model/hand_made.h"

using ui::BoardSearch;
using ui::Found;
using ui::FoundKind;
using ui::LengthUnit;

class BoardSearchTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_board = odb_testing::read(locations::kSample);
        m_search.setBoard(m_board);
    }

    void namesThatBeginWithTheTextComeBeforeThoseThatHoldIt() {
        QCOMPARE(titles("1pps"), (QStringList{"1PPS_IN", "1PPS_OUT"}));
        QCOMPARE(titles("netc"), (QStringList{"NetC3_1", "NetC4_2", "NetC9_1"}));
        QCOMPARE(titles("u1").first(), "U1");
        QCOMPARE(titles("+3.3v"), (QStringList{"+3.3V", "+3.3V_OSC"}));
        QCOMPARE(titles("l02"), QStringList{"L02-INNER_LAYER"});
        QCOMPARE(titles("no such thing"), QStringList{});
        QCOMPARE(titles("  "), QStringList{});
    }

    void kindsAreTold() {
        QCOMPARE(only("SW").kind, FoundKind::Net);
        QVERIFY(m_search.detailOf(only("SW")).startsWith("Net, "));
        QCOMPARE(only("J6").kind, FoundKind::Component);
        QVERIFY2(m_search.detailOf(only("J6")).endsWith("bottom side, Keystone_4871"),
                 qPrintable(m_search.detailOf(only("J6"))));
        QCOMPARE(m_search.detailOf(only("L02")), "Layer, Signal");
    }

    void lettersBeyondAsciiAreFoundAsTheyAreWritten() {
        model::DocumentBuilder builder;
        static_cast<void>(builder.addNet("LÜFTER_EIN"));
        BoardSearch search;
        search.setBoard(builder.finish());
        QCOMPARE(search.find("LÜFTER", LengthUnit::Millimetre, 5).size(), std::size_t{1});
        QCOMPARE(search.find("lÜfter", LengthUnit::Millimetre, 5).size(), std::size_t{1});
    }

    void aNetComesBeforeTheLayerOfItsName() {
        model::DocumentBuilder builder;
        hand_made::addLayer(builder, "GND");
        static_cast<void>(builder.addNet("GND"));
        BoardSearch search;
        search.setBoard(builder.finish());
        const std::vector<Found> found = search.find("gnd", LengthUnit::Millimetre, 5);
        QCOMPARE(found.size(), std::size_t{2});
        QCOMPARE(found[0].kind, FoundKind::Net);
        QCOMPARE(found[1].kind, FoundKind::Layer);
    }

    void pinsAreNamedByTheirComponent() {
        const std::vector<Found> pins = m_search.find("u1.", LengthUnit::Millimetre, 50);
        QCOMPARE(std::ranges::count(pins, FoundKind::Pin, &Found::kind), 9);
        for (const char* text : {"U1.4", "u1-4"}) {
            const Found pin = only(text);
            QCOMPARE(pin.kind, FoundKind::Pin);
            QCOMPARE(m_search.titleOf(pin, LengthUnit::Millimetre), "U1.4");
        }
    }

    void aPinOfSeveralPadsIsFoundOnce() {
        model::DocumentBuilder builder;
        const model::NetId net = builder.addNet("GND");
        std::vector<model::Pin> pins(3);
        for (std::size_t i = 0; i < pins.size(); ++i) {
            pins[i].name = builder.string(i < 2 ? "MP" : "1");
            pins[i].net = net;
        }
        model::Component part;
        part.refdes = "J7";
        builder.addComponent(part, pins);
        BoardSearch search;
        search.setBoard(builder.finish());
        const std::vector<Found> found = search.find("j7.", LengthUnit::Millimetre, 50);
        QCOMPARE(found.size(), std::size_t{2});
        QCOMPARE(search.titleOf(found[1], LengthUnit::Millimetre), "J7.MP");
        QCOMPARE(search.detailOf(found[1]), "Pin, net GND, 2 pads");
        QCOMPARE(search.detailOf(found[0]), "Pin, net GND");
    }

    void attributesAreFoundByValueAndByName() {
        const std::vector<Found> found = m_search.find("smt", LengthUnit::Millimetre, 50);
        const auto type = std::ranges::find(found, FoundKind::Attribute, &Found::kind);
        QVERIFY(type != found.end());
        QCOMPARE(m_search.titleOf(*type, LengthUnit::Millimetre), ".comp_mount_type: smt");
        QVERIFY(m_search.detailOf(*type).startsWith("Attribute of "));
        QCOMPARE(m_search.attribute(*type).count, model::componentsWith(*m_board, m_search.attribute(*type)).size());
        QVERIFY(titles("comp mount").contains(".comp_mount_type: smt"));
    }

    void attributesComeLastAndHaveRoom() {
        const auto titlesIn = [](const BoardSearch& search, std::size_t most) {
            QStringList all;
            for (const Found& found : search.find("10k", LengthUnit::Millimetre, most)) {
                all += search.titleOf(found, LengthUnit::Millimetre);
            }
            return all;
        };
        model::DocumentBuilder builder;
        for (const char* name : {"A10K_1", "A10K_2", "A10K_3", "A10K_4", "A10K_5", "A10K_6"}) {
            static_cast<void>(builder.addNet(name));
        }
        model::Component part;
        part.refdes = "R1";
        part.part = "10k";
        builder.addComponent(part, {});
        BoardSearch search;
        search.setBoard(builder.finish());
        QCOMPARE(titlesIn(search, 50).last(), "Part: 10k");
        QCOMPARE(titlesIn(search, 5), (QStringList{"A10K_1", "A10K_2", "A10K_3", "A10K_4", "Part: 10k"}));
        QCOMPARE(titlesIn(search, 3), (QStringList{"A10K_1", "A10K_2", "A10K_3"}));
    }

    void textsThatOnlyNameAPartOrPinAreLeftOut() {
        model::DocumentBuilder builder;
        model::Component part;
        part.refdes = "R12";
        part.part = "R12";
        model::Pin pin;
        pin.name = builder.string("1");
        builder.addComponent(part, std::vector{pin});
        const model::LayerId silk = hand_made::addLayer(builder, "SILK");
        builder.beginLayer(silk);
        for (const char* text : {"R12", "R12.1", "R12 here"}) {
            model::DocumentBuilder::Origin origin;
            origin.attributes = builder.attributes({{".string", text}});
            builder.addCircle({{0, 0}, 1000, 0}, origin);
        }
        BoardSearch search;
        search.setBoard(builder.finish());
        QStringList all;
        for (const Found& found : search.find("r12", LengthUnit::Millimetre, 50)) {
            all += search.titleOf(found, LengthUnit::Millimetre);
        }
        QCOMPARE(all, (QStringList{"R12", "Part: R12", ".string: R12 here"}));
    }

    void placesAreRead_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::newRow("with unit") << "12.5, -3 mm" << 12.5e6 << -3e6;
        QTest::newRow("without") << "1 2" << 1e6 << 2e6;
        QTest::newRow("mils") << "100,200 MIL" << 2.54e6 << 5.08e6;
        QTest::newRow("two units") << "1 in, 2 mm" << 25.4e6 << 2e6;
        QTest::newRow("micrometres") << "5 µm; .5 µm" << 5e3 << 500.0;
    }
    void placesAreRead() {
        QFETCH(QString, text);
        QFETCH(double, x);
        QFETCH(double, y);
        const auto location = ui::parsePlace(text, LengthUnit::Millimetre);
        QVERIFY(location.has_value());
        QVERIFY(std::abs(location->x - x) < 1e-3 && std::abs(location->y - y) < 1e-3);
        QCOMPARE(m_search.find(text, LengthUnit::Millimetre, 5).front().kind, FoundKind::Location);
    }

    void aPlaceIsListedInTheUnitOfTheWindow() {
        const auto found = m_search.find("10, 20 mm", LengthUnit::Mil, 5);
        QCOMPARE(m_search.titleOf(found.front(), LengthUnit::Mil), "393.70, 787.40 mil");
        QCOMPARE(m_search.titleOf(found.front(), LengthUnit::Millimetre), "10.0000, 20.0000 mm");
    }

    /// Locations of KiCad, which counts Y downwards: the sample lies above its origin.
    void aPlaceBesideTheBoardIsOfferedTheOtherWayUp() {
        const auto found = m_search.find("10, -20 mm", LengthUnit::Millimetre, 5);
        QVERIFY(found.size() >= 2 && found[0].kind == FoundKind::Location && found[1].kind == FoundKind::Location);
        QCOMPARE(found[0].location.y, 20e6);
        QCOMPARE(found[1].location.y, -20e6);
        QVERIFY(m_search.detailOf(found[0]).contains("downwards"));
        QCOMPARE(m_search.detailOf(found[1]), QString("Location"));
        QCOMPARE(m_search.find("10, 20 mm", LengthUnit::Millimetre, 5).front().location.y, 20e6);
        QCOMPARE(m_search.find("10, -2000 mm", LengthUnit::Millimetre, 5).front().location.y, -2e9);
    }

    void whatIsNoPlaceIsNone() {
        for (const char* text : {"", "1", "1,2,3", "1 km, 2 km", "a b", "1,", "--1, 2"}) {
            QVERIFY2(!ui::parsePlace(text, LengthUnit::Millimetre), text);
        }
    }

    /// The panel has no nets of its own; both steps on it have a net A.
    void placedStepsAreSearchedToo() {
        const auto panel = odb_testing::read(std::string(locations::kTestData) + "/odb/panel");
        BoardSearch search;
        search.setBoard(panel);
        const std::vector<const model::Document*> steps = model::distinctSteps(*panel);
        const std::vector<Found> found = search.find("a", LengthUnit::Millimetre, 2);
        QCOMPARE(found.size(), std::size_t{2});
        QVERIFY(found[0].step != found[1].step);
        for (const Found& net : found) {
            QCOMPARE(net.kind, FoundKind::Net);
            QCOMPARE(search.titleOf(net, LengthUnit::Millimetre), "A");
            QCOMPARE(steps[net.step]->elementsOf(model::NetId{std::size_t{net.row}}).size(), std::size_t{1});
            QCOMPARE(search.detailOf(net),
                     QString("Net, 1 element, in step %1").arg(QString::fromStdString(steps[net.step]->job.step)));
        }
    }

    void noMoreAreFoundThanAskedFor() {
        QCOMPARE(m_search.find("e", LengthUnit::Millimetre, 3).size(), std::size_t{3});
        QVERIFY(BoardSearch().find("e", LengthUnit::Millimetre, 3).empty());
    }

private:
    [[nodiscard]] QStringList titles(const QString& text) const {
        QStringList all;
        for (const Found& found : m_search.find(text, LengthUnit::Millimetre, 50)) {
            all += m_search.titleOf(found, LengthUnit::Millimetre);
        }
        return all;
    }
    [[nodiscard]] Found only(const QString& text) const {
        const std::vector<Found> found = m_search.find(text, LengthUnit::Millimetre, 1);
        return found.empty() ? Found{} : found.front();
    }

    std::shared_ptr<const model::Document> m_board;
    BoardSearch m_search;
};

QTEST_APPLESS_MAIN(BoardSearchTest)
#include "board_search_test.moc"
