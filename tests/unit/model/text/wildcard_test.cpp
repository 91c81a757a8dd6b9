#include "model/text/wildcard.h"

#include <QtTest>

class WildcardTest : public QObject {
    Q_OBJECT

private slots:
    void starsAreAnyTextAndQuestionMarksAnyLetter() {
        const auto fits = [](const char* name, const char* pattern) { return model::fitsWildcard(name, pattern); };
        QVERIFY(fits("VCC3V3", "VCC*") && fits("VCC", "VCC*") && fits("a.b.c", "*.c") && fits("abcbc", "a*bc"));
        QVERIFY(fits("D0", "D?") && fits("", "*") && fits("", "") && fits("ab", "**b*"));
        QVERIFY(!fits("D10", "D?") && !fits("VC", "VCC*") && !fits("x", "") && !fits("abcb", "a*bc"));
        QVERIFY(!fits("vcc", "VCC"));
    }

    void lettersMayBeAlike() {
        const auto fits = [](const char* name, const char* pattern) {
            return model::fitsWildcard(name, pattern, [](char inName, char inPattern) {
                return inName == inPattern || (inName == '_' && inPattern == ' ');
            });
        };
        QVERIFY(fits("a_b_c", "a b*") && !fits("a b", "a_b"));
        QVERIFY2(fits("*", "?") && fits("*", "*") && !fits("a", "**b"), "stars of a pattern are no letters");
    }
};

QTEST_GUILESS_MAIN(WildcardTest)
#include "wildcard_test.moc"
