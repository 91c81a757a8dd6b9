#include "model/nets/net_groups.h"

#include <QtTest>
#include <algorithm>
#include <random>
#include <set>

#include "model/board/document_builder.h"
#include "model/nets/net_statistics.h"

using namespace model;

namespace {

std::shared_ptr<const Document> boardOf(const std::vector<std::string>& names) {
    DocumentBuilder builder;
    for (const std::string& name : names) {
        builder.addNet(name);
    }
    return builder.finish();
}

/// "name: member member" per group.
QStringList textOf(const Document& board, const NetGroups& groups) {
    QStringList lines;
    for (std::uint32_t group = 0; group < groups.names.size(); ++group) {
        QString line = QString::fromStdString(groups.names[group]) + ":";
        for (std::size_t net = 0; net < board.nets.size(); ++net) {
            line += groups.groupOf[net] == group ? " " + QString::fromStdString(board.nets[net].name) : QString();
        }
        lines += line;
    }
    return lines;
}

QStringList grouped(const std::vector<std::string>& names, NetGrouping grouping) {
    const auto board = boardOf(names);
    return textOf(*board, groupNets(*board, grouping));
}

}  // namespace

class NetGroupsTest : public QObject {
    Q_OBJECT

private slots:
    void sheetsFollowTheOnesAroundThem() {
        const auto board =
            boardOf({"/Power/VIN", "GND", "/CPU 10/DDR/A0", "/CPU 2/X", "/EN", "/CPU 10/DDR/A1", "DAC_U/D"});
        const NetGroups groups = groupNets(*board, NetGrouping::Sheet);
        QCOMPARE(groups.names, (std::vector<std::string>{"/", "CPU 2", "CPU 10", "DDR", "Power"}));
        QCOMPARE(groups.depths, (std::vector<std::uint32_t>{0, 0, 0, 1, 0}));
        QCOMPARE(groups.groupOf, (std::vector<std::uint32_t>{4, kNoGroup, 3, 1, 0, 3, kNoGroup}));
        QVERIFY(hasSheets(*board));
        const auto other = boardOf({"POWER\\ADJ", "GND", "IO\\UART\\RX", "POWER\\FB"});
        const NetGroups nested = groupNets(*other, NetGrouping::Sheet);
        QCOMPARE(nested.names, (std::vector<std::string>{"IO", "UART", "POWER"}));
        QCOMPARE(nested.groupOf, (std::vector<std::uint32_t>{2, kNoGroup, 1, 2}));
        QVERIFY(hasSheets(*other));
        QVERIFY(!hasSheets(*boardOf({"GND", "/EN", "/VIN", "DAC_U/D"})));
        QVERIFY(!hasSheets(*boardOf({})));
    }

    void overbarsAreNoSheets() {
        const auto groupsOf = [](const std::vector<std::string>& names) {
            return groupNets(*boardOf(names), NetGrouping::Sheet).names;
        };
        const std::vector<std::string> bars{"LV_R\\S\\T\\1", "LV_R\\S\\T\\2", "CS\\1", "GND"};
        QCOMPARE(groupsOf(bars), std::vector<std::string>());
        QVERIFY(!hasSheets(*boardOf(bars)));
        QCOMPARE(groupsOf({"ENC_A\\", "WR\\_EN\\B"}), std::vector<std::string>());
        QCOMPARE(groupsOf({"TOP\\A\\X", "TOP\\UART\\X"}), (std::vector<std::string>{"TOP", "A", "UART"}));
        QCOMPARE(groupsOf({"WR\\_EN", "CS\\2"}), (std::vector<std::string>{"CS", "WR"}));
        DocumentBuilder builder;
        builder.addNet("WR\\_EN");
        builder.addNet("CS\\2");
        builder.job().generator = "Altium Designer 23";
        QCOMPARE(groupNets(*builder.finish(), NetGrouping::Sheet).names, std::vector<std::string>());
    }

    void noSheetHasAnEmptyName() {
        const auto board = boardOf({"/A//B", "//C", "/D/", "\\E"});
        const NetGroups groups = groupNets(*board, NetGrouping::Sheet);
        QVERIFY(std::ranges::none_of(groups.names, &std::string::empty));
    }

    void pairs_data() {
        QTest::addColumn<QString>("a");
        QTest::addColumn<QString>("b");
        QTest::addColumn<QString>("name");  // empty: no pair
        const std::array<const char*, 3> rows[] = {
            {"CK0_P", "CK0_N", "CK0_P/N"},
            {"USB_D+", "USB_D-", "USB_D+/-"},
            {"DP", "DM", "DP/M"},
            {"usb_dp", "usb_dm", "usb_dp/m"},
            {"USB_DP0", "USB_DN0", "USB_DP/N0"},
            {"PCIE0_TXP", "PCIE0_TXN", "PCIE0_TXP/N"},
            {"NO_DATA_IN_N31", "NO_DATA_IN_P31", "NO_DATA_IN_P/N31"},
            {"CLKREF_P_CLOCK1", "CLKREF_N_CLOCK1", "CLKREF_P/N_CLOCK1"},
            {"PHASEP", "PHASEN", "PHASEP/N"},
            {"+5V", "-5V", ""},
            {"P1", "N1", ""},
            {"STOP_A", "STON_A", ""},
            {"VDD_P", "VDD_M", ""},
            {"CLK_p", "CLK_N", ""},
            {"A", "B", ""},
        };
        for (const auto& [a, b, name] : rows) {
            QTest::newRow(a) << a << b << name;
        }
    }
    void pairs() {
        QFETCH(QString, a);
        QFETCH(QString, b);
        QFETCH(QString, name);
        const QStringList expected = name.isEmpty() ? QStringList() : QStringList(QString("%1: %2 %3").arg(name, a, b));
        QCOMPARE(grouped({a.toStdString(), b.toStdString()}, NetGrouping::DifferentialPair), expected);
        QVERIFY(grouped({a.toStdString(), "OTHER"}, NetGrouping::DifferentialPair).isEmpty());
    }

    void aPairHasTwoNetsAndANetOnePair() {
        // Signs at several places: the last one decides, for both.
        QCOMPARE(grouped({"XPP", "XPN", "XNP", "XNN"}, NetGrouping::DifferentialPair),
                 (QStringList{"XNP/N: XNP XNN", "XPP/N: XPP XPN"}));
        std::mt19937 random(5);
        for (int round = 0; round < 300; ++round) {
            std::set<std::string> names;
            while (names.size() < 40) {
                std::string name;
                const std::size_t length = 1 + random() % 5;
                while (name.size() < length) {
                    name += "PNDM+-_0A"[random() % 9];
                }
                names.insert(name);
            }
            const auto board = boardOf({names.begin(), names.end()});
            const NetGroups groups = groupNets(*board, NetGrouping::DifferentialPair);
            QCOMPARE(groups.groupOf.size(), board->nets.size());
            std::map<std::uint32_t, std::vector<std::string>> members;
            for (std::size_t net = 0; net < board->nets.size(); ++net) {
                if (groups.groupOf[net] != kNoGroup) {
                    members[groups.groupOf[net]].push_back(board->nets[net].name);
                }
            }
            QCOMPARE(members.size(), groups.names.size());
            for (const auto& [group, pair] : members) {
                QCOMPARE(pair.size(), std::size_t{2});
                QVERIFY(std::ranges::count(polarTwins(pair[0]), pair[1]) == 1);
                QVERIFY(std::ranges::count(polarTwins(pair[1]), pair[0]) == 1);
            }
        }
    }

    void busesDifferInOneNumber() {
        QCOMPARE(grouped({"IO[0]_R", "IO[1]_R", "IO2[0]_R", "D<7>", "D<8>"}, NetGrouping::Bus),
                 (QStringList{"D<7..8>: D<7> D<8>", "IO[0..1]_R: IO[0]_R IO[1]_R"}));
        QCOMPARE(grouped({"A00", "A01", "A2", "A3", "BA0", "BA1", "DQ0R", "DQ1R", "DQ2R", "DQ3R"}, NetGrouping::Bus),
                 (QStringList{"A[0..3]: A00 A01 A2 A3", "DQ[0..3]R: DQ0R DQ1R DQ2R DQ3R"}));
        // What programs number through, and voltages, are no buses.
        QVERIFY(grouped({"N31710", "N31711", "N31712", "N31713"}, NetGrouping::Bus).isEmpty());
        QVERIFY(grouped({"NetJ1_1", "NetJ1_2", "NetJ1_3", "NetJ1_4"}, NetGrouping::Bus).isEmpty());
        QVERIFY(grouped({"X1", "X20", "X300", "X4000"}, NetGrouping::Bus).isEmpty());
        QVERIFY(grouped({"V1", "V2", "V3", "V4"}, NetGrouping::Bus).isEmpty());
        QVERIFY(grouped({"A9999999990", "A9999999991", "A9999999992", "A9999999993"}, NetGrouping::Bus).isEmpty());
    }

    void suppliesAreKnownByNameAndPins() {
        for (const char* name : {"GND", "AGND", "gnd_power", "VSSA", "0V"}) {
            QCOMPARE(supplyOf(name, 50), Supply::Ground);
        }
        for (const char* name :
             {"VCC", "+5V", "3V3", "1.8V", "12P0V", "3.3VD_TRXFE", "VDDIO", "IRIDIUM_3.3VD", "V5_A"}) {
            QCOMPARE(supplyOf(name, 50), Supply::Power);
        }
        for (const char* name : {"CLK", "RST_N", "V", "P5", "VOUTER_LIMIT", "", "_", "DVDT"}) {
            QCOMPARE(supplyOf(name, 50), Supply::None);
        }
        QCOMPARE(supplyOf("CLKPD_1P8V", 2), Supply::None);
        QCOMPARE(supplyOf("GND_SENSE", 2), Supply::None);
        DocumentBuilder builder;
        const NetId many = builder.addNet("COM");
        builder.addNet("FEW");
        std::vector<Pin> pins(20);
        std::ranges::for_each(pins, [&](Pin& pin) { pin.net = many; });
        builder.addComponent({}, pins);
        const auto board = builder.finish();
        QCOMPARE(textOf(*board, groupNets(*board, NetGrouping::Supply)), QStringList{"Many pins: COM"});
    }

    void attributesOfTheJobComeFirst() {
        DocumentBuilder builder;
        const auto property = [&](const char* name, const char* value) {
            const Property one{builder.string(name), builder.string(value)};
            return builder.addProperties(std::span(&one, 1));
        };
        builder.addNet("A", property(".net_type", "RF"));
        builder.addNet("B", property("NetClass", "10"));
        builder.addNet("C", property(".net_type", "RF"));
        builder.addNet("D", property("NetClass", "9"));
        builder.addNet("E", property("colour", "red"));
        builder.addNet("CLK_P", property(".diff_pair", "clock"));
        builder.addNet("CLK_N");
        builder.addNet("CLKB", property(".diff_pair", "clock"));
        const auto board = builder.finish();
        QCOMPARE(textOf(*board, groupNets(*board, NetGrouping::Class)), (QStringList{"9: D", "10: B", "RF: A C"}));
        QCOMPARE(textOf(*board, groupNets(*board, NetGrouping::DifferentialPair)), QStringList{"clock: CLK_P CLKB"});
    }

    void boardsWithoutNetsHaveNoGroups() {
        for (const auto grouping :
             {NetGrouping::Class, NetGrouping::DifferentialPair, NetGrouping::Bus, NetGrouping::Supply}) {
            QVERIFY(grouped({}, grouping).isEmpty());
            QVERIFY(grouped({"", "", "$NONE$"}, grouping).isEmpty());
        }
    }

    void groupsAreInTheOrderPeopleCountAndNoneIsEmpty() {
        std::vector<std::string> names;
        for (int i = 40; i-- > 0;) {
            names.push_back("B" + std::to_string(i / 4) + "[" + std::to_string(i % 4) + "]");
        }
        const auto board = boardOf(names);
        const NetGroups groups = groupNets(*board, NetGrouping::Bus);
        QCOMPARE(groups.names.size(), std::size_t{10});
        QVERIFY(std::ranges::is_sorted(groups.names, isNamedBefore));
        for (std::size_t net = 0; net < names.size(); ++net) {
            QVERIFY(QString::fromStdString(groups.names[groups.groupOf[net]])
                        .startsWith(QString::fromStdString(names[net].substr(0, 2))));
        }
    }
};

QTEST_APPLESS_MAIN(NetGroupsTest)
#include "net_groups_test.moc"
