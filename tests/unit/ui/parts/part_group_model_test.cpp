#include "ui/parts/part_group_model.h"

#include <QAbstractItemModelTester>
#include <QtTest>

#include "model/board/document_builder.h"
#include "ui/common/sorted_rows.h"
#include "ui/common/table_text.h"

using ui::PartGroupModel;
using ui::PartModel;

namespace {

/// Capacitors C10, C2 and C1 that are alike but for their tolerance, C3 of another value, C4 that is not fitted, and R1
/// of which the job says the same but for its package.
std::shared_ptr<const model::Document> board() {
    using namespace model;
    DocumentBuilder builder;
    Package package;
    package.name = "0603";
    const PackageId small = builder.addPackage(package, {});
    const auto add = [&](const char* refdes, const char* value, const char* tolerance, bool isFitted, PackageId of) {
        Component part;
        part.refdes = refdes;
        part.part = "CAP";
        part.package = of;
        part.isPopulated = isFitted;
        part.properties =
            builder.addProperties(std::vector<Property>{{builder.string("VALUE"), builder.string(value)},
                                                        {builder.string("Tolerance"), builder.string(tolerance)}});
        builder.addComponent(part, {});
    };
    add("C10", "100n", "5%", true, small);
    add("C2", "100n", "1%", true, small);
    add("C3", "20n", "5%", true, small);
    add("C4", "100n", "5%", false, small);
    add("C1", "100n", "5%", true, small);
    add("R1", "100n", "5%", true, {});
    return builder.finish();
}

}  // namespace

class PartGroupModelTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_parts.setBoard(board());
        m_parts.setAttribute({});
    }

    void whatTheJobSaysAlikeIsOneRow() {
        PartGroupModel groups(m_parts);
        QAbstractItemModelTester tester(&groups, QAbstractItemModelTester::FailureReportingMode::QtTest);
        QCOMPARE(groups.rowCount(), 0);
        groups.setOn(true);
        QCOMPARE(texts(groups, PartGroupModel::Designators), (QStringList{"C1, C2, C10", "C3", "C4", "R1"}));
        QCOMPARE(texts(groups, PartGroupModel::Quantity), (QStringList{"3", "1", "1", "1"}));
        QCOMPARE(texts(groups, PartGroupModel::Value), (QStringList{"100n", "20n", "100n", "100n"}));
        QCOMPARE(texts(groups, PartGroupModel::Package), (QStringList{"0603", "0603", "0603", ""}));
        QCOMPARE(texts(groups, PartGroupModel::Fitted), (QStringList{"yes", "yes", "no", "yes"}));
        QVERIFY(groups.hasValues());
        QCOMPARE(groups.partsOf(0), (std::vector<int>{0, 1, 4}));
        QCOMPARE(groups.groupOf(4), std::optional(0));
        m_parts.setBoard(model::DocumentBuilder().finish());
        QCOMPARE(groups.rowCount(), 0);
        QVERIFY(!groups.groupOf(0));
    }

    /// C2 is between those that are listed.
    void whatTheBoardExcludesIsLeftOutAndCounted() {
        model::DocumentBuilder builder;
        const auto add = [&](const char* refdes, const char* mark) {
            model::Component part;
            part.refdes = refdes;
            part.part = "LOGO";
            part.properties =
                builder.addProperties(std::vector<model::Property>{{builder.string(mark), builder.string("yes")}});
            builder.addComponent(part, {});
        };
        add("C1", "dnp");
        add("C2", "exclude_from_bom");
        add("C3", "exclude_from_pos_files");
        m_parts.setBoard(builder.finish());
        PartGroupModel groups(m_parts);
        QVERIFY(groups.leftOutText().isEmpty());
        groups.setOn(true);
        QCOMPARE(texts(groups, PartGroupModel::Designators), QStringList{"C1, C3"});
        QCOMPARE(groups.partsOf(0), (std::vector<int>{0, 2}));
        QVERIFY(!groups.groupOf(1));
        QCOMPARE(groups.groupOf(2), std::optional(0));
        QCOMPARE(groups.leftOutText(), "1 component excluded from the bill of materials");
        const QVariant tip = groups.headerData(PartGroupModel::Quantity, Qt::Horizontal, Qt::ToolTipRole);
        QVERIFY2(tip.toString().endsWith(groups.leftOutText()), qPrintable(tip.toString()));
        m_parts.setBoard(board());
        QVERIFY(groups.leftOutText().isEmpty());
    }

    void tipsHaveAllDesignatorsInShortLines() {
        model::DocumentBuilder builder;
        for (int number = 1; number <= 30; ++number) {
            model::Component part;
            part.refdes = "R" + std::to_string(number);
            builder.addComponent(part, {});
        }
        m_parts.setBoard(builder.finish());
        PartGroupModel groups(m_parts);
        groups.setOn(true);
        const QString tip = groups.index(0, PartGroupModel::Designators).data(Qt::ToolTipRole).toString();
        QCOMPARE(tip.split('\n').size(), 3);
        QVERIFY(tip.startsWith("R1, R2, ") && tip.contains("R12,\nR13") && tip.endsWith(", R30"));
    }

    void attributesAreWhatAllHaveOrEachHas() {
        PartGroupModel groups(m_parts);
        groups.setOn(true);
        QCOMPARE(texts(groups, PartGroupModel::Attributes).front(), "VALUE: 100n");
        m_parts.setAttribute("Tolerance");
        QCOMPARE(texts(groups, PartGroupModel::Attributes).front(), "5%, 1%");
    }

    void rowsAreSortedAsPeopleCountAndFilteredAsAWhole() {
        PartGroupModel groups(m_parts);
        groups.setOn(true);
        ui::SortedRows rows(groups);
        rows.sort(PartGroupModel::Value);
        QCOMPARE(rows.index(0, PartGroupModel::Designators).data().toString(), "C3");
        rows.sort(PartGroupModel::Quantity, Qt::DescendingOrder);
        QCOMPARE(rows.index(0, PartGroupModel::Quantity).data().toString(), "3");
        rows.setWords("c10 1%");
        QCOMPARE(rows.rowCount(), 1);
        QCOMPARE(rows.index(0, PartGroupModel::Designators).data().toString(), "C1, C2, C10");
    }

    void filesHaveAllDesignatorsInOneField() {
        PartGroupModel groups(m_parts);
        groups.setOn(true);
        const QStringList lines = ui::tableCsv(groups).split('\n');
        QCOMPARE(lines[0], "Quantity,Part,Value,Package,Attributes,Fitted,Step,Designators");
        QCOMPARE(lines[1], "3,CAP,100n,0603,VALUE: 100n,yes,,\"C1, C2, C10\"");
    }

private:
    static QStringList texts(const PartGroupModel& model, int column) {
        QStringList all;
        for (int row = 0; row < model.rowCount(); ++row) {
            all += model.index(row, column).data().toString();
        }
        return all;
    }

    PartModel m_parts;
};

QTEST_MAIN(PartGroupModelTest)
#include "part_group_model_test.moc"
