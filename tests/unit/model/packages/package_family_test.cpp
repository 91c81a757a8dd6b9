// What a component is, told from its pins: by hand, in the sizes of real jobs (millimetres).
#include "model/packages/package_family.h"

#include <QtTest>

#include "tests/unit/model/packages/in_millimetres.h"

using model::Box;
using model::Nm;
using model::PackageFacts;
using model::PackageFamily;
using model::PartKind;
using model::PinLayout;
using model::Point;
using packages::boxAt;
using packages::mm;

namespace {

/// A package under construction.
struct Package {
    PackageFacts facts;

    Package(std::string refdes, std::string name) {
        facts.refdes = std::move(refdes);
        facts.name = std::move(name);
        facts.boardDepth = mm(1.6);
    }
    Package& pin(double x, double y, double width, double height, bool isThrough = false) {
        facts.addPin({mm(x), mm(y)}, boxAt(x, y, width, height), isThrough);
        return *this;
    }
    Package& outline(double width, double height) {
        facts.setOutline({}, boxAt(0, 0, width, height), {});
        return *this;
    }
    /// Pins on the left and the right, `apart` in x.
    Package& columns(int perSide, double pitch, double apart, double width, double height, bool isThrough = false) {
        for (int i = 0; i < perSide; ++i) {
            const double y = pitch * (0.5 * (perSide - 1) - i);
            pin(-apart / 2, y, width, height, isThrough);
            pin(apart / 2, y, width, height, isThrough);
        }
        return *this;
    }
    Package& rows(int perSide, double pitch, double apart, double width, double height) {
        for (int i = 0; i < perSide; ++i) {
            const double x = pitch * (0.5 * (perSide - 1) - i);
            pin(x, -apart / 2, width, height);
            pin(x, apart / 2, width, height);
        }
        return *this;
    }
    [[nodiscard]] PackageFamily family(Nm height = 0) const {
        return familyOf(facts, patternOf(facts), model::kindOf(facts.refdes, facts.name), height);
    }
};

Package chip(const char* refdes, const char* name = "0402") {
    return Package(refdes, name).pin(-0.48, 0, 0.56, 0.62).pin(0.48, 0, 0.56, 0.62).outline(1.81, 0.91);
}

Package grid(int n, double pitch) {
    Package package("U1", "BGA");
    for (int i = 0; i < n * n; ++i) {
        package.pin(pitch * (i % n), pitch * (i / n), 0.4, 0.4);
    }
    return package;
}

}  // namespace

class PackageFamilyTest : public QObject {
    Q_OBJECT

private slots:
    void namesAreHints() {
        QCOMPARE(model::kindOf("R17", ""), PartKind::Resistor);
        QCOMPARE(model::kindOf("c3", "0402"), PartKind::Capacitor);
        QCOMPARE(model::kindOf("D4", "LED_0603_1608Metric"), PartKind::Led);
        QCOMPARE(model::kindOf("U2", "XTAL_FM_SMD5X7"), PartKind::Crystal);
        QCOMPARE(model::kindOf("CON7", ""), PartKind::Connector);
        QCOMPARE(model::kindOf("?", "PinHeader_1x03"), PartKind::Connector);
        QCOMPARE(model::kindOf("J2", "CARDEDGE15X2"), PartKind::Bare);
        QCOMPARE(model::kindOf("H1", "MountingHole_2.5mm"), PartKind::Bare);
        QCOMPARE(model::kindOf("", ""), PartKind::Unknown);
    }

    void pairsAreChipsUnlessTheyAreMoulded() {
        QCOMPARE(chip("R1").family(), PackageFamily::Chip);
        QCOMPARE(chip("C1").family(), PackageFamily::Chip);
        QCOMPARE(chip("no_refdes").family(), PackageFamily::Chip);
        const auto large = [](const char* refdes, const char* name) {
            return Package(refdes, name).pin(-2, 0, 2, 2.2).pin(2, 0, 2, 2.2).outline(7, 6.6);
        };
        QCOMPARE(large("D1", "SMB").family(), PackageFamily::TwoLeads);
        QCOMPARE(large("C1", "CAPP_AVX_CASE-D-7343").family(), PackageFamily::TwoLeads);
        QCOMPARE(large("C1", "6.3x7.7").family(), PackageFamily::CanCapacitor);
        QCOMPARE(large("L1", "5040").family(), PackageFamily::TwoLeads);
        QCOMPARE(large("Y1", "HC49").family(), PackageFamily::Crystal);
    }

    void leadsOnTwoSides() {
        const Package sot = Package("Q1", "SOT23").pin(-1, 0.95, 1.4, 0.6).pin(-1, -0.95, 1.4, 0.6).pin(1, 0, 1.4, 0.6);
        QCOMPARE(patternOf(sot.facts).layout, PinLayout::TwoRows);
        QVERIFY(!patternOf(sot.facts).isAlongY);
        QCOMPARE(sot.family(), PackageFamily::SmallOutline);
        QCOMPARE(Package("U1", "SOIC-8").columns(4, 1.27, 5.4, 1.55, 0.6).family(), PackageFamily::DualInLine);
        const Package across = Package("U1", "TSSOP48").rows(24, 0.5, 7.2, 0.3, 1.7);
        QVERIFY(patternOf(across.facts).isAlongY);
        QCOMPARE(across.family(), PackageFamily::DualInLine);
    }

    void shortPadsAreTerminals() {
        QCOMPARE(Package("U1", "").columns(4, 0.5, 2.8, 0.7, 0.25).pin(0, 0, 1.5, 1.8).family(),
                 PackageFamily::DualFlat);
        QCOMPARE(Package("U1", "").columns(8, 0.5, 4, 0.8, 0.3).rows(8, 0.5, 4, 0.3, 0.8).family(),
                 PackageFamily::QuadFlatNoLead);
        QCOMPARE(Package("U1", "").columns(16, 0.5, 11.2, 1.5, 0.3).rows(16, 0.5, 11.2, 0.3, 1.5).family(),
                 PackageFamily::QuadFlat);
    }

    void whatLiesOnTheCentrePadIsNoPattern() {
        // KiCad writes thermal vias and windows of paste as pins of their own.
        Package qfn = Package("U2", "").columns(8, 0.5, 4.9, 0.8, 0.3).rows(8, 0.5, 4.9, 0.3, 0.8).pin(0, 0, 3.6, 3.6);
        for (int i = 0; i < 25; ++i) {
            qfn.pin(0.7 * (i % 5 - 2), 0.7 * (i / 5 - 2), 0.5, 0.5);
        }
        QVERIFY(patternOf(qfn.facts).hasCentrePad);
        QCOMPARE(qfn.family(), PackageFamily::QuadFlatNoLead);
    }

    void gridsAreGrids() {
        QCOMPARE(grid(10, 0.8).family(), PackageFamily::Grid);
        QCOMPARE(patternOf(grid(10, 0.8).facts).layout, PinLayout::Grid);
    }

    void pinsThroughTheBoard() {
        const auto two = [](const char* refdes, double apart, double width, double height) {
            return Package(refdes, "")
                .pin(-apart / 2, 0, 1.6, 1.6, true)
                .pin(apart / 2, 0, 1.6, 1.6, true)
                .outline(width, height);
        };
        QCOMPARE(two("C1", 5, 12.5, 12.5).family(), PackageFamily::Radial);
        QCOMPARE(two("R1", 10, 12, 2.5).family(), PackageFamily::Axial);
        QCOMPARE(two("J1", 2.54, 5.1, 2.6).family(), PackageFamily::Header);
        QCOMPARE(two("J1", 5.08, 10, 8).family(), PackageFamily::Connector);
        QCOMPARE(Package("U1", "").columns(7, 2.54, 7.62, 1.6, 1.6, true).family(), PackageFamily::ThroughDual);
        QCOMPARE(Package("J1", "").columns(5, 2.54, 2.54, 1.7, 1.7, true).family(), PackageFamily::Header);
        QCOMPARE(Package("PS1", "").columns(5, 5.08, 33, 1.7, 1.7, true).family(), PackageFamily::ThroughHole);
    }

    void bareCopperIsNoBody() {
        QCOMPARE(Package("FID1", "").family(), PackageFamily::None);
        QCOMPARE(Package("U1", "").outline(5, 5).family(mm(1)), PackageFamily::None);
        QCOMPARE(Package("TP1", "").pin(0, 0, 1, 1).family(), PackageFamily::None);
        QCOMPARE(Package("TP1", "").pin(0, 0, 1, 1).family(mm(1)), PackageFamily::None);
        QCOMPARE(Package("JP1", "").pin(-0.6, 0, 1, 1).pin(0.6, 0, 1, 1).family(), PackageFamily::None);
        QCOMPARE(Package("J1", "").pin(0, 0, 1, 1, true).family(), PackageFamily::None);
        QCOMPARE(Package("J1", "").pin(0, 0, 1, 1, true).family(mm(6)), PackageFamily::Post);
    }

    void cardsAreNoQuadFlatPackages() {
        QCOMPARE(Package("U14", "").columns(3, 1, 138, 1.8, 0.3).rows(140, 0.5, 4.6, 0.3, 1.8).family(),
                 PackageFamily::Other);
    }
};

QTEST_APPLESS_MAIN(PackageFamilyTest)
#include "package_family_test.moc"
