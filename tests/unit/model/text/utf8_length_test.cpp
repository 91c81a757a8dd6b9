#include <QtTest>

#include "model/text/utf8.h"

class Utf8LengthTest : public QObject {
    Q_OBJECT

private slots:
    void wholeSequencesHaveTheirLength() {
        QCOMPARE(model::utf8Length("a"), std::size_t{1});
        QCOMPARE(model::utf8Length("\xC2\xB5m"), std::size_t{2});
        QCOMPARE(model::utf8Length("\xE2\x82\xAC"), std::size_t{3});
        QCOMPARE(model::utf8Length("\xF0\x9F\x98\x80!"), std::size_t{4});
    }

    void brokenOnesHaveNone() {
        for (const char* broken : {"\x80", "\xC0\x80", "\xC2", "\xC2 ", "\xE2\x82", "\xF0\x9F\x98", "\xF5\x80\x80\x80",
                                   "\xFF", "\xE0\x80\x80", "\xED\xA0\x80", "\xF0\x80\x80\x80", "\xF4\x90\x80\x80"}) {
            QCOMPARE(model::utf8Length(broken), std::size_t{0});
        }
    }
};

QTEST_APPLESS_MAIN(Utf8LengthTest)
#include "utf8_length_test.moc"
