#include "model/base/ascii.h"

#include <QtTest>

class AsciiTest : public QObject {
    Q_OBJECT

private slots:
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
