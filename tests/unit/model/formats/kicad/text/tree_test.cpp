#include "model/formats/kicad/text/tree.h"

#include <QtTest>

using namespace model;
using kicad::BoardItems;
using kicad::Item;

namespace {

std::vector<std::string> headsOf(std::string_view text, Diagnostics& diagnostics) {
    BoardItems items(text, "file", diagnostics);
    std::vector<std::string> heads;
    for (Item item; items.next(item);) {
        heads.emplace_back(item.head());
    }
    return heads;
}

using Heads = std::vector<std::string>;

}  // namespace

class TreeTest : public QObject {
    Q_OBJECT

private slots:
    void boardsAreTold() {
        QVERIFY(kicad::looksLikeBoard("(kicad_pcb (version 4)"));
        QVERIFY(kicad::looksLikeBoard(" \n( kicad_pcb\n"));
        QVERIFY(!kicad::looksLikeBoard("(kicad_sch (version 4)"));
        QVERIFY(!kicad::looksLikeBoard("kicad_pcb"));
        QVERIFY(!kicad::looksLikeBoard(""));
    }

    void itemsAreListsOfAtomsAndLists() {
        Diagnostics diagnostics;
        BoardItems items("(kicad_pcb\n (net 1 \"a \\\"b\\\"\\n\")\n(x (y 1 2) flag (z no)))", "file", diagnostics);
        Item item;
        QVERIFY(items.next(item));
        QCOMPARE(item.line(), 2U);
        QCOMPARE(item.word(1), std::string_view("1"));
        QCOMPARE(item.text(2), std::string("a \"b\"\n"));
        QVERIFY(item.at(2).isQuoted());
        QVERIFY(items.next(item));
        QCOMPARE(item.find("y").word(2), std::string_view("2"));
        QCOMPARE(item.find("y").source(), std::string_view("(y 1 2)"));
        QVERIFY(item.isSet("flag"));
        QVERIFY(!item.isSet("z"));
        QVERIFY(!item.find("nothing").isThere());
        QVERIFY(item.find("nothing").find("more").word(3).empty());
        QVERIFY(!items.next(item));
        QCOMPARE(diagnostics.entries().size(), std::size_t{0});
    }

    void aForgottenParenthesisOfTeardropsIsAdded() {
        Diagnostics diagnostics;
        BoardItems items("(kicad_pcb (pad 1 (teardrops (curved no)filter_ratio 0.9) (enabled yes)) (net 3)) (net 4))",
                         "file", diagnostics);
        Item item;
        QVERIFY(items.next(item));
        QCOMPARE(item.find("teardrops").find("filter_ratio").word(1), std::string_view("0.9"));
        QVERIFY(item.find("teardrops").isSet("enabled"));
        QCOMPARE(item.find("net").word(1), std::string_view("3"));
        QVERIFY(items.next(item));
        QCOMPARE(item.head(), std::string_view("net"));
        QVERIFY(!items.next(item));
        QCOMPARE(diagnostics.entries().size(), std::size_t{1});
    }

    void anItemThatDoesNotEndCostsOnlyItself() {
        Diagnostics diagnostics;
        QCOMPARE(headsOf("(kicad_pcb\n\t(segment (start 1 2)\n\t(via (at 1 2))\n\t(zone)\n)", diagnostics),
                 (Heads{"segment", "via", "zone"}));
        QCOMPARE(diagnostics.count(Severity::Error), std::size_t{1});
        QCOMPARE(diagnostics.entries()[0].line, 2U);
    }

    void aParenthesisTooManyEndsNothing() {
        Diagnostics diagnostics;
        QCOMPARE(headsOf("(kicad_pcb (a)) (b))", diagnostics), (Heads{"a", "b"}));
        QCOMPARE(diagnostics.count(Severity::Warning), std::size_t{1});
    }

    void aFileThatIsCutOffIsReported() {
        Diagnostics diagnostics;
        QCOMPARE(headsOf("(kicad_pcb (a (b", diagnostics), (Heads{"a"}));
        QCOMPARE(diagnostics.count(Severity::Error), std::size_t{1});
    }

    void aTextEndsWithItsLine() {
        Diagnostics diagnostics;
        QCOMPARE(headsOf("(kicad_pcb (a \"open\n) (b))", diagnostics), (Heads{"a", "b"}));
        QCOMPARE(diagnostics.count(Severity::Warning), std::size_t{1});
    }

    void aQuoteWithinAWordBelongsToIt() {
        Diagnostics diagnostics;
        BoardItems items("(kicad_pcb (a 0.062\" (b \"c\")) (d x\"y\"z))", "file", diagnostics);
        Item item;
        QVERIFY(items.next(item));
        QCOMPARE(item.text(1), std::string("0.062\""));
        QCOMPARE(item.find("b").text(1), std::string("c"));
        QVERIFY(items.next(item));
        QCOMPARE(item.text(1), std::string("x\"y\"z"));
        QVERIFY(diagnostics.entries().empty());
    }

    void depthCostsNoStack() {
        Diagnostics diagnostics;
        const std::string text = "(kicad_pcb " + std::string(1'000'000, '(') + std::string(1'000'000, ')') + " (b))";
        QCOMPARE(headsOf(text, diagnostics), (Heads{"", "b"}));
    }

    void linesWithAHashAreComments() {
        Diagnostics diagnostics;
        QCOMPARE(headsOf("(kicad_pcb\n  # (c)\n (a #b))", diagnostics), (Heads{"a"}));
    }
};

QTEST_APPLESS_MAIN(TreeTest)
#include "tree_test.moc"
