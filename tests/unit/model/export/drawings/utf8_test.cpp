#include "model/export/drawings/utf8.h"

#include <QtTest>

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
        QTest::newRow("four") << QByteArray("\xF0\x9F\x98\x80") << 0x1F600U << std::size_t{4};
        QTest::newRow("cut off") << QByteArray("\xE2\x82") << 0U << std::size_t{2};
        QTest::newRow("broken off") << QByteArray("\xE2x") << 0U << std::size_t{1};
        QTest::newRow("no lead") << QByteArray("\x80") << 0U << std::size_t{1};
        QTest::newRow("too long") << QByteArray("\xE0\x80\xAF") << 0U << std::size_t{3};
        QTest::newRow("half a pair") << QByteArray("\xED\xA0\x80") << 0U << std::size_t{3};
    }

    void characters() {
        QFETCH(const QByteArray, text);
        const model::Character first = model::firstCharacter(text.toStdString());
        QTEST(first.code, "code");
        QTEST(first.bytes, "bytes");
    }
};

QTEST_GUILESS_MAIN(Utf8Test)
#include "utf8_test.moc"
