// Laser vias as lines pass them: exact through the axis, and of the right area beside it.
#include "model/section/landing_via.h"

#include <QtTest>
#include <cmath>

using namespace model;

namespace {

/// Drilled from the top through 20 µm of copper and 80 µm of dielectric, 100 µm wide, plated 15 µm thick.
LandingVia via(double beside = 0.0) {
    return {1e6, beside, 50e3, 15e3, 100'000, 80'000, 0};
}

double areaOf(const std::vector<SectionPiece>& pieces) {
    double area = 0.0;
    for (const SectionPiece& piece : pieces) {
        area +=
            (piece.to - piece.from + piece.upperTo() - piece.upperFrom()) / 2 * (double{1} * piece.top - piece.bottom);
    }
    return area;
}

/// The same by summing thin layers.
double areaOf(const LandingVia& of) {
    double area = 0.0;
    for (double z = 5.0; z < 100'000.0; z += 10.0) {
        const double inner = z < of.wall ? 0.0 : of.innerHalf(z);
        area += 20.0 * (of.outerHalf(z) - inner);
    }
    return area;
}

QString textOf(const SectionPiece& piece) {
    return QString("%1-%2/%3-%4@%5-%6")
        .arg(piece.from / 1000)
        .arg(piece.to / 1000)
        .arg(piece.upperFrom() / 1000)
        .arg(piece.upperTo() / 1000)
        .arg(piece.bottom / 1000.0)
        .arg(piece.top / 1000.0);
}

}  // namespace

class LandingViaTest : public QObject {
    Q_OBJECT

private slots:
    void throughTheAxisItIsAFloorAndTwoWalls() {
        const auto pieces = platingOf(via(), {});
        QCOMPARE(pieces.size(), std::size_t{5});
        // 40 µm of radius on the pad, 50 where it enters the dielectric: 1.875 µm more over the floor of 15 µm.
        QCOMPARE(textOf(pieces[0]), QString("960-1040/958.125-1041.88@0-15"));
        QCOMPARE(textOf(pieces[1]), QString("958.125-973.125/950-965@15-80"));
        QCOMPARE(textOf(pieces[2]), QString("1026.88-1041.88/1035-1050@15-80"));
        QCOMPARE(textOf(pieces[3]), QString("950-965/950-965@80-100"));
        QCOMPARE(textOf(pieces[4]), QString("1035-1050/1035-1050@80-100"));
    }

    void fromBelowItIsTheMirrorImage() {
        LandingVia below = via();
        below.entry = -100'000;
        below.shoulder = -80'000;
        const auto pieces = platingOf(below, {});
        QCOMPARE(textOf(pieces.back()), QString("958.125-1041.88/960-1040@-15-0"));
        QCOMPARE(areaOf(pieces), areaOf(platingOf(via(), {})));
    }

    void besideTheAxisTheAreaIsRight() {
        for (const double beside : {0.0, 10e3, 25e3, 34e3, 38e3, 45e3, 49e3}) {
            const double wanted = areaOf(via(beside));
            QVERIFY2(std::abs(areaOf(platingOf(via(beside), {})) - wanted) < 0.02 * wanted,
                     qPrintable(QString("%1: %2 %3").arg(beside).arg(areaOf(platingOf(via(beside), {}))).arg(wanted)));
        }
        QVERIFY(platingOf(via(51e3), {}).empty());
    }

    void whatTheDrillTookAndTheConeLeavesIsFilledUp() {
        SectionPiece substrate;
        substrate.bottom = -50'000;
        substrate.top = 80'000;
        const auto pieces = besideVia(via(), substrate);
        QCOMPARE(textOf(pieces[0]), QString("950-960/950-958.125@0-15"));
        QCOMPARE(textOf(pieces[1]), QString("1040-1050/1041.88-1050@0-15"));
        QCOMPARE(areaOf(pieces), 10e3 * 80e3);  // two triangles
        substrate.bottom = 90'000;
        QVERIFY(besideVia(via(), substrate).empty());
    }

    void filledOnesHaveNothingInside() {
        LandingVia filled = via();
        filled.wall = filled.radius;
        double area = areaOf(platingOf(filled, {}));
        QCOMPARE(area, 90e3 * 80e3 + 100e3 * 20e3);
    }
};

QTEST_APPLESS_MAIN(LandingViaTest)
#include "landing_via_test.moc"
