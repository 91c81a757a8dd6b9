#include "ui/shell/load_summary.h"

#include <QLocale>

#include "ui/common/paths.h"

namespace ui {

namespace {

/// "1 layer", "141,000 elements"
QString counted(std::size_t count, const char* one, const char* many) {
    return QStringLiteral("%1 %2").arg(QLocale().toString(static_cast<qulonglong>(count)),
                                       QLatin1String(count == 1 ? one : many));
}

QString timeText(double seconds) {
    return seconds < 1.0 ? QStringLiteral("%1 ms").arg(qRound(seconds * 1000.0))
                         : QStringLiteral("%1 s").arg(QLocale().toString(seconds, 'f', 1));
}

}  // namespace

QString loadSummary(const LoadedBoard& board, const MessageModel& messages) {
    const std::size_t problems = messages.count(model::Severity::Warning) + messages.count(model::Severity::Error);
    return QStringLiteral("Opened %1: %2, %3, %4, in %5")
        .arg(displayName(board.request.path), counted(board.document->layers.size(), "layer", "layers"),
             counted(board.document->elements.size(), "element", "elements"), counted(problems, "warning", "warnings"),
             timeText(board.seconds));
}

}  // namespace ui
