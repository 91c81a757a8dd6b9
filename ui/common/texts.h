#pragma once

#include <QStringList>
#include <string>
#include <vector>

namespace ui {

[[nodiscard]] inline QStringList textsOf(const std::vector<std::string>& utf8) {
    QStringList texts;
    for (const std::string& text : utf8) {
        texts += QString::fromStdString(text);
    }
    return texts;
}

}  // namespace ui
