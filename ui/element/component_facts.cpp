#include "ui/element/component_facts.h"

#include <QCoreApplication>
#include <QStringList>

#include "model/index/attributes.h"
#include "model/index/pin_names.h"
#include "ui/common/net_name.h"

namespace ui {

namespace {

struct ComponentText {
    Q_DECLARE_TR_FUNCTIONS(ui::Facts)
};

QString netsText(const model::Document& step, const model::Component& component) {
    const QStringList names = netNames(step, model::netsOf(step, component));
    return names.isEmpty() ? ComponentText::tr("none") : names.join(QStringLiteral(", "));
}

void addAttributes(const model::Document& step, const model::Component& component, Facts& facts) {
    model::forEachAttribute(step, component, [&](const std::string& name, const std::string& value) {
        facts.emplace_back(QString::fromStdString(name),
                           value.empty() ? ComponentText::tr("yes") : QString::fromStdString(value));
    });
}

}  // namespace

Facts componentFacts(const model::Document& step, model::ComponentId id, LengthUnit unit, bool isOneOfSteps) {
    using T = ComponentText;
    const model::Component& component = step.components[id.row()];
    const model::Point at = component.placement.origin;
    Facts facts;
    if (!component.part.empty()) {
        facts.emplace_back(T::tr("Part"), QString::fromStdString(component.part));
    }
    facts.emplace_back(T::tr("Package"), component.package.isValid()
                                             ? QString::fromStdString(step.packages[component.package.row()].name)
                                             : T::tr("not in the job"));
    facts.emplace_back(T::tr("Side"), component.side == model::LayerSide::Bottom ? T::tr("Bottom") : T::tr("Top"));
    const QString position = positionText(at.x, at.y, unit);
    const QString ofStep = T::tr("Position in step %1").arg(QString::fromStdString(step.job.step));
    facts.emplace_back(isOneOfSteps ? ofStep : T::tr("Position"),
                       component.isPlaced ? position : T::tr("%1 (assumed, the middle of its pins)").arg(position));
    facts.emplace_back(T::tr("Rotation"), component.isPlaced
                                              ? T::tr("%1 clockwise").arg(angleText(component.placement.clockwiseDeg))
                                              : T::tr("not in the job"));
    facts.emplace_back(T::tr("Height"),
                       component.height > 0 ? lengthInBoth(component.height, unit) : T::tr("not in the job"));
    facts.emplace_back(T::tr("Fitted"), component.isPopulated ? T::tr("yes") : T::tr("no"));
    facts.emplace_back(T::tr("Nets"), netsText(step, component));
    addAttributes(step, component, facts);
    return facts;
}

}  // namespace ui
