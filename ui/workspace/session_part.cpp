#include "ui/workspace/session_part.h"

namespace ui {

QString textOfOthers(const model::session::KnownPart& part, const QString& name) {
    const auto text = [&name](const char* sentence) {
        return QCoreApplication::translate("SessionPart", sentence).arg(name);
    };
    if (part.keepsOthers && part.replacesOthers) {
        return text(QT_TRANSLATE_NOOP("SessionPart",
                                      "%1 in the session file were changed outside this window, too. What was changed "
                                      "here as well was replaced; the rest is kept, and Reload (F5) shows it."));
    }
    if (part.replacesOthers) {
        return text(QT_TRANSLATE_NOOP("SessionPart",
                                      "%1 in the session file were changed outside this window, too. What was changed "
                                      "here as well was replaced."));
    }
    return part.keepsOthers ? text(QT_TRANSLATE_NOOP("SessionPart",
                                                     "%1 in the session file were changed outside this window, too. "
                                                     "That is kept, and Reload (F5) shows it."))
                            : QString();
}

}  // namespace ui
