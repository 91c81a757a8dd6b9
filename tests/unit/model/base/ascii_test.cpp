#include "model/base/ascii.h"

#include <QtTest>

class AsciiTest : public QObject {
    Q_OBJECT

private slots:
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
