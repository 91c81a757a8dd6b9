#include "ui/common/trouble_text.h"

#include <QCoreApplication>
#include <QStringList>

namespace ui {

QString troubleText(std::size_t errors, std::size_t warnings) {
    const auto counted = [](const char* one, const char* many, std::size_t count) {
        const QString text = QCoreApplication::translate("troubleText", count == 1 ? one : many);
        return count == 1 ? text : text.arg(count);
    };
    QStringList parts;
    if (errors > 0) {
        parts += counted("1 error", "%L1 errors", errors);
    }
    if (warnings > 0) {
        parts += counted("1 warning", "%L1 warnings", warnings);
    }
    return parts.isEmpty() ? QCoreApplication::translate("troubleText", "no warnings")
                           : parts.join(QStringLiteral(", "));
}

}  // namespace ui
