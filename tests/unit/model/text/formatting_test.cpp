#include "model/text/formatting.h"

#include <QtTest>

class FormattingTest : public QObject {
    Q_OBJECT

private slots:
    void textsAreFitForXml_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("xml");
        QTest::newRow("markup") << QByteArray("a<b>&\"c\"") << QByteArray("a&lt;b>&amp;&quot;c&quot;");
        QTest::newRow("control characters") << QByteArray("a\tb\x01") << QByteArray("a b ");
        QTest::newRow("beyond ASCII") << QByteArray("35 µm €") << QByteArray("35 µm €");
        QTest::newRow("Latin-1") << QByteArray("\xb5m") << QByteArray("?m");
        QTest::newRow("cut off") << QByteArray("a\xe2\x82") << QByteArray("a??");
        QTest::newRow("more bytes than it needs") << QByteArray("\xc0\xbc") << QByteArray("??");
        QTest::newRow("half of a pair") << QByteArray("\xed\xa0\x80") << QByteArray("???");
    }
    void textsAreFitForXml() {
        QFETCH(const QByteArray, text);
        QTEST(QByteArray::fromStdString(model::xmlText(text.toStdString())), "xml");
    }
};

QTEST_APPLESS_MAIN(FormattingTest)
#include "formatting_test.moc"
