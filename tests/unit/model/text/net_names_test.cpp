#include "model/text/net_names.h"

#include <QtTest>

using namespace std::string_literals;

/// Spellings as in jobs of KiCad: what they stand for, and what only looks like them.
class NetNamesTest : public QObject {
    Q_OBJECT

private slots:
    void spelledCharactersAreWritten() {
        QCOMPARE(model::readableName("Net-(U1-P1.00{slash}XL1)"), "Net-(U1-P1.00/XL1)"s);
        QCOMPARE(model::readableName("A{lt}3{colon}0{gt}{space}{brace}x"), "A<3:0> {x"s);
    }

    void activeLowPartsHaveBars() {
        QCOMPARE(model::readableName("/nRF54L15/~{CS}_FLASH"), "/nRF54L15/C\u0305S\u0305_FLASH"s);
        QCOMPARE(model::readableName("~{R{slash}W}"), "R\u0305/\u0305W\u0305"s);
        QCOMPARE(model::readableName("~{µΩ}"), "µ\u0305Ω\u0305"s);
        QCOMPARE(model::readableName("~{A~{B}C}"), "A\u0305~\u0305{\u0305B\u0305}\u0305C\u0305"s);
    }

    void typedNamesHaveNone() { QCOMPARE(model::typedName("TRG_~{RESET}_A{slash}B"), "TRG_RESET_A/B"s); }

    void everythingElseStaysAsItIs() {
        for (const char* name :
             {"", "GND", "/D+", "5V_{AON}_BOOT", "~RESET", "~{RESET", "{slash", "{unknown}", "A}B"}) {
            QCOMPARE(model::readableName(name), std::string(name));
            QCOMPARE(model::typedName(name), std::string(name));
        }
    }

    void sheetsEndAtTheLastSlash() {
        QCOMPARE(model::sheetOf("/Ethernet/PHY/RXD0"), "/Ethernet/PHY/");
        QCOMPARE(model::sheetOf("/RXD0"), "/");
        QCOMPARE(model::sheetOf("INTERFACES\\MOTOR\\$1N28"), "INTERFACES\\MOTOR\\");
        QCOMPARE(model::sheetOf("DAC_U/D"), "");
        QCOMPARE(model::sheetOf("Net-(U1-P1.00{slash}XL1)"), "");
        QCOMPARE(model::sheetOf(""), "");
    }

    void aSheetIsNeverAllOfAName() {
        QCOMPARE(model::sheetOf("/"), "");
        QCOMPARE(model::sheetOf("/Ethernet/"), "/");
        QCOMPARE(model::sheetOf("ENC_A\\"), "");
        QCOMPARE(model::sheetOf("IO\\ENC_A\\"), "IO\\");
    }

    void barsAreNoSheets() {
        using enum model::Backslash;
        QCOMPARE(model::sheetOf("LV_R\\S\\T\\1", Overbar), "");
        QCOMPARE(model::sheetOf("/CPU/R\\S\\T\\", Overbar), "/CPU/");
        for (const char* name : {"ENC_A\\", "R\\S\\T\\1", "\\", "Ω\\µ\\"}) {
            QVERIFY2(model::backslashIn(name) == Overbar, name);
        }
        for (const char* name : {"INTERFACES\\MOTOR\\$1N28", "A\\\\B", "A\\B\\CD\\E"}) {
            QVERIFY2(model::backslashIn(name) == EndsSheet, name);
        }
        for (const char* name : {"POWER\\ADJ", "GND", "", "/A/B"}) {
            QVERIFY2(!model::backslashIn(name), name);
        }
    }
};

QTEST_APPLESS_MAIN(NetNamesTest)
#include "net_names_test.moc"
