#include "model/export/solids/step_text.h"

#include <QtTest>
#include <string>
#include <vector>

using model::StepId;
using model::stepString;
using model::StepText;

class StepTextTest : public QObject {
    Q_OBJECT

private slots:
    void lengthsAreMillimetresWithAPoint_data() {
        QTest::addColumn<double>("nm");
        QTest::addColumn<QString>("text");
        QTest::newRow("whole") << 2e6 << "2.";
        QTest::newRow("half") << 1.5e6 << "1.5";
        QTest::newRow("zero") << 0.0 << "0.";
        QTest::newRow("a nanometre") << 1.0 << "0.000001";
        QTest::newRow("a tenth of it") << -0.1 << "-0.0000001";
        QTest::newRow("a hundredth of it") << -0.01 << "-0.00000001";
        QTest::newRow("below what is written") << -0.001 << "0.";
        QTest::newRow("large") << -1073741824.0 << "-1073.741824";
    }
    void lengthsAreMillimetresWithAPoint() {
        QFETCH(double, nm);
        QFETCH(QString, text);
        StepText step;
        step.add("A(", StepText::Length{nm}, ")");
        QCOMPARE(QString::fromStdString(std::string(step.text())), "#1=A(" + text + ");\n");
    }

    void entitiesAreNumberedAndReferToEachOther() {
        StepText step;
        const StepId point = step.point({1e6, -250'000.0}, 35'000.0);
        const StepId up = step.direction(0, 0, 1);
        const std::vector<StepId> both{point, up};
        step.add("THING(", both, ",", StepId{0}, ")");
        QCOMPARE(step.lastId(), StepId{3});
        QCOMPARE(QString::fromStdString(std::string(step.text())),
                 QString("#1=CARTESIAN_POINT('',(1.,-0.25,0.035));\n#2=DIRECTION('',(0.,0.,1.));\n"
                         "#3=THING((#1,#2),$);\n"));
    }

    void namesAreWrittenAsPart21Wants_data() {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("plain") << QByteArray("GND") << QByteArray("'GND'");
        QTest::newRow("quote") << QByteArray("it's") << QByteArray("'it''s'");
        QTest::newRow("backslash") << QByteArray("a\\b") << QByteArray("'a\\\\b'");
        QTest::newRow("greek") << QByteArray("\xCE\xA9") << QByteArray("'\\X2\\03A9\\X0\\'");
        QTest::newRow("beyond 16 bits") << QByteArray("\xF0\x9F\x98\x80") << QByteArray("'\\X4\\0001F600\\X0\\'");
        QTest::newRow("no UTF-8") << QByteArray(
                                         "a\xFF"
                                         "b\xC3")
                                  << QByteArray("'a?b?'");
        QTest::newRow("control characters") << QByteArray("a\nb") << QByteArray("'a?b'");
        QTest::newRow("comment signs stay") << QByteArray("/*;#*/") << QByteArray("'/*;#*/'");
    }
    void namesAreWrittenAsPart21Wants() {
        QFETCH(QByteArray, name);
        QFETCH(QByteArray, text);
        QCOMPARE(QByteArray::fromStdString(stepString(name.toStdString())), text);
    }
};

QTEST_APPLESS_MAIN(StepTextTest)
#include "step_text_test.moc"
