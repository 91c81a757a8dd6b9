#include "ui/statistics/statistics_model.h"

#include <QAbstractItemModelTester>
#include <QtTest>
#include <numbers>

#include "model/statistics/element_sizes.h"
#include "tests/unit/ui/sample_document.h"
#include "ui/common/sorted_rows.h"
#include "ui/common/table_text.h"

using ui::StatisticsModel;

namespace {

QString namesOf(const QAbstractItemModel& model) {
    QStringList names;
    for (int row = 0; row < model.rowCount(); ++row) {
        names += model.index(row, StatisticsModel::Layer).data().toString();
    }
    return names.join(' ');
}

}  // namespace

class StatisticsModelTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_model.setDocument(sampleDocument()); }

    void countsKindsPerLayerAndInAllWithoutAddedLayers() {
        QCOMPARE(ui::tableText(m_model),
                 "Layer\tLine\tArc\tCircle\tTrail\tArea\tElements\tFeatures\tCopper\n"
                 "top\t1200\t0\t1\t0\t0\t1201\t1300\t\n"
                 "bottom\t0\t0\t2\t0\t0\t2\t2\t\n"
                 "notes\t0\t0\t0\t0\t0\t0\t0\t\n"
                 "All layers\t1200\t0\t3\t0\t0\t1203\t1302\t\n");
    }

    void totalAgreesWithTheDocument() {
        const auto counts = sampleDocument()->elementCounts();
        const int last = m_model.rowCount() - 1;
        for (std::size_t kind = 0; kind < model::kElementKindCount; ++kind) {
            QCOMPARE(m_model.index(last, StatisticsModel::Line + int(kind)).data(Qt::EditRole).toUInt(), counts[kind]);
        }
    }

    void numbersAreGroupedForReading() {
        QCOMPARE(m_model.index(0, StatisticsModel::Line).data().toString(), QLocale().toString(1200));
    }

    void totalStaysLastHoweverSorted() {
        m_sorter.sort(StatisticsModel::Circle, Qt::DescendingOrder);
        QCOMPARE(namesOf(m_sorter), "bottom top notes All layers");
        m_sorter.sort(StatisticsModel::Circle, Qt::AscendingOrder);
        QCOMPARE(namesOf(m_sorter), "notes top bottom All layers");
        m_sorter.sort(StatisticsModel::Layer, Qt::DescendingOrder);
        QCOMPARE(namesOf(m_sorter), "top notes bottom All layers");
    }

    void selectedRowsAreCopiedOnceEach() {
        const QModelIndexList cells{m_model.index(1, 3), m_model.index(1, 0), m_model.index(3, 2)};
        QCOMPARE(ui::rowsText(cells), "bottom\t0\t0\t2\t0\t0\t2\t2\t\nAll layers\t1200\t0\t3\t0\t0\t1203\t1302\t\n");
        QCOMPARE(ui::rowsText({}), QString());
    }

    void copperStandsInTheUnitOfTheUserAndSortsByNumber() {
        m_model.setDocument(sampleDocument(), model::copperAreas(*sampleDocument()));
        const auto copper = [&](int row) { return m_model.index(row, StatisticsModel::Copper); };
        const double circle = std::numbers::pi / 4.0 * 500'000.0 * 500'000.0;
        QCOMPARE(copper(1).data(Qt::EditRole).toDouble(), 2.0 * circle / 1e12);
        QCOMPARE(copper(1).data().toString(), ui::areaText(2.0 * circle, ui::LengthUnit::Millimetre));
        QCOMPARE(copper(2).data().toString(), QString());  // not copper
        QCOMPARE(copper(3).data(Qt::EditRole).toDouble(),
                 copper(0).data(Qt::EditRole).toDouble() + copper(1).data(Qt::EditRole).toDouble());
        m_model.setUnit(ui::LengthUnit::Mil);
        QCOMPARE(copper(1).data().toString(), ui::areaText(2.0 * circle, ui::LengthUnit::Mil));
        m_sorter.sort(StatisticsModel::Copper, Qt::AscendingOrder);
        QCOMPARE(namesOf(m_sorter), "bottom top notes All layers");
        m_model.setUnit(ui::LengthUnit::Millimetre);
    }

    void isEmptyWithoutADocument() {
        m_model.setDocument(nullptr);
        QCOMPARE(m_model.rowCount(), 0);
        QCOMPARE(m_sorter.rowCount(), 0);
    }

private:
    StatisticsModel m_model;
    ui::SortedRows m_sorter{m_model};
    QAbstractItemModelTester m_tester{&m_model, QAbstractItemModelTester::FailureReportingMode::QtTest};
    QAbstractItemModelTester m_sorterTester{&m_sorter, QAbstractItemModelTester::FailureReportingMode::QtTest};
};

QTEST_GUILESS_MAIN(StatisticsModelTest)
#include "statistics_model_test.moc"
