#include "ui/common/table_view.h"

#include <QHeaderView>
#include <QLineEdit>
#include <QLocale>
#include <QScrollBar>
#include <QSignalSpy>
#include <QtTest>

#include "tests/patience.h"
#include "ui/common/sorted_rows.h"
#include "ui/common/table_model.h"

using ui::Cell;
using ui::TableModel;
using ui::TableView;

namespace {

/// Numbers, and names that take the room that is left. Counts how often a cell is made.
class Numbers : public TableModel {
public:
    explicit Numbers(int rows)
        : TableModel({{"Number", "", ui::kNumber}, {"Name", ""}, {"Length", "", ui::kNumber | ui::kLength}}),
          m_numbers(static_cast<std::size_t>(rows), 7) {}

    void set(int row, qulonglong number) { m_numbers[static_cast<std::size_t>(row)] = number; }
    void begin() {
        beginResetModel();
        endResetModel();
    }

    mutable int cells = 0;

protected:
    [[nodiscard]] int rows() const override { return static_cast<int>(m_numbers.size()); }
    [[nodiscard]] Cell cell(int row, int column) const override {
        ++cells;
        const qulonglong number = m_numbers[static_cast<std::size_t>(row)];
        if (column == 1) {
            return {.text = "the name of row " + QString::number(row), .colour = QColor(Qt::red), .tip = "a name"};
        }
        return column == 0 ? count(number) : length(1e6 * static_cast<double>(number));
    }

private:
    std::vector<qulonglong> m_numbers;
};

/// One name, which takes whatever is typed.
class OneName : public TableModel {
public:
    OneName() : TableModel({{"Name", "", ui::kEditable}}) {}

protected:
    [[nodiscard]] int rows() const override { return 1; }
    [[nodiscard]] Cell cell(int, int) const override { return {m_name}; }
    bool edit(int, int, const QVariant& value) override {
        m_name = value.toString();
        return true;
    }

private:
    QString m_name = "before";
};

}  // namespace

class TableViewTest : public QObject {
    Q_OBJECT

private slots:
    void theLongestNumberIsWholeWhereverItIs_data() {
        QTest::addColumn<int>("rows");
        QTest::addColumn<int>("longest");
        QTest::newRow("first of a few") << 20 << 0;
        QTest::newRow("last of a few") << 20 << 19;
        QTest::newRow("first") << 900 << 0;
        QTest::newRow("within") << 900 << 501;
        QTest::newRow("last") << 900 << 899;
    }
    void theLongestNumberIsWholeWhereverItIs() {
        QFETCH(const int, rows);
        QFETCH(const int, longest);
        Numbers numbers(rows);
        numbers.set(longest, 123'456'789);
        TableView table(numbers);
        table.fitColumns(1);
        table.show();
        const int needed = table.fontMetrics().horizontalAdvance(QLocale().toString(123'456'789));
        QVERIFY2(table.columnWidth(0) > needed, qPrintable(QString::number(table.columnWidth(0))));
        numbers.set(longest, 1);
        numbers.begin();
        QTRY_VERIFY(table.columnWidth(0) < needed);
    }

    void aLongTableIsMeasuredBySomeOfItsRows() {
        Numbers numbers(200'000);
        TableView table(numbers);
        table.resize(400, 300);
        table.fitColumns(1);
        table.show();
        QVERIFY2(numbers.cells < 10'000, qPrintable(QString::number(numbers.cells)));
        QVERIFY(numbers.cells > 0);
    }

    void allThatIsDrawnOfACellIsAskedForAtOnce() {
        Numbers numbers(3);
        ui::SortedRows rows(numbers);
        for (const QModelIndex& index : {rows.index(1, 0), rows.index(1, 1), rows.index(2, 2), QModelIndex()}) {
            std::vector<QModelRoleData> roles;
            for (const int role : {Qt::DisplayRole, Qt::FontRole, Qt::ForegroundRole, Qt::CheckStateRole,
                                   Qt::DecorationRole, Qt::TextAlignmentRole, Qt::BackgroundRole, Qt::EditRole}) {
                roles.emplace_back(role);
                roles.back().setData(QStringLiteral("from before"));
            }
            numbers.cells = 0;
            rows.multiData(index, roles);
            QCOMPARE(numbers.cells, index.isValid() ? 1 : 0);
            for (const QModelRoleData& role : roles) {
                QCOMPARE(role.data(), index.data(role.role()));
            }
        }
    }

    /// A point for lengths and a point for the thousands of counts would be misread.
    void countsAndLengthsAreWrittenAlikeInEveryLanguage() {
        const QLocale before;
        QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
        ui::setNumberFormat();
        Numbers numbers(1);
        numbers.set(0, 1'234);
        const QString count = numbers.index(0, 0).data().toString();
        const QString text = QStringLiteral("%L1").arg(1'234'567);
        QLocale::setDefault(before);
        QCOMPARE(count, "1,234");
        QCOMPARE(text, "1,234,567");
    }

    void lengthsSayBothSystemsInTheirTips() {
        Numbers numbers(1);
        numbers.setUnit(ui::LengthUnit::Millimetre);
        QCOMPARE(numbers.index(0, 0).data(Qt::ToolTipRole), QVariant());
        QCOMPARE(numbers.index(0, 1).data(Qt::ToolTipRole).toString(), QStringLiteral("a name"));
        const QString tip = numbers.index(0, 2).data(Qt::ToolTipRole).toString();
        QVERIFY2(tip.contains("7") && tip.contains("mm") && tip.contains("275.59"), qPrintable(tip));
    }

    void theCurrentRowStaysInSightWhenTheTableBecomesSmaller() {
        Numbers numbers(200);
        TableView table(numbers);
        table.resize(300, 400);
        table.show();
        QVERIFY(QTest::qWaitForWindowExposed(&table));
        table.goToRow(numbers.index(150, 1));  // the last one in sight
        const auto isInSight = [&] {
            const QRect row = table.visualRect(table.currentIndex());
            return row.top() >= 0 && row.bottom() < table.viewport()->height();
        };
        QVERIFY(isInSight());
        for (const int height : {250, 150}) {
            table.resize(300, height);
            QTRY_VERIFY(table.viewport()->height() < height);
            QVERIFY2(isInSight(), qPrintable(QString::number(height)));
        }
        table.resize(300, 400);
        table.scrollToTop();
        table.resize(300, 150);
        QTRY_VERIFY(table.viewport()->height() < 150);
        QVERIFY2(table.verticalScrollBar()->value() == 0, "the user has left it");
    }

    void theEnterThatEndsAnEditChoosesNoRow() {
        OneName names;
        TableView table(names);
        table.show();
        table.setCurrentIndex(names.index(0, 0));
        const QSignalSpy chosen(&table, &TableView::rowChosen);
        QTest::keyClick(&table, Qt::Key_F2);
        auto* editor = table.findChild<QLineEdit*>();
        QVERIFY(editor != nullptr);
        editor->setText("after");
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE(names.index(0, 0).data().toString(), QString("after"));
        QCOMPARE(chosen.count(), 0);
        QTRY_VERIFY(table.findChild<QLineEdit*>() == nullptr);
        QTest::keyClick(&table, Qt::Key_Return);
        QCOMPARE(chosen.count(), 1);
    }
};

QTEST_MAIN(TableViewTest)
#include "table_view_test.moc"
