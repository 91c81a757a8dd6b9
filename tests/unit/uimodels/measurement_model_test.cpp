#include "ui/models/measurement_model.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QtTest>

using model::session::Measurement;
using ui::models::MeasurementModel;

namespace {

/// 3, 4 and 12 mm: 13 mm in space.
Measurement slanting(const char* name) {
    return {name, "pcb", {1e6, 1e6, "TOP", "A", "centre"}, {4e6, 5e6, "BOTTOM", "B", "edge"}, 12e6, 0.0, false, true};
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
        model.setUnit(ui::models::LengthUnit::Mil);
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
        QCOMPARE(text(0, MeasurementModel::Name), QString("a"));
        QVERIFY(text(0, MeasurementModel::Distance).startsWith("13"));
        QVERIFY(text(0, MeasurementModel::Distance).contains("mil"));
        QVERIFY(text(0, MeasurementModel::DeltaX).startsWith("3"));
        QVERIFY(text(0, MeasurementModel::DeltaZ).startsWith("12"));
        QCOMPARE(text(0, MeasurementModel::Layers), QString("TOP – BOTTOM"));
        QCOMPARE(text(0, MeasurementModel::Nets), QString("A – B"));
        QVERIFY(text(1, MeasurementModel::Distance).startsWith("overlap"));
        QVERIFY(text(1, MeasurementModel::Distance).contains("10"));  // mil
        QCOMPARE(text(1, MeasurementModel::Layers), QString("TOP"));
        QCOMPARE(text(1, MeasurementModel::Nets), QString("A – no net"));
        QVERIFY(!ui::models::partsText(flat, ui::models::LengthUnit::Millimetre).contains("ΔZ"));
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
