#include "model/base/ascii.h"

#include <QtTest>

class AsciiTest : public QObject {
    Q_OBJECT

private slots:
    /// Of all bytes: those of other alphabets, in UTF-8 or Latin-1, are none of them.
    void lettersDigitsAndBlanksAreThoseOfAscii() {
        const auto bytesThatAre = [](bool (*isWanted)(char)) {
            std::string found;
            for (int byte = 0; byte < 256; ++byte) {
                found.append(isWanted(static_cast<char>(byte)) ? 1 : 0, static_cast<char>(byte));
            }
            return found;
        };
        QCOMPARE(bytesThatAre(base::isLetter), std::string("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"));
        QCOMPARE(bytesThatAre(base::isDigit), std::string("0123456789"));
        QCOMPARE(bytesThatAre(base::isBlank), std::string("\t\n\r "));
    }

    void onlyLettersOfAsciiChange() {
        QCOMPARE(base::lowerCase("Top_CU-1@[`{"), std::string("top_cu-1@[`{"));
        QCOMPARE(base::upperCase("Top_CU-1@[`{"), std::string("TOP_CU-1@[`{"));
        QCOMPARE(base::lowerCase("\xc3\x84\xc4"), std::string("\xc3\x84\xc4"));  // Ä in UTF-8 and Latin-1
        QCOMPARE(base::upperCase("\xc3\xa4\xe4"), std::string("\xc3\xa4\xe4"));
    }

    void caseOfLettersDoesNotCount() {
        QVERIFY(base::equalsIgnoringCase("F.Cu", "f.cU"));
        QVERIFY(base::equalsIgnoringCase("", ""));
        QVERIFY(!base::equalsIgnoringCase("F.Cu", "F.C"));
        QVERIFY(!base::equalsIgnoringCase("@[", "`{"));              // 32 apart, as letters are
        QVERIFY(!base::equalsIgnoringCase("\xc3\x84", "\xc3\xa4"));  // Ä, ä: no ASCII
    }
};

QTEST_APPLESS_MAIN(AsciiTest)
#include "ascii_test.moc"
