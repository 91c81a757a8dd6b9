#include "model/board/diagnostics.h"

#include <QtTest>

using model::Diagnostics;
using model::ElementId;
using model::Severity;

class DiagnosticsTest : public QObject {
    Q_OBJECT

private slots:
    void oneCauseIsOneEntryThatNamesItsFirstPlace() {
        Diagnostics diagnostics;
        diagnostics.report(Severity::Warning, "a", 7, "a pad was skipped", ElementId{3});
        diagnostics.report(Severity::Warning, "a", 9, "a pad was skipped", ElementId{4});
        diagnostics.report(Severity::Warning, "b", 1, "a pad was skipped");
        QCOMPARE(diagnostics.entries().size(), 2U);
        QCOMPARE(diagnostics.entries()[0].line, 7U);
        QCOMPARE(diagnostics.entries()[0].count, 2U);
        QVERIFY(diagnostics.entries()[0].element == ElementId{3});
    }

    void appendingAddsUpTheCounts() {
        Diagnostics first;
        first.report(Severity::Info, "a", 1, "x");
        Diagnostics second;
        second.report(Severity::Info, "a", 2, "x");
        second.report(Severity::Error, "a", 3, "y");
        first.append(second);
        QCOMPARE(first.entries().size(), 2U);
        QCOMPARE(first.entries()[0].count, 2U);
        QCOMPARE(first.count(Severity::Error), 1U);
        QCOMPARE(first.count(Severity::Warning), 0U);
    }

    void messagesBeginWithACapital() {
        Diagnostics diagnostics;
        diagnostics.report(Severity::Info, "a", 1, "layer x: odd");
        diagnostics.report(Severity::Info, "a", 2, "Layer x: odd");
        diagnostics.report(Severity::Info, "a", 3, "");
        QCOMPARE(diagnostics.entries().size(), 2U);
        QCOMPARE(diagnostics.entries()[0].text, std::string("Layer x: odd"));
    }

    void softenedEntriesKeepAllElse() {
        Diagnostics diagnostics;
        diagnostics.report(Severity::Error, "a", 7, "odd", ElementId{3});
        diagnostics.report(Severity::Error, "a", 9, "odd", ElementId{4});
        diagnostics.report(Severity::Info, "b", 1, "even");
        diagnostics.soften(Severity::Warning);
        diagnostics.report(Severity::Error, "a", 11, "odd");
        QCOMPARE(diagnostics.entries().size(), 2U);
        QVERIFY(diagnostics.entries()[0].severity == Severity::Warning);
        QCOMPARE(diagnostics.entries()[0].count, 3U);
        QCOMPARE(diagnostics.entries()[0].line, 7U);
        QVERIFY(diagnostics.entries()[0].element == ElementId{3});
        QVERIFY(diagnostics.entries()[1].severity == Severity::Info);
    }

    void anEntryCanBeLocatedLater() {
        Diagnostics diagnostics;
        diagnostics.report(Severity::Info, "a", 1, "odd");
        diagnostics.locate(0, {}, model::Diagnostic{}.location);
        QVERIFY(!diagnostics.entries()[0].location);
        diagnostics.locate(0, {}, base::Point{3, 4});
        QCOMPARE(diagnostics.entries()[0].location, std::optional(base::Point{3, 4}));
    }
};

QTEST_APPLESS_MAIN(DiagnosticsTest)
#include "diagnostics_test.moc"
