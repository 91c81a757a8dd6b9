#include "model/export/drawings/dxf_names.h"

#include <QtTest>

class DxfNamesTest : public QObject {
    Q_OBJECT

private slots:
    void namesAreTakenOnceWhateverTheirCase() {
        model::DxfNames names;
        QCOMPARE(names.unique("F.Cu"), std::string("F.Cu"));
        QCOMPARE(names.unique("f.cu"), std::string("f.cu_2"));
        QCOMPARE(names.unique("F.Cu"), std::string("F.Cu_3"));
        QCOMPARE(names.unique("0"), std::string("0_2"));  // every drawing has one of that name
        QCOMPARE(names.unique(""), std::string("_"));
    }

    void forbiddenCharactersAreReplaced() {
        model::DxfNames names;
        QCOMPARE(names.unique("a<b>/c|d*e=f\n"), std::string("a_b__c_d_e_f_"));
        QCOMPARE(names.unique("Lötstopp µ"), std::string("L\\U+00F6tstopp \\U+00B5"));
        QCOMPARE(names.unique("\xFFx"), std::string("_x"));
        QCOMPARE(names.unique("\xF0\x9F\x98\x80"), std::string("_"));  // beyond four digits
    }

    void textsKeepWhatNamesMayNotHave() {
        QCOMPARE(model::dxfText("U<1>\n"), std::string("U<1>_"));
        QCOMPARE(model::dxfText("µ"), std::string("\\U+00B5"));
        QCOMPARE(model::dxfText(""), std::string());
    }

    void coloursAreTheNearestOfTheTable() {
        QCOMPARE(model::dxfColour(0xFF0000), 1);
        QCOMPARE(model::dxfColour(0xFFFF00), 2);
        QCOMPARE(model::dxfColour(0x0000FF), 5);
        QCOMPARE(model::dxfColour(0xFFFFFF), 7);
        QCOMPARE(model::dxfColour(0xFF7F00), 30);  // orange
        QCOMPARE(model::dxfColour(0x00FF7F), 110);
        QCOMPARE(model::dxfColour(0x7F0000), 14);
        QCOMPARE(model::dxfColour(0xFF7F7F), 11);
        QCOMPARE(model::dxfColour(0x343434), 250);
    }
};

QTEST_GUILESS_MAIN(DxfNamesTest)
#include "dxf_names_test.moc"
