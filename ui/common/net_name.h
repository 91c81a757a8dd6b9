#pragma once

#include <QStringList>

#include "model/board/document.h"
#include "model/text/net_names.h"

namespace ui {

/// A net as people write its name (model::readableName); empty for none.
[[nodiscard]] inline QString netName(const model::Document& step, model::NetId net) {
    return net.isValid() ? QString::fromStdString(model::readableName(step.nets[net.row()].name)) : QString();
}

[[nodiscard]] inline QStringList netNames(const model::Document& step, const std::vector<model::NetId>& nets) {
    QStringList names;
    for (const model::NetId net : nets) {
        names += netName(step, net);
    }
    return names;
}

}  // namespace ui
