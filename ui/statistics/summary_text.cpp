#include "ui/statistics/summary_text.h"

#include <QCoreApplication>
#include <QStringList>

namespace ui {

namespace {

struct SummaryText {
    Q_DECLARE_TR_FUNCTIONS(ui::SummaryText)
};

QString counted(std::uint64_t count, const QString& one, const QString& many) {
    return count == 1 ? one : many.arg(count);
}

QString sizeText(const model::BoardSummary& board, LengthUnit unit) {
    const QString size = QStringLiteral("%1 × %2").arg(lengthText(static_cast<double>(board.width), unit),
                                                       lengthText(static_cast<double>(board.height), unit));
    const QString whose = board.hasCopies ? SummaryText::tr("Panel %1") : SummaryText::tr("Board %1");
    return whose.arg(board.isSizeAssumed ? SummaryText::tr("%1 (assumed, the job has no outline)").arg(size) : size);
}

}  // namespace

QString summaryText(const model::BoardSummary& board, LengthUnit unit) {
    QStringList texts;
    if (board.width > 0 && board.height > 0) {
        texts += sizeText(board, unit);
    }
    if (board.thickness > 0) {
        texts += SummaryText::tr("%1 thick").arg(lengthText(board.thickness, unit));
    }
    texts += counted(board.copperLayers, SummaryText::tr("1 copper layer"), SummaryText::tr("%L1 copper layers"));
    texts += counted(board.nets, SummaryText::tr("1 net"), SummaryText::tr("%L1 nets"));
    texts += counted(board.components, SummaryText::tr("1 component"), SummaryText::tr("%L1 components"));
    texts += counted(board.holes, SummaryText::tr("1 hole"), SummaryText::tr("%L1 holes"));
    const QString text = texts.join(QStringLiteral(" · "));
    return board.hasCopies ? SummaryText::tr("%1, with all copies").arg(text) : text;
}

}  // namespace ui
