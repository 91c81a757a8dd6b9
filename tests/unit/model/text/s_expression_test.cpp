// Lists in parentheses, as KiCad writes them.
#include "model/text/s_expression.h"

#include <QtTest>

class SExpressionTest : public QObject {
    Q_OBJECT

private slots:
    void listsAtomsTextsAndLines() {
        const auto all = model::parseSExpressions(
            "(version 1)\n# a comment with (\n(rule \"a \\\"b\\\"\"\n  (constraint clearance (min 0.2mm)))\nend");
        QVERIFY(all);
        QCOMPARE(all->items.size(), std::size_t{3});
        QCOMPARE(all->items[0].head(), std::string("version"));
        QCOMPARE(all->items[0].at(1), std::string("1"));
        const model::SExpression& rule = all->items[1];
        QCOMPARE(rule.line, std::size_t{3});
        QCOMPARE(rule.at(1), std::string("a \"b\""));
        QVERIFY(rule.find("constraint") != nullptr);
        QCOMPARE(rule.find("constraint")->line, std::size_t{4});
        QCOMPARE(rule.find("constraint")->find("min")->at(1), std::string("0.2mm"));
        QVERIFY(rule.find("layer") == nullptr);
        QCOMPARE(rule.at(7), std::string());
        QVERIFY(!all->items[2].isList);
        QCOMPARE(all->items[2].atom, std::string("end"));
    }

    void whatDoesNotEndIsAnError_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("words");
        QTest::newRow("open") << QByteArray("\n(a (b)") << QByteArray("line 2: a list is not closed");
        QTest::newRow("closed") << QByteArray("(a))\n") << QByteArray("line 1: a list is closed");
        QTest::newRow("text") << QByteArray("(a\n\"b)") << QByteArray("line 2: a text does not end");
        QTest::newRow("deep") << QByteArray(100'000, '(') << QByteArray("more than 64 others, the limit");
    }
    void whatDoesNotEndIsAnError() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, words);
        const auto all = model::parseSExpressions(text.toStdString());
        QVERIFY(!all);
        QVERIFY2(all.error().text.find(words.toStdString()) != std::string::npos, all.error().text.c_str());
    }
};

QTEST_APPLESS_MAIN(SExpressionTest)
#include "s_expression_test.moc"
