#include "app/reports/stackup_report.h"

#include <QtTest>

#include "model/board/document_builder.h"
#include "model/geometry/outlines.h"

class StackupReportTest : public QObject {
    Q_OBJECT

private slots:
    /// What the plating leaves of an area is not told, so neither is where that comes from.
    void areasHaveTheSidesOfTheirBoxAndNoInside() {
        model::DocumentBuilder builder;
        model::Layer drills;
        drills.type = model::LayerType::Drill;
        builder.beginLayer(builder.addLayer(drills));
        model::DocumentBuilder::Origin origin;
        origin.flags = model::kHole | model::kPlated;
        model::ShapeSketch sketch;
        model::addBox(sketch, 1'100'000, 1'800'000, false);
        builder.addArea({builder.addShape(sketch), {}}, origin);
        const auto board = builder.finish();
        const nlohmann::ordered_json row = app::drillsJson(*board, model::drillTable(*board)).at(0);
        QCOMPARE(row["shape"].get<std::string>(), std::string("area"));
        QCOMPARE(row["diameter_nm"].get<model::Nm>(), 1'100'000);
        QCOMPARE(row["length_nm"].get<model::Nm>(), 1'800'000);
        QCOMPARE(row["inside_nm"].get<model::Nm>(), 0);
        QVERIFY(row["inside_source"].is_null());
        QVERIFY(row["tool"].is_null());
    }
};

QTEST_APPLESS_MAIN(StackupReportTest)
#include "stackup_report_test.moc"
