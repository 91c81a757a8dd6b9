#include "ui/element/fact_model.h"

#include <QCoreApplication>
#include <algorithm>

namespace ui {

namespace {

constexpr std::pair<const char*, FactLink> kLinks[] = {
    {QT_TRANSLATE_NOOP("ui::Facts", "Layer"), FactLink::Layer},
    {QT_TRANSLATE_NOOP("ui::Facts", "Net"), FactLink::Net},
    {QT_TRANSLATE_NOOP("ui::Facts", "Pin"), FactLink::Pin},
    {QT_TRANSLATE_NOOP("ui::Facts", "Component"), FactLink::Component}};

}  // namespace

FactModel::FactModel(QObject* parent) : TableModel({{tr("Property"), {}}, {tr("Value"), {}}}, parent) {}

void FactModel::setFacts(Facts facts, const QColor& linkColour) {
    m_linkColour = linkColour;
    replace(m_facts, std::move(facts));
}

std::optional<FactLink> FactModel::linkOf(int row) const {
    const QString& fact = m_facts[static_cast<std::size_t>(row)].first;
    if (fact.isEmpty()) {
        return FactLink::PinOfNet;
    }
    const auto* found = std::ranges::find_if(
        kLinks, [&](const auto& link) { return fact == QCoreApplication::translate("ui::Facts", link.first); });
    return found != std::end(kLinks) ? std::optional(found->second) : std::nullopt;
}

Cell FactModel::cell(int row, int column) const {
    const auto& [name, value] = m_facts[static_cast<std::size_t>(row)];
    return column == Name ? Cell{.text = name}
                          : Cell{.text = value, .colour = linkOf(row) ? QVariant(m_linkColour) : QVariant()};
}

QString FactModel::tip(int row, int column) const {
    const auto& [name, value] = m_facts[static_cast<std::size_t>(row)];
    return column == Name ? name : linkOf(row) ? value + '\n' + tr("Click to select it") : value;
}

}  // namespace ui
