#include "model/formats/kicad/unused_pads.h"

#include <QtTest>

#include "tests/unit/model/formats/kicad/kicad_testing.h"

using namespace kicad_testing;

namespace {

/// At (1, 1) mm.
constexpr const char* kUnusedVia =
    "(via (at 1 1) (size 0.6) (drill 0.3) (layers \"F.Cu\" \"B.Cu\") (remove_unused_layers yes) (keep_end_layers yes) "
    "(net 1))";

/// Is the pad of the via on the inner layer there, beside one track?
bool keeps(const std::string& track) {
    return on(boardWith(kUnusedVia + track), "In1.Cu").size() == 2;
}

std::string segment(const std::string& ends, const char* net = "1") {
    return "(segment " + ends + " (width 0.2) (layer \"In1.Cu\") (net " + net + "))";
}

}  // namespace

class UnusedPadsTest : public QObject {
    Q_OBJECT

private slots:
    void tracksOverTheMiddleKeepIt() {
        QVERIFY(keeps(segment("(start -3 1) (end 5 1)")));
        QVERIFY(keeps(segment("(start -3 1.09) (end 5 1.09)")));
        QVERIFY(!keeps(segment("(start -3 1.11) (end 5 1.11)")));  // it only touches the pad
        QVERIFY(!keeps(segment("(start -3 1) (end 5 1)", "0")));
        QVERIFY(!keeps(segment("(start 1.4 1) (end 5 1)")));
        QVERIFY(keeps("(arc (start -1 -1) (mid 1 1) (end 3 -1) (width 0.2) (layer \"In1.Cu\") (net 1))"));
        QVERIFY(!keeps("(arc (start -1 -1) (mid 1 -3) (end 3 -1) (width 0.2) (layer \"In1.Cu\") (net 1))"));
    }

    void heatSinksKeepAllOfTheirCopper() {
        const auto pad = [](const char* property) {
            return "(footprint \"x\" (layer \"F.Cu\") (at 0 0) (pad \"1\" thru_hole circle (at 1 1) (size 2 2) (drill "
                   "1) " +
                   std::string(property) + " (layers \"*.Cu\") (remove_unused_layers yes) (net 1)))";
        };
        QCOMPARE(on(boardWith(pad("(property pad_prop_heatsink)")), "In1.Cu").size(), std::size_t{1});
        QCOMPARE(on(boardWith(pad("(property pad_prop_bga)")), "In1.Cu").size(), std::size_t{0});
    }

    /// KiCad 6 asks the fills, later ones the list in the via.
    void fillsKeepItInFilesOfKicad6() {
        const auto count = [](const std::string& points, const char* version, const char* net = "1") {
            const std::string zone = "(zone (net " + std::string(net) +
                                     ") (net_name \"\") (layer \"In1.Cu\") (min_thickness 0.2) "
                                     "(filled_areas_thickness no) (filled_polygon (layer \"In1.Cu\") (pts " +
                                     points + ")))";
            return on(boardWith(kUnusedVia + zone, "", version), "In1.Cu").size();
        };
        const std::string around = "(xy 0 0) (xy 4 0) (xy 4 4) (xy 0 4)";
        QCOMPARE(count(around, "20211014"), std::size_t{2});
        QCOMPARE(count(around, "20211014", "0"), std::size_t{1});
        QCOMPARE(count(around, "20221018"), std::size_t{1});
        QCOMPARE(count("(xy 1.29 0) (xy 4 0) (xy 4 4) (xy 1.29 4)", "20211014"), std::size_t{2});
        QCOMPARE(count("(xy 1.31 0) (xy 4 0) (xy 4 4) (xy 1.31 4)", "20211014"), std::size_t{1});
    }
};

QTEST_APPLESS_MAIN(UnusedPadsTest)
#include "unused_pads_test.moc"
