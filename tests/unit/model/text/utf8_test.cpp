#include "model/text/utf8.h"

#include <QtTest>

using namespace std::string_literals;

class Utf8Test : public QObject {
    Q_OBJECT

private slots:
    void characters_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<unsigned>("code");
        QTest::addColumn<std::size_t>("bytes");
        QTest::newRow("ascii") << QByteArray("Az") << 0x41U << std::size_t{1};
        QTest::newRow("two") << QByteArray("\xC2\xB5m") << 0xB5U << std::size_t{2};
        QTest::newRow("three") << QByteArray("\xE2\x82\xAC") << 0x20ACU << std::size_t{3};
        QTest::newRow("four") << QByteArray("\xF0\x9F\x98\x80!") << 0x1F600U << std::size_t{4};
        QTest::newRow("nothing") << QByteArray("\0", 1) << 0U << std::size_t{1};
    }
    void characters() {
        QFETCH(const QByteArray, text);
        const model::Character first = model::firstCharacter(text.toStdString());
        QVERIFY(first.isSound);
        QTEST(first.code, "code");
        QTEST(first.bytes, "bytes");
        QVERIFY(model::isUtf8(text.toStdString()));
        std::string written;
        model::appendUtf8(written, first.code);
        QCOMPARE(written, text.toStdString().substr(0, first.bytes));
    }

    void brokenOnes_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<std::size_t>("bytes");
        QTest::newRow("no lead") << QByteArray("\x80") << std::size_t{1};
        QTest::newRow("lead of none") << QByteArray("\xF5\x80\x80\x80") << std::size_t{1};
        QTest::newRow("last byte of all") << QByteArray("\xFF") << std::size_t{1};
        QTest::newRow("cut off") << QByteArray("\xE2\x82") << std::size_t{2};
        QTest::newRow("four cut off") << QByteArray("\xF0\x9F\x98") << std::size_t{3};
        QTest::newRow("broken off") << QByteArray("\xC2 ") << std::size_t{1};
        QTest::newRow("two for one") << QByteArray("\xC0\x80") << std::size_t{1};
        QTest::newRow("three for two") << QByteArray("\xE0\x80\xAF") << std::size_t{3};
        QTest::newRow("four for three") << QByteArray("\xF0\x80\x80\x80") << std::size_t{4};
        QTest::newRow("half a pair") << QByteArray("\xED\xA0\x80") << std::size_t{3};
        QTest::newRow("beyond Unicode") << QByteArray("\xF4\x90\x80\x80") << std::size_t{4};
    }
    void brokenOnes() {
        QFETCH(const QByteArray, text);
        const model::Character first = model::firstCharacter(text.toStdString());
        QVERIFY(!first.isSound);
        QCOMPARE(first.code, 0U);
        QTEST(first.bytes, "bytes");
        QVERIFY(!model::isUtf8("a" + text.toStdString()));
    }

    void textsAreCutBetweenCharacters() {
        const std::string text = "a\xC2\xB5\xF0\x9F\x98\x80!";
        std::vector<std::size_t> cuts;
        for (std::size_t most = 0; most <= text.size() + 1; ++most) {
            cuts.push_back(model::cutWithin(text, most));
        }
        QCOMPARE(cuts, (std::vector<std::size_t>{0, 1, 1, 3, 3, 3, 3, 7, 8, 8}));
        QCOMPARE(model::cutWithin("\xF0\x9F\x98\x80", 2), std::size_t{2});  // it has no room
        QCOMPARE(model::cutWithin(std::string(9, '\x80'), 5), std::size_t{5});
    }

    void bytesThatAreNoneAreMovedAsLatin1() {
        const std::string text = "\xB5m \xC2\xB5m \xE2\x82"s;
        std::string_view from = text;
        std::string to;
        while (!from.empty()) {
            model::moveCharacter(from, to);
        }
        QCOMPARE(to, "\xC2\xB5m \xC2\xB5m \xC3\xA2\xC2\x82"s);
    }
};

QTEST_APPLESS_MAIN(Utf8Test)
#include "utf8_test.moc"
