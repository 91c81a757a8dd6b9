#include "ui/stackup/stackup_model.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QtTest>

#include "model/board/document_builder.h"
#include "tests/unit/model/formats/odb/odb_testing.h"
#include "tests/unit/ui/sample_document.h"
#include "ui/common/table_text.h"

using model::Source;
using ui::StackupModel;

namespace {

/// Copper that the job states, laminate that follows from the board's thickness, and a mask that is assumed.
std::shared_ptr<const model::Document> stackOf(model::Nm coreThickness = 1'200'000) {
    auto document = std::make_shared<model::Document>(*sampleDocument());
    model::Material copper;
    copper.copperOz = 1.0;
    model::Material core;
    core.name = "FR-4";
    core.dielectricConstant = 4.25;
    core.lossTangent = 0.02;
    document->stackup.rows = {
        {"mask", {}, model::LayerType::SolderMask, 1'235'000, 25'000, Source::Assumed, {}},
        {"top", model::LayerId{0}, model::LayerType::Signal, 1'200'000, 35'000, Source::Job, copper},
        {"below top", {}, model::LayerType::Dielectric, 0, coreThickness, Source::Derived, core},
    };
    return document;
}

}  // namespace

class StackupModelTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_model.setDocument(stackOf()); }

    void everyRowTellsWhatItIsAndHowThatIsKnown() {
        QCOMPARE(ui::tableText(m_model),
                 "#\tLayer\tType\tThickness\tCumulative\tFrom\tCopper\tDk\tDf\tMaterial\n"
                 "1\tmask\tSolder mask\t25 µm\t25 µm\tassumed\t\t\t\t\n"
                 "2\ttop\tSignal\t35 µm\t60 µm\tread\t1 oz\t\t\t\n"
                 "3\tbelow top\tDielectric\t1.2 mm\t1.26 mm\tderived\t\t4.25\t0.02\tFR-4\n"
                 "\tCopper to copper\t\t1.2 mm\t1.2 mm\t\t\t\t\t\n"
                 "\tOverall\t\t1.26 mm\t1.26 mm\t\t\t\t\t\n");
    }

    void coreAndPrepregAndEditedAreNamed() {
        auto document = std::make_shared<model::Document>(*stackOf());
        document->stackup.rows[2].material.type = "PREPREG";
        document->stackup.rows[2].source = Source::Session;
        m_model.setDocument(document);
        QCOMPARE(textAt(2, StackupModel::Type), "Prepreg");
        QCOMPARE(textAt(2, StackupModel::From), "edited");
        document = std::make_shared<model::Document>(*document);
        document->stackup.rows[2].material.type = "CORE";
        m_model.setDocument(document);
        QCOMPARE(textAt(2, StackupModel::Type), "Core");
    }

    void zonesAreColumnsSideBySide() {
        m_model.setDocument(odb_testing::read(odb_testing::dataJob("rigid_flex")));
        const int rigid = m_model.columnOf(StackupModel::Cumulative);
        for (const auto& [column, name] : {std::pair{rigid, "Rigid"},
                                           {rigid + 1, "Flex"},
                                           {rigid + 2, "Stiffened end"},
                                           {m_model.columnOf(StackupModel::From), "From"},
                                           {m_model.columnOf(StackupModel::MaterialName), "Material"}}) {
            QCOMPARE(m_model.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString(), name);
        }
        const int top = m_model.rowOf(model::LayerId{1});
        QCOMPARE(textAt(top, StackupModel::Name), "TOP");
        QCOMPARE(m_model.index(top, rigid).data().toString(), "60 µm");
        QCOMPARE(m_model.index(top, rigid + 1).data().toString(), "–");
        const int last = m_model.rowCount() - 1;
        QCOMPARE(textAt(last, StackupModel::Name), "Overall");
        QCOMPARE(m_model.index(last, rigid + 1).data().toString(), "606.67 µm");
        QCOMPARE(m_model.index(last, rigid + 2).data().toString(), "856.67 µm");
        QCOMPARE(m_model.index(top, m_model.columnOf(StackupModel::From)).data().toString(), "assumed");
    }

    void findingsMarkTheirRows() {
        QVERIFY(!m_model.index(2, StackupModel::Name).data(Qt::DecorationRole).isValid());
        auto document = std::make_shared<model::Document>(*stackOf());
        document->stackup.rows[2].material.dielectricConstant = 42;
        m_model.setDocument(document);
        QCOMPARE(m_model.findings().size(), std::size_t{1});
        QVERIFY(m_model.index(2, StackupModel::Name).data(Qt::DecorationRole).isValid());
        QVERIFY(m_model.index(2, StackupModel::Name).data(Qt::ToolTipRole).toString().contains("a Dk of 42"));
        QVERIFY(!m_model.index(1, StackupModel::Name).data(Qt::DecorationRole).isValid());
    }

    void totalsAreNeitherEditedNorReset() {
        QSignalSpy edited(&m_model, &StackupModel::edited);
        QVERIFY(m_model.isTotal(3) && m_model.isTotal(4) && !m_model.isTotal(2));
        QVERIFY(!m_model.setData(thickness(3), "1 mm", Qt::EditRole));
        m_model.resetAll();
        QCOMPARE(edited[0][0].value<std::vector<model::ThicknessOverride>>().size(), std::size_t{3});
        m_model.reset({2, 3, 4});
        QCOMPARE(edited[1][0].value<std::vector<model::ThicknessOverride>>().size(), std::size_t{1});
    }

    void onlyThicknessesCanBeEdited() {
        for (int column = 0; column < m_model.columnCount(); ++column) {
            QCOMPARE(m_model.flags(m_model.index(0, column)).testFlag(Qt::ItemIsEditable),
                     column == StackupModel::Thickness);
        }
        QVERIFY(!m_model.setData(m_model.index(0, StackupModel::Name), "other", Qt::EditRole));
    }

    void anEditIsAskedForAndTheDocumentStaysAsItIs() {
        QSignalSpy edited(&m_model, &StackupModel::edited);
        QVERIFY(m_model.setData(thickness(1), " 2 oz ", Qt::EditRole));
        QCOMPARE(edited.count(), 1);
        const auto changes = edited[0][0].value<std::vector<model::ThicknessOverride>>();
        QCOMPARE(changes.size(), std::size_t{1});
        QCOMPARE(changes[0].layer, "top");
        QCOMPARE(changes[0].thickness, 69'600);
        QCOMPARE(thickness(1).data().toString(), "35 µm");
    }

    void theSameThicknessAgainIsNoEdit() {
        QSignalSpy edited(&m_model, &StackupModel::edited);
        for (int row = 0; row < m_model.layerCount(); ++row) {
            QVERIFY(m_model.setData(thickness(row), thickness(row).data(Qt::EditRole), Qt::EditRole));
        }
        QCOMPARE(edited.count(), 0);
    }

    void anEmptyTextGoesBackToTheJob() {
        QSignalSpy edited(&m_model, &StackupModel::edited);
        QVERIFY(m_model.setData(thickness(2), "", Qt::EditRole));
        QCOMPARE(edited[0][0].value<std::vector<model::ThicknessOverride>>()[0].thickness, 0);
    }

    void aBareNumberIsInTheUnitOfWhatStandsThere() {
        QSignalSpy edited(&m_model, &StackupModel::edited);
        QVERIFY(m_model.setData(thickness(1), "70", Qt::EditRole));  // of "35 µm"
        QCOMPARE(edited[0][0].value<std::vector<model::ThicknessOverride>>()[0].thickness, 70'000);
    }

    void whatIsNoThicknessIsRefusedWithTheReason_data() {
        QTest::addColumn<int>("row");
        QTest::addColumn<QString>("text");
        QTest::newRow("no number") << 1 << "thick";
        QTest::newRow("beyond all boards") << 1 << "1 inch";
        QTest::newRow("a weight of laminate") << 2 << "1 oz";
    }
    void whatIsNoThicknessIsRefusedWithTheReason() {
        QFETCH(int, row);
        QFETCH(QString, text);
        QSignalSpy edited(&m_model, &StackupModel::edited);
        QSignalSpy refused(&m_model, &StackupModel::refused);
        QVERIFY(!m_model.setData(thickness(row), text, Qt::EditRole));
        QCOMPARE(edited.count(), 0);
        QCOMPARE(refused.count(), 1);
        QVERIFY(refused[0][0].toString().contains(text));
    }

    void sameRowsWithOtherHeightsAreNoReset() {
        QSignalSpy reset(&m_model, &StackupModel::modelReset);
        QSignalSpy changed(&m_model, &StackupModel::dataChanged);
        m_model.setDocument(stackOf(800'000));
        QCOMPARE(reset.count(), 0);
        QCOMPARE(changed.count(), 1);
        QCOMPARE(thickness(2).data().toString(), "800 µm");
        m_model.setDocument(sampleDocument());
        QCOMPARE(reset.count(), 1);
        QCOMPARE(m_model.rowCount(), 0);
    }

    void modelKeepsTheRules() {
        StackupModel model;
        QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.setDocument(stackOf());
        model.setDocument(stackOf(500'000));
        model.setDocument(nullptr);
    }

private:
    [[nodiscard]] QString textAt(int row, StackupModel::Column column) const {
        return m_model.index(row, m_model.columnOf(column)).data().toString();
    }
    [[nodiscard]] QModelIndex thickness(int row) const { return m_model.index(row, StackupModel::Thickness); }

    StackupModel m_model;
};

QTEST_APPLESS_MAIN(StackupModelTest)
#include "stackup_model_test.moc"
