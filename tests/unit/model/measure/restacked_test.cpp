// Measurements of a board whose thicknesses are edited.
#include "model/measure/restacked.h"

#include <QtTest>

#include "model/measure/net_path.h"
#include "model/measure/separation.h"
#include "tests/unit/model/measure/measure_fixture.h"

using namespace model;
using namespace measuring;

class RestackedTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        DocumentBuilder builder;
        addLayers(builder);
        m_before = builder.finish();
        Document taller = *m_before;
        taller.layers[Top].z += kHigher;
        taller.layers[Drill].thickness += kHigher;
        taller.stackup.rows[0].z += kHigher;
        taller.stackup.rows[1].thickness += kHigher;
        taller.stackup.rows[1].source = Source::Session;
        taller.boardThickness += kHigher;
        m_now = std::make_shared<const Document>(std::move(taller));
    }

    void heightsBetweenLayersFollowAndComeBack() {
        Measurement measurement = between("top", "inner", 1e6);
        measurement.notes = {"both are of net GND", std::string(kHeightIsAssumed).append("below top")};
        const Measurement after = restacked(*m_before, *m_now, measurement);
        QCOMPARE(after.dz, 1.5e6);
        QCOMPARE(after.notes, std::vector<std::string>{"both are of net GND"});  // it is known now
        QVERIFY(restacked(*m_now, *m_before, after) == measurement);
    }

    void whatHasTheHeightsAlreadyStays() {
        const Measurement measurement = between("top", "inner", 1.5e6);
        QVERIFY(restacked(*m_before, *m_now, measurement) == measurement);
    }

    void bodiesStayAsFarAboveTheirLayer() {
        QCOMPARE(restacked(*m_before, *m_now, between("top", "inner", 1.2e6)).dz, 1.7e6);
    }

    void whatIsOnOneLayerOrInThePlaneStays() {
        const Measurement onLayer = between("top", "top", 0.0);
        QVERIFY(restacked(*m_before, *m_now, onLayer) == onLayer);
        Measurement angle = between("top", "bottom", 0.0);
        angle.kind = MeasurementKind::Angle;
        QVERIFY(restacked(*m_before, *m_now, angle) == angle);
        const Measurement elsewhere = between("top", "of another board", 7.0);
        QVERIFY(restacked(*m_before, *m_now, elsewhere) == elsewhere);
    }

    void holesOfANetPathFollow() {
        Measurement measurement = between("drill", "top", 0.0);
        measurement.kind = MeasurementKind::Length;
        measurement.path = MeasuredPath{{{"bottom", 1e6, {}}, {"inner", 1e6, {}}}, 2, 2.2e6};
        measurement.notes = {kHolesAreAssumed};
        const Measurement after = restacked(*m_before, *m_now, measurement);
        QCOMPARE(after.path->holeHeight, 2.7e6);
        QCOMPARE(after.path->runs, measurement.path->runs);
        QVERIFY(after.notes.empty());
        QVERIFY(restacked(*m_now, *m_before, after) == measurement);
        measurement.path = MeasuredPath{{{"top", 1e6, {}}}, 0, 0.0};
        measurement.notes.clear();
        QVERIFY(restacked(*m_before, *m_now, measurement) == measurement);
    }

private:
    static constexpr Nm kHigher = 500'000;

    static Measurement between(const char* a, const char* b, double dz) {
        Measurement measurement;
        measurement.kind = MeasurementKind::Clearance;
        measurement.from.layer = a;
        measurement.to.layer = b;
        measurement.dz = dz;
        return measurement;
    }

    std::shared_ptr<const Document> m_before;
    std::shared_ptr<const Document> m_now;  ///< the dielectric below top is known, and higher
};

QTEST_APPLESS_MAIN(RestackedTest)
#include "restacked_test.moc"
