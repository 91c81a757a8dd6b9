#include "ui/statistics/drill_model.h"

#include <QAbstractItemModelTester>
#include <QtTest>

#include "model/board/document_builder.h"
#include "ui/common/table_text.h"

using model::ElementId;
using ui::DrillModel;

namespace {

/// Three vias and a mounting hole; between them a pad, which is no hole. One tool.
std::shared_ptr<const model::Document> drilledBoard(model::Nm finished = 250'000) {
    using namespace model;
    DocumentBuilder builder;
    Layer copper;
    copper.name = "top";
    copper.type = LayerType::Signal;
    copper.side = LayerSide::Top;
    const LayerId top = builder.addLayer(copper);
    copper.name = "bottom";
    copper.side = LayerSide::Bottom;
    const LayerId bottom = builder.addLayer(copper);
    Layer drill;
    drill.name = "drill";
    drill.type = LayerType::Drill;
    drill.spanTop = top;
    drill.spanBottom = bottom;
    const LayerId drills = builder.addLayer(drill);
    DrillTool tool;
    tool.layer = drills;
    tool.number = 7;
    tool.plating = model::Plating::Via;
    tool.drillSize = 300'000;
    tool.finishedSize = finished;
    builder.addTool(tool);
    builder.beginLayer(top);
    builder.addCircle({{0, 0}, 600'000, 0}, {});
    builder.beginLayer(drills);
    DocumentBuilder::Origin via;
    via.flags = kHole | kPlated | kVia;
    DocumentBuilder::Origin bare;
    bare.flags = kHole;
    builder.addCircle({{0, 0}, 300'000, 250'000}, via);
    builder.addCircle({{5'000'000, 0}, 3'000'000, 3'000'000}, bare);
    builder.addCircle({{1'000'000, 0}, 300'000, 250'000}, via);
    builder.addCircle({{2'000'000, 0}, 300'000, 250'000}, via);
    return builder.finish();
}

}  // namespace

class DrillModelTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_model.setUnit(ui::LengthUnit::Millimetre);
        m_model.setDocument(drilledBoard());
    }

    void sameHolesAreOneRow() {
        QCOMPARE(ui::tableText(m_model),
                 "Layer\tSpan\tKind\tShape\tDiameter\tLength\tFinished\tInside\tTool\tHoles\n"
                 "drill\tthrough\tVia\tround\t0.3\t\t0.25\t0.25\t7\t3\n"
                 "drill\tthrough\tNPTH\tround\t3\t\t\t3\t\t1\n");
        QCOMPARE(m_model.index(0, DrillModel::Span).data(Qt::ToolTipRole).toString(), "top to bottom");
    }

    void rowsNameTheirHoles() {
        const auto own = [](std::initializer_list<std::uint32_t> rows) {
            std::vector<model::BoardElement> elements;
            for (const std::uint32_t row : rows) {
                elements.push_back({0, ElementId{row}});
            }
            return elements;
        };
        QCOMPARE(m_model.holesIn({0}), own({1, 3, 4}));
        QCOMPARE(m_model.holesIn({1, 0}), own({1, 2, 3, 4}));
        QVERIFY(m_model.holesIn({}).empty());
    }

    /// A tool that is as large finished as drilled says nothing of the plating, which is assumed then.
    void aFinishedSizeIsWhatTheJobStates() {
        const auto shown = [this](int row, DrillModel::Column column) {
            return m_model.index(row, column).data().toString();
        };
        m_model.setDocument(drilledBoard(300'000));
        QCOMPARE(shown(0, DrillModel::Finished), "0.3000 mm");
        QCOMPARE(shown(0, DrillModel::Inside), "0.2500 mm");
        m_model.setDocument(drilledBoard(0));
        QCOMPARE(shown(0, DrillModel::Finished), QString());
        QCOMPARE(shown(0, DrillModel::Inside), "0.2500 mm");
        QCOMPARE(shown(1, DrillModel::Finished), QString());  // it has no tool
    }

    void anAssumedPlatingIsMarked() {
        const auto isMarked = [this](int row, DrillModel::Column column) {
            const QModelIndex cell = m_model.index(row, column);
            return cell.data(Qt::FontRole).value<QFont>().italic() &&
                   cell.data(Qt::ToolTipRole).toString().startsWith("Assumed");
        };
        QVERIFY(!isMarked(0, DrillModel::Inside) && !isMarked(1, DrillModel::Inside));
        m_model.setDocument(drilledBoard(300'000));
        QVERIFY(isMarked(0, DrillModel::Inside));
        QVERIFY(!isMarked(1, DrillModel::Inside));  // an NPTH has none
        QVERIFY(!isMarked(0, DrillModel::Finished));
    }

    void lengthsFollowTheUnit() {
        QCOMPARE(m_model.index(0, DrillModel::Diameter).data().toString(), "0.3000 mm");
        m_model.setUnit(ui::LengthUnit::Mil);
        QVERIFY(m_model.index(0, DrillModel::Diameter).data().toString().endsWith(" mil"));
        QCOMPARE(m_model.index(0, DrillModel::Diameter).data(Qt::EditRole).toDouble(), 300'000 / 25'400.0);
    }

    void isEmptyWithoutADocument() {
        m_model.setDocument(nullptr);
        QCOMPARE(m_model.rowCount(), 0);
    }

private:
    DrillModel m_model;
    QAbstractItemModelTester m_tester{&m_model, QAbstractItemModelTester::FailureReportingMode::QtTest};
};

QTEST_GUILESS_MAIN(DrillModelTest)
#include "drill_model_test.moc"
