#include "model/formats/odb/text/records.h"

#include <QtTest>

using model::odb::coordinateNm;
using model::odb::Fields;
using model::odb::LineReader;
using model::odb::symbolNm;
using model::odb::Unit;

class RecordsTest : public QObject {
    Q_OBJECT

private slots:
    void linesAreNumberedAsAnEditorShowsThem() {
        LineReader lines("one\r\n\r\n# comment\n  two  \n\nthree");
        QVERIFY(lines.next());
        QCOMPARE(lines.line(), std::string_view("one"));
        QCOMPARE(lines.number(), 1U);
        QVERIFY(lines.next());
        QCOMPARE(lines.line(), std::string_view("two  "));
        QCOMPARE(lines.number(), 4U);
        QVERIFY(lines.next());
        QCOMPARE(lines.line(), std::string_view("three"));
        QCOMPARE(lines.number(), 6U);
        QVERIFY(!lines.next());
    }

    void anEmptyTextHasNoLines() {
        QVERIFY(!LineReader("").next());
        QVERIFY(!LineReader("\n\r\n# only a comment\n").next());
    }

    void aByteOrderMarkIsNoText() {
        LineReader lines("\xef\xbb\xbfUNITS=MM\n");
        QVERIFY(lines.next());
        QCOMPARE(lines.line(), std::string_view("UNITS=MM"));
    }

    void fieldsEndAtTheAttributes() {
        Fields fields("P  1\t2;0=3;ID=7");
        QCOMPARE(fields.word(), std::string_view("P"));
        QCOMPARE(fields.word(), std::string_view("1"));
        QVERIFY(!fields.atEnd());
        QCOMPARE(fields.word(), std::string_view("2"));
        QVERIFY(fields.atEnd());
        QVERIFY(!fields.failed());
        QCOMPARE(fields.tail(), std::string_view("0=3;ID=7"));
        fields.word();
        QVERIFY(fields.failed());
    }

    void lengthsAreRoundedExactly_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("unit");
        QTest::addColumn<int>("nm");
        const int mm = 1'000'000;
        const int inch = 25'400'000;
        QTest::newRow("whole") << "3" << mm << 3'000'000;
        QTest::newRow("plus") << "+3.5" << mm << 3'500'000;
        QTest::newRow("no leading digit") << "-.25" << mm << -250'000;
        QTest::newRow("no digit after the point") << "7." << mm << 7'000'000;
        QTest::newRow("below 1 nm, up") << "0.0000005" << mm << 1;
        QTest::newRow("below 1 nm, down") << "0.00000049" << mm << 0;
        QTest::newRow("half away from zero") << "-0.0000005" << mm << -1;
        QTest::newRow("inch") << "0.1" << inch << 2'540'000;
        QTest::newRow("inch, many digits") << "-0.000664468504" << inch << -16'878;
        QTest::newRow("inch, more digits than fit") << "0.05555555555555555555" << inch << 1'411'111;
        QTest::newRow("exponent") << "-9.84251968503937e-005" << inch << -2'500;
        QTest::newRow("mil") << "25.0000" << static_cast<int>(symbolNm(Unit::Inch)) << 635'000;
        QTest::newRow("um") << "299.9994" << static_cast<int>(symbolNm(Unit::Millimetre)) << 299'999;
        QTest::newRow("largest") << "1073.741824" << mm << (1 << 30);
    }
    void lengthsAreRoundedExactly() {
        QFETCH(QString, text);
        QFETCH(int, unit);
        QFETCH(int, nm);
        const std::string line = text.toStdString();
        Fields fields(line);
        QCOMPARE(fields.length(unit), nm);
        QVERIFY(!fields.failed());
        QVERIFY(fields.atEnd());
    }

    void whatIsNoLengthFails() {
        for (const std::string_view text :
             {"", "-", ".", "1.2.3", "12a", "nan", "inf", "1073.741825", "-1e9", "0x10", "1,5"}) {
            Fields fields(text);
            fields.length(coordinateNm(Unit::Millimetre));
            QVERIFY2(fields.failed(), text.data());
        }
    }

    void integersMustBeWhole() {
        Fields good("-12 +7");
        QCOMPARE(good.integer(), -12);
        QCOMPARE(good.integer(), 7);
        QVERIFY(!good.failed());
        for (const std::string_view text : {"1.5", "", "99999999999", "x"}) {
            Fields fields(text);
            fields.integer();
            QVERIFY(fields.failed());
        }
    }

    void latin1BecomesUtf8AndUtf8Stays() {
        QCOMPARE(model::odb::toUtf8("10\xb5"
                                    "F"),
                 std::string("10\xc2\xb5"
                             "F"));
        QCOMPARE(model::odb::toUtf8("10\xc2\xb5"
                                    "F \xe2\x84\xa6"),
                 std::string("10\xc2\xb5"
                             "F \xe2\x84\xa6"));
        QCOMPARE(model::odb::toUtf8("\xe2\x84"), std::string("\xc3\xa2\xc2\x84"));
    }

    void unitsAreNamedInAnyCase() {
        QCOMPARE(model::odb::parseUnit("mm"), std::optional(Unit::Millimetre));
        QCOMPARE(model::odb::parseUnit("INCH"), std::optional(Unit::Inch));
        QVERIFY(!model::odb::parseUnit("").has_value());
        QVERIFY(!model::odb::parseUnit("metre").has_value());
    }
};

QTEST_APPLESS_MAIN(RecordsTest)
#include "records_test.moc"
