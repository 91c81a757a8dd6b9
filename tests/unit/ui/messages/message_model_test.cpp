#include "ui/messages/message_model.h"

#include <QAbstractItemModelTester>
#include <QtTest>

#include "tests/unit/ui/sample_document.h"
#include "ui/common/sorted_rows.h"
#include "ui/common/table_text.h"

using model::Severity;
using ui::MessageModel;

class MessageModelTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        model::Diagnostics modelling;
        modelling.report(Severity::Warning, "steps/pcb/layers/bottom/features", 9, "Outline crosses itself; repaired");
        m_model.setMessages(sampleDocument(), modelling);
        m_filter.setLeastRank(int(Severity::Info));
        m_filter.setWords({});
        m_filter.sort(-1);
    }

    void listsReadingThenModellingWithFileLineAndCount() {
        QCOMPARE(ui::tableText(m_model),
                 "Severity\tMessage\tWhere\tCount\n"
                 "Note\tNo thickness for the copper layers: 35 µm assumed\tmatrix/matrix\t1\n"
                 "Warning\tText record not drawn\tsteps/pcb/layers/top/features:17\t2\n"
                 "Error\tSymbol is defined nowhere\tsteps/pcb/layers/bottom/features:4\t1\n"
                 "Warning\tOutline crosses itself; repaired\tsteps/pcb/layers/bottom/features:9\t1\n");
        QCOMPARE(m_model.count(Severity::Warning), std::size_t{2});
    }

    void severityFilterKeepsWhatIsAtLeastAsSevere() {
        m_filter.setLeastRank(int(Severity::Warning));
        QCOMPARE(m_filter.rowCount(), 3);
        m_filter.setLeastRank(int(Severity::Error));
        QCOMPARE(m_filter.rowCount(), 1);
    }

    void allWordsMustOccurInTextOrPlace() {
        m_filter.setWords("FEATURES bottom");
        QCOMPARE(m_filter.rowCount(), 2);
        m_filter.setWords(" bottom  crosses ");
        QCOMPARE(m_filter.rowCount(), 1);
        m_filter.setWords("nowhere crosses");
        QCOMPARE(m_filter.rowCount(), 0);
    }

    void severitySortsByWeight() {
        m_filter.sort(MessageModel::Severity, Qt::DescendingOrder);
        QCOMPARE(m_filter.index(0, 0).data().toString(), "Error");
        QCOMPARE(m_filter.index(3, 0).data().toString(), "Note");
    }

    void whatRulesLeaveOutStaysOverAnExport() {
        model::Diagnostics rules;
        rules.report(Severity::Info, "b.kicad_pro", 7, "Design rules: min_via_diameter is left out");
        m_model.setRules(rules);
        m_model.setExported({});
        QCOMPARE(m_model.rowCount(), 5);
        QCOMPARE(m_model.index(4, MessageModel::Location).data().toString(), "b.kicad_pro:7");
        m_model.setRules({});
        QCOMPARE(m_model.rowCount(), 4);
    }

    void newMessagesReplaceTheOldOnes() {
        m_model.setMessages(nullptr, {});
        QCOMPARE(m_model.rowCount(), 0);
        QCOMPARE(m_model.count(Severity::Error), std::size_t{0});
    }

private:
    MessageModel m_model;
    ui::SortedRows m_filter{m_model};
    QAbstractItemModelTester m_tester{&m_model, QAbstractItemModelTester::FailureReportingMode::QtTest};
    QAbstractItemModelTester m_filterTester{&m_filter, QAbstractItemModelTester::FailureReportingMode::QtTest};
};

QTEST_GUILESS_MAIN(MessageModelTest)
#include "message_model_test.moc"
