#include "ui/clearance/rule_model.h"

#include <QColor>
#include <algorithm>
#include <cmath>
#include <utility>

#include "model/base/thickness_units.h"

namespace ui {

namespace {

/// Mid tones, readable on a light and on a dark ground; the word says the same.
constexpr QColor kBroken(0xd9, 0x4a, 0x3d);
constexpr QColor kPassed(0x3a, 0x9a, 0x7a);
constexpr QColor kIncomplete(0xb8, 0x86, 0x1b);
constexpr model::Nm kCommonClearance = 100'000;
constexpr double kCommonRatio = 10.0;

QString anyNet() {
    return RuleModel::tr("any net");
}

/// In nanometres; -1 if the text is no length.
double nanometresOf(const QString& text, LengthUnit unit) {
    bool isNumber = false;
    const std::string point = model::withDecimalPoint(text.trimmed().toStdString());
    const double bare = QString::fromStdString(point).toDouble(&isNumber) * nmPer(unit);
    double nm = bare;
    if (!isNumber) {
        const base::Result<base::Nm> length = model::parseLength(point);
        nm = length ? static_cast<double>(*length) : -1.0;
    }
    return nm;
}

/// None if the text is no length that a rule can have.
std::optional<model::Nm> lengthOf(const QString& text, LengthUnit unit) {
    const double nm = nanometresOf(text, unit);
    const bool isLeast = nm >= 0.5 && nm <= static_cast<double>(model::kMostLeast);
    return isLeast ? std::optional(static_cast<model::Nm>(std::lround(nm))) : std::nullopt;
}

/// "8", "8:1", "8 : 1". None if the text is no ratio that a rule can have.
std::optional<double> ratioOf(const QString& text) {
    bool isNumber = false;
    const QString one = text.section(':', 1).trimmed();
    const std::string point = model::withDecimalPoint(text.section(':', 0, 0).trimmed().toStdString());
    const double ratio = QString::fromStdString(point).toDouble(&isNumber);
    const bool isRatio = isNumber && ratio >= model::kLeastRatio && ratio <= model::kMostRatio &&
                         (one == QLatin1String("1") || !text.contains(':'));
    return isRatio ? std::optional(ratio) : std::nullopt;
}

QString allLayers() {
    return RuleModel::tr("all layers");
}

/// "copper-copper within a net" is a kind of its own here.
QString kindText(model::RuleKind kind, bool isSameNet) {
    const auto name = QString(QLatin1String(model::nameOf(kind)));
    return isSameNet ? RuleModel::tr("%1 within a net").arg(name) : name;
}

QStringList kindChoices() {
    QStringList choices;
    for (std::size_t row = 0; row < model::kRuleKindCount; ++row) {
        const auto kind = static_cast<model::RuleKind>(row);
        choices += kindText(kind, false);
        if (kind == model::RuleKind::CopperToCopper) {
            choices += kindText(kind, true);
        }
    }
    return choices;
}

template <class Object>
QStringList namesOf(std::size_t count) {
    QStringList names;
    for (std::size_t row = 0; row < count; ++row) {
        names += QLatin1String(model::nameOf(static_cast<Object>(row)));
    }
    return names;
}

QStringList objectChoices(model::RuleSide side) {
    return side == model::RuleSide::Copper ? namesOf<model::CopperObject>(model::kCopperObjectCount)
           : side == model::RuleSide::Hole ? namesOf<model::HoleClass>(model::kHoleClassCount)
                                           : QStringList();
}

std::size_t sideOf(int column) {
    return column == RuleModel::First || column == RuleModel::FirstObject ? 0 : 1;
}

model::RuleSide sideAt(const model::Rule& rule, int column) {
    return model::sidesOf(rule.kind)[sideOf(column)];
}

/// Rules of one side of holes name it first.
std::size_t holeRow(const model::Rule& rule, int column) {
    return model::holeSidesOf(rule.kind) == 2 ? sideOf(column) : 0;
}

QString objectText(const model::Rule& rule, int column) {
    const model::RuleSide side = sideAt(rule, column);
    return side == model::RuleSide::Copper ? QString(QLatin1String(model::nameOf(rule.objects[sideOf(column)])))
           : side == model::RuleSide::Hole ? QString(QLatin1String(model::nameOf(rule.holes[holeRow(rule, column)])))
                                           : QString();
}

QString netText(const model::Rule& rule, int column) {
    const std::string& name = rule.classes[sideOf(column)];
    return sideAt(rule, column) == model::RuleSide::None ? QString()
           : name.empty()                                ? anyNet()
                                                         : QString::fromStdString(name);
}

QString layerText(const model::Rule& rule) {
    return !model::hasLayer(rule.kind) ? QString()
           : rule.layer.empty()        ? allLayers()
                                       : QString::fromStdString(rule.layer);
}

/// What the new kind does not know is dropped.
model::Rule withKind(const model::Rule& rule, model::RuleKind kind, bool isSameNet) {
    model::Rule after{kind, rule.least, {}, rule.isOn};
    after.isSameNet = isSameNet;
    after.layer = model::hasLayer(kind) ? rule.layer : "";
    for (std::size_t side = 0; side < model::netSidesOf(kind); ++side) {
        after.classes[side] = rule.classes[side];
    }
    if (model::sidesOf(kind) == model::sidesOf(rule.kind)) {
        after.objects = rule.objects;
        after.holes = rule.holes;
    }
    after.least = !model::hasLeast(kind) ? 0 : rule.least > 0 ? rule.least : kCommonClearance;
    const bool hasRatio = model::limitOf(kind) == model::RuleLimit::Ratio;
    after.mostRatio = !hasRatio ? 0.0 : rule.mostRatio > 0 ? rule.mostRatio : kCommonRatio;
    return after;
}

QString boundText(const model::Rule& rule, LengthUnit unit) {
    switch (model::limitOf(rule.kind)) {
        case model::RuleLimit::Length: return lengthText(static_cast<double>(rule.least), unit);
        case model::RuleLimit::Ratio: return QString::fromStdString(model::ratioText(rule.mostRatio));
        default: return {};
    }
}

}  // namespace

RuleModel::RuleModel(QObject* parent)
    : TableModel(
          {{tr("On"), tr("Whether the rule is checked"), kCheck},
           {tr("Rule"), tr("What is checked against what")},
           {tr("Kind"), tr("What keeps a clearance, or how much must be left"), kEditable},
           {tr("Between"), tr("Nets of this class, or any net"), kEditable},
           {tr("And"), tr("Nets of this class, or any net"), kEditable},
           {tr("Of"), tr("Tracks, pads, vias or planes; kind of holes"), kEditable},
           {tr("And of"), tr("Tracks, pads, vias or planes; kind of holes"), kEditable},
           {tr("Layer"), tr("A side, outer or inner layers, one layer, or all of them"), kEditable},
           {tr("Limit"),
            tr("The least value that passes, with a unit (100um, 4 mil) or in yours; the largest aspect ratio (8 : 1)"),
            kEditable},
           {tr("Result"), tr("In how many locations the rule is broken, or that it could not check everything")}},
          parent) {}

void RuleModel::setRules(model::RuleTable rules) {
    beginResetModel();
    m_rules = std::move(rules);
    m_results.clear();
    endResetModel();
}

void RuleModel::replaceRules(model::RuleTable rules) {
    const model::RuleTable before = m_rules;
    setRules(std::move(rules));
    emit edited(before);
}

void RuleModel::setResults(std::vector<RuleResult> results) {
    m_results = std::move(results);
    announceChange();
}

/// Rows stay what they are, or the whole table is another.
void RuleModel::change(model::RuleTable after) {
    const model::RuleTable before = m_rules;
    if (after.rules.size() != before.rules.size()) {
        setRules(std::move(after));
    } else {
        m_rules = std::move(after);
        m_results.clear();
        announceChange();
    }
    emit edited(before);
}

bool RuleModel::refuse(const QString& why) {
    emit refused(why);
    return false;
}

bool RuleModel::setTolerance(const QString& text) {
    const double nm = nanometresOf(text, unit());
    if (!(nm >= 0 && nm <= static_cast<double>(model::kMostTolerance))) {
        return refuse(tr("%1 is no tolerance: 0 to 10 um").arg(text));
    }
    model::RuleTable after = m_rules;
    after.tolerance = static_cast<model::Nm>(std::lround(nm));
    if (text != tolerance() && !(after == m_rules)) {  // what is shown is rounded
        change(std::move(after));
    }
    return true;
}

QString RuleModel::tolerance() const {
    return lengthText(static_cast<double>(m_rules.tolerance), unit());
}

void RuleModel::addRule() {
    model::RuleTable after = m_rules;
    after.rules.push_back({model::RuleKind::CopperToCopper, kCommonClearance, {}});
    change(std::move(after));
}

void RuleModel::removeRule(int row) {
    if (m_rules.rules.size() == 1) {
        refuse(tr("At least one rule must stay; switch it off instead."));
        return;
    }
    model::RuleTable after = m_rules;
    after.rules.erase(after.rules.begin() + row);
    change(std::move(after));
}

int RuleModel::moveRule(int row, int by) {
    const int to = row + by;
    if (to < 0 || to >= rowCount()) {
        return row;
    }
    model::RuleTable after = m_rules;
    std::swap(after.rules[static_cast<std::size_t>(row)], after.rules[static_cast<std::size_t>(to)]);
    change(std::move(after));
    return to;
}

bool RuleModel::setClass(std::size_t row, const model::NetClass& netClass) {
    const bool isNew = row == m_rules.classes.size();
    if (netClass.name.empty()) {
        return refuse(tr("A net class needs a name."));
    }
    const auto known = std::ranges::find(m_rules.classes, netClass.name, &model::NetClass::name);
    if (known != m_rules.classes.end() && static_cast<std::size_t>(known - m_rules.classes.begin()) != row) {
        return refuse(tr("There is a net class %1 already.").arg(QString::fromStdString(netClass.name)));
    }
    if (isNew && model::netClassCount(m_rules) >= model::kMostNetClasses) {
        return refuse(tr("There can be at most %1 net classes.").arg(model::kMostNetClasses));
    }
    model::RuleTable after = m_rules;
    if (isNew) {
        after.classes.push_back(netClass);
    } else {
        const std::string old = std::exchange(after.classes[row], netClass).name;
        for (model::Rule& rule : after.rules) {
            std::ranges::replace(rule.classes, old, netClass.name);
        }
    }
    change(std::move(after));
    return true;
}

bool RuleModel::removeClass(std::size_t row) {
    const std::string& name = m_rules.classes[row].name;
    const auto user = std::ranges::find_if(
        m_rules.rules, [&](const model::Rule& rule) { return std::ranges::count(rule.classes, name) > 0; });
    if (user != m_rules.rules.end()) {
        return refuse(tr("Rule %1 uses %2: change or remove it first.")
                          .arg(user - m_rules.rules.begin() + 1)
                          .arg(QString::fromStdString(name)));
    }
    model::RuleTable after = m_rules;
    after.classes.erase(after.classes.begin() + static_cast<std::ptrdiff_t>(row));
    change(std::move(after));
    return true;
}

QString RuleModel::withWaived(const QString& text, const RuleResult& result) {
    return result.waived == 0 ? text : tr("%1, %L2 waived").arg(text).arg(result.waived);
}

Cell RuleModel::resultOf(std::size_t row) const {
    if (!m_rules.rules[row].isOn) {
        return {tr("off")};
    }
    if (m_results.empty()) {
        return {tr("not checked")};
    }
    const RuleResult& result = m_results[row];
    if (result.verdict == model::Verdict::Passed) {
        return {.text = withWaived(tr("pass"), result), .colour = kPassed};
    }
    if (result.verdict == model::Verdict::Unused) {
        return {tr("unused: nothing on the board meets it")};
    }
    if (result.verdict == model::Verdict::Incomplete) {
        return {.text = withWaived(tr("incomplete, see below"), result), .colour = kIncomplete};
    }
    const auto whole = [&result](const QString& count) {
        const QString text = withWaived(count, result);
        return result.unchecked == 0 ? text : tr("%1; incomplete").arg(text);
    };
    const QString count =
        result.count == 1 ? tr("FAIL, in 1 location") : tr("FAIL, in %L1 locations").arg(result.count);
    // A narrow panel shows the beginning: the verdict and its number.
    return {.text = whole(tr("FAIL: %L1").arg(result.count)), .colour = kBroken, .tip = whole(count)};
}

Cell RuleModel::cell(int row, int column) const {
    const model::Rule& rule = m_rules.rules[static_cast<std::size_t>(row)];
    switch (column) {
        case On: return {.isChecked = rule.isOn};
        case Title: return text(model::titleOf(rule));
        case Kind: return {.text = kindText(rule.kind, rule.isSameNet), .choices = choicesOf(rule, column)};
        case First:
        case Second: return {.text = netText(rule, column), .choices = choicesOf(rule, column)};
        case FirstObject:
        case SecondObject: return {.text = objectText(rule, column), .choices = choicesOf(rule, column)};
        case Layer: return {.text = layerText(rule), .choices = choicesOf(rule, column)};
        case Least: return {boundText(rule, unit())};
        default: return resultOf(static_cast<std::size_t>(row));
    }
}

/// None where nothing can be chosen.
QStringList RuleModel::choicesOf(const model::Rule& rule, int column) const {
    switch (column) {
        case Kind: return kindChoices();
        case First:
        case Second: return sideAt(rule, column) == model::RuleSide::None ? QStringList() : netChoices(rule);
        case FirstObject:
        case SecondObject: return objectChoices(sideAt(rule, column));
        case Layer: return model::hasLayer(rule.kind) ? layerChoices(rule) : QStringList();
        default: return {};
    }
}

/// Also those that the rule names without a class: "net:CLK*".
QStringList RuleModel::netChoices(const model::Rule& rule) const {
    QStringList choices{anyNet()};
    for (const model::NetClass& netClass : m_rules.classes) {
        choices += QString::fromStdString(netClass.name);
    }
    for (const std::string& name : rule.classes) {
        if (!name.empty() && !choices.contains(QString::fromStdString(name))) {
            choices += QString::fromStdString(name);
        }
    }
    return choices;
}

QStringList RuleModel::layerChoices(const model::Rule& rule) const {
    QStringList choices{allLayers(), QStringLiteral("top"), QStringLiteral("bottom"), QStringLiteral("outer"),
                        QStringLiteral("inner")};
    choices += m_layers;
    if (!rule.layer.empty() && !choices.contains(QString::fromStdString(rule.layer))) {
        choices += QString::fromStdString(rule.layer);
    }
    return choices;
}

Qt::ItemFlags RuleModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags flags = TableModel::flags(index);
    const model::Rule& rule = m_rules.rules[static_cast<std::size_t>(index.row())];
    const bool isChosen = index.column() >= Kind && index.column() <= Layer;
    const bool hasLimit = model::limitOf(rule.kind) != model::RuleLimit::None;
    const bool isOpen = isChosen ? !choicesOf(rule, index.column()).isEmpty() : index.column() != Least || hasLimit;
    return isOpen ? flags : flags & ~Qt::ItemIsEditable;
}

bool RuleModel::setLimit(model::Rule& rule, const QString& text) {
    if (model::limitOf(rule.kind) == model::RuleLimit::Ratio) {
        const std::optional<double> ratio = ratioOf(text);
        rule.mostRatio = ratio.value_or(rule.mostRatio);
        return ratio || refuse(tr("%1 is no aspect ratio: 8, 0.8 : 1, …").arg(text));
    }
    const std::optional<model::Nm> least = lengthOf(text, unit());
    rule.least = least.value_or(rule.least);
    return least || refuse(tr("%1 is no length: 100um, 4 mil, …").arg(text));
}

/// False if the text is none for this column.
bool RuleModel::set(model::Rule& rule, int column, const QString& text) {
    if (column == Least) {
        return setLimit(rule, text);
    }
    if (!choicesOf(rule, column).contains(text)) {
        return false;
    }
    const std::string name = text.toStdString();
    if (column == Kind) {
        const bool isSameNet = text == kindText(model::RuleKind::CopperToCopper, true);
        rule = withKind(rule, model::ruleKindOf(name).value_or(model::RuleKind::CopperToCopper), isSameNet);
    } else if (column == Layer) {
        rule.layer = text == allLayers() ? std::string() : name;
    } else if (column == First || column == Second) {
        rule.classes[sideOf(column)] = text == anyNet() ? std::string() : name;
    } else if (sideAt(rule, column) == model::RuleSide::Hole) {
        rule.holes[holeRow(rule, column)] = model::holeClassOf(name).value_or(model::HoleClass::Any);
    } else {
        rule.objects[sideOf(column)] = model::copperObjectOf(name).value_or(model::CopperObject::Any);
    }
    return true;
}

bool RuleModel::check(int row, int, bool isChecked) {
    model::RuleTable after = m_rules;
    after.rules[static_cast<std::size_t>(row)].isOn = isChecked;
    if (!(after == m_rules)) {
        change(std::move(after));
    }
    return true;
}

bool RuleModel::edit(int row, int column, const QVariant& value) {
    if (value.toString() == cell(row, column).text.toString()) {
        return true;  // what is shown is rounded
    }
    model::RuleTable after = m_rules;
    if (!set(after.rules[static_cast<std::size_t>(row)], column, value.toString())) {
        return false;
    }
    if (!(after == m_rules)) {
        change(std::move(after));
    }
    return true;
}

}  // namespace ui
