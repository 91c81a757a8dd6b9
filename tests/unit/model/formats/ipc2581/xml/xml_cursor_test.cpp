#include "model/formats/ipc2581/xml/xml_cursor.h"

#include <QtTest>

#include "model/formats/ipc2581/xml/xml_outline.h"
#include "model/formats/ipc2581/xml/xml_values.h"

using model::ipc2581::XmlCursor;
using model::ipc2581::XmlOutline;
using Token = model::ipc2581::XmlCursor::Token;

namespace {

XmlOutline outline(std::string_view text) {
    base::Progress progress;
    return model::ipc2581::outlineOf(text, progress);
}

std::string faultOf(std::string_view text) {
    return std::string(outline(text).fault);
}

}  // namespace

class XmlCursorTest : public QObject {
    Q_OBJECT

private slots:
    void tagsComeInTheirOrder() {
        XmlCursor at("<?xml version='1.0'?>\n<!-- <no> -->\n<p:a x=\"1\" y = '2>3'>text<![CDATA[<b>]]><c/>\n</p:a>\n");
        QCOMPARE(at.next(), Token::Start);
        QCOMPARE(at.name(), std::string_view("a"));
        QCOMPARE(at.value("x"), std::string_view("1"));
        QCOMPARE(at.value("y"), std::string_view("2>3"));
        QCOMPARE(at.value("z"), std::string_view());
        QCOMPARE(at.line(), 3U);
        QCOMPARE(at.depth(), 1);
        QCOMPARE(at.next(), Token::Start);
        QCOMPARE(at.name(), std::string_view("c"));
        QVERIFY(at.isEmpty());
        QCOMPARE(at.depth(), 1);
        QCOMPARE(at.next(), Token::End);
        QCOMPARE(at.line(), 4U);
        QCOMPARE(at.next(), Token::Finished);
    }

    void childrenThatAreNotReadArePassedOver() {
        XmlCursor at("<a><b><c/><c/></b><d/><b/></a><e/>");
        at.next();
        std::string names;
        model::ipc2581::forEachChild(at, [&] { names += std::string(at.name()); });
        QCOMPARE(names, std::string("bdb"));
        QCOMPARE(at.next(), Token::Start);
        QCOMPARE(at.name(), std::string_view("e"));
    }

    void theOutlineListsWhatIsNearTheRoot() {
        const XmlOutline found = outline("<a>\n<b><c><d><e><f/></e></d></c></b>\n<b/></a>");
        QVERIFY(found.fault.empty());
        QCOMPARE(found.sections.size(), std::size_t{6});
        QCOMPARE(found.sections[4].depth, 5);
        QCOMPARE(found.sections[5].line, 3U);
    }

    void faultsEndTheTextWithTheirLine_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("fault");
        QTest::newRow("wrong end") << QByteArray("<a>\n<b></a>") << QByteArray("an end tag that does not fit");
        QTest::newRow("no start") << QByteArray("<a/>\n</a>") << QByteArray("an end tag without");
        QTest::newRow("cut off") << QByteArray("<a>\n<b") << QByteArray("the file ends in the middle");
        QTest::newRow("not closed") << QByteArray("<a>\n<b/>") << QByteArray("the file ends before");
        QTest::newRow("no quotes") << QByteArray("<a>\n<b x=1/></a>") << QByteArray("an attribute is not written");
        QTest::newRow("comment") << QByteArray("<a>\n<!-- ") << QByteArray("a comment does not end");
    }
    void faultsEndTheTextWithTheirLine() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, fault);
        const std::string copy = text.toStdString();
        const XmlOutline found = outline(copy);
        QVERIFY2(found.fault.starts_with(fault.toStdString()), std::string(found.fault).c_str());
        QCOMPARE(found.faultLine, 2U);
        QVERIFY(!found.hasDocumentType);
    }

    void documentTypesAndDeepNestingAreRefused() {
        const std::string bomb = "<!DOCTYPE a [<!ENTITY b \"cc\"><!ENTITY d \"&b;&b;\">]><a x=\"&d;\"/>";
        QVERIFY(outline(bomb).hasDocumentType);
        QVERIFY(outline(bomb).sections.empty());
        std::string deep;
        for (int i = 0; i < 100; ++i) {
            deep += "<a>";
        }
        QCOMPARE(faultOf(deep), std::string("elements nest too deep: 64 levels are the limit"));
    }

    void valuesAreDecoded() {
        using namespace model::ipc2581;
        QCOMPARE(textOf("A&amp;B &lt;&#65;&#x42;&gt; &quot;&apos;"), std::string("A&B <AB> \"'"));
        QCOMPARE(textOf("&nobody; & &#0; &#xD800;"), std::string("&nobody; & &#0; &#xD800;"));
        QCOMPARE(textOf("\xB5m"), std::string("\xC2\xB5m"));
        QCOMPARE(textOf("\xC2\xB5m"), std::string("\xC2\xB5m"));
        QCOMPARE(realOf(" +1.50 ").value_or(0.0), 1.5);
        QCOMPARE(realOf("5.959E7").value_or(0.0), 5.959e7);
        QVERIFY(!realOf("1,5") && !realOf("") && !realOf("inf") && !realOf("nan"));
        QVERIFY(isTrue("true") && isTrue("1") && isTrue("TRUE") && !isTrue("false") && !isTrue(""));
    }
};

QTEST_APPLESS_MAIN(XmlCursorTest)
#include "xml_cursor_test.moc"
