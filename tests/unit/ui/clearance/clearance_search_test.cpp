// What a search for clearances and a check of rules say of themselves: that there may be more, and what nobody checked.
#include "ui/clearance/clearance_search.h"

#include <QtTest>
#include <algorithm>

#include "tests/unit/model/hand_made.h"

using namespace hand_made;
using ui::ClearanceRequest;
using ui::ClearanceResult;

namespace {

/// Three discs in a row, each of a net of its own.
std::shared_ptr<const model::Document> threeDiscs() {
    model::DocumentBuilder builder;
    const model::LayerId top = addLayer(builder, "top");
    builder.beginLayer(top);
    for (const int column : {0, 1, 2}) {
        builder.addCircle({{column * 2 * kMm, 0}, kMm, 0},
                          of(builder.addNet(std::string(1, static_cast<char>('A' + column)))));
    }
    return builder.finish();
}

QString summaryOf(const std::shared_ptr<const model::Document>& board, const ClearanceRequest& request) {
    base::Progress progress;
    const base::Result<ClearanceResult> found = ui::searchClearances(*board, request, progress);
    ui::ClearanceModel model;
    model.setSpacings(board, spacingsOf(*found), request.isOfRules ? request.rules : model::RuleTable{},
                      isComplete(*found), found->isCut);
    return model.summary();
}

}  // namespace

class ClearanceSearchTest : public QObject {
    Q_OBJECT

private slots:
    void aLongListSaysThatThereMayBeMore() {
        const auto board = threeDiscs();
        ClearanceRequest request;
        request.question.count = 500;
        const QString all = summaryOf(board, request);
        QVERIFY2(all.startsWith("Smallest spacing ") && all.endsWith("; 3 locations"), qPrintable(all));
        request.question.count = 2;
        const QString cut = summaryOf(board, request);
        QVERIFY2(cut.endsWith("; at least 2 locations"), qPrintable(cut));
    }

    /// Rules that pass say nothing of what their file asks for besides.
    void whatIsLeftOutOfTheRulesIsNoPass() {
        const auto board = threeDiscs();
        ClearanceRequest request;
        request.isOfRules = true;
        request.rules.rules = {{model::RuleKind::CopperToCopper, 100 * kUm, {}}};
        QVERIFY(summaryOf(board, request).startsWith("All rules pass"));
        request.leftOut = 6;
        const QString verdict = summaryOf(board, request);
        QVERIFY2(verdict.startsWith("No rule is broken, but not everything could be checked"), qPrintable(verdict));
        base::Progress progress;
        const auto notes = ui::searchClearances(*board, request, progress)->notes;
        QVERIFY(std::ranges::any_of(
            notes, [](const std::string& note) { return note.starts_with("not checked: 6 entries"); }));
    }
};

QTEST_APPLESS_MAIN(ClearanceSearchTest)
#include "clearance_search_test.moc"
