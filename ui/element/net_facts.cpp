#include "ui/element/net_facts.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <map>

#include "model/index/pin_names.h"

namespace ui {

namespace {

constexpr qsizetype kMostPins = 200;  // more is a column that nobody reads; the count is exact

QString countText(std::size_t count) {
    return QStringLiteral("%L1").arg(count);
}

QStringList pinsOf(const model::Document& step, model::NetId net) {
    QStringList pins;
    for (std::size_t row = 0; row < step.pins.size(); ++row) {
        if (step.pins[row].net == net && step.pins[row].component.isValid()) {
            pins += QString::fromStdString(model::fullPinName(step, model::PinId{row}));
        }
    }
    return pins;
}

}  // namespace

Facts netFacts(const model::StepTree& tree, const model::BoardNet& net) {
    const auto tr = [](const char* text) { return QCoreApplication::translate("ui::Facts", text); };
    const model::Document& step = *tree.steps[net.step];
    Facts facts;
    if (net.step > 0) {
        facts.emplace_back(tr("Step"), QString::fromStdString(step.job.step));
    }
    const auto elements = step.elementsOf(net.net);
    facts.emplace_back(tr("Elements"), countText(elements.size()));
    const QStringList pins = pinsOf(step, net.net);
    facts.emplace_back(tr("Pins"), countText(static_cast<std::size_t>(pins.size())));
    for (const QString& pin : pins.first(std::min(pins.size(), kMostPins))) {
        facts.emplace_back(QString(), pin);
    }
    std::map<model::LayerId, std::size_t> counts;
    for (const model::ElementId element : elements) {
        ++counts[step.elements.layer[element.row()]];
    }
    for (const auto& [layer, count] : counts) {
        facts.emplace_back(tr("On %1").arg(QString::fromStdString(step.layer(layer).name)), countText(count));
    }
    return facts;
}

}  // namespace ui
