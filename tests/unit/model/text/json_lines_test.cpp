#include "model/text/json_lines.h"

#include <QtTest>

using model::JsonLines;

class JsonLinesTest : public QObject {
    Q_OBJECT

private slots:
    void valuesHaveTheirLines() {
        const JsonLines lines("{\n\"a\": 1, // one\n/* two\n*/ \"b\": [\n  {\"c\": \"x\\\"y\"},\n  {}]\n}");
        QCOMPARE(lines.of("/a"), std::size_t{2});
        QCOMPARE(lines.of("/b"), std::size_t{4});
        QCOMPARE(lines.of("/b/0/c"), std::size_t{5});
        QCOMPARE(lines.of("/b/1"), std::size_t{6});
        QCOMPARE(lines.of("/b/7"), std::size_t{4});
    }

    /// A lone slash was waited at for ever: found by fuzzing.
    void whatIsNoJsonEnds_data() {
        QTest::addColumn<QByteArray>("text");
        for (const char* text : {"[/", "[1 / 2]", "{\"a\": / }", "[}", "{]", "[,,]", "{\"a\"", "/*", "//", "[\"\\",
                                 "{/:/}", "[[[[[[[[[[[[[[[[[[[[", "[*/]"}) {
            QTest::addRow("%s", text) << QByteArray(text);
        }
    }
    void whatIsNoJsonEnds() {
        QFETCH(QByteArray, text);
        const JsonLines lines(std::string_view(text.constData(), static_cast<std::size_t>(text.size())));
        QCOMPARE(lines.of("/nothing"), std::size_t{1});
    }
};

QTEST_APPLESS_MAIN(JsonLinesTest)
#include "json_lines_test.moc"
