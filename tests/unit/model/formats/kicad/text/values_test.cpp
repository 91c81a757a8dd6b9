#include "model/formats/kicad/text/values.h"

#include <QtTest>

using namespace model::kicad;

class ValuesTest : public QObject {
    Q_OBJECT

private slots:
    void lengthsAreNanometres() {
        QCOMPARE(lengthOf("1"), std::optional(1e6));
        QCOMPARE(lengthOf("-0.000001"), std::optional(-1.0));
        QCOMPARE(lengthOf("123.456789"), std::optional(123'456'789.0));
        QCOMPARE(lengthOf(".5"), std::optional(5e5));
        QCOMPARE(lengthOf("0.0000004"), std::optional(0.0));
        QCOMPARE(lengthOf("0.0000006"), std::optional(1.0));
        QCOMPARE(lengthOf("1e-3"), std::optional(1e3));
        QCOMPARE(lengthOf("+2"), std::optional(2e6));
    }

    void whatIsNoLengthIsNone() {
        for (const char* word : {"", "-", ".", "1.2.3", "abc", "1mm", "nan", "inf", "1e300", "99999999999999"}) {
            QVERIFY2(!lengthOf(word), word);
        }
    }

    void namesLoseTheirEscapes() {
        QCOMPARE(nameOf("A{slash}B{colon}{brace}x}"), std::string("A/B:{x}"));
        QCOMPARE(nameOf("~{RESET}"), std::string("~{RESET}"));
        QCOMPARE(nameOf("{other}{"), std::string("{other}{"));
        QCOMPARE(nameOf("{dblquote}a{bar}b{comma}{dollar}{dblquote}"), std::string("\"a|b,$\""));
        QCOMPARE(nameOf("${slash}~{lt}^{gt}_{bar}"), std::string("${slash}~{lt}^{gt}_{bar}"));
    }
};

QTEST_APPLESS_MAIN(ValuesTest)
#include "values_test.moc"
