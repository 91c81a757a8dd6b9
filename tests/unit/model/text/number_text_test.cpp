#include "model/text/number_text.h"

#include <QtTest>

namespace {

std::string fixed(double value, int digits) {
    std::string text;
    model::appendNumber(text, value, digits);
    return text;
}

std::string significant(double value, int digits) {
    std::string text = "x";
    model::appendSignificant(text, value, digits);
    return text.substr(1);
}

}  // namespace

class NumberTextTest : public QObject {
    Q_OBJECT

private slots:
    void numbersEndWithTheirLastDigit() {
        QCOMPARE(fixed(1.5, 7), std::string("1.5"));
        QCOMPARE(fixed(100.0, 7), std::string("100"));
        QCOMPARE(fixed(100.0, 0), std::string("100"));
        QCOMPARE(fixed(-0.00000001, 7), std::string("0"));
        QCOMPARE(fixed(-12.3456789, 4), std::string("-12.3457"));
    }

    void significantDigitsAreCounted() {
        QCOMPARE(significant(0.0123456789, 4), std::string("0.01235"));
        QCOMPARE(significant(-0.0, 4), std::string("0"));
        QCOMPARE(significant(1.25e-9, 9), std::string("1.25e-09"));
        QCOMPARE(significant(7.0, 9), std::string("7"));
        QCOMPARE(static_cast<float>(std::stod(significant(static_cast<double>(0.1F), 9))), 0.1F);
    }
};

QTEST_GUILESS_MAIN(NumberTextTest)
#include "number_text_test.moc"
