#include "ui/measure/measurement_model.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QtTest>

using model::Measurement;
using model::MeasurementKind;
using ui::MeasurementModel;

namespace {

/// 3, 4 and 12 mm: 13 mm in space.
Measurement slanting(const char* name) {
    Measurement measurement{name, "pcb"};
    measurement.from = {1e6, 1e6, "TOP", "A", "centre"};
    measurement.to = {4e6, 5e6, "BOTTOM", "B", "edge"};
    measurement.dz = 12e6;
    return measurement;
}

QString text(const Measurement& measurement, int column) {
    MeasurementModel model;
    model.setMeasurements({measurement});
    return model.data(model.index(0, column), Qt::DisplayRole).toString();
}

}  // namespace

class MeasurementModelTest : public QObject {
    Q_OBJECT

private slots:
    void isAWellBehavedModel() {
        MeasurementModel model;
        const QAbstractItemModelTester tester(&model);
        model.setMeasurements({slanting("a")});
        model.setMeasurements({slanting("b")});
        model.setMeasurements({slanting("b"), slanting("c")});
        model.setUnit(ui::LengthUnit::Mil);
        model.setMeasurements({});
        QCOMPARE(model.rowCount(), 0);
    }

    void tellsLengthsLayersAndNets() {
        MeasurementModel model;
        Measurement flat = slanting("flat");
        flat.dz = 0.0;
        flat.overlap = 254'000.0;
        flat.to.layer = "TOP";
        flat.to.net.clear();
        model.setMeasurements({slanting("a"), flat});
        const auto text = [&](int row, int column) {
            return model.data(model.index(row, column), Qt::DisplayRole).toString();
        };
        QCOMPARE(text(0, MeasurementModel::Kind), QString("point to point"));
        QCOMPARE(text(0, MeasurementModel::Name), QString("a"));
        QVERIFY(text(0, MeasurementModel::Value).startsWith("13"));
        QVERIFY(text(0, MeasurementModel::Value).contains("mil"));
        QVERIFY(text(0, MeasurementModel::DeltaX).startsWith("3"));
        QVERIFY(text(0, MeasurementModel::DeltaZ).startsWith("12"));
        QCOMPARE(text(0, MeasurementModel::Layers), QString("TOP – BOTTOM"));
        QCOMPARE(text(0, MeasurementModel::Nets), QString("A – B"));
        QVERIFY(text(1, MeasurementModel::Value).startsWith("overlap"));
        QVERIFY(text(1, MeasurementModel::Value).contains("10"));  // mil
        QCOMPARE(text(1, MeasurementModel::Layers), QString("TOP"));
        QCOMPARE(text(1, MeasurementModel::Nets), QString("A – no net"));
        QVERIFY(!ui::partsText(flat, ui::LengthUnit::Millimetre).front().contains("ΔZ"));
        model.setUnit(ui::LengthUnit::Mil);
        QVERIFY2(text(1, MeasurementModel::Value).startsWith("overlap 10.00 mil ("),
                 qPrintable(text(1, MeasurementModel::Value)));
    }

    void aPlanarDistanceHasTheOneInSpaceBesideIt() {
        Measurement planar = slanting("a");
        planar.isPlanar = true;
        QVERIFY2(text(planar, MeasurementModel::Value).startsWith("5.0000 mm ("),
                 qPrintable(text(planar, MeasurementModel::Value)));
        QCOMPARE(ui::partsText(planar, ui::LengthUnit::Millimetre),
                 (QStringList{"ΔX 3.0000 mm  ΔY 4.0000 mm  ΔZ 12.0000 mm", "in space 13.0000 mm"}));
    }

    void anAngleIsTheOneBetweenItsArms() {
        Measurement angle = slanting("a");
        angle.kind = MeasurementKind::Angle;
        angle.corner = {0.0, 0.0, "TOP", "", "end"};
        angle.from.y = 0.0;
        angle.to = {0.0, 7e6, "TOP", "", "end"};
        QCOMPARE(text(angle, MeasurementModel::Value), QString("90°"));
        angle.to = {-5e6, 5e6, "TOP", "", "end"};
        QCOMPARE(text(angle, MeasurementModel::Value), QString("135°"));
        QCOMPARE(text(angle, MeasurementModel::Kind), QString("angle"));
        QVERIFY(text(angle, MeasurementModel::DeltaX).isEmpty());
    }

    void aRadiusTellsTheDiameterToo() {
        Measurement radius = slanting("r");
        radius.kind = MeasurementKind::Radius;
        radius.dz = 0.0;
        QCOMPARE(text(radius, MeasurementModel::Value), QString("R 5.0000 mm (196.85 mil)  ⌀ 10.0000 mm (393.70 mil)"));
    }

    void aLengthTellsLayersAndHoles() {
        Measurement length = slanting("l");
        length.kind = MeasurementKind::Length;
        length.path = {
            {{"TOP", 3e6, {{0, 0}, {3e6, 0}}}, {"L2", 1e6, {{3e6, 0}, {4e6, 0}}}, {"TOP", 2e6, {{4e6, 0}, {6e6, 0}}}},
            2,
            5e5};
        length.notes = {"a guess"};
        QVERIFY(text(length, MeasurementModel::Value).startsWith("6.5000 mm"));
        QCOMPARE(text(length, MeasurementModel::Details),
                 QString("TOP 5.0000 mm; L2 1.0000 mm; 2 holes 0.5000 mm; a guess"));
    }

    void whatRoundsToNothingHasNoSign() {
        using namespace ui;
        QCOMPARE(lengthText(-4.0, LengthUnit::Millimetre), QString("0 mm"));
        QCOMPARE(lengthText(-100.0, LengthUnit::Millimetre), QString("-0.0001 mm"));
        QCOMPARE(lengthText(-100.0, LengthUnit::Mil), QString("0 mil"));
        QCOMPARE(positionText(-1e-6, -1e6, LengthUnit::Millimetre), QString("0.0000, -1.0000 mm"));
        QCOMPARE(angleText(1e-6), QString("0°"));
        Measurement flat = slanting("a");
        flat.to.y = flat.from.y - 1e-3;
        QCOMPARE(partsText(flat, LengthUnit::Millimetre).front(), QString("ΔX 3.0000 mm  ΔY 0.0000 mm  ΔZ 12.0000 mm"));
    }

    void namesAndBoxesAreEditedByWhoListens() {
        MeasurementModel model;
        model.setMeasurements({slanting("a")});
        const QSignalSpy renamed(&model, &MeasurementModel::renamed);
        const QSignalSpy shown(&model, &MeasurementModel::shownChanged);
        const QModelIndex name = model.index(0, MeasurementModel::Name);
        QVERIFY(name.flags().testFlag(Qt::ItemIsEditable));
        QVERIFY(!model.index(0, MeasurementModel::Nets).flags().testFlag(Qt::ItemIsEditable));
        QVERIFY(model.setData(name, " width ", Qt::EditRole));
        QCOMPARE(renamed.size(), 1);
        QCOMPARE(renamed[0][1].toString(), QString("width"));
        QVERIFY(!model.setData(name, "  ", Qt::EditRole));
        QVERIFY(model.setData(name, "a", Qt::EditRole));  // nothing changes
        QCOMPARE(renamed.size(), 1);
        QCOMPARE(name.data(Qt::CheckStateRole).toInt(), int(Qt::Checked));
        QVERIFY(model.setData(name, Qt::Unchecked, Qt::CheckStateRole));
        QCOMPARE(shown.size(), 1);
        QCOMPARE(shown[0][1].toBool(), false);
    }
};

QTEST_APPLESS_MAIN(MeasurementModelTest)
#include "measurement_model_test.moc"
