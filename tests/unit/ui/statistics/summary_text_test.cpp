#include "ui/statistics/summary_text.h"

#include <QtTest>

using model::BoardSummary;
using ui::LengthUnit;
using ui::summaryText;

namespace {

BoardSummary smallBoard() {
    return {.width = 90'000'000,
            .height = 133'985'000,
            .thickness = 1'571'400,
            .copperLayers = 4,
            .nets = 103,
            .components = 145,
            .holes = 212};
}

}  // namespace

class SummaryTextTest : public QObject {
    Q_OBJECT

private slots:
    void sizesFollowTheUnit() {
        QCOMPARE(summaryText(smallBoard(), LengthUnit::Millimetre),
                 QString("Board 90 mm × 133.985 mm · 1.5714 mm thick · 4 copper layers · 103 nets · 145 components · "
                         "212 holes"));
        QVERIFY(summaryText(smallBoard(), LengthUnit::Inch)
                    .startsWith("Board 3.54331 in × 5.275 in · 0.06187 in thick · "));
    }

    void aPanelIsCalledOne() {
        BoardSummary panel = smallBoard();
        panel.hasCopies = true;
        const QString text = summaryText(panel, LengthUnit::Millimetre);
        QVERIFY2(text.startsWith("Panel 90 mm × ") && text.endsWith("212 holes, with all copies"), qPrintable(text));
    }

    void whatIsNotKnownIsNotClaimed() {
        BoardSummary board{.copperLayers = 1, .nets = 1, .components = 1, .holes = 1};
        QCOMPARE(summaryText(board, LengthUnit::Mil), QString("1 copper layer · 1 net · 1 component · 1 hole"));
        board = smallBoard();
        board.isSizeAssumed = true;
        QVERIFY(summaryText(board, LengthUnit::Millimetre).contains("133.985 mm (assumed, the job has no outline) · "));
    }
};

QTEST_APPLESS_MAIN(SummaryTextTest)
#include "summary_text_test.moc"
